// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/subdivision.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "hardball/broadphase/cell_block.hpp"
#include "hardball/broadphase/cell_table.hpp"
#include "hardball/broadphase/shell_cells.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/numbers/random.hpp"

namespace hardball::cells_test {
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

// A periodic box of so many cells along each axis, open along those that have none.
Subdivision cells_of(const CellIndex& shape) {
  std::array<Boundary, kAxes> boundary{};
  Vec3 size;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    boundary[axis] = shape[axis] == 0 ? Boundary::open : Boundary::periodic;
    size[axis] = shape[axis];
  }
  return Subdivision(Box(boundary, size), 1, 1 << 30);
}

TEST(CellTable, GivesEachCellAListIfThereAreFew) {
  for (const CellIndex& shape : {CellIndex{3, 4, 5}, {16, 16, 16}, {100, 50, 2}, {1, 1, 1}}) {
    const CellTable table(cells_of(shape), 3000);
    EXPECT_FALSE(table.is_shared());
    std::vector<std::uint32_t> lists;
    CellRange{{0, 0, 0}, {shape[0] - 1, shape[1] - 1, shape[2] - 1}}.for_each(
        [&](const CellIndex& cell) { lists.push_back(table.list(cell)); });
    EXPECT_EQ(lists.size(), table.size());
    EXPECT_TRUE(std::is_sorted(lists.begin(), lists.end())) << "adjacent along z, adjacent in memory";
    EXPECT_EQ(std::set<std::uint32_t>(lists.begin(), lists.end()).size(), lists.size());
    EXPECT_LT(lists.back(), table.size());
  }
}

TEST(CellTable, HasNoMoreListsThanSpheresAndAFew) {
  for (const CellIndex& shape :
       {CellIndex{0, 0, 0}, {0, 3, 3}, {1 << 20, 1 << 20, 1 << 20}, {1000, 1000, 1}}) {
    for (const std::size_t spheres : {0U, 1U, 5000U, 100000U}) {
      const CellTable table(cells_of(shape), spheres);
      EXPECT_TRUE(table.is_shared());
      EXPECT_LE(table.size(), spheres + 4096);
      EXPECT_GE(table.size(), spheres / 2);
    }
  }
}

void check_lists_where_spheres_are_expected(const CellSpans& spans) {
  constexpr CellIndex kShape{40, 50, 60};
  const CellTable table(cells_of(kShape), 30000, spans);
  EXPECT_TRUE(table.is_shared());
  EXPECT_EQ(table.size(), 13U * 31 * 60);
  const auto is_expected = [&](std::size_t axis, std::int32_t index) {
    return (index - spans[axis].first + kShape[axis]) % kShape[axis] < spans[axis].count;
  };
  std::map<std::uint32_t, std::vector<CellIndex>> by_list;
  CellRange{{0, 0, 0}, {39, 49, 59}}.for_each(
      [&](const CellIndex& cell) { by_list[table.list(cell)].push_back(cell); });
  EXPECT_EQ(by_list.size(), table.size());
  EXPECT_LT(by_list.rbegin()->first, table.size());
  for (const auto& [list, cells] : by_list) {
    const CellIndex& first = cells.front();
    for (const CellIndex& cell : cells) {
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const bool are_elsewhere = !is_expected(axis, cell[axis]) && !is_expected(axis, first[axis]);
        EXPECT_TRUE(cell[axis] == first[axis] || are_elsewhere);
      }
    }
  }
  CellRange{{0, 0, 0}, {39, 49, 59}}.for_each([&](const CellIndex& cell) {
    for (const std::uint32_t rows : {0U, 1U, 2U}) {
      bool is_alone = true;
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const auto most = static_cast<std::int32_t>(rows);
        for (std::int32_t step = -most; step <= most; ++step)
          is_alone &= is_expected(axis, (cell[axis] + step + kShape[axis]) % kShape[axis]);
      }
      EXPECT_EQ(table.is_shared_within(rows, cell), !is_alone);
    }
  });
}

