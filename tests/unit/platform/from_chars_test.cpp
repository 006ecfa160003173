// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/platform/from_chars.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>

#include "hardball/numbers/random.hpp"

namespace hardball::from_chars_test {
namespace {

// Both read the same number, or none, from the same characters.
void expect_as_the_library(std::string_view text) {
  constexpr double kBefore = 17;
  double expected = kBefore;
  double found = kBefore;
  const char* const end = text.data() + text.size();
  const auto by_library = std::from_chars(text.data(), end, expected);
  const auto by_strtod = platform::from_chars_by_strtod(text.data(), end, found);
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

}  // namespace
}  // namespace hardball::from_chars_test
