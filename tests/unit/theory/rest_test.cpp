// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/theory/rest.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hardball/world/world.hpp"

namespace hardball::rest_test {
namespace {

constexpr double kGravity = 10;
constexpr double kDiameter = 0.4;

World thrown(const Vec3& velocity, std::size_t at_rest) {
  World world(Box({Boundary::open, Boundary::open, Boundary::open}, {}), {0, 0, -kGravity});
  world.add({.position = {0, 0, 100}, .velocity = velocity, .radius = kDiameter / 2});
  for (std::size_t k = 0; k < at_rest; ++k)
    world.add({.position = {1.0 + static_cast<double>(k), 0, 0}, .radius = kDiameter / 2});
  return world;
}

bool is_reached(const World& world, double time) {
  const Totals start = totals_of(world, Time(0));
  const Rest rest(start, world.size(), false, kGravity);
  return rest.is_reached(totals_of(world, Time(time)));
}

TEST(Rest, LooksAtMultiplesOfAnIntervalAlone) {
  const Rest rest(totals_of(thrown({}, 0), Time(0)), 1, false, kGravity);
  const double interval = 2 * std::sqrt(kDiameter / kGravity);
  EXPECT_DOUBLE_EQ(rest.next_look(0), interval);
  EXPECT_FALSE(rest.is_time_to_look(0)) << "what hangs in the air is not at rest";
  double now = 0;
  for (int k = 1; k < 1000; ++k) {
    EXPECT_FALSE(rest.is_time_to_look(now + interval / 3));
    const double next = rest.next_look(now + interval / 3);
    EXPECT_EQ(next, rest.next_look(now));
    EXPECT_TRUE(rest.is_time_to_look(next));
    now = next;
  }
}

TEST(Rest, NeedsEverySphereToBeSlow) {
  const double fast = std::sqrt(kGravity * kDiameter);
  EXPECT_TRUE(is_reached(thrown({}, 1000), 0));
  EXPECT_TRUE(is_reached(thrown({0.5 * fast, 0, 0}, 1000), 0));
  EXPECT_FALSE(is_reached(thrown({0.7 * fast, 0, 0}, 1000), 0)) << "one is fast";
  EXPECT_FALSE(is_reached(thrown({0.5 * fast, 0, 0}, 1), 0)) << "they are fast on average";
  // At the top of its flight a sphere is slow.
  EXPECT_FALSE(is_reached(thrown({0, 0, fast}, 0), fast / kGravity));
}

}  // namespace
}  // namespace hardball::rest_test
