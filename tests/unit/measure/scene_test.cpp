// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

#include "hardball/world/curve_order.hpp"
#include "support/gas.hpp"

namespace hardball::scene_test {
namespace {

TEST(Scene, ComputesEverythingOnce) {
  const World world = support::make_gas({.count = 50});
  const Scene scene(world, Time(0));
  EXPECT_EQ(&scene.species(), &scene.species());
  EXPECT_EQ(&scene.fluid(), &scene.fluid());
  EXPECT_EQ(&scene.statistics(), &scene.statistics());
  EXPECT_EQ(&scene.thermal_motion(), &scene.thermal_motion());
  EXPECT_EQ(&scene.centers(), &scene.centers());
  EXPECT_EQ(&scene.surroundings(), &scene.surroundings());
}

TEST(Scene, HoldsCurrentCentersInTheOrderOfIds) {
  World world = support::make_gas({.count = 50});
  const Time now(0.01);
  world.reorder(order_along_curve(world, now));
  const Scene scene(world, now);
  ASSERT_EQ(scene.centers().size(), world.size());
  for (SphereId id = 0; id < world.size(); ++id) {
    EXPECT_EQ(scene.centers()[id], world.position(world.slot_of(id), now));
    EXPECT_EQ(world.slot_of_rank(id), world.slot_of(id));
  }
}

// Whatever the range, shorter than the cells of the neighborhood or as long as the box.
TEST(Scene, HasTheNeighborQueryOfAllPairs) {
  const World world = support::make_gas({.count = 60, .packing_fraction = 0.1});
  const Scene scene(world, Time(0));
  const double edge = world.box().size().x;
  for (const double range : {0.01 * edge, 0.2 * edge, 0.49 * edge}) {
    std::set<std::pair<std::size_t, std::size_t>> expected;
    std::set<std::pair<std::size_t, std::size_t>> found;
    for (std::size_t a = 0; a < world.size(); ++a) {
      for (std::size_t b = 0; b < world.size(); ++b) {
        Vec3 separation = scene.centers()[b] - scene.centers()[a];
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
          separation[axis] -= edge * std::round(separation[axis] / edge);
        }
        if (a != b && length(separation) <= range) expected.emplace(a, b);
      }
      scene.surroundings().for_each_neighbor(
          a, range, [&](std::size_t b, const Vec3&, double) { EXPECT_TRUE(found.emplace(a, b).second); });
    }
    EXPECT_EQ(found, expected) << range;
  }
}

}  // namespace
}  // namespace hardball::scene_test
