// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/tuning/cell_edge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "hardball/broadphase/subdivision.hpp"
#include "unit/theory/some_gas.hpp"

namespace hardball::cell_edge_test {
namespace {

using support::some_gas;

double cost_at(const GasStatistics& statistics, double edge, const UnitCosts& costs) {
  return cost_rate(expected_counts(statistics, edge), costs);
}

TEST(CostRate, AddsUpTheCostsOfAllSteps) {
  CellCounts counts;
  counts.collision = 2;
  counts.wall = 3;
  counts.enter = 5;
  counts.stale = 7;
  counts.cells = 11;
  counts.cells_entered = 13;
  counts.candidates_after_collision = 17;
  counts.candidates_after_wall = 19;
  counts.candidates_when_stale = 23;
  counts.candidates_after_enter = 29;
  EXPECT_EQ(cost_rate(counts, {1, 0, 0, 0}), 2.0 / 2 + 3) << "a collision has two spheres";
  EXPECT_EQ(cost_rate(counts, {0, 1, 0, 0}), 5);
  EXPECT_EQ(cost_rate(counts, {0, 0, 1, 0}), (2 + 3 + 7) * 11 + 5 * 13);
  EXPECT_EQ(cost_rate(counts, {0, 0, 0, 1}), 2 * 17 + 3 * 19 + 7 * 23 + 5 * 29);
}

TEST(OptimalCellEdge, IsWhereTheCostIsLeast) {
  for (const double packing_fraction : {1e-6, 1e-3, 0.02, 0.1, 0.3, 0.5}) {
    for (const double radius : {1e-9, 0.5, 1e6}) {
      for (const double cell : {0.5, 3.0, 60.0}) {
        const GasStatistics statistics = some_gas(10000, packing_fraction, radius);
        const UnitCosts costs{.contact = 25, .enter = 10, .cell = cell, .prediction = 1};
        const double edge = optimal_cell_edge(statistics, costs);
        const double least = cost_at(statistics, edge, costs);
        // The scan misses at most what lies between two steps, where the minimum is flat.
        for (double other = edge / 16; other < 16 * edge; other *= 1.05) {
          if (other < radius / 4) continue;
          EXPECT_LE(least, cost_at(statistics, other, costs) * 1.02) << packing_fraction << " " << cell;
        }
      }
    }
  }
}

TEST(OptimalCellEdge, GrowsAsTheGasBecomesDilute) {
  double last = 0;
  for (double packing_fraction = 0.5; packing_fraction > 1e-9; packing_fraction /= 3) {
    const double edge = optimal_cell_edge(some_gas(1000, packing_fraction, 0.5));
    EXPECT_GT(edge, last);
    last = edge;
  }
}

TEST(OptimalCellEdge, GrowsWithTheCostOfCrossingsAndShrinksWithThatOfPredictions) {
  const GasStatistics statistics = some_gas(1000000, 0.05, 0.5);
  const UnitCosts costs;
  UnitCosts slow_crossings = costs;
  slow_crossings.enter *= 8;
  UnitCosts slow_predictions = costs;
  slow_predictions.prediction *= 8;
  EXPECT_GT(optimal_cell_edge(statistics, slow_crossings), 1.2 * optimal_cell_edge(statistics, costs));
  EXPECT_LT(1.2 * optimal_cell_edge(statistics, slow_predictions), optimal_cell_edge(statistics, costs));
  GasStatistics fast = statistics;
  fast.mean_speed *= 1000;
  EXPECT_EQ(optimal_cell_edge(fast, costs), optimal_cell_edge(statistics, costs));
  fast.mean_speed = 0;
  EXPECT_EQ(optimal_cell_edge(fast, costs), optimal_cell_edge(statistics, costs));
}

TEST(OptimalCellEdge, IsAPositiveNumberForAnyWorld) {
  EXPECT_GT(optimal_cell_edge(gas_statistics(World(), Time(0))), 0);
  World world;
  world.add({{1, 2, 3}, {}, 1e-30, 1});
  for (int i = 0; i < 4; ++i) {
    const GasStatistics statistics = gas_statistics(world, Time(0));
    for (const double edge : {optimal_cell_edge(statistics), paper_cell_edge(statistics)}) {
      EXPECT_GT(edge, 0);
      EXPECT_LT(edge, std::numeric_limits<double>::infinity());
    }
    EXPECT_GE(optimal_cell_edge(statistics), world.largest_radius() / 4)
        << "large spheres are not spread over too many cells";
    world.add({{1e10 * (i + 1), 0, 0}, {1, 0, 0}, std::pow(10, 3 * i), 1});
  }
}

// The printed equation, its left and its right side.
TEST(PaperCellEdge, SolvesThePapersEquation) {
  for (const double packing_fraction : {1e-6, 1e-3, 0.1, 0.5}) {
    const GasStatistics statistics = some_gas(10000, packing_fraction, 1.5);
    const UnitCosts costs{.contact = 1e9, .enter = 8, .cell = 3, .prediction = 2};
    const double edge = paper_cell_edge(statistics, costs);
    const double n0 = statistics.number_density();
    const double r = 1.5;
    const double left = 2 * n0 * (edge + 2 * r) * (edge + 2 * r) *
                        (2 * std::numbers::pi * r * r * n0 * edge * edge + 2 * (edge - r));
    EXPECT_NEAR(left, 8 + 3, 1e-9 * 11);
  }
}

// The paper's cost per sphere and time, whose derivative is the equation.
TEST(PaperCellEdge, IsWhereThePapersCostIsLeast) {
  const GasStatistics statistics = some_gas(10000, 0.02, 1.5);
  const UnitCosts costs;
  const auto cost = [&](double edge) {
    const double r = 1.5;
    const double n0 = statistics.number_density();
    const double candidates = n0 * std::pow(edge + 2 * r, 3);
    return 4 * std::numbers::pi * r * r * n0 * costs.prediction * candidates +
           6 / edge * (costs.prediction * candidates + costs.enter + costs.cell);
  };
  const double edge = paper_cell_edge(statistics, costs);
  EXPECT_LT(cost(edge), cost(1.001 * edge));
  EXPECT_LT(cost(edge), cost(edge / 1.001));
}

// A gas in a cube whose edge doubles, at speed one.
TEST(CellEdgeWatch, RebuildsOnceTheLossExceedsItsCost) {
  const UnitCosts costs;
  CellEdgeWatch watch(costs);
  const GasStatistics dense = some_gas(100000, 0.1, 0.5);
  const double edge = optimal_cell_edge(dense, costs);
  watch.restart(edge);
  EXPECT_EQ(watch.update(dense, 1e6), std::nullopt) << "nothing is better";
  const GasStatistics dilute = some_gas(100000, 0.1 / 8, 0.5);  // the cube has grown twofold
  const double better = optimal_cell_edge(dilute, costs);
  const CellCounts best = expected_counts(dilute, better);
  const double loss = cost_at(dilute, edge, costs) - cost_rate(best, costs);
  ASSERT_GT(loss, 0);
  const double patience = rebuild_cost(best, costs) / loss;
  EXPECT_EQ(watch.update(dilute, 0.6 * patience), std::nullopt);
  EXPECT_EQ(watch.update(dilute, 0.3 * patience), std::nullopt);
  const std::optional<double> ahead = watch.update(dilute, 0.2 * patience);
  ASSERT_TRUE(ahead);
  EXPECT_DOUBLE_EQ(*ahead, better * std::sqrt(better / edge))
      << "by half as much again as the best edge has moved";
  // The cloud stops growing, contrary to the extrapolation.
  EXPECT_EQ(watch.update(dilute, 0.1 * patience), std::nullopt);
  EXPECT_EQ(watch.update(dilute, 1e6 * patience), better);
  EXPECT_EQ(watch.update(dilute, 1e6 * patience), std::nullopt);
}

TEST(CellEdgeWatch, CountsTimeByTheSpeedOfTheSpheres) {
  const UnitCosts costs;
  GasStatistics dilute = some_gas(100000, 0.1 / 64, 0.5);
  const CellCounts best = expected_counts(dilute, optimal_cell_edge(dilute, costs));
  const double patience = rebuild_cost(best, costs) / (cost_at(dilute, 2, costs) - cost_rate(best, costs));
  CellEdgeWatch watch(costs);
  watch.restart(2);
  EXPECT_EQ(watch.update(dilute, 0.1 * patience), std::nullopt);
  dilute.mean_speed /= 100;
  EXPECT_EQ(watch.update(dilute, 80 * patience), std::nullopt);
  EXPECT_TRUE(watch.update(dilute, 20 * patience));
}

TEST(CellEdgeWatch, LeavesWorldsAloneInWhichNothingMoves) {
  CellEdgeWatch watch;
  watch.restart(1e-3);
  EXPECT_EQ(watch.update(GasStatistics{}, 1), std::nullopt);
  GasStatistics still = some_gas(1000, 0.1, 0.5);
  still.mean_speed = 0;
  EXPECT_EQ(watch.update(still, 1e300), std::nullopt);
}

}  // namespace
}  // namespace hardball::cell_edge_test
