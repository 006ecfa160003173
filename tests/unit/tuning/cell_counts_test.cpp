// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/tuning/cell_counts.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "hardball/broadphase/large_sizes.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/theory/kinetic_theory.hpp"
#include "hardball/tuning/cell_axes.hpp"
#include "hardball/tuning/cell_edge.hpp"
#include "hardball/tuning/size_classes.hpp"
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

CellAxes undisturbed(const Vec3& edges) {
  CellAxes axes;
  for (std::size_t axis = 0; axis < kAxes; ++axis) axes[axis].edge = edges[axis];
  return axes;
}

// Reference: a sphere that moves through cells, and the rows that it holds.
class Flyer {
 public:
  Flyer(const Vec3& edges, double diameter, double free_path)
      : edges_(edges), diameter_(diameter), free_path_(free_path) {
    turn();
  }

  // Means at evenly spaced path lengths.
  RowSurplus mean(int samples) {
    RowSurplus sum;
    const double spacing = 0.37 * edges_.x;
    double flown = 0;
    for (int k = 0; k < samples; ++k) {
      while (flown < spacing) flown += advance(spacing - flown);
      flown = 0;
      std::array<double, kAxes> surplus{};
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        surplus[axis] = front_[axis] - back_[axis] - diameter_ / edges_[axis];
      }
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        sum.along[axis] += surplus[axis] / samples;
        sum.across[axis] += surplus[(axis + 1) % kAxes] * surplus[(axis + 2) % kAxes] / samples;
      }
      sum.all += surplus[0] * surplus[1] * surplus[2] / samples;
    }
    return sum;
  }

 private:
  // Moves to the next crossing or collision, at most by `most`; returns the distance.
  double advance(double most) {
    double way = std::min(most, until_collision_);
    std::size_t crossed = kAxes;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const double to_row =
          ((front_[axis] + 1) * edges_[axis] - (center_[axis] + diameter_ / 2)) / direction_[axis];
      if (to_row >= way) continue;
      way = std::max(0.0, to_row);
      crossed = axis;
    }
    center_ += way * direction_;
    until_collision_ -= way;
    if (crossed < kAxes) {
      ++front_[crossed];
      give_up_rows();
    } else if (until_collision_ <= 0) {
      turn();
    }
    return way;
  }

  // By symmetry all directions may be taken to point upwards, if the position in the cells is drawn again.
  void turn() {
    until_collision_ = -free_path_ * std::log(1 - random_.uniform());
    direction_ = {std::fabs(random_.normal()), std::fabs(random_.normal()), std::fabs(random_.normal())};
    direction_ = (1 / length(direction_)) * direction_;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      center_[axis] = edges_[axis] * random_.uniform();
      front_[axis] = std::floor((center_[axis] + diameter_ / 2) / edges_[axis]);
    }
    give_up_rows();
  }

  void give_up_rows() {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      back_[axis] = std::floor((center_[axis] - diameter_ / 2) / edges_[axis]);
    }
  }

  Vec3 edges_;
  double diameter_;
  double free_path_;
  Random random_{1};
  Vec3 center_;
  Vec3 direction_;
  double until_collision_ = 0;
  std::array<double, kAxes> front_{};
  std::array<double, kAxes> back_{};
};

TEST(RowSurplus, IsThatOfASphereMovingThroughCells) {
  for (const Vec3& edges : {Vec3{1, 1, 1}, Vec3{1, 1.6, 2.5}}) {
    for (const double diameter : {0.01, 0.4, 1.7}) {
      for (const double free_path : {0.3, 2.0, 40.0}) {
        const RowSurplus expected = Flyer(edges, diameter, free_path).mean(200000);
        const RowSurplus surplus = mean_row_surplus(undisturbed(edges), diameter, free_path, 3);
        // Standard errors of the samples, which are correlated over a few edges, and of 512 points: below
        // 0.01.
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
          EXPECT_NEAR(surplus.along[axis], expected.along[axis], 0.03);
          EXPECT_NEAR(surplus.across[axis], expected.across[axis], 0.03);
        }
        EXPECT_NEAR(surplus.all, expected.all, 0.03);
      }
    }
  }
}

TEST(RowSurplus, VanishesWithManyCollisionsAndWithOneCell) {
  const RowSurplus crowded = mean_row_surplus(undisturbed({1, 1, 1}), 0.4, 1e-4, 3);
  for (std::size_t axis = 0; axis < kAxes; ++axis) EXPECT_NEAR(crowded.along[axis], 0, 0.01);
  CellAxes whole = undisturbed({1, 1, 1});
  for (CellAxis& axis : whole) axis.is_divided = false;
  const RowSurplus none = mean_row_surplus(whole, 0.4, std::numeric_limits<double>::infinity(), 3);
  EXPECT_EQ(none.along, (std::array<double, kAxes>{}));
  EXPECT_EQ(none.all, 0);
}

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
}  // namespace hardball::cell_counts_test
