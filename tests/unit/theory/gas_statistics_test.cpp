// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/theory/gas_statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "hardball/numbers/random.hpp"
#include "unit/theory/some_gas.hpp"

namespace hardball::moments_test {
namespace {

TEST(GasStatistics, AreThoseOfTheSpheres) {
  World world(Box::walls({10, 20, 30}));
  world.add({{5, 5, 5}, {3, 4, 0}, 1, 7});
  world.add({{5, 9, 5}, {0, 0, 1}, 2, 1});
  const GasStatistics statistics = gas_statistics(world, Time(0));
  EXPECT_EQ(statistics.spheres, 2U);
  EXPECT_EQ(statistics.volume(), 6000);
  EXPECT_EQ(statistics.number_density(), 2.0 / 6000);
  EXPECT_EQ(statistics.radius_power, (std::array<double, 6>{1, 1.5, 2.5, 4.5, 8.5, 16.5}));
  EXPECT_EQ(statistics.mean_radius(), 1.5);
  EXPECT_EQ(statistics.largest_radius, 2);
  EXPECT_EQ(statistics.mean_speed, 3);
  EXPECT_DOUBLE_EQ(statistics.packing_fraction(), 12 * std::numbers::pi / 6000);
}

TEST(GasStatistics, VolumeOfOpenSpaceFollowsTheCloudAndNotAFewStrays) {
  World world;
  Random random(1);
  for (int i = 0; i < 4000; ++i) {
    world.add({{100 * random.uniform(), 100 * random.uniform(), 100 * random.uniform()}, {}, 0.1, 1});
  }
  for (int i = 0; i < 10; ++i) world.add({{1e9, -1e12, 1e30}, {}, 0.1, 1});
  // The middle half of a uniform distribution, doubled, has a standard error of 2 percent along each axis.
  EXPECT_NEAR(gas_statistics(world, Time(0)).volume(), 1e6, 2e5);
}

TEST(GasStatistics, OpenSpaceIsMeasuredAtTheGivenTime) {
  World world;
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 place{random.normal(), random.normal(), random.normal()};
    world.add({place, place, 0.001, 1});  // all distances double in a unit of time
  }
  const double before = gas_statistics(world, Time(0)).extent.x;
  EXPECT_NEAR(gas_statistics(world, Time(1)).extent.x, 2 * before, 1e-9);
  EXPECT_NEAR(gas_statistics(world, Time(9)).extent.x, 10 * before, 1e-9);
}

TEST(GasStatistics, OfNothingAreFinite) {
  const GasStatistics statistics = gas_statistics(World(), Time(0));
  EXPECT_EQ(statistics.spheres, 0U);
  EXPECT_EQ(statistics.mean_speed, 0);
}

TEST(GasStatistics, AreAlikeIfNothingButTheSpeedHasChangedMuch) {
  const GasStatistics statistics = support::some_gas(1000, 0.1, 0.5);
  const auto changed = [&](const auto& change) {
    GasStatistics other = statistics;
    change(other);
    return are_alike(other, statistics) || are_alike(statistics, other);
  };
  EXPECT_TRUE(are_alike(statistics, statistics));
  EXPECT_TRUE(changed([](GasStatistics& other) { other.mean_speed *= 10; }));
  EXPECT_TRUE(changed([](GasStatistics& other) { other.extent.y *= 1.01; }));
  EXPECT_FALSE(changed([](GasStatistics& other) { other.mean_speed = 0; }));
  EXPECT_FALSE(changed([](GasStatistics& other) { other.spheres += 1; }));
  EXPECT_FALSE(changed([](GasStatistics& other) { other.radius_power[1] *= 1.05; }));
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    EXPECT_FALSE(changed([axis](GasStatistics& other) { other.extent[axis] *= 1.05; }));
  }
}

}  // namespace
}  // namespace hardball::moments_test
