// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <utility>

#include "hardball/memory/huge_pages.hpp"
#include "hardball/memory/prefetch.hpp"

namespace hardball::large_vector_test {
namespace {

struct alignas(64) CacheLine {
  std::uint64_t number = 0;
  std::array<std::uint64_t, 7> others{};
};

template <class T>
std::uintptr_t address_of(const T& value) {
  return reinterpret_cast<std::uintptr_t>(&value);
}

LargeVector<CacheLine> numbered(std::size_t count) {
  LargeVector<CacheLine> lines(count);
  for (std::size_t i = 0; i < count; ++i) lines[i].number = i;
  return lines;
}

bool is_numbered(const LargeVector<CacheLine>& lines, std::size_t count) {
  if (lines.size() < count) return false;
  for (std::size_t i = 0; i < count; ++i) {
    if (lines[i].number != i) return false;
  }
  return true;
}

// From one cache line to 8 MB, including the size from which huge pages are used.
constexpr std::array<std::size_t, 6> kCounts = {1, 1000, (1 << 16) - 1, 1 << 16, (1 << 16) + 1, 1 << 17};

TEST(LargeVector, CanBeFilledCopiedAndMoved) {
  for (const std::size_t count : kCounts) {
    LargeVector<CacheLine> lines = numbered(count);
    const LargeVector<CacheLine> copy = lines;
    lines[count / 2].number = 0;
    EXPECT_TRUE(is_numbered(copy, count)) << "a copy has its own memory";
    lines = copy;
    const CacheLine* const place = lines.data();
    const LargeVector<CacheLine> moved = std::move(lines);
    EXPECT_EQ(moved.data(), place) << "moved, not copied";
    EXPECT_TRUE(is_numbered(moved, count));
  }
}

TEST(LargeVector, KeepsItsElementsWhenItGrowsAndShrinks) {
  LargeVector<CacheLine> lines;
  constexpr std::size_t kMax = 1 << 17;
  for (std::size_t i = 0; i < kMax; ++i) {
    lines.emplace_back();
    lines.back().number = i;
  }
  EXPECT_TRUE(is_numbered(lines, kMax));
  lines.resize(1000);
  lines.shrink_to_fit();
  EXPECT_TRUE(is_numbered(lines, 1000));
  lines.assign(kMax, CacheLine{});
  EXPECT_EQ(lines[kMax - 1].number, 0U);
}

TEST(LargeVector, IsAligned) {
  for (const std::size_t count : kCounts) {
    const LargeVector<CacheLine> lines(count);
    EXPECT_EQ(address_of(lines[0]) % 64, 0U);
    // From two huge pages on, whole ones.
    if (count * sizeof(CacheLine) >= std::size_t{1} << 22) {
      EXPECT_EQ(address_of(lines[0]) % (std::size_t{1} << 21), 0U);
    }
    const LargeVector<double> numbers(count * 8);
    EXPECT_EQ(address_of(numbers[0]) % alignof(double), 0U);
  }
}

TEST(HugePageAllocator, IsTheSameForAllTypes) {
  const HugePageAllocator<double> one;
  const HugePageAllocator<double> same(HugePageAllocator<char>{});
  EXPECT_TRUE(one == same);
  double* const memory = HugePageAllocator<double>().allocate(1 << 20);
  memory[(1 << 20) - 1] = 3;
  HugePageAllocator<double>().deallocate(memory, 1 << 20);
}

TEST(Prefetch, TakesAnyAddressAndChangesNothing) {
  LargeVector<CacheLine> lines = numbered(1000);
  for (const CacheLine& line : lines) prefetch(&line);
  prefetch(lines.data() + lines.size());
  prefetch(nullptr);
  EXPECT_TRUE(is_numbered(lines, 1000));
}

}  // namespace
}  // namespace hardball::large_vector_test
