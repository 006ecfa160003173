// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/theory/gas_statistics.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "hardball/numbers/random.hpp"
#include "hardball/theory/kinetic_theory.hpp"
#include "hardball/theory/rest.hpp"
#include "hardball/world/world.hpp"
#include "unit/theory/some_gas.hpp"

namespace hardball::kinetic_theory_test {
namespace {

using support::some_gas;

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

// Carnahan and Starling's contact values at these packing fractions are (Z - 1) / (4 phi), Z as tabulated.
TEST(KineticTheory, MeanFreePathAndTimeAgreeWithTables) {
  const std::array<std::pair<double, double>, 4> kTable = {
      {{0.1, 1.52126}, {0.2, 2.40625}, {0.3, 3.97376}, {0.45, 9.38467}}};
  for (const auto& [packing_fraction, tabulated] : kTable) {
    const GasStatistics statistics = some_gas(1000, packing_fraction, 0.5);
    const double contact = (tabulated - 1) / (4 * packing_fraction);
    EXPECT_NEAR(contact_value(statistics), contact, 1e-4 * contact);
    EXPECT_NEAR(compressibility(statistics), tabulated, 1e-4 * tabulated);
    const double path = 1 / (std::numbers::sqrt2 * std::numbers::pi * statistics.number_density() * contact);
    EXPECT_NEAR(mean_free_path(statistics), path, 1e-4 * path);
    EXPECT_NEAR(mean_free_time(statistics), path / statistics.mean_speed, 1e-4 * path);
  }
  EXPECT_EQ(mean_free_path(some_gas(1, 0.1, 1)), std::numeric_limits<double>::infinity());
  GasStatistics still = some_gas(10, 0.1, 1);
  still.mean_speed = 0;
  EXPECT_EQ(mean_free_time(still), std::numeric_limits<double>::infinity());
}

// The mean over pairs of (r_i + r_j)^2 g_ij, with the published contact value of each pair.
TEST(KineticTheory, ContactValueOfAMixtureIsTheMeanOverItsPairs) {
  const std::vector<double> radii{0.3, 0.5, 0.5, 1.1};
  GasStatistics statistics = some_gas(1000, 0.3, 1);
  statistics.radius_power = {};
  for (const double radius : radii) {
    for (std::size_t k = 0; k < 6; ++k) {
      statistics.radius_power[k] +=
          std::pow(radius, static_cast<double>(k)) / static_cast<double>(radii.size());
    }
  }
  const double sixth_of_density = std::numbers::pi / 6 * statistics.number_density();
  const double xi2 = sixth_of_density * 4 * statistics.radius_power[2];
  const double xi3 = sixth_of_density * 8 * statistics.radius_power[3];
  const double free = 1 - xi3;
  double sum = 0;
  double weight = 0;
  for (const double a : radii) {
    for (const double b : radii) {
      const double h = (2 * a) * (2 * b) / (2 * a + 2 * b);
      const double g = 1 / free + 3 * xi2 / (free * free) * h + 2 * xi2 * xi2 / (free * free * free) * h * h;
      sum += (a + b) * (a + b) * g;
      weight += (a + b) * (a + b);
    }
  }
  EXPECT_NEAR(contact_value(statistics), sum / weight, 1e-12 * sum / weight);
}

TEST(KineticTheory, WallRateIsProportionalToSpeedAndInverselyToTheDistance) {
  EXPECT_EQ(wall_rate(some_gas(100, 0.1, 1)), 0) << "no walls";
  const GasStatistics points = some_gas(1000, 1e-15, 0.5, Boundary::wall);
  EXPECT_NEAR(wall_rate(points) * points.extent.x, 3.0 / 2, 1e-4)
      << "three pairs, half the mean speed along each axis";
  // Dilute: the accessible length is less by a diameter, and the density at the wall is that inside times 1 +
  // 4 phi.
  const GasStatistics dilute = some_gas(100000, 1e-3, 0.5, Boundary::wall);
  EXPECT_NEAR(wall_rate(dilute) * (dilute.extent.x - 1), 1.5 * (1 + 4e-3), 1e-4);
}

// At low density a sphere excludes others from eight times its volume, a touching pair from 8 + 8 - 2.5 times
// a sphere's; the partner is counted.
TEST(KineticTheory, ExcessAboutASphereIsTheVolumeItExcludes) {
  const double packing = 1e-5;
  const GasStatistics statistics = some_gas(1000, packing, 0.5);
  EXPECT_NEAR(excess_about_sphere(statistics), -8 * packing, 1e-7);
  EXPECT_NEAR(excess_about_pair(statistics) - 1, -13.5 * packing, 1e-7);
}

TEST(KineticTheory, ExcessOfTheDenseFluidIsOneSphereLess) {
  const GasStatistics statistics = some_gas(1000, 0.45, 0.5);
  EXPECT_NEAR(excess_about_sphere(statistics), -1, 0.03);
  EXPECT_NEAR(excess_about_pair(statistics), -1, 0.15);
}

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
}  // namespace hardball::kinetic_theory_test
