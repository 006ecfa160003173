// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/tuning/cell_edge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "hardball/world/random.hpp"

namespace hardball {
namespace {

Moments gas(std::size_t spheres, double packing_fraction, double radius) {
  Moments moments;
  moments.spheres = spheres;
  moments.mean_radius = moments.largest_radius = radius;
  moments.mean_square_radius = radius * radius;
  moments.mean_cube_radius = radius * radius * radius;
  moments.mean_speed = 1;
  moments.volume =
      static_cast<double>(spheres) * 4 * std::numbers::pi / 3 * moments.mean_cube_radius / packing_fraction;
  return moments;
}

// What a sphere costs in unit time with cells of edge L, up to a constant: at each collision, all spheres in
// its cells are looked at; at each crossing, the new row of cells is entered and another left.
double cost(const Moments& moments, const UnitCosts& costs, double edge) {
  const double density = moments.number_density();
  const double diameter = 2 * moments.mean_radius;
  const double speed = moments.mean_speed;
  const double candidates = density * std::pow(edge + 2 * diameter, 3);
  const double collisions = speed / moments.mean_free_path() * candidates * costs.prediction;
  const double cells_entered = std::pow(1 + diameter / edge, 2);
  const double new_candidates = density * edge * std::pow(edge + 2 * diameter, 2);
  return collisions + 3 * speed / (2 * edge) *
                          (cells_entered * costs.cell_update + new_candidates * costs.prediction +
                           3 * costs.queue_operation);
}

TEST(OptimalCellEdge, IsWhereTheCostIsLeast) {
  for (const double packing_fraction : {1e-6, 1e-3, 0.02, 0.1, 0.3, 0.5}) {
    for (const double radius : {1e-9, 0.5, 1e6}) {
      for (const double update : {0.5, 8.0, 60.0}) {
        const Moments moments = gas(10000, packing_fraction, radius);
        UnitCosts costs;
        costs.cell_update = update;
        const double edge = optimal_cell_edge(moments, costs);
        const double least = cost(moments, costs, edge);
        // The minimum is flat: a thousandth away the cost differs by some 1e-7, which doubles resolve.
        EXPECT_LT(least, cost(moments, costs, 1.001 * edge));
        EXPECT_LT(least, cost(moments, costs, edge / 1.001));
        for (double other = edge / 64; other < 64 * edge; other *= 1.1) {
          EXPECT_LE(least, cost(moments, costs, other) * (1 + 1e-12));
        }
      }
    }
  }
}

TEST(OptimalCellEdge, GrowsAsTheGasThins) {
  double last = 0;
  for (double packing_fraction = 0.5; packing_fraction > 1e-9; packing_fraction /= 3) {
    const double edge = optimal_cell_edge(gas(1000, packing_fraction, 0.5));
    EXPECT_GT(edge, last);
    last = edge;
  }
}

TEST(OptimalCellEdge, IsAPositiveNumberForAnyWorld) {
  EXPECT_GT(optimal_cell_edge(moments_of(World(), Time(0))), 0);
  World world;
  world.add({{1, 2, 3}, {}, 1e-30, 1});
  for (int i = 0; i < 4; ++i) {
    const double edge = optimal_cell_edge(moments_of(world, Time(0)));
    EXPECT_GT(edge, 0);
    EXPECT_LT(edge, std::numeric_limits<double>::infinity());
    EXPECT_GE(edge, world.largest_radius() / 4) << "large spheres are not spread over too many cells";
    world.add({{1e10 * (i + 1), 0, 0}, {1, 0, 0}, std::pow(10, 3 * i), 1});
  }
}

TEST(Moments, AreThoseOfTheSpheres) {
  World world(Box::walls({10, 20, 30}));
  world.add({{5, 5, 5}, {3, 4, 0}, 1, 7});
  world.add({{5, 9, 5}, {0, 0, 1}, 2, 1});
  const Moments moments = moments_of(world, Time(0));
  EXPECT_EQ(moments.spheres, 2U);
  EXPECT_EQ(moments.volume, 6000);
  EXPECT_EQ(moments.mean_radius, 1.5);
  EXPECT_EQ(moments.mean_square_radius, 2.5);
  EXPECT_EQ(moments.mean_cube_radius, 4.5);
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
  // The middle half of a uniform distribution, doubled, has a standard error of 2 per cent along each axis.
  EXPECT_NEAR(moments_of(world, Time(0)).volume, 1e6, 2e5);
}

// Carnahan and Starling's contact values at these packing fractions are (Z - 1) / (4 phi), Z as tabulated.
TEST(Moments, MeanFreePathAndTimeAreThoseOfKineticTheory) {
  const std::array<std::pair<double, double>, 4> kTable = {
      {{0.1, 1.52126}, {0.2, 2.40625}, {0.3, 3.97376}, {0.45, 9.38467}}};
  for (const auto& [packing_fraction, compressibility] : kTable) {
    const Moments moments = gas(1000, packing_fraction, 0.5);
    const double contact_value = (compressibility - 1) / (4 * packing_fraction);
    EXPECT_NEAR(moments.contact_value(), contact_value, 1e-4 * contact_value);
    const double path =
        1 / (std::numbers::sqrt2 * std::numbers::pi * moments.number_density() * contact_value);
    EXPECT_NEAR(moments.mean_free_path(), path, 1e-4 * path);
    EXPECT_NEAR(moments.mean_free_time(), path / moments.mean_speed, 1e-4 * path);
  }
  EXPECT_EQ(gas(1, 0.1, 1).mean_free_path(), std::numeric_limits<double>::infinity());
  Moments still = gas(10, 0.1, 1);
  still.mean_speed = 0;
  EXPECT_EQ(still.mean_free_time(), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace hardball
