// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include "hardball/memory/function.hpp"
#include "hardball/memory/huge_pages.hpp"
#include "hardball/memory/prefetch.hpp"
#include "hardball/memory/value_pointer.hpp"

namespace hardball::memory_test {
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

int twice(int number) {
  return 2 * number;
}

TEST(Function, CallsWhatItHolds) {
  const int three = 3;
  EXPECT_EQ(Function<int(int)>(twice)(4), 8);
  EXPECT_EQ(Function<int(int)>([&](int number) { return three * number; })(4), 12);
  EXPECT_EQ(Function<int(int)>(std::function<int(int)>(twice))(4), 8);
  const Function<double(int)> converts = twice;
  EXPECT_EQ(converts(4), 8.0);
}

TEST(Function, IsEmptyIfItHoldsNothing) {
  EXPECT_FALSE(Function<void()>());
  EXPECT_FALSE(Function<void()>(nullptr));
  EXPECT_FALSE(Function<void()>(std::function<void()>()));
  EXPECT_FALSE(Function<int(int)>(static_cast<int (*)(int)>(nullptr)));
  EXPECT_TRUE(Function<int(int)>(twice));
  const Function<void()> empty;
  EXPECT_FALSE(Function<void()>(empty));
}

TEST(Function, CopiesWhatItHolds) {
  Function<int()> counts = [count = 0]() mutable { return ++count; };
  EXPECT_EQ(counts(), 1);
  Function<int()> copy = counts;
  EXPECT_EQ(counts(), 2);
  EXPECT_EQ(counts(), 3);
  EXPECT_EQ(copy(), 2);
  copy = counts;
  EXPECT_EQ(copy(), 4);
}

TEST(Function, MovesAndReleasesWhatItHolds) {
  const auto shared = std::make_shared<std::string>("held");
  Function<std::size_t()> holds = [shared] { return shared->size(); };
  EXPECT_EQ(shared.use_count(), 2);
  Function<std::size_t()> moved = std::move(holds);
  EXPECT_EQ(shared.use_count(), 2);
  EXPECT_EQ(moved(), 4U);
  moved = nullptr;
  EXPECT_EQ(shared.use_count(), 1);
}

TEST(Function, TakesOnlyWhatCanBeCalledSo) {
  static_assert(std::is_constructible_v<Function<int(int)>, int (*)(int)>);
  static_assert(!std::is_constructible_v<Function<int(int)>, std::string (*)(int)>);
  static_assert(!std::is_constructible_v<Function<int(int)>, int (*)(std::string)>);
  static_assert(!std::is_constructible_v<Function<int(int)>, int>);
}

class Shape {
 public:
  virtual ~Shape() = default;
  virtual int corners() const = 0;
  virtual std::unique_ptr<Shape> clone() const = 0;
};

class Triangle final : public Shape {
 public:
  int corners() const override { return 3; }
  std::unique_ptr<Shape> clone() const override { return std::make_unique<Triangle>(*this); }
};

TEST(ValuePointer, CopiesTheValue) {
  ValuePointer<std::string> original = ValuePointer<std::string>::make("abc");
  const ValuePointer<std::string> copy = original;
  original->push_back('d');
  EXPECT_EQ(*original, "abcd");
  EXPECT_EQ(*copy, "abc");
  original = copy;
  EXPECT_EQ(*original, "abc");
}

TEST(ValuePointer, IsNullByDefaultAndAfterAMove) {
  EXPECT_FALSE(ValuePointer<std::string>());
  EXPECT_FALSE(ValuePointer<std::string>(ValuePointer<std::string>()));
  ValuePointer<std::string> original = ValuePointer<std::string>::make("abc");
  const ValuePointer<std::string> moved = std::move(original);
  EXPECT_TRUE(moved);
  EXPECT_FALSE(original);  // NOLINT(bugprone-use-after-move)
}

TEST(ValuePointer, CopiesByClone) {
  const ValuePointer<Shape> original = std::make_unique<Triangle>();
  const ValuePointer<Shape> copy = original;
  EXPECT_NE(&*copy, &*original);
  EXPECT_EQ(copy->corners(), 3);
}

}  // namespace
}  // namespace hardball::memory_test
