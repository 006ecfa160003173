// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/standard/number_text.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "hardball/numbers/random.hpp"

namespace hardball::number_text_test {
namespace {

// Both read the same number, or none, from the same characters.
void expect_as_the_library(std::string_view text) {
  constexpr double kBefore = 17;
  double expected = kBefore;
  double found = kBefore;
  const char* const end = text.data() + text.size();
  const auto by_library = std::from_chars(text.data(), end, expected);
  const auto by_strtod = from_chars_by_strtod(text.data(), end, found);
  EXPECT_EQ(by_strtod.ec, by_library.ec) << text;
  EXPECT_EQ(by_strtod.ptr - text.data(), by_library.ptr - text.data()) << text;
  EXPECT_EQ(std::bit_cast<std::uint64_t>(found), std::bit_cast<std::uint64_t>(expected)) << text;
}

TEST(FromCharsByStrtod, ReadsWhatTheLibraryReads) {
  for (const char* const text : {"0",
                                 "-0",
                                 "1",
                                 "-1.5",
                                 "007",
                                 "1.",
                                 ".5",
                                 "-.5e3",
                                 "1e3",
                                 "1E+3",
                                 "1e-3",
                                 "1e",
                                 "1e+",
                                 "1ex",
                                 "1.5.2",
                                 "2,5",
                                 "5 ",
                                 "0x10",
                                 "0x",
                                 "inf",
                                 "-inf",
                                 "Infinity",
                                 "INF",
                                 "infinit",
                                 "nan",
                                 "-nan",
                                 "1e-310",
                                 "5e-324",
                                 "1.7976931348623157e308",
                                 "0e99999",
                                 "0.0e-99999",
                                 "123456789012345678901234567890"})
    expect_as_the_library(text);
}

TEST(FromCharsByStrtod, RefusesWhatTheLibraryRefuses) {
  for (const char* const text : {"", "-", "+1", " 1", "\t1", "\n1", ".", "-.", "e5", ".e5", "x", "--1", "-+1",
                                 "in", "1e999", "-1e999", "1e-999", "-1e-999"})
    expect_as_the_library(text);
}

TEST(FromCharsByStrtod, RestoresEveryNumber) {
  Random random(3);
  for (int k = 0; k < 20000; ++k) {
    // Any bits are a number, or none.
    const std::uint64_t bits = random.bits();
    std::array<char, 32> digits;
    const auto [end, status] =
        std::to_chars(digits.data(), digits.data() + digits.size(), std::bit_cast<double>(bits));
    ASSERT_EQ(status, std::errc());
    const std::string_view text(digits.data(), static_cast<std::size_t>(end - digits.data()));
    if (text.find("nan") == std::string_view::npos) expect_as_the_library(text);
  }
}

void expect_written_as_by_the_library(double number) {
  std::array<char, 400> expected;
  std::array<char, 400> found;
  const auto by_library = std::to_chars(expected.data(), expected.data() + expected.size(), number);
  const auto by_snprintf = to_chars_by_snprintf(found.data(), found.data() + found.size(), number);
  EXPECT_EQ(std::string_view(found.data(), by_snprintf.ptr),
            std::string_view(expected.data(), by_library.ptr));
}

TEST(ToCharsBySnprintf, WritesWhatTheLibraryWrites) {
  for (const double number :
       {0.0, -0.0, 1.0, -1.5, 0.1, 1e-3, 1e-4, 1e-5, 1e4, 1e5, 12e4, 123456.0, 1e15, 1e16, 1e22,
        123456789012345683968.0, 5e-324, 1.7976931348623157e308, 9007199254740993.0})
    expect_written_as_by_the_library(number);
  for (int power = -1074; power < 1024; ++power) {
    const double number = std::ldexp(1, power);
    for (const double close : {number, std::nextafter(number, 0), std::nextafter(number, 1e308)})
      expect_written_as_by_the_library(close);
  }
  Random random(3);
  for (int k = 0; k < 1000; ++k) {
    const auto any = std::bit_cast<double>(random.bits());
    if (!std::isnan(any)) expect_written_as_by_the_library(any);
    expect_written_as_by_the_library(random.uniform());
    expect_written_as_by_the_library(std::floor(1e6 * random.uniform()) / 1000);
  }
}

TEST(ToCharsBySnprintf, NeedsRoom) {
  std::array<char, 2> text;
  EXPECT_EQ(to_chars_by_snprintf(text.data(), text.data() + 2, 0.5).ec, std::errc::value_too_large);
  EXPECT_EQ(to_chars_by_snprintf(text.data(), text.data() + 2, 12).ptr, text.data() + 2);
}

}  // namespace
}  // namespace hardball::number_text_test
