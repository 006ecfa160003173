// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "bench/time_stepped.hpp"

#include <gtest/gtest.h>

namespace hardball::bench::time_stepped_test {
namespace {

World two_spheres(const Vec3& first_velocity, const Vec3& second_velocity) {
  World world(Box::walls({20, 10, 10}));
  world.add({.position = {5, 5, 5}, .velocity = first_velocity, .radius = 1});
  world.add({.position = {8, 5, 5}, .velocity = second_velocity, .radius = 1});
  return world;
}

TEST(TimeStepped, ResolvesACollisionOnce) {
  TimeStepped simulation(two_spheres({1, 0, 0}, {}), Time(0));
  EXPECT_EQ(simulation.step(0.9), 0U) << "not there yet";
  EXPECT_EQ(simulation.step(0.2), 1U);
  EXPECT_EQ(simulation.step(0.05), 0U) << "they overlap but part";
}

TEST(TimeStepped, StepsOverACollisionThatIsTooShort) {
  TimeStepped simulation(two_spheres({10, 0, 0}, {}), Time(0));
  EXPECT_EQ(simulation.step(0.6), 0U);
}

TEST(TimeStepped, ReflectsAtWalls) {
  // The first goes to the wall at 0 and back, and meets the second where it was.
  TimeStepped simulation(two_spheres({-4, 0, 0}, {}), Time(0));
  EXPECT_EQ(simulation.step(1), 0U);
  EXPECT_EQ(simulation.step(1), 0U);
  EXPECT_EQ(simulation.step(0.4), 1U);
}

}  // namespace
}  // namespace hardball::bench::time_stepped_test
