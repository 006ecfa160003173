// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "hardball/broadphase/subdivision.hpp"

namespace hardball {

/// Two by two by two cells: a sphere no larger than a cell touches no others.
///
/// Cell k of the block has the upper place along x, y and z where k has the bits 4, 2 and 1. Which of them a
/// sphere touches cannot be foreseen; sets of them are eight bits, and nothing here branches on them.
class CellBlock {
 public:
  static constexpr std::uint32_t kCells = 8;
  /// The cells of the block's lower face across each axis; add kUpper for those of the upper face.
  static constexpr std::array<std::array<std::uint32_t, 4>, kAxes> kFace{
      {{0, 1, 2, 3}, {0, 1, 4, 5}, {0, 2, 4, 6}}};
  static constexpr std::array<std::uint32_t, kAxes> kUpper{4, 2, 1};

  /// The block whose lowest cell is `low`, in a store whose lists of neighbouring cells are `strides` apart.
  CellBlock(const Subdivision& cells, CellIndex low, const std::array<std::uint32_t, kAxes>& strides) {
    cells.fold(low);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const auto lower = static_cast<std::uint32_t>(low[axis]);
      const std::uint32_t upper = choose(low[axis] + 1 != cells.period(axis), lower + 1, 0);
      offsets_[axis] = {lower * strides[axis], upper * strides[axis]};
    }
  }

  /// The list of a cell.
  std::uint32_t list(std::uint32_t cell) const {
    return offsets_[0][cell >> 2] + offsets_[1][(cell >> 1) & 1] + offsets_[2][cell & 1];
  }

  /// The cells with the lower place along an axis, if `lower`, and those with the upper one, if `upper`.
  static std::uint32_t slab(std::size_t axis, bool lower, bool upper) {
    constexpr std::array<std::uint32_t, kAxes> kLowerSlab{0x0f, 0x33, 0x55};
    constexpr std::array<std::uint32_t, kAxes> kUpperSlab{0xf0, 0xcc, 0xaa};
    return choose(lower, kLowerSlab[axis], 0) | choose(upper, kUpperSlab[axis], 0);
  }

  /// One of two numbers, without a branch.
  static std::uint32_t choose(bool condition, std::uint32_t yes, std::uint32_t no) {
    return no ^ ((yes ^ no) & (0U - static_cast<std::uint32_t>(condition)));
  }

 private:
  std::array<std::array<std::uint32_t, 2>, kAxes> offsets_;
};

}  // namespace hardball
