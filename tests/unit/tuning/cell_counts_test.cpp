// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/tuning/cell_counts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "hardball/errors/error.hpp"
#include "hardball/theory/kinetic_theory.hpp"
#include "unit/theory/some_gas.hpp"

namespace hardball::cell_counts_test {
namespace {

using support::some_gas;

// Points touch one cell at a time.
TEST(CellCounts, OfPointsAreThoseOfOneCellEach) {
  GasStatistics statistics = some_gas(1000, 1e-21, 0.5);
  const double edge = statistics.extent.x / 10;
  const CellCounts counts = expected_counts(statistics, edge * (1 - 1e-12));
  EXPECT_NEAR(counts.enter, 3 * 0.5 / edge, 1e-6 * counts.enter) << "half the speed along each axis";
  EXPECT_NEAR(counts.cells, 1, 1e-5);
  EXPECT_NEAR(counts.cells_entered, 1, 1e-5);
  // A row behind is kept until the next crossing along any axis.
  EXPECT_GT(counts.candidates_after_enter, 1);
  EXPECT_LT(counts.candidates_after_enter, 4);
}

TEST(CellCounts, SphereTouchesAsManyCellsAsItsExtentRequires) {
  const GasStatistics statistics = some_gas(8000, 0.1, 0.5);
  const double edge = statistics.extent.x / 20;
  const CellCounts counts = expected_counts(statistics, edge * (1 - 1e-12));
  EXPECT_NEAR(counts.cells, std::pow(1 + 1 / edge, 3), 1e-9);
  EXPECT_NEAR(counts.cells_entered, std::pow(1 + 1 / edge, 2), 1e-9);
  EXPECT_NEAR(counts.collision, 1 / mean_free_time(statistics), 1e-12);
}

// If cells were released immediately, there would be in each cell that a sphere touches, besides itself,
// those whose centers lie in a cube of edge L + d.
TEST(CellCounts, CandidatesAreThoseOfTheCellsTouchedAndSomeLeft) {
  for (const double packing_fraction : {1e-3, 0.1, 0.4}) {
    const GasStatistics statistics = some_gas(8000, packing_fraction, 0.5);
    const double edge = statistics.extent.x / 10;
    const CellCounts counts = expected_counts(statistics, edge * (1 - 1e-12));
    const double in_cell = statistics.number_density() * std::pow(edge + 1, 3);
    const double cells = std::pow(1 + 1 / edge, 3);
    // Of a sphere's own volume, eight are excluded, each from up to eight cells.
    EXPECT_GT(counts.candidates_after_collision, cells * (1 + in_cell) - 8);
    EXPECT_LT(counts.candidates_after_collision, 2 * cells * (1 + in_cell) + 8);
    const double cells_entered = std::pow(1 + 1 / edge, 2);
    EXPECT_GT(counts.candidates_after_enter, cells_entered * in_cell - 4);
    // Rows released late add up along all three axes.
    EXPECT_LT(counts.candidates_after_enter, 3 * cells_entered * in_cell);
    EXPECT_GT(counts.candidates_when_stale, counts.candidates_after_collision - 8);
  }
}

TEST(CellCounts, RatesFollowTheSpeedAndCountsDoNot) {
  GasStatistics statistics = some_gas(8000, 0.1, 0.5);
  const CellCounts slow = expected_counts(statistics, 2);
  statistics.mean_speed = 7;
  const CellCounts fast = expected_counts(statistics, 2);
  EXPECT_NEAR(fast.enter, 7 * slow.enter, 1e-9);
  EXPECT_NEAR(fast.collision, 7 * slow.collision, 1e-9);
  EXPECT_NEAR(fast.stale, 7 * slow.stale, 1e-9);
  EXPECT_NEAR(fast.predictions(), 7 * slow.predictions(), 1e-9);
  EXPECT_NEAR(fast.candidates_after_enter, slow.candidates_after_enter, 1e-12);
}

TEST(CellCounts, DoNotDependOnTheUnitOfLength) {
  const CellCounts small = expected_counts(some_gas(1000, 0.1, 0.5e-9), 2.5e-9);
  const CellCounts large = expected_counts(some_gas(1000, 0.1, 0.5), 2.5);
  EXPECT_NEAR(small.candidates_after_collision, large.candidates_after_collision, 1e-9);
  EXPECT_NEAR(small.candidates_after_enter, large.candidates_after_enter, 1e-9);
  EXPECT_NEAR(small.cells, large.cells, 1e-9);
}

// One cell between walls: all spheres are candidates, and there is nothing to enter.
TEST(CellCounts, OneCellBetweenWallsContainsAll) {
  const GasStatistics statistics = some_gas(100, 1e-4, 0.5, Boundary::wall);
  const CellCounts counts = expected_counts(statistics, statistics.extent.x);
  EXPECT_EQ(counts.enter, 0);
  EXPECT_NEAR(counts.candidates_after_collision, 101, 1.1) << "the sphere itself is among them";
  EXPECT_NEAR(counts.candidates_after_wall, 101, 1.1);
}

TEST(CellCounts, LargeSpheresCountMoreAmongThoseThatCollide) {
  const GasStatistics statistics = some_gas(1000, 0.2, 0.5);
  GasStatistics wide = statistics;
  wide.radius_power[5] *= 1.5;  // matters only through the large spheres' share of collisions
  EXPECT_GT(expected_counts(wide, 2).candidates_after_collision,
            expected_counts(statistics, 2).candidates_after_collision);
}

TEST(CellCounts, RefuseInvalidEdges) {
  const GasStatistics statistics = some_gas(1000, 0.2, 0.5);
  EXPECT_THROW(expected_counts(statistics, 0), Error);
  EXPECT_THROW(expected_counts(statistics, -1), Error);
  EXPECT_EQ(expected_counts(GasStatistics{}, 1).enter, 0) << "no spheres";
}

}  // namespace
}  // namespace hardball::cell_counts_test
