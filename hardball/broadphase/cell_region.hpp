// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "hardball/broadphase/subdivision.hpp"
#include "hardball/events/event.hpp"

namespace hardball {

/// A sphere's region in a CellGrid: a range of cells, and the face through which it will be left.
struct CellRegion {
  CellIndex low{};
  std::array<std::uint16_t, kAxes> more{};  ///< Cells beyond the lowest.
  std::uint8_t crossed_face = 0;

  CellRange range() const { return {low, {low[0] + more[0], low[1] + more[1], low[2] + more[2]}}; }
  void take(const CellRange& range) {
    low = range.low;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      more[axis] = static_cast<std::uint16_t>(range.high[axis] - range.low[axis]);
    }
  }
  /// The row of cells that the sphere enters next.
  CellRange row_ahead() const {
    CellRange row = range();
    const std::size_t axis = axis_of(crossed_face);
    row.low[axis] = row.high[axis] = is_upper(crossed_face) ? row.high[axis] + 1 : row.low[axis] - 1;
    return row;
  }
  /// The axes along which a region that is a CellBlock is two cells wide, as bits.
  std::uint32_t wide_axes() const { return (more[0] * 4U + more[1] * 2U) + more[2]; }
};

}  // namespace hardball
