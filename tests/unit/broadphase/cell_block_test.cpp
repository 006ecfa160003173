// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/cell_block.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "hardball/broadphase/cell_table.hpp"

namespace hardball::cell_block_test {
namespace {

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

}  // namespace
}  // namespace hardball::cell_block_test
