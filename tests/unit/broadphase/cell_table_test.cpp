// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/cell_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace hardball::cell_table_test {
namespace {

TEST(CellTable, GivesEachCellAListIfThereAreFew) {
  for (const CellIndex& shape : {CellIndex{3, 4, 5}, {16, 16, 16}, {100, 50, 2}, {1, 1, 1}}) {
    const CellTable table(shape, 3000);
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
      const CellTable table(shape, spheres);
      EXPECT_TRUE(table.is_shared());
      EXPECT_LE(table.size(), spheres + 4096);
      EXPECT_GE(table.size(), spheres / 2);
    }
  }
}

// Spheres are in lumps, sheets and rows as often as they are everywhere.
TEST(CellTable, SpreadsCellsOverSharedLists) {
  const CellTable table({0, 0, 0}, 30000);
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
    const CellTable table(shape, 30000);
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
      const CellTable table(shape, spheres);
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
