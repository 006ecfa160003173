// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/cell_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <vector>

namespace hardball::cell_table_test {
namespace {

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

}  // namespace
}  // namespace hardball::cell_table_test
