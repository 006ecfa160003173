// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/subdivision.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/numbers/random.hpp"

namespace hardball::subdivision_test {
namespace {

constexpr std::int32_t kMax = 1 << 20;

TEST(Subdivision, FitsWholeCellsIntoBoundedAxes) {
  const Subdivision cells(Box({Boundary::wall, Boundary::periodic, Boundary::open}, {10, 10, 0}), 3, kMax);
  EXPECT_DOUBLE_EQ(cells.edge(0), 10.0 / 3);
  EXPECT_DOUBLE_EQ(cells.edge(1), 10.0 / 3);
  EXPECT_EQ(cells.edge(2), 3);
  EXPECT_EQ(cells.first(0), 0);
  EXPECT_EQ(cells.last(0), 2);
  EXPECT_EQ(cells.period(0), 0);
  EXPECT_EQ(cells.period(1), 3);
  EXPECT_EQ(cells.period(2), 0);
  const Subdivision one(Box::walls({10, 10, 10}), 1000, kMax);
  EXPECT_EQ(one.last(0), 0);
  EXPECT_EQ(one.edge(0), 10);
}

TEST(Subdivision, OfAFlatBoxIsOneLayer) {
  for (const Box& box : {Box::flat_periodic(10, 20), Box::flat_walls(10, 20), Box::flat_open()}) {
    const Subdivision cells(box, 1, kMax);
    EXPECT_EQ(cells.first(2), 0);
    EXPECT_EQ(cells.last(2), 0);
    EXPECT_EQ(cells.shape()[2], 1);
    const Path path{{5.5, 5.5, 0}, {1, -2, 0}, Time(0)};
    const CellRange range = cells.range_at(path.position, 3);
    EXPECT_EQ(range.low[2], 0);
    EXPECT_EQ(range.high[2], 0);
    EXPECT_EQ(range.high[0] - range.low[0], 6);
    EXPECT_NEAR(cells.next_enter(path.position, path.velocity, {}, 3, range).wait, 0.25, 1e-4);
    EXPECT_EQ(cells.next_enter(path.position, path.velocity, {}, 3, range).axis, 1);
    const Path at_rest{{5.5, 5.5, 0}, {}, Time(0)};
    EXPECT_TRUE(std::isinf(cells.next_enter(at_rest.position, at_rest.velocity, {}, 3, range).wait));
    const CellCrossing falling = cells.next_enter({5.5, 5.5, 0}, {}, {2, 0, 0}, 3, range);
    EXPECT_EQ(falling.axis, 0);
    EXPECT_NEAR(falling.wait, std::sqrt(0.5), 1e-4);
  }
}

TEST(Subdivision, KnowsHowManyCellsASphereTouchesAndWhereImagesAreNearest) {
  const Subdivision cells(Box({Boundary::periodic, Boundary::wall, Boundary::open}, {7, 7, 0}), 1);
  EXPECT_EQ(cells.most_touched(0, 0), 2) << "a point between two";
  EXPECT_EQ(cells.most_touched(0, 0.49), 2);
  EXPECT_EQ(cells.most_touched(0, 0.5), 3);
  EXPECT_EQ(cells.most_touched(0, 2.2), 6);
  EXPECT_TRUE(cells.has_nearest_images(0, 0.49)) << "less than three cells apart";
  EXPECT_FALSE(cells.has_nearest_images(0, 0.5)) << "less than five";
  EXPECT_TRUE(cells.has_nearest_images(1, 100)) << "there are no images";
  EXPECT_TRUE(cells.has_nearest_images(2, 100));
}

TEST(Subdivision, RefusesEdgesThatAreNotPositiveAndFinite) {
  for (const double edge :
       {0.0, -1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(Subdivision(Box::open(), edge, kMax), Error);
  }
}

TEST(Subdivision, FoldsIndicesByWholeBoxes) {
  const Subdivision cells(Box({Boundary::periodic, Boundary::wall, Boundary::periodic}, {10, 10, 10}), 2.5,
                          kMax);
  for (std::int32_t place = -13; place <= 13; ++place) {
    CellIndex cell{place, 2, place};
    const Image boxes = cells.fold(cell);
    EXPECT_EQ(cell[0] + cells.cells_beyond(0, boxes), place);
    EXPECT_EQ(cells.folded(0, place), cell[0]);
    EXPECT_EQ(cells.folded({place, 2, place}), cell);
    EXPECT_EQ(cell[1], 2);
    EXPECT_GE(cell[2], 0);
    EXPECT_LT(cell[2], 4);
    EXPECT_EQ(boxes[1], 0);
  }
}

TEST(Subdivision, RangeCoversTheSphereAndNotMuchMore) {
  Random random(1);
  const Box box({Boundary::wall, Boundary::periodic, Boundary::open}, {10, 10, 0});
  for (int i = 0; i < 5000; ++i) {
    const double edge = 0.3 + 6 * random.uniform();
    const Subdivision cells(box, edge, kMax);
    const double radius = 0.05 + 2 * random.uniform();
    const Vec3 place{10 * random.uniform(), 40 * random.uniform() - 20, 1e4 * random.normal()};
    const CellRange range = cells.range_at(place, radius);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const double e = cells.edge(axis);
      const bool at_lower_wall = box.is_wall(axis) && range.low[axis] == 0;
      const bool at_upper_wall = box.is_wall(axis) && range.high[axis] == cells.last(axis);
      ASSERT_TRUE(at_lower_wall || range.low[axis] * e < place[axis] - radius);
      ASSERT_TRUE(at_upper_wall || (range.high[axis] + 1) * e > place[axis] + radius);
      const double reach = cells.reach(axis, radius) + 1e-12 * (e + std::fabs(place[axis]));
      ASSERT_GT((range.low[axis] + 1) * e, place[axis] - reach);
      ASSERT_LT(range.high[axis] * e, place[axis] + reach);
    }
  }
}

TEST(Subdivision, KnowsWhichCellsAnExtentMeets) {
  const Subdivision cells(Box({Boundary::periodic, Boundary::wall, Boundary::open}, {10, 10, 0}), 1, kMax);
  const auto span_along = [&](std::size_t axis, double low, double high) {
    Extent extent;
    extent.low[axis] = low;
    extent.high[axis] = high;
    const CellSpan span = cells.spans_of(extent)[axis];
    return std::pair(span.first, span.count);
  };
  const std::pair<std::int32_t, std::int32_t> all{0, 10};
  EXPECT_EQ(span_along(0, 2.5, 4.5), std::pair(2, 3));
  EXPECT_EQ(span_along(0, 2, 4), std::pair(1, 4)) << "cells admit spheres early";
  EXPECT_EQ(span_along(0, -1.5, 1.5), std::pair(-2, 4));
  EXPECT_EQ(span_along(0, 18.5, 21.5), std::pair(-2, 4));
  EXPECT_EQ(span_along(0, -31.5, -28.5), std::pair(-2, 4));
  EXPECT_EQ(span_along(0, 8.5, 12.5), std::pair(-2, 5));
  EXPECT_EQ(span_along(0, 7.5, 10.5), std::pair(7, 4));
  EXPECT_EQ(span_along(0, 0.5, 10.5), all) << "each cell once";
  EXPECT_EQ(span_along(0, -Extent::kInfinity, 3), all);
  EXPECT_EQ(span_along(1, -1.5, 1.5), std::pair(0, 2));
  EXPECT_EQ(span_along(1, 8.5, Extent::kInfinity), std::pair(8, 2));
  EXPECT_EQ(span_along(1, -Extent::kInfinity, Extent::kInfinity), all);
  EXPECT_EQ(span_along(1, 20, 30).second, 1) << "at least one";
  EXPECT_EQ(span_along(2, -3, 3).second, 0);
}

TEST(Subdivision, SpheresBeyondTheOutermostCellsOfOpenSpaceBelongToThese) {
  const Subdivision cells(Box::open(), 1, 16);
  EXPECT_EQ(cells.first(0), -8);
  EXPECT_EQ(cells.last(0), 7);
  const CellRange range = cells.range_at({1e30, -1e30, 0.5}, 0.25);
  EXPECT_EQ(range, (CellRange{{7, -8, 0}, {7, -8, 0}}));
  const CellCrossing next = cells.next_enter({1e30, -1e30, 0.5}, {1, -1, 0}, {}, 0.25, range);
  EXPECT_EQ(next.wait, std::numeric_limits<double>::infinity());
}

TEST(Subdivision, RefusesToCountCellsWithoutEnd) {
  const Subdivision cells(Box::periodic({1, 1, 1}), 1e-3, kMax);
  EXPECT_THROW(cells.range_at({1e9, 0, 0}, 0.1), RunFailure);
  EXPECT_EQ(cells.folded(0, 1 << 28), (1 << 28) % 1000);
  for (const std::int32_t far : {1 << 29, -(1 << 29) - 1}) EXPECT_THROW(cells.folded(0, far), RunFailure);
}

TEST(Subdivision, EntersTheNextCellSlightlyBeforeTouchingItAndLeavesSlightlyAfter) {
  const Subdivision cells(Box::open(), 2, kMax);
  const double radius = 0.5;
  // By this much cells admit early and release late.
  const double margin_x = cells.reach(0, radius) - radius;
  const double margin_z = cells.reach(2, radius) - radius;
  const Path up{{1, 1, 1}, {2, 1, 0}, Time(7)};
  const CellRange start = cells.range_at(up.position, radius);
  ASSERT_EQ(start, (CellRange{{0, 0, 0}, {0, 0, 0}}));
  const CellCrossing enter = cells.next_enter(up.position, up.velocity, {}, radius, start);
  EXPECT_EQ(enter.axis, 0);
  EXPECT_TRUE(enter.up);
  EXPECT_LT(enter.wait, 0.25);
  EXPECT_NEAR(enter.wait, 0.25 - margin_x / 2, 1e-14);
  const CellCrossing leave = cells.next_leave(up, radius, {{0, 0, 0}, {1, 0, 0}});
  EXPECT_EQ(leave.axis, 0);
  EXPECT_GT(leave.wait, 0.75);
  EXPECT_NEAR(leave.wait, 0.75 + margin_x / 2, 1e-14);

  const Path down{{1, 1, 1}, {0, 0, -1}, Time(7)};
  const CellCrossing below = cells.next_enter(down.position, down.velocity, {}, radius, start);
  EXPECT_EQ(below.axis, 2);
  EXPECT_FALSE(below.up);
  EXPECT_NEAR(below.wait, 0.5 - margin_z, 1e-14);
  EXPECT_NEAR(cells.next_leave(down, radius, {{0, 0, -1}, {0, 0, 0}}).wait, 1.5 + margin_z, 1e-14);
  EXPECT_EQ(cells.next_leave(down, radius, start).wait, std::numeric_limits<double>::infinity());
  EXPECT_EQ(cells.next_enter({1, 1, 1}, {}, {}, radius, start).wait, std::numeric_limits<double>::infinity());
}

TEST(CellRange, VisitsItsCellsOnceEach) {
  const CellRange range{{-1, 2, 0}, {1, 2, 1}};
  std::vector<CellIndex> visited;
  range.for_each([&](const CellIndex& cell) {
    EXPECT_TRUE(range.contains(cell));
    visited.push_back(cell);
  });
  EXPECT_EQ(visited.size(), 6U);
  EXPECT_FALSE(range.contains({-2, 2, 0}));
  EXPECT_FALSE(range.contains({0, 3, 0}));
}

TEST(Subdivision, ReachAndDistanceBeyondAFaceShowWhichCellsASphereTouches) {
  const Subdivision cells(Box({Boundary::wall, Boundary::periodic, Boundary::open}, {10, 10, 0}), 1, kMax);
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 position{10 * random.uniform(), 40 * random.uniform() - 20, 40 * random.uniform() - 20};
    const double radius = 2 * random.uniform();
    const CellRange range = cells.range_at(position, radius);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const double reach = cells.reach(axis, radius);
      ASSERT_GT(reach, radius);
      for (std::int32_t place = range.low[axis] - 2; place <= range.high[axis] + 2; ++place) {
        if (place < cells.first(axis) || place >= cells.last(axis)) continue;
        const double beyond = cells.beyond_face(axis, place + 1, position[axis]);
        ASSERT_EQ(beyond < reach, range.low[axis] <= place);
        ASSERT_EQ(beyond > -reach, range.high[axis] > place);
      }
    }
  }
}

// Wherever cells are distinct, rounding errors are far smaller than their margin.
TEST(Subdivision, MarginsExceedTheRoundingOfTheFarthestPositions) {
  const Subdivision cells(Box({Boundary::wall, Boundary::periodic, Boundary::open}, {1e6, 10, 0}), 1, kMax);
  const std::array<double, kAxes> farthest{1e6, 0x1p29, kMax / 2.0};
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double next = std::nextafter(farthest[axis], std::numeric_limits<double>::infinity());
    EXPECT_GT(cells.reach(axis, 0), 20 * (next - farthest[axis]));
    EXPECT_LT(cells.reach(axis, 0), 1e-5 * cells.edge(axis));
  }
}

}  // namespace
}  // namespace hardball::subdivision_test
