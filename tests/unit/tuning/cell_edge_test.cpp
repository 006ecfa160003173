// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/tuning/cell_edge.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "hardball/broadphase/subdivision.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/tuning/cell_axes.hpp"
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

// The rows of cells that a sphere touches along an axis.
struct Rows {
  double low;
  double high;

  Rows(double center, double radius, double edge)
      : low(std::floor((center - radius) / edge)), high(std::floor((center + radius) / edge)) {}
  double count() const { return high - low + 1; }
  double shared_with(const Rows& other) const {
    return std::max(0.0, std::min(high, other.high) - std::max(low, other.low) + 1);
  }
};

GasStatistics statistics_between_walls(double size, double radius) {
  GasStatistics statistics;
  statistics.spheres = 1000;
  statistics.radius_power[1] = statistics.largest_radius = radius;
  statistics.extent = {size, size, size};
  statistics.box = Box::walls(statistics.extent);
  return statistics;
}

// A mean and its error.
class Mean {
 public:
  void add(double value) {
    ++count_;
    sum_ += value;
    squares_ += value * value;
  }
  double value() const { return sum_ / count_; }
  double error() const { return std::sqrt(squares_ / count_ - value() * value()) / std::sqrt(count_); }

 private:
  double count_ = 0;
  double sum_ = 0;
  double squares_ = 0;
};

// Reference: pairs placed at random between two walls.
TEST(CellAxes, BetweenWallsKnowHowManyRowsPairsShare) {
  constexpr int kPairs = 200000;
  constexpr double kRadius = 0.5;
  const GasStatistics statistics = support::some_gas(1000, 0.01, kRadius, Boundary::wall);
  const double size = statistics.extent.x;
  Random random(1);
  for (const double cells : {2, 3, 7, 20, 90}) {  // 90: a sphere is more than two cells wide
    const CellAxis axis = cell_axes(statistics, size / cells * (1 - 1e-12))[0];
    ASSERT_NEAR(axis.edge, size / cells, 1e-9);
    EXPECT_EQ(axis.room, size - 2 * kRadius);
    Mean rows;
    Mean shared;
    Mean shared_at_wall;
    const Rows at_wall(kRadius * (1 + 1e-9), kRadius, axis.edge);
    const auto anywhere = [&] { return kRadius + axis.room * random.uniform(); };
    for (int i = 0; i < kPairs; ++i) {
      const Rows other(anywhere(), kRadius, axis.edge);
      rows.add(other.count());
      shared.add(other.shared_with(Rows(anywhere(), kRadius, axis.edge)));
      shared_at_wall.add(other.shared_with(at_wall));
    }
    const double rows_far_from_walls = 1 + 2 * kRadius / axis.edge;
    const double scale = axis.room / rows_far_from_walls / (axis.edge + 2 * kRadius);
    constexpr double kErrors = 4;
    EXPECT_NEAR(axis.rows * rows_far_from_walls, rows.value(), kErrors * rows.error() + 1e-9) << cells;
    EXPECT_NEAR(axis.rows_at_wall * rows_far_from_walls, at_wall.count(), 1e-9) << cells;
    EXPECT_NEAR(axis.candidates, shared.value() * scale, kErrors * shared.error() * scale) << cells;
    EXPECT_NEAR(axis.candidates_at_wall, shared_at_wall.value() * scale,
                kErrors * shared_at_wall.error() * scale)
        << cells;
  }
}

TEST(CellAxes, BetweenWallsKnowWhichFacesCanBeCrossed) {
  const GasStatistics statistics = support::some_gas(1000, 0.01, 0.5, Boundary::wall);
  const double size = statistics.extent.x;
  const auto passed = [&](double cells) {
    const CellAxis axis = cell_axes(statistics, size / cells * (1 - 1e-12))[1];
    return axis.crossings * axis.room;
  };
  EXPECT_EQ(passed(1), 0);
  EXPECT_FALSE(cell_axes(statistics, size)[0].is_divided);
  EXPECT_NEAR(passed(2), 1, 1e-9);
  EXPECT_NEAR(passed(10), 9, 1e-9);
  EXPECT_NEAR(passed(90), 87, 1e-9) << "the front of a sphere starts two cells away from the wall";
}

