// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/surfaces/cone.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "hardball/errors/error.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/surfaces/surface.hpp"
#include "hardball/world/walls.hpp"

namespace hardball::cone_test {
namespace {

constexpr double kSlope = 0.75;  // the wall has the direction (3, 4) / 5

Surface funnel() {
  return Surface(Cone({0, 0, 1}, kSlope), {});
}

TEST(Cone, IsAsFarAsItsWall) {
  EXPECT_DOUBLE_EQ(funnel().distance({0, 0, 5}, Time(0)), 3);
  EXPECT_NEAR(funnel().distance({3, 0, 4}, Time(0)), 0, 1e-15);
  EXPECT_DOUBLE_EQ(funnel().distance({6, 0, 4}, Time(0)), -2.4);
  const Vec3 direction = funnel().direction({1, 0, 5}, Time(0));
  EXPECT_NEAR(direction.x, 0.8, 1e-15);
  EXPECT_NEAR(direction.z, -0.6, 1e-15);
}

TEST(Cone, IsMetFromInside) {
  const Path across{{0, 0, 5}, {1, 0, 0}, Time(0)};
  // At the distance 3 - 0.8 x from the wall, less the radius.
  EXPECT_NEAR(funnel().contact_time({}, across, 1).value(), 2.5, 1e-15);
  const Path upwards{{1, 0, 5}, {0, 0, 1}, Time(0)};
  EXPECT_EQ(funnel().contact_time({}, upwards, 1), kNever);
}

// On the axis all directions are alike, and squares only touch.
TEST(Cone, HoldsASphereThatComesDownItsAxis) {
  const Path down{{0, 0, 5}, {0, 0, -1}, Time(0)};
  const double least_height = 1 / 0.6;
  EXPECT_NEAR(funnel().contact_time({}, down, 1).value(), 5 - least_height, 1e-14);
  World world(Box::walls({10, 10, 10}), {}, {Surface(Cone({0, 0, 1}, kSlope), {5, 5, 0})});
  world.add({.position = {5, 5, 5}, .velocity = {0, 0, -1}, .radius = 1});
  Simulation simulation(world);
  simulation.run_until(6);
  EXPECT_GT(simulation.velocity(0).z, 0);
}

// A sphere that fills the cone around the apex is on the axis but for rounding: yet its directions to the
// wall are perpendicular to it, and what it is told of an approach agrees with them.
TEST(Cone, HasDirectionsRightNextToItsAxis) {
  const double length_of_axis = std::sqrt(1 + 0.3 * 0.3);
  const Vec3 axis{1 / length_of_axis, 0.3 / length_of_axis, 0};
  const Vec3 across{-axis.y, axis.x, 0};
  const double secant = std::sqrt(1 + kSlope * kSlope);
  const Surface cone(Cone(axis, kSlope), {});
  const Surface tube(Cylinder(axis, 1), {});
  for (const double along : {1.0, 300.0, 2e6}) {
    const Vec3 on_axis = along * axis;
    for (int steps = -20; steps <= 20; ++steps) {
      const Vec3 position{on_axis.x, on_axis.y + steps * 0x1p-52 * along, 0};
      // The products are exact in long double.
      const long double aside =
          static_cast<long double>(position.y) * axis.x - static_cast<long double>(position.x) * axis.y;
      if (std::fabs(aside) < 1e-18 * along) continue;
      const double side = aside > 0 ? 1 : -1;
      const Vec3 expected = (1 / secant) * (side * across - kSlope * axis);
      EXPECT_NEAR(length(cone.direction(position, Time(0)) - expected), 0, 1e-9) << along << ", " << steps;
      EXPECT_NEAR(length(tube.direction(position, Time(0)) - side * across), 0, 1e-9);
      // Touching, and sliding along the wall a little outwards or inwards.
      const double radius = cone.distance(position, Time(0));
      for (const double speed : {1e-6, -1e-6}) {
        const Vec3 velocity = side * kSlope * across + axis + speed * expected;
        EXPECT_EQ(cone.is_approached(Motion(), {position, velocity, Time(0)}, radius), speed > 0);
      }
    }
  }
}

TEST(Cone, LeavesRoomBetweenTheFacesOfTheBox) {
  const World world(Box::walls({10, 10, 4}), {}, {Surface(Cone({0, 0, 1}, kSlope), {5, 5, -2})});
  const double frustum = std::numbers::pi / 3 * kSlope * kSlope * (6 * 6 * 6 - 2 * 2 * 2);
  EXPECT_DOUBLE_EQ(accessible_volume(world), frustum);
  const World wedge(Box::flat_walls(10, 4), {}, {Surface(Cone({0, -1, 0}, kSlope), {5, 4, 0})});
  EXPECT_DOUBLE_EQ(accessible_volume(wedge), kSlope * 16);
}

TEST(Cone, IsRefusedWhereItCannotBe) {
  EXPECT_THROW(Surface(Cone({0, 0, 1}, 0), {}), Error);
  EXPECT_THROW(Surface(Cone({0, 0, 2}, 1), {}), Error);
  EXPECT_THROW(World(Box::periodic({9, 9, 9}), {}, {funnel()}), Error);
  EXPECT_THROW(World(Box::flat_walls(9, 9), {}, {funnel()}), Error);
}

}  // namespace
}  // namespace hardball::cone_test
