// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Walls that stand for several surfaces.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "hardball/scenario/scenario.hpp"
#include "hardball/world/walls.hpp"
#include "support/refusal.hpp"

namespace hardball::joined_walls_test {
namespace {

const double kPi = std::numbers::pi;

Scenario scenario_with(const std::string& wall) {
  return parse_scenario(
      "[box]\nboundary = ['open', 'open', 'open']\n[[spheres]]\nradius = 0.1\npositions = [[1.5, 0, 0.5]]\n"
      "velocities = [[0, 0, 0]]\n[[walls]]\n" +
          wall,
      "gas.toml");
}

World world_with(const std::string& wall) {
  const Scenario scenario = scenario_with(wall);
  std::vector<Surface> surfaces;
  for (const SurfaceDescription& description : scenario.surfaces) surfaces.push_back(description.surface);
  return World(Box::open(), {}, surfaces);
}

TEST(JoinedWalls, OfATruncatedConeAreAConeAndTwoPlanes) {
  const std::string text =
      "shape = 'truncated_cone'\npoint = [1, 2, 0]\naxis = [0, 0, 2]\nheight = 4\nrestitution = 0.5\n";
  for (const bool widens : {true, false}) {
    const World world = world_with(
        text + (widens ? "bottom_radius = 1\ntop_radius = 3" : "bottom_radius = 3\ntop_radius = 1"));
    ASSERT_EQ(world.surfaces().size(), 3U);
    EXPECT_EQ(world.surfaces()[1].material().restitution, 0.5);
    EXPECT_NEAR(accessible_volume(world), kPi / 3 * 4 * (1 + 3 + 9), 1e-13);
    const double secant = std::sqrt(1.25);
    const auto distance = [&](const Vec3& place) { return distance_to_surfaces(world, place, Time(0)); };
    EXPECT_NEAR(distance({1, 2, 0.5}), 0.5, 1e-15);
    EXPECT_NEAR(distance({1, 2, 3.75}), 0.25, 1e-15);
    EXPECT_NEAR(distance({2.5, 2, 2}), 0.5 / secant, 1e-15);
    EXPECT_LT(distance({widens ? 3.0 : 1.0, 2, widens ? 1 : 4.5}), 0);
  }
}

TEST(JoinedWalls, OfAShellAreTwoSpheres) {
  const World world =
      world_with("shape = 'shell'\npoint = [0, 0, 1]\nradius = 3\ninner_radius = 2\nvelocity = [0, 0, 1]");
  ASSERT_EQ(world.surfaces().size(), 2U);
  EXPECT_EQ(world.surfaces()[1].velocity(), (Vec3{0, 0, 1}));
  EXPECT_NEAR(accessible_volume(world), 4 * kPi / 3 * (27 - 8), 1e-13);
  EXPECT_NEAR(distance_to_surfaces(world, {2.25, 0, 1}, Time(0)), 0.25, 1e-15);
  EXPECT_NEAR(distance_to_surfaces(world, {0, 0, 3.9}, Time(0)), 0.1, 1e-15);
}

TEST(JoinedWalls, OfAnAnnulusAreATubeAPillarAndTwoPlanes) {
  const World world = world_with(
      "shape = 'annulus'\npoint = [1, 2, 0]\naxis = [0, 0, 1]\nradius = 3\ninner_radius = 1\nheight = 4");
  ASSERT_EQ(world.surfaces().size(), 4U);
  EXPECT_NEAR(accessible_volume(world), kPi * 4 * (9 - 1), 1e-13);
  EXPECT_NEAR(distance_to_surfaces(world, {3.5, 2, 2}, Time(0)), 0.5, 1e-15);
  EXPECT_NEAR(distance_to_surfaces(world, {2.25, 2, 2}, Time(0)), 0.25, 1e-15);
  EXPECT_NEAR(distance_to_surfaces(world, {3, 2, 3.9}, Time(0)), 0.1, 1e-15);
}

TEST(JoinedWalls, AreRefusedWithoutRoom) {
  const auto refused = [](const std::string& wall) {
    return support::refusal_of([&] { scenario_with(wall); });
  };
  EXPECT_NE(refused("shape = 'shell'\npoint = [0, 0, 0]\nradius = 2\ninner_radius = 2").find("smaller"),
            std::string::npos);
  EXPECT_NE(refused("shape = 'truncated_cone'\npoint = [0, 0, 0]\naxis = [0, 0, 1]\nheight = 1\n"
                    "bottom_radius = 1\ntop_radius = 1")
                .find("give a cylinder"),
            std::string::npos);
}

// Planes across the axis end what encloses spheres, in any direction.
TEST(AccessibleVolume, IsThatBetweenPlanes) {
  const Vec3 axis{0.6, 0, 0.8};
  const auto volume = [](const Box& box, std::vector<Surface> surfaces) {
    return accessible_volume(World(box, {}, std::move(surfaces)));
  };
  const Surface tube(Cylinder(axis, 2), {1, 1, 1});
  const Surface low(Plane(axis), -1 * axis);
  const Surface high(Plane(-axis), 3 * axis);
  EXPECT_NEAR(volume(Box::open(), {tube, low, high}), 4 * kPi * 4, 1e-13);
  EXPECT_NEAR(volume(Box::open(), {high, low, tube, Surface(Obstacle(0.5), {1, 1, 1})}),
              4 * kPi * 4 - kPi / 6, 1e-13);
  EXPECT_TRUE(std::isnan(volume(Box::open(), {tube, low})));
  const Surface piston(Plane(-axis), 3 * axis, -0.1 * axis);
  EXPECT_TRUE(std::isnan(volume(Box::open(), {tube, low, piston}))) << "it changes";
  EXPECT_TRUE(std::isnan(volume(Box::open(), {tube, low, Surface(Plane({0, 0, -1}), {0, 0, 5})})));
  // Nearly a tube, whose volume keeps its digits.
  const Surface slim(Cone({0, 0, 1}, 1e-9), {0, 0, -1e9});
  EXPECT_NEAR(
      volume(Box::open(), {slim, Surface(Plane({0, 0, 1}), {}), Surface(Plane({0, 0, -1}), {0, 0, 2})}),
      kPi * 2 * (1 + 2e-9), 1e-13);
}

}  // namespace
}  // namespace hardball::joined_walls_test