// Also across the face of the box, whether the cells are counted from before it or pass it.
TEST(CellTable, GivesListsWhereSpheresAreExpected) {
  check_lists_where_spheres_are_expected({CellSpan{5, 12}, {10, 30}, {0, 60}});
  check_lists_where_spheres_are_expected({CellSpan{35, 12}, {10, 30}, {0, 60}});
  check_lists_where_spheres_are_expected({CellSpan{-5, 12}, {10, 30}, {0, 60}});
}

// However many boxes away its index is, and whether the cells expected touch or pass a face of the box.
TEST(CellTable, GivesACellTheListThatItHasInTheBox) {
  const Subdivision cells = cells_of({20, 1, 1});
  for (const CellSpan& expected : {CellSpan{0, 1}, {0, 5}, {7, 5}, {15, 5}, {19, 1}, {-3, 5}, {17, 5}}) {
    const CellTable table(cells, 5, {expected, {0, 1}, {0, 1}});
    ASSERT_TRUE(table.is_shared());
    for (std::int32_t index = -60; index < 60; ++index)
      EXPECT_EQ(table.list({index, 0, 0}), table.list(cells.folded({index, 0, 0}))) << index;
  }
}

TEST(CellTable, GivesAllCellsListsIfThatIsNotMuchMore) {
  const CellTable table(cells_of({10, 10, 10}), 3000, {CellSpan{0, 8}, {0, 10}, {0, 10}});
  EXPECT_FALSE(table.is_shared());
  EXPECT_EQ(table.size(), 1000U);
}

// Spheres are in lumps, sheets and rows as often as they are everywhere.
TEST(CellTable, SpreadsCellsOverSharedLists) {
  const CellTable table(cells_of({0, 0, 0}), 30000);
  const auto most_in_a_list = [&table](const CellRange& range, const CellIndex& step) {
    std::vector<std::size_t> counts(table.size());
    range.for_each([&](const CellIndex& cell) {
      ++counts[table.list({cell[0] * step[0], cell[1] * step[1], cell[2] * step[2] + cell[0]})];
    });
    return *std::max_element(counts.begin(), counts.end());
  };
  EXPECT_LE(most_in_a_list({{-15, -15, -15}, {15, 15, 15}}, {1, 1, 1}), 4U);
  EXPECT_LE(most_in_a_list({{-100, 70, 0}, {100, 210, 0}}, {1, 1, 1}), 4U);
  for (const std::int32_t step : {1, 2, 3, 64, 1000, 4096, 32767}) {
    EXPECT_LE(most_in_a_list({{-10000, 5, -5}, {10000, 5, -5}}, {step, 1, 1}), 4U) << step;
    EXPECT_LE(most_in_a_list({{0, -10000, 0}, {0, 10000, 0}}, {1, step, 1}), 4U) << step;
  }
}

// All cells of a box lie in lists of about the same length, in two dimensions and in one as well.
TEST(CellTable, SpreadsTheCellsOfABoxEvenly) {
  for (const CellIndex& shape : {CellIndex{64, 64, 64}, {1000, 1000, 1}, {1000, 1, 300}, {1, 1 << 18, 1}}) {
    const CellTable table(cells_of(shape), 30000);
    ASSERT_TRUE(table.is_shared());
    std::vector<std::size_t> counts(table.size());
    CellRange{{0, 0, 0}, {shape[0] - 1, shape[1] - 1, shape[2] - 1}}.for_each(
        [&](const CellIndex& cell) { ++counts[table.list(cell)]; });
    const double mean =
        static_cast<double>(shape[0]) * shape[1] * shape[2] / static_cast<double>(table.size());
    double squares = 0;
    for (const std::size_t count : counts)
      squares += (static_cast<double>(count) - mean) * (static_cast<double>(count) - mean);
    // Spread at random, they would have a variance of their mean.
    EXPECT_LE(squares / static_cast<double>(table.size()), mean / 3);
  }
}