// The slow twin: the rows one by one.
TEST(CellAxes, BetweenWallsSumUpAllRows) {
  for (const double diameter : {1e-9, 0.2, 1.0, 3.7}) {
    for (const double size : {4.0, 5.3, 40.0, 4000.0}) {
      for (const double edge : {0.3, 1.0, 2.2, 7.0, 300.0}) {
        const GasStatistics statistics = statistics_between_walls(size, diameter / 2);
        const CellAxis axis = cell_axes(statistics, edge)[0];
        const double cells = std::round(size / axis.edge);
        double rows = 0;
        double pairs = 0;
        double at_wall = 0;
        for (double row = 0; row < cells; ++row) {
          // Where centers may lie, from the least on.
          const double low = std::max(0.0, row * axis.edge - diameter);
          const double high = std::min(axis.room, (row + 1) * axis.edge);
          rows += high - low;
          pairs += (high - low) * (high - low);
          if (row <= std::floor(diameter / axis.edge)) at_wall += high - low;
        }
        const double rows_far_from_walls = 1 + diameter / axis.edge;
        const double far_from_walls = rows_far_from_walls * (axis.edge + diameter);
        const auto expect_near = [&](double found, double expected) {
          EXPECT_NEAR(found, expected, 1e-9 * expected) << diameter << " " << size << " " << edge;
        };
        expect_near(axis.rows * rows_far_from_walls, rows / axis.room);
        expect_near(axis.candidates * far_from_walls, pairs / axis.room);
        expect_near(axis.candidates_at_wall * far_from_walls, at_wall);
      }
    }
  }
}

// Far from walls a row is as good as any other: a wide box must not take the digits of what remains.
TEST(CellAxes, OfAWideBoxBetweenWallsAreThoseOfOpenSpace) {
  for (const double scale : {1e-60, 1e-30, 1.0, 1e30, 1e45}) {
    const CellAxis axis = cell_axes(statistics_between_walls(1e8 * scale, scale), scale)[0];
    EXPECT_NEAR(axis.candidates, 1, 1e-7) << scale;
    const CellAxis widest = cell_axes(statistics_between_walls(1e60, scale), 1e53)[0];
    EXPECT_NEAR(widest.candidates, 1, 1e-6) << scale;
  }
  for (const double scale : {1e-60, 1.0, 1e60}) {
    const CellAxis undivided = cell_axes(statistics_between_walls(scale, scale / 4), 1e60)[0];
    EXPECT_DOUBLE_EQ(undivided.candidates, 0.5 / (1.5 * 1.5)) << "the room, over rows and their widths";
  }
}

TEST(CellAxes, WithoutWallsAreAllAlike) {
  for (const Boundary boundary : {Boundary::periodic, Boundary::open}) {
    const CellAxis axis = cell_axes(support::some_gas(1000, 0.01, 0.5, boundary), 1)[2];
    EXPECT_EQ(axis.candidates, 1);
    EXPECT_EQ(axis.candidates_at_wall, 1);
    EXPECT_TRUE(axis.is_divided);
    EXPECT_DOUBLE_EQ(axis.crossings, 1 / axis.edge);
  }
}

TEST(CellAxes, OfCellsLargerThanAnOpenCloudHoldWhatThereIs) {
  const GasStatistics statistics = support::some_gas(1000, 0.01, 0.5, Boundary::open);
  const CellAxis axis = cell_axes(statistics, 100 * statistics.extent.x)[0];
  EXPECT_DOUBLE_EQ(axis.candidates * (1 + 1 / axis.edge) * (axis.edge + 1), statistics.extent.x);
}

}  // namespace
}  // namespace hardball::cell_edge_test
