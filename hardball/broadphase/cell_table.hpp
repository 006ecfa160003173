// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "hardball/broadphase/subdivision.hpp"

namespace hardball {

/// Which list holds the spheres of a cell: the paper's subspace tree, with a formula in place of the tree.
///
/// If there are few cells per sphere, each has a list. If there are many, or space is unbounded, cells share
/// lists: then those who search a cell find the spheres of others as well. Either way memory is O(spheres).
/// The number of a list is a sum over the axes, modulo 2^32; of shared ones, the first bits of it. Cost:
/// O(1).
class CellTable {
 public:
  CellTable() = default;
  /// `shape` is the number of cells along each axis, zero where unbounded.
  CellTable(const CellIndex& shape, std::size_t spheres);

  /// The number of lists.
  std::size_t size() const { return size_; }
  /// Whether cells may share a list.
  bool is_shared() const { return shift_ > 0; }

  /// The list of a cell, which must be folded into the box.
  std::uint32_t list(const CellIndex& cell) const {
    return list_at(part(0, cell[0]) + part(1, cell[1]) + part(2, cell[2]));
  }
  /// What an index along an axis contributes to the sum.
  std::uint32_t part(std::size_t axis, std::int32_t index) const {
    return static_cast<std::uint32_t>(index) * strides_[axis];
  }
  /// By how much the sum grows from one cell to the next.
  std::uint32_t stride(std::size_t axis) const { return strides_[axis]; }
  /// The list, given the sum.
  std::uint32_t list_at(std::uint32_t sum) const { return sum >> shift_; }

 private:
  std::size_t size_ = 0;
  std::array<std::uint32_t, kAxes> strides_{};
  std::uint32_t shift_ = 0;
};

}  // namespace hardball