// Otherwise a neighbor would be found twice.
TEST(CellTable, CellsAroundOneShareNoList) {
  for (std::size_t spheres = 1; spheres < 100000000; spheres *= 2) {
    for (const CellIndex& shape : {CellIndex{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {1, 1, 0}}) {
      const CellTable table(cells_of(shape), spheres);
      const auto has = [&](std::size_t axis) { return shape[axis] == 0 ? 1 : 0; };
      const CellIndex far{has(0), has(1), has(2)};
      std::size_t cells = 0;
      std::set<std::uint32_t> lists;
      CellRange{{-far[0], -far[1], -far[2]}, far}.for_each([&](const CellIndex& cell) {
        lists.insert(table.list(cell));
        ++cells;
      });
      EXPECT_EQ(lists.size(), cells) << spheres;
    }
  }
}

// The index of a cell in its block along an axis.
bool is_upper_along(std::size_t axis, std::uint32_t cell) {
  return (cell & CellBlock::kAxisBit[axis]) != 0;
}

TEST(CellBlock, ListsAreThoseOfTheTableAlsoAcrossAPeriodicBox) {
  const auto check = [](const Vec3& size, const CellSpans& expected, bool is_shared) {
    const Subdivision cells(Box({Boundary::periodic, Boundary::wall, Boundary::periodic}, size), 1, 1 << 20);
    const CellTable table(cells, 60, expected);
    EXPECT_EQ(table.is_shared(), is_shared);
    const CellIndex shape = cells.shape();
    for (const CellIndex& low : {CellIndex{0, 0, 0},
                                 {shape[0] - 1, shape[1] - 2, shape[2] - 1},
                                 {-1, 1, -6},
                                 {2 * shape[0] + 1, 0, 3 * shape[2] - 1}}) {
      const CellBlock block(table, low);
      for (std::uint32_t cell = 0; cell < CellBlock::kCells; ++cell) {
        CellIndex place = low;
        for (std::size_t axis = 0; axis < kAxes; ++axis) place[axis] += is_upper_along(axis, cell) ? 1 : 0;
        EXPECT_EQ(block.list(cell), table.list(cells.folded(place)));
      }
    }
  };
  check({3, 4, 5}, {CellSpan{0, 3}, {0, 4}, {0, 5}}, false);
  check({3, 4, 5}, {CellSpan{0, 3}, {1, 1}, {4, 2}}, true);
  check({300, 400, 500}, {CellSpan{0, 300}, {0, 400}, {0, 500}}, true);
  check({300, 400, 500}, {CellSpan{295, 10}, {0, 10}, {495, 10}}, true);
}

TEST(CellBlock, VisitsTheListsOfASetOfCells) {
  const Subdivision cells(Box::periodic({5, 5, 5}), 1, 1 << 20);
  const CellTable table(cells, 60);
  const CellBlock block(table, {4, 1, 2});
  for (std::uint32_t set = 0; set < 1U << CellBlock::kCells; ++set) {
    std::vector<std::uint32_t> expected;
    for (std::uint32_t cell = 0; cell < CellBlock::kCells; ++cell) {
      if ((set >> cell & 1) != 0) expected.push_back(block.list(cell));
    }
    std::vector<std::uint32_t> visited;
    block.for_each_list(set, [&visited](std::uint32_t list) { visited.push_back(list); });
    EXPECT_EQ(visited, expected);
  }
}

TEST(CellBlock, CellsAboveACellHaveItsIndexAlongAllOtherAxes) {
  for (std::uint32_t from = 0; from < CellBlock::kCells; ++from) {
    for (std::uint32_t axes = 0; axes < CellBlock::kCells; ++axes) {
      if ((from & axes) != 0) continue;
      const std::uint32_t above = CellBlock::cells_above(from, axes);
      EXPECT_LT(above, 1U << CellBlock::kCells);
      for (std::uint32_t cell = 0; cell < CellBlock::kCells; ++cell) {
        bool is_above = true;
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
          const bool along = (axes & CellBlock::kAxisBit[axis]) != 0;
          is_above = is_above && (along || is_upper_along(axis, cell) == is_upper_along(axis, from));
        }
        EXPECT_EQ((above >> cell & 1) != 0, is_above);
      }
    }
  }
}

