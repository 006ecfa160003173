// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "hardball/world/curve_order.hpp"
#include "support/crystal.hpp"
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

TEST(NeighborQuery, OfASphereInACrystalAreItsShells) {
  const World world = support::make_crystal(support::simple_cubic(), 5, 1.1);
  constexpr double kRange = 2;
  const Scene scene(world, Time(0));
  const NeighborQuery& surroundings = scene.surroundings();
  surroundings.for_each_center(kRange, [&](std::size_t center) {
    std::size_t first = 0;
    std::size_t second = 0;
    std::size_t third = 0;
    surroundings.for_each_neighbor(center, kRange,
                                   [&](std::size_t neighbor, const Vec3& separation, double square) {
                                     EXPECT_NE(neighbor, center);
                                     EXPECT_EQ(square, dot(separation, separation));
                                     const double shell = square / (1.1 * 1.1);
                                     first += std::fabs(shell - 1) < 1e-9;
                                     second += std::fabs(shell - 2) < 1e-9;
                                     third += std::fabs(shell - 3) < 1e-9;
                                     EXPECT_LT(shell, 3.001);
                                   });
    EXPECT_EQ(first, 6U);
    EXPECT_EQ(second, 12U);
    EXPECT_EQ(third, 8U);
  });
}

TEST(NeighborQuery, HoldTheImagesOfASphereInASmallBox) {
  World world(Box::periodic({1.1, 1.1, 5}));
  world.add({.position = {0.3, 0.3, 1}, .radius = 0.5});
  const Scene scene(world, Time(0));
  std::size_t images = 0;
  scene.surroundings().for_each_neighbor(0, 1.2, [&](std::size_t neighbor, const Vec3& separation, double) {
    EXPECT_EQ(neighbor, 0U);
    EXPECT_NEAR(length(separation), 1.1, 1e-12);
    ++images;
  });
  EXPECT_EQ(images, 4U);
}

TEST(NeighborQuery, AreWhereSpheresHaveMovedTo) {
  World world;
  world.add({.position = {0, 0, 0}, .velocity = {1, 0, 0}});
  world.add({.position = {9, 0, 0}, .velocity = {-1, 0, 0}});
  const auto pairs_at = [&](double time) {
    constexpr double kRange = 4;
    const Scene scene(world, Time(time));
    const NeighborQuery& surroundings = scene.surroundings();
    int pairs = 0;
    surroundings.for_each_center(kRange, [&](std::size_t center) {
      surroundings.for_each_neighbor(center, kRange, [&](auto&&...) { ++pairs; });
    });
    return pairs;
  };
  EXPECT_EQ(pairs_at(2), 0);
  EXPECT_EQ(pairs_at(3), 2);
}

TEST(NeighborQuery, OfManySpheresAreThoseOfSomeEvenlyChosen) {
  World world(Box::periodic({100, 100, 100}));
  constexpr std::size_t kSpheres = 3 * NeighborQuery::kMaxCenters;
  Random random(52);
  for (std::size_t i = 0; i < kSpheres; ++i) {
    world.add({.position = 100 * Vec3{random.uniform(), random.uniform(), random.uniform()}, .radius = 0.1});
  }
  const Scene scene(world, Time(0));
  const auto centers_within = [&](double range) {
    std::vector<std::size_t> centers;
    scene.surroundings().for_each_center(range, [&](std::size_t center) { centers.push_back(center); });
    return centers;
  };
  const std::vector<std::size_t> few = centers_within(1);
  ASSERT_EQ(few.size(), NeighborQuery::kMaxCenters);
  for (std::size_t k = 0; k < few.size(); ++k) EXPECT_EQ(few[k], 3 * k);
  // With 2000 neighbors each, 100 spheres are chosen.
  const double range = std::cbrt(2000 * 1e6 / kSpheres * 3 / (4 * std::numbers::pi));
  EXPECT_NEAR(static_cast<double>(centers_within(range).size()), NeighborQuery::kMaxNeighbors / 2000, 1);
}

}  // namespace
}  // namespace hardball::scene_test
