// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "hardball/broadphase/subdivision.hpp"

namespace hardball {

/// The cells that a sphere touches in a sheared box, counted along its path: in each row along x, as seen
/// from there.
struct ShearedRegion {
  static constexpr std::size_t kMostRows = 8;

  /// The cells of one row.
  struct Cells {
    std::int32_t first = 0;
    std::int32_t last = 0;

    bool contains(std::int32_t cell) const { return first <= cell && cell <= last; }
    friend bool operator==(const Cells&, const Cells&) = default;
  };

  std::int32_t lowest = 0;       ///< The lowest row along y.
  std::uint8_t count = 0;        ///< Number of rows; zero if there is no region.
  std::uint8_t crossed_row = 0;  ///< Row of the next crossing, counted from the lowest.
  std::uint8_t crossed_face = 0;
  Cells depths;                        ///< Cells along z.
  std::array<Cells, kMostRows> along;  ///< Cells of each row, along x.

  std::int32_t highest() const { return lowest + count - 1; }
  bool has_row(std::int32_t row) const { return lowest <= row && row <= highest(); }
  /// Precondition: has_row(row).
  Cells& in_row(std::int32_t row) { return along[static_cast<std::size_t>(row - lowest)]; }
  const Cells& in_row(std::int32_t row) const { return along[static_cast<std::size_t>(row - lowest)]; }
  /// The cells of a row in space. Precondition: has_row(row).
  CellRange cells_in(std::int32_t row) const {
    return {{in_row(row).first, row, depths.first}, {in_row(row).last, row, depths.last}};
  }
  bool contains(const CellIndex& cell) const {
    return has_row(cell[1]) && in_row(cell[1]).contains(cell[0]) && depths.contains(cell[2]);
  }
  /// Whether the cells are the same.
  friend bool operator==(const ShearedRegion& a, const ShearedRegion& b) {
    if (a.lowest != b.lowest || a.count != b.count || a.depths != b.depths) return false;
    for (std::size_t i = 0; i < a.count; ++i) {
      if (a.along[i] != b.along[i]) return false;
    }
    return true;
  }
};

}  // namespace hardball
