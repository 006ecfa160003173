// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/nearest_name.hpp"

#include <gtest/gtest.h>

#include <array>

namespace hardball {
namespace {

constexpr std::array<std::string_view, 5> kNames{"count", "radius", "mass", "mean_speed", "speed"};

TEST(NearestName, ForgivesSlips) {
  EXPECT_EQ(nearest_name("raduis", kNames), "radius");
  EXPECT_EQ(nearest_name("radus", kNames), "radius");
  EXPECT_EQ(nearest_name("counts", kNames), "count");
  EXPECT_EQ(nearest_name("maas", kNames), "mass");
  EXPECT_EQ(nearest_name("meanspeed", kNames), "mean_speed");
}

TEST(NearestName, FindsTheWordItself) {
  for (const std::string_view name : kNames) EXPECT_EQ(nearest_name(name, kNames), name);
}

TEST(NearestName, CountsAnExchangeOfNeighboursOnce) {
  constexpr std::array<std::string_view, 2> kTwo{"xx", "ba"};
  EXPECT_EQ(nearest_name("ab", kTwo), "ba");
}

TEST(NearestName, TakesTheFirstOfEquallyNearOnes) {
  constexpr std::array<std::string_view, 2> kTwo{"ax", "ay"};
  EXPECT_EQ(nearest_name("az", kTwo), "ax");
  EXPECT_EQ(nearest_name("", kTwo), "ax");
}

}  // namespace
}  // namespace hardball
