// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/cell_block.hpp"

#include <gtest/gtest.h>

#include "hardball/broadphase/cell_store.hpp"

namespace hardball {
namespace {

// The place of a cell in its block along an axis.
bool is_upper_along(std::size_t axis, std::uint32_t cell) {
  return (cell & CellBlock::kUpper[axis]) != 0;
}

TEST(CellBlock, ListsAreThoseOfTheStoreAlsoAcrossAPeriodicBox) {
  constexpr std::int32_t kMost = 1 << 20;
  const Subdivision cells(Box({Boundary::periodic, Boundary::wall, Boundary::periodic}, {3, 4, 5}), 1, kMost);
  CellStore store;
  store.reset(cells.shape(), 60);
  ASSERT_TRUE(store.is_dense());
  for (const CellIndex& low : {CellIndex{0, 0, 0}, {2, 2, 4}, {-1, 1, -6}, {7, 0, 14}}) {
    const CellBlock block(cells, low, store.strides());
    for (std::uint32_t cell = 0; cell < CellBlock::kCells; ++cell) {
      CellIndex place = low;
      for (std::size_t axis = 0; axis < kAxes; ++axis) place[axis] += is_upper_along(axis, cell) ? 1 : 0;
      cells.fold(place);
      EXPECT_EQ(block.list(cell), store.list(place));
      EXPECT_NE(block.list(cell), store.spare_list());
    }
  }
}

TEST(CellBlock, SlabsHoldTheCellsOfOnePlaceAlongAnAxis) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    for (const bool lower : {false, true}) {
      for (const bool upper : {false, true}) {
        const std::uint32_t slab = CellBlock::slab(axis, lower, upper);
        EXPECT_LT(slab, 1U << CellBlock::kCells);
        for (std::uint32_t cell = 0; cell < CellBlock::kCells; ++cell) {
          EXPECT_EQ(((slab >> cell) & 1) != 0, is_upper_along(axis, cell) ? upper : lower);
        }
      }
    }
  }
}

TEST(CellBlock, FacesHoldTheLowerCellsAcrossAnAxis) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    std::uint32_t face = 0;
    for (const std::uint32_t cell : CellBlock::kFace[axis]) face |= 1U << cell;
    EXPECT_EQ(face, CellBlock::slab(axis, true, false));
    EXPECT_EQ(face << CellBlock::kUpper[axis], CellBlock::slab(axis, false, true));
  }
}

TEST(CellBlock, ChoosesWithoutABranch) {
  EXPECT_EQ(CellBlock::choose(true, 3, 5), 3U);
  EXPECT_EQ(CellBlock::choose(false, 3, 5), 5U);
}

}  // namespace
}  // namespace hardball
