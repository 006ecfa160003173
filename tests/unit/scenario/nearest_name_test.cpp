// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/nearest_name.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace hardball::nearest_name_test {
namespace {

constexpr std::array<std::string_view, 5> kNames{"count", "radius", "mass", "mean_speed", "speed"};

std::string did_you_mean(const std::string& name) {
  return "did you mean '" + name + "'?";
}

TEST(Suggestion, CorrectsMisspellings) {
  EXPECT_EQ(suggestion("raduis", kNames), did_you_mean("radius"));
  EXPECT_EQ(suggestion("radus", kNames), did_you_mean("radius"));
  EXPECT_EQ(suggestion("radii", kNames), did_you_mean("radius"));
  EXPECT_EQ(suggestion("counts", kNames), did_you_mean("count"));
  EXPECT_EQ(suggestion("maas", kNames), did_you_mean("mass"));
  EXPECT_EQ(suggestion("meanspeed", kNames), did_you_mean("mean_speed"));
  EXPECT_EQ(suggestion("maas", kNames, '"'), "did you mean \"mass\"?");
}

TEST(Suggestion, NamesAllWhereNoneIsNear) {
  constexpr std::array<std::string_view, 3> kCommands{"run", "check", "tune"};
  const std::string all = "choose among 'run', 'check', 'tune'";
  EXPECT_EQ(suggestion("sweep", kCommands), all);
  EXPECT_EQ(suggestion("", kCommands), all);
  EXPECT_EQ(suggestion("simulate", kCommands), all);
  EXPECT_EQ(suggestion("rnu", kCommands), did_you_mean("run"));
  EXPECT_EQ(suggestion("chekc", kCommands), did_you_mean("check"));
}

TEST(Suggestion, CountsASwapOfAdjacentLettersOnce) {
  constexpr std::array<std::string_view, 2> kTwo{"xx", "ba"};
  EXPECT_EQ(suggestion("ab", kTwo), did_you_mean("ba"));
}

TEST(Suggestion, TakesTheFirstOfEquallyNearOnes) {
  constexpr std::array<std::string_view, 2> kTwo{"ax", "ay"};
  EXPECT_EQ(suggestion("az", kTwo), did_you_mean("ax"));
}

TEST(Suggestion, ForAVeryLongWordTakesNoTime) {
  const std::array<std::string_view, 2> names{"radius", "radii"};
  EXPECT_EQ(suggestion("radiuss", names), "did you mean 'radius'?");
  EXPECT_EQ(suggestion(std::string(5'000'000, 'r'), names), "choose among 'radius', 'radii'");
}

}  // namespace
}  // namespace hardball::nearest_name_test
