// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/tuning/cell_axes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hardball/world/random.hpp"
#include "unit/tuning/gas_moments.hpp"

namespace hardball {
namespace {

// The rows of cells that a sphere touches along an axis.
struct Rows {
  double low;
  double high;

  Rows(double center, double radius, double edge)
      : low(std::floor((center - radius) / edge)), high(std::floor((center + radius) / edge)) {}
  bool meets(const Rows& other) const { return low <= other.high && other.low <= high; }
};

Moments moments_between_walls(double size, double radius) {
  Moments moments;
  moments.spheres = 1000;
  moments.radius_power[1] = moments.largest_radius = radius;
  moments.extent = {size, size, size};
  moments.box = Box::walls(moments.extent);
  return moments;
}

// Reference: pairs placed at random between two walls.
TEST(CellAxes, BetweenWallsKnowHowManyPairsShareARow) {
  constexpr int kPairs = 200000;
  constexpr double kRadius = 0.5;
  const Moments moments = support::gas_moments(1000, 0.01, kRadius, Boundary::wall);
  const double size = moments.extent.x;
  Random random(1);
  for (const double cells : {2, 3, 7, 20, 90}) {  // 90: a sphere is more than two cells wide
    const CellAxis axis = cell_axes(moments, size / cells * (1 - 1e-12))[0];
    ASSERT_NEAR(axis.edge, size / cells, 1e-9);
    EXPECT_EQ(axis.room, size - 2 * kRadius);
    int together = 0;
    int together_at_wall = 0;
    const auto anywhere = [&] { return kRadius + axis.room * random.uniform(); };
    for (int i = 0; i < kPairs; ++i) {
      const Rows other(anywhere(), kRadius, axis.edge);
      together += other.meets(Rows(anywhere(), kRadius, axis.edge));
      together_at_wall += other.meets(Rows(kRadius * (1 + 1e-9), kRadius, axis.edge));
    }
    const double far_from_walls = axis.edge + 4 * kRadius;
    const double scale = axis.room / far_from_walls / kPairs;
    // Four standard errors of the count.
    EXPECT_NEAR(axis.candidates, together * scale, 4 * std::sqrt(together) * scale) << cells;
    EXPECT_NEAR(axis.candidates_at_wall, together_at_wall * scale, 4 * std::sqrt(together_at_wall) * scale)
        << cells;
  }
}

TEST(CellAxes, BetweenWallsKnowWhichFacesCanBeCrossed) {
  const Moments moments = support::gas_moments(1000, 0.01, 0.5, Boundary::wall);
  const double size = moments.extent.x;
  const auto passed = [&](double cells) {
    const CellAxis axis = cell_axes(moments, size / cells * (1 - 1e-12))[1];
    return axis.crossings * axis.room;
  };
  EXPECT_EQ(passed(1), 0);
  EXPECT_FALSE(cell_axes(moments, size)[0].is_divided);
  EXPECT_NEAR(passed(2), 1, 1e-9);
  EXPECT_NEAR(passed(10), 9, 1e-9);
  EXPECT_NEAR(passed(90), 87, 1e-9) << "the front of a sphere starts two cells away from the wall";
}

// The slow twin: the rows one by one.
TEST(CellAxes, BetweenWallsSumUpAllRows) {
  for (const double diameter : {1e-9, 0.2, 1.0, 3.7}) {
    for (const double size : {4.0, 5.3, 40.0, 4000.0}) {
      for (const double edge : {0.3, 1.0, 2.2, 7.0, 300.0}) {
        const Moments moments = moments_between_walls(size, diameter / 2);
        const CellAxis axis = cell_axes(moments, edge)[0];
        double apart = 0;
        for (double row = std::floor(diameter / axis.edge) + 1; row * axis.edge < axis.room; ++row) {
          const double ends = std::min(axis.edge, row * axis.edge - diameter);  // where upper ends may lie
          apart += ends * (axis.room - row * axis.edge);
        }
        const double spread = axis.room * (1 - 2 * apart / (axis.room * axis.room));
        EXPECT_NEAR(axis.candidates * (axis.edge + 2 * diameter), spread, 1e-9 * spread)
            << diameter << " " << size << " " << edge;
      }
    }
  }
}

// Far from walls a row is as good as any other: a wide box must not take the digits of what remains.
TEST(CellAxes, OfAWideBoxBetweenWallsAreThoseOfOpenSpace) {
  for (const double scale : {1e-60, 1e-30, 1.0, 1e30, 1e45}) {
    const CellAxis axis = cell_axes(moments_between_walls(1e8 * scale, scale), scale)[0];
    EXPECT_NEAR(axis.candidates, 1, 1e-7) << scale;
    const CellAxis widest = cell_axes(moments_between_walls(1e60, scale), 1e53)[0];
    EXPECT_NEAR(widest.candidates, 1, 1e-6) << scale;
  }
  for (const double scale : {1e-60, 1.0, 1e60}) {
    const CellAxis undivided = cell_axes(moments_between_walls(scale, scale / 4), 1e60)[0];
    EXPECT_DOUBLE_EQ(undivided.candidates, 0.5 / 2) << "the room, over the edge and two diameters";
  }
}

TEST(CellAxes, WithoutWallsAreAllAlike) {
  for (const Boundary boundary : {Boundary::periodic, Boundary::open}) {
    const CellAxis axis = cell_axes(support::gas_moments(1000, 0.01, 0.5, boundary), 1)[2];
    EXPECT_EQ(axis.candidates, 1);
    EXPECT_EQ(axis.candidates_at_wall, 1);
    EXPECT_TRUE(axis.is_divided);
    EXPECT_DOUBLE_EQ(axis.crossings, 1 / axis.edge);
  }
}

TEST(CellAxes, OfCellsLargerThanAnOpenCloudHoldWhatThereIs) {
  const Moments moments = support::gas_moments(1000, 0.01, 0.5, Boundary::open);
  const CellAxis axis = cell_axes(moments, 100 * moments.extent.x)[0];
  EXPECT_DOUBLE_EQ(axis.candidates * (axis.edge + 2), moments.extent.x);
}

}  // namespace
}  // namespace hardball
