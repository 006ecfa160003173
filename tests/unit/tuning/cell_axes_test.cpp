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

TEST(CellAxes, WithoutWallsAreAllAlike) {
  for (const Boundary boundary : {Boundary::periodic, Boundary::open}) {
    const CellAxis axis = cell_axes(support::gas_moments(1000, 0.01, 0.5, boundary), 1)[2];
    EXPECT_EQ(axis.candidates, 1);
    EXPECT_EQ(axis.candidates_at_wall, 1);
    EXPECT_TRUE(axis.is_divided);
    EXPECT_DOUBLE_EQ(axis.crossings, 1 / axis.edge);
  }
}

}  // namespace
}  // namespace hardball
