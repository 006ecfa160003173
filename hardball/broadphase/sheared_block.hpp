// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "hardball/broadphase/cell_block.hpp"
#include "hardball/broadphase/cell_table.hpp"
#include "hardball/broadphase/subdivision.hpp"

namespace hardball {

/// Two by two cells in each of two rows of a sheared box: all that a sphere no larger than a cell can touch,
/// and which of these it is in.
///
/// A set of cells is eight bits, as of a CellBlock. Cells follow each other in pairs, a lower and an upper
/// one, along four directions: x in the lower row, x in the upper row, where cells are others, y and z.
struct ShearedBlock {
  static constexpr std::size_t kDirections = 4;
  static constexpr std::size_t kAcrossRows = 2;
  static constexpr std::size_t kDepth = 3;
  static constexpr std::array<std::size_t, kDirections> kAxis{0, 0, 1, 2};

  /// The cells of a block that are the lower or the upper ones along a direction. An upper one is this many
  /// bits above the lower one.
  struct Halves {
    std::uint32_t lower;
    std::uint32_t upper;
    std::uint32_t bits;

    constexpr std::uint32_t both() const { return lower | upper; }
    /// The upper cells, or the lower ones for 1.
    constexpr std::uint32_t half(std::uint32_t lower_one) const { return upper >> (bits * lower_one); }
    constexpr std::uint32_t lower_if(bool condition) const { return lower * (condition ? 1U : 0U); }
    constexpr std::uint32_t upper_if(bool condition) const { return upper * (condition ? 1U : 0U); }
    /// A set of cells without one half, unless it has none of the other.
    constexpr std::uint32_t without(std::uint32_t half, std::uint32_t cells) const {
      const std::uint32_t rest = cells & ~half;
      return (rest & both()) != 0 ? rest : cells;
    }
  };
  static constexpr std::array<Halves, kDirections> kHalves{Halves{0x03, 0x30, 4}, Halves{0x0c, 0xc0, 4},
                                                           Halves{0x33, 0xcc, 2}, Halves{0x55, 0xaa, 1}};

  /// The index of the lower cells along each direction. Without meaning where the sphere is in neither half.
  std::array<std::int32_t, kDirections> low{};
  std::uint8_t cells = 0;
  std::uint8_t crossing = 0;  ///< The next.

  static constexpr std::uint32_t crossing_along(std::size_t direction, std::uint32_t downwards) {
    return static_cast<std::uint32_t>(2 * direction) + downwards;
  }
  static constexpr std::size_t direction_of(std::uint32_t crossing) { return crossing / 2; }
  static constexpr bool is_downwards(std::uint32_t crossing) { return crossing % 2 == 1; }

  /// The index of the outermost cell that the sphere is in along a direction.
  std::int32_t outermost(std::size_t direction, bool upwards) const {
    const auto [lower, upper, bits] = kHalves[direction];
    if (upwards) return low[direction] + ((cells & upper) != 0 ? 1 : 0);
    return low[direction] + ((cells & lower) != 0 ? 0 : 1);
  }
  /// The indices of one of its cells.
  CellIndex index(std::uint32_t cell) const {
    const std::uint32_t row = cell >> 1 & 1;
    return {low[row] + static_cast<std::int32_t>(cell >> 2),
            low[kAcrossRows] + static_cast<std::int32_t>(row),
            low[kDepth] + static_cast<std::int32_t>(cell & 1)};
  }

  /// The cells of a block that are at the same depths along z as those that the sphere is in.
  std::uint32_t depths() const {
    const Halves& depth = kHalves[kDepth];
    return depth.lower_if((cells & depth.lower) != 0) | depth.upper_if((cells & depth.upper) != 0);
  }
  /// Lets the one half that the sphere is in along a direction be the rear one, and returns the cells ahead.
  std::uint32_t make_room(std::size_t direction, bool upwards) {
    const Halves& half = kHalves[direction];
    const std::uint32_t ahead = cells & (upwards ? half.upper : half.lower);
    if (ahead != 0) {
      cells = static_cast<std::uint8_t>(cells ^ ahead ^ (upwards ? ahead >> half.bits : ahead << half.bits));
      low[direction] += upwards ? 1 : -1;
      if (direction == kAcrossRows) low[upwards ? 0 : 1] = low[upwards ? 1 : 0];
    }
    const std::uint32_t rear = cells & half.both();
    return upwards ? rear << half.bits : rear >> half.bits;
  }

  /// Calls visit(list) for a set of cells.
  template <class Visit>
  void for_each_list(std::uint32_t set, const CellTable& table, Visit&& visit) const {
    std::array<CellTable::Pair, kDirections> parts;
    for (std::size_t direction = 0; direction < kDirections; ++direction)
      parts[direction] = table.parts_from(kAxis[direction], low[direction]);
    CellBlock::for_each_cell(set, [&](std::uint32_t cell) {
      const std::uint32_t row = cell >> 1 & 1;
      visit(table.list_at(parts[row][cell >> 2] + parts[kAcrossRows][row] + parts[kDepth][cell & 1]));
    });
  }
};

}  // namespace hardball
