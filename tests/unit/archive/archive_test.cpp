// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/archive/archive.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include "hardball/errors/error.hpp"
#include "support/refusal.hpp"

namespace hardball::archive_test {
namespace {

// A class without a public default constructor, whose state has a part that follows from the rest.
class Even {
 public:
  explicit Even(int value) : value_(value), half_(value / 2) {}
  int half() const { return half_; }

  friend bool operator==(const Even&, const Even&) = default;

 private:
  friend class hardball::Persistence;
  Even() = default;
  static void persist(auto& archive, auto& self) { archive(self.value_); }
  bool restored() {
    half_ = value_ / 2;
    return value_ % 2 == 0;
  }

  int value_;
  int half_;
};

using Everything =
    std::tuple<bool, std::uint8_t, int, std::uint64_t, double, std::string, std::vector<double>,
               std::vector<Even>, std::array<int, 3>, std::pair<int, bool>, std::optional<Even>,
               std::optional<double>, std::variant<double, Even>, std::unordered_map<std::uint32_t, int>>;

Everything everything() {
  return {true,
          std::uint8_t{200},
          -7,
          std::numeric_limits<std::uint64_t>::max(),
          -0.0,
          "text",
          {1, 2, std::numeric_limits<double>::infinity()},
          {Even(2), Even(4)},
          {1, 2, 3},
          {5, true},
          Even(6),
          std::nullopt,
          Even(8),
          {{1, 10}, {7, 70}}};
}

TEST(Archive, RestoresWhatWasArchived) {
  const Everything original = everything();
  Everything read;
  std::get<std::optional<double>>(read) = 1;
  restore(archived(original), "test", read);
  EXPECT_EQ(read, original);
  EXPECT_TRUE(std::signbit(std::get<double>(read)));
  EXPECT_EQ(std::get<std::vector<Even>>(read)[1].half(), 2);
}

TEST(Archive, IsTheSameBytesForEqualMaps) {
  std::unordered_map<std::uint32_t, int> a;
  std::unordered_map<std::uint32_t, int> b;
  constexpr std::uint32_t kEntries = 100;
  for (std::uint32_t i = 0; i < kEntries; ++i) {
    a[i] = 1;
    b[kEntries - 1 - i] = 1;
  }
  EXPECT_EQ(archived(a), archived(b));
}

TEST(Archive, ThatEndsTooEarlyIsRefused) {
  const std::string bytes = archived(everything());
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    Everything read;
    EXPECT_THROW(restore(bytes.substr(0, length), "test", read), Error) << length;
  }
  Everything read;
  EXPECT_THROW(restore(bytes + '\0', "test", read), Error) << "or too late";
}

TEST(Archive, ClaimsNoMoreMemoryThanItHasBytes) {
  // As many numbers as there are bytes in the address space.
  std::vector<double> numbers;
  EXPECT_THROW(restore(archived(std::uint64_t{1} << 61), "test", numbers), Error);
  std::vector<Even> objects;
  EXPECT_THROW(restore(archived(std::uint64_t{1} << 61), "test", objects), Error);
  std::string text;
  EXPECT_THROW(restore(archived(std::numeric_limits<std::uint64_t>::max()), "test", text), Error);
}

TEST(Archive, OfAnImpossibleStateIsRefused) {
  Even odd(0);
  EXPECT_THROW(restore(archived(3), "test", odd), Error);
  bool truth = false;
  EXPECT_THROW(restore(archived(std::uint8_t{2}), "test", truth), Error);
  std::variant<double, Even> kind;
  EXPECT_THROW(restore(archived(std::uint8_t{2}, 0.0), "test", kind), Error);
}

TEST(Archive, OfBeforeTheFirstReleaseIsRefusedByName) {
  ArchiveWriter archive;
  archive(ArchiveWriter::kFirstReleased - 1, 1);
  int number = 0;
  const Error error = support::error_of([&] { restore(archive.bytes(), "run/checkpoint", number); });
  EXPECT_EQ(error.where(), "run/checkpoint");
  EXPECT_EQ(error.remedy(), "start the run again, or end it with the program that wrote it");
}

TEST(Archive, OfALaterVersionIsRefusedByName) {
  ArchiveWriter archive;
  archive(ArchiveWriter::kVersion + 1, 1);
  int number = 0;
  const Error error = support::error_of([&] { restore(archive.bytes(), "run/checkpoint", number); });
  EXPECT_EQ(error.where(), "run/checkpoint");
  EXPECT_EQ(error.remedy(), "use a later version of the program");
}

}  // namespace
}  // namespace hardball::archive_test
