// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "hardball/broadphase/cell_table.hpp"
#include "hardball/broadphase/subdivision.hpp"
#include "hardball/geometry/inlining.hpp"

namespace hardball {

/// Two by two by two cells: all that a sphere no larger than a cell can touch.
///
/// A set of axes is three bits, 4, 2 and 1 for x, y and z. It also identifies a cell: the one with the upper
/// index along these axes. A set of cells is eight bits, one per cell.
class CellBlock {
 public:
  static constexpr std::uint32_t kCells = 8;
  static constexpr std::array<std::uint32_t, kAxes> kAxisBit{4, 2, 1};

  /// The block whose lowest cell is `low`.
  HARDBALL_ALWAYS_INLINE CellBlock(const CellTable& table, const CellIndex& low) : table_(table) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) parts_[axis] = table.parts_from(axis, low[axis]);
  }

  /// The list of a cell.
  std::uint32_t list(std::uint32_t cell) const { return table_.list_at(sum(cell)); }

  /// Calls visit(list) for a set of cells.
  template <class Visit>
  void for_each_list(std::uint32_t cells, Visit&& visit) const {
    if (table_.is_spread()) [[unlikely]]
      return for_each_cell(cells, [&](std::uint32_t cell) { visit(list(cell)); });
    for_each_cell(cells, [&](std::uint32_t cell) { visit(sum(cell)); });
  }

  /// Calls visit(cell) for each of a set of cells.
  template <class Visit>
  static void for_each_cell(std::uint32_t cells, Visit&& visit) {
    for (std::uint32_t left = cells; left != 0; left &= left - 1)
      visit(static_cast<std::uint32_t>(std::countr_zero(left)));
  }

  /// Cell `from` and its upper neighbors along `axes`, none of which `from` contains.
  static std::uint32_t cells_above(std::uint32_t from, std::uint32_t axes) {
    return std::uint32_t{kAboveLowest[axes]} << from;
  }

  /// The set of a single axis, or none.
  static std::uint32_t axis_if(bool condition, std::size_t axis) {
    return static_cast<std::uint32_t>(condition) * kAxisBit[axis];
  }
  /// 1 if a set of axes contains an axis, otherwise 0.
  static std::uint32_t count(std::uint32_t axes, std::size_t axis) { return axes / kAxisBit[axis] & 1; }

 private:
  static constexpr std::array<std::uint8_t, kCells> kAboveLowest{0x01, 0x03, 0x05, 0x0f,
                                                                 0x11, 0x33, 0x55, 0xff};

  std::uint32_t sum(std::uint32_t cell) const {
    return parts_[0][cell >> 2] + parts_[1][(cell >> 1) & 1] + parts_[2][cell & 1];
  }

  const CellTable& table_;
  std::array<CellTable::Pair, kAxes> parts_;
};

}  // namespace hardball
