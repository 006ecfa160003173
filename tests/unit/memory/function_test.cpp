// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/memory/function.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

namespace hardball::function_test {
namespace {

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

}  // namespace
}  // namespace hardball::function_test
