// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/tuning/size_classes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hardball/broadphase/large_sizes.hpp"
#include "hardball/tuning/cell_edge.hpp"

namespace hardball::size_classes_test {
namespace {

// Some spheres of radius 2 among others of radius .1, in a periodic cube.
World mixture(double size, int large) {
  World world(Box::periodic({size, size, size}));
  for (int i = 0; i < large; ++i) {
    world.add({{2.5 + 5 * (i % 6), 2.5 + 5 * (i / 6 % 6), 2.5}, {1, 0, 0}, 2, 1});
  }
  for (int i = 0; i < 1000; ++i) {
    world.add({{0.5 + i % 10, 0.5 + i / 10 % 10, 6 + 0.5 * (i / 100)}, {0, 1, 0}, 0.1, 1});
  }
  return world;
}

TEST(SizeClasses, HoldEverySphereOnce) {
  const World world = mixture(32, 3);
  const std::vector<SizeClass> classes = size_classes(world, Time(0));
  ASSERT_EQ(classes.size(), 2U);
  EXPECT_EQ(classes[0].spheres, 1000);
  EXPECT_NEAR(classes[0].radius, 0.1, 1e-12);
  EXPECT_EQ(classes[1].spheres, 3);
  EXPECT_NEAR(classes[1].mean_speed, 1, 1e-12);
}

// The prediction counts those spheres as large that the grid does: the cost has a step where it does.
TEST(SizeClasses, AreLargeWhereTheGridSaysSo) {
  const World world = mixture(32, 36);
  const GasStatistics statistics = gas_statistics(world, Time(0));
  const std::vector<SizeClass> classes = size_classes(world, Time(0));
  const double border = 2 / LargeSizes::kLargestInRows;
  EXPECT_TRUE(LargeSizes::in(world, Subdivision(world.box(), 0.96 * border)));
  EXPECT_FALSE(LargeSizes::in(world, Subdivision(world.box(), 1.06 * border)));
  const double below = cost_rate_by_class(statistics, classes, border * (1 - 1e-9), {});
  const double above = cost_rate_by_class(statistics, classes, border * (1 + 1e-9), {});
  EXPECT_GT(std::abs(above / below - 1), 0.01);
}

TEST(SizeClasses, HaveTheBestEdge) {
  const World world = mixture(32, 3);
  const GasStatistics statistics = gas_statistics(world, Time(0));
  const std::vector<SizeClass> classes = size_classes(world, Time(0));
  const BestLength best = best_edge(world, Time(0), statistics, {});
  EXPECT_EQ(best.length, optimal_edge_by_class(statistics, classes));
  EXPECT_EQ(best.cost, cost_rate_by_class(statistics, classes, best.length, {}));
}

TEST(SizeClasses, AreIgnoredWhereSizesAreAlikeOrTheBoxIsSmall) {
  World alike = mixture(32, 0);
  const GasStatistics statistics = gas_statistics(alike, Time(0));
  EXPECT_EQ(best_edge(alike, Time(0), statistics, {}).length, best_cell_edge(statistics, {}).length);
  const World small = mixture(11.5, 2);
  const GasStatistics moments_in_small = gas_statistics(small, Time(0));
  EXPECT_GT(best_edge(small, Time(0), moments_in_small, {}).length, 0);
}

}  // namespace
}  // namespace hardball::size_classes_test
