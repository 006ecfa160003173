// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/tuning/cell_axes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hardball/numbers/random.hpp"
#include "unit/theory/some_gas.hpp"

namespace hardball::cell_axes_test {
namespace {

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
}  // namespace hardball::cell_axes_test
