// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/theory/moments.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "hardball/numbers/random.hpp"
#include "unit/theory/gas_moments.hpp"

namespace hardball::moments_test {
namespace {

TEST(Moments, AreThoseOfTheSpheres) {
  World world(Box::walls({10, 20, 30}));
  world.add({{5, 5, 5}, {3, 4, 0}, 1, 7});
  world.add({{5, 9, 5}, {0, 0, 1}, 2, 1});
  const Moments moments = moments_of(world, Time(0));
  EXPECT_EQ(moments.spheres, 2U);
  EXPECT_EQ(moments.volume(), 6000);
  EXPECT_EQ(moments.number_density(), 2.0 / 6000);
  EXPECT_EQ(moments.radius_power, (std::array<double, 6>{1, 1.5, 2.5, 4.5, 8.5, 16.5}));
  EXPECT_EQ(moments.mean_radius(), 1.5);
  EXPECT_EQ(moments.largest_radius, 2);
  EXPECT_EQ(moments.mean_speed, 3);
  EXPECT_DOUBLE_EQ(moments.packing_fraction(), 12 * std::numbers::pi / 6000);
}

TEST(Moments, VolumeOfOpenSpaceFollowsTheCloudAndNotAFewStrays) {
  World world;
  Random random(1);
  for (int i = 0; i < 4000; ++i) {
    world.add({{100 * random.uniform(), 100 * random.uniform(), 100 * random.uniform()}, {}, 0.1, 1});
  }
  for (int i = 0; i < 10; ++i) world.add({{1e9, -1e12, 1e30}, {}, 0.1, 1});
  // The middle half of a uniform distribution, doubled, has a standard error of 2 percent along each axis.
  EXPECT_NEAR(moments_of(world, Time(0)).volume(), 1e6, 2e5);
}

TEST(Moments, OpenSpaceIsMeasuredAtTheGivenTime) {
  World world;
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 place{random.normal(), random.normal(), random.normal()};
    world.add({place, place, 0.001, 1});  // all distances double in a unit of time
  }
  const double before = moments_of(world, Time(0)).extent.x;
  EXPECT_NEAR(moments_of(world, Time(1)).extent.x, 2 * before, 1e-9);
  EXPECT_NEAR(moments_of(world, Time(9)).extent.x, 10 * before, 1e-9);
}

TEST(Moments, OfNothingAreFinite) {
  const Moments moments = moments_of(World(), Time(0));
  EXPECT_EQ(moments.spheres, 0U);
  EXPECT_EQ(moments.mean_speed, 0);
}

TEST(Moments, AreAlikeIfNothingButTheSpeedHasChangedMuch) {
  const Moments moments = support::gas_moments(1000, 0.1, 0.5);
  const auto changed = [&](const auto& change) {
    Moments other = moments;
    change(other);
    return are_alike(other, moments) || are_alike(moments, other);
  };
  EXPECT_TRUE(are_alike(moments, moments));
  EXPECT_TRUE(changed([](Moments& other) { other.mean_speed *= 10; }));
  EXPECT_TRUE(changed([](Moments& other) { other.extent.y *= 1.01; }));
  EXPECT_FALSE(changed([](Moments& other) { other.mean_speed = 0; }));
  EXPECT_FALSE(changed([](Moments& other) { other.spheres += 1; }));
  EXPECT_FALSE(changed([](Moments& other) { other.radius_power[1] *= 1.05; }));
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    EXPECT_FALSE(changed([axis](Moments& other) { other.extent[axis] *= 1.05; }));
  }
}

}  // namespace
}  // namespace hardball::moments_test