TEST(CellBlock, SetsOfAxes) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    EXPECT_EQ(CellBlock::axis_if(true, axis), CellBlock::kAxisBit[axis]);
    EXPECT_EQ(CellBlock::axis_if(false, axis), 0U);
    EXPECT_EQ(CellBlock::count(7, axis), 1U);
    EXPECT_EQ(CellBlock::count(7 & ~CellBlock::kAxisBit[axis], axis), 0U);
  }
}

constexpr double kSize = 12;

// Whether a cell that is `shift` cells beyond `folded` has a point within `outer`, and one beyond `inner`.
bool is_in_shell(const Subdivision& cells, const CellIndex& cell, const Vec3& center, double inner,
                 double outer) {
  double near = 0;
  double far = 0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double low = cells.edge(axis) * cell[axis] - center[axis];
    const double high = low + cells.edge(axis);
    // The outermost cells reach on for ever.
    const bool is_first = cells.period(axis) == 0 && cell[axis] == cells.first(axis);
    const bool is_last = cells.period(axis) == 0 && cell[axis] == cells.last(axis);
    const double nearest = std::max({is_first ? 0.0 : low, is_last ? 0.0 : -high, 0.0});
    near += nearest * nearest;
    far += is_first || is_last ? HUGE_VAL : std::pow(std::max(-low, high), 2);
  }
  return near <= outer * outer && far >= inner * inner;
}

TEST(ShellCells, AreThoseNearTheSurface) {
  Random random(7);
  for (const Boundary boundary : {Boundary::periodic, Boundary::wall}) {
    const Box box({boundary, boundary, boundary}, {kSize, kSize, kSize});
    const Subdivision cells(box, 1);
    for (int i = 0; i < 100; ++i) {
      const Vec3 center{kSize * random.uniform(), kSize * random.uniform(), kSize * random.uniform()};
      const double outer = 0.4 * kSize * random.uniform();
      const double inner = std::max(0.0, outer - 2 * random.uniform());
      std::multiset<CellIndex> found;
      for_each_cell_of_shell(cells, center, inner, outer, [&](const CellIndex& cell) { found.insert(cell); });
      std::multiset<CellIndex> expected;
      const std::int32_t beyond = boundary == Boundary::periodic ? 12 : 0;
      const CellRange all{{-beyond, -beyond, -beyond}, {11 + beyond, 11 + beyond, 11 + beyond}};
      all.for_each([&](const CellIndex& cell) {
        if (is_in_shell(cells, cell, center, inner, outer)) expected.insert(cells.folded(cell));
      });
      EXPECT_EQ(found, expected);
      EXPECT_FALSE(found.empty());
    }
  }
}

TEST(ShellCells, OfAFullSphereHaveNoHole) {
  const Subdivision cells(Box::periodic({kSize, kSize, kSize}), 1);
  std::set<CellIndex> found;
  for_each_cell_of_shell(cells, {6.5, 6.5, 6.5}, 0, 3, [&](const CellIndex& cell) { found.insert(cell); });
  EXPECT_TRUE(found.contains({6, 6, 6}));
  found.clear();
  for_each_cell_of_shell(cells, {6.5, 6.5, 6.5}, 2.5, 3, [&](const CellIndex& cell) { found.insert(cell); });
  EXPECT_FALSE(found.contains({6, 6, 6}));
  EXPECT_TRUE(found.contains({6, 6, 3}));
}

}  // namespace
}  // namespace hardball::cells_test
