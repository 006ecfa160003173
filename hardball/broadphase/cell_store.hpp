// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "hardball/broadphase/subdivision.hpp"
#include "hardball/events/event.hpp"

namespace hardball {

/// The cells that contain spheres: the paper's subspace tree, with tables in place of the tree.
///
/// If the box has few cells per sphere there is a list for each cell; if it has many, or is unbounded, a hash
/// table leads to the lists of the occupied ones. Either way memory is O(occupants). A sphere can be in a
/// cell more than once, when its region wraps around a periodic box. Cost: O(1) per operation, and
/// O(occupants of the cell) to erase. `Lists` is SlotLists or PointLists.
template <class Lists>
class CellStore {
 public:
  /// Empties the store. `shape` is the number of cells along each axis, zero where unbounded; `expected` is
  /// the number of spheres, which determines the kind of directory.
  void reset(const CellIndex& shape, std::size_t expected);

  /// Cells are passed folded into the box; with a slot comes what else the lists hold of it.
  template <class... Rest>
  void insert(const CellIndex& cell, Slot slot, const Rest&... rest) {
    lists_.insert(dense_ ? dense_list(cell) : list_for_insert(cell), slot, rest...);
  }
  /// Precondition: the sphere is in the cell.
  void erase(const CellIndex& cell, Slot slot) {
    if (dense_) {
      lists_.erase(dense_list(cell), slot);
    } else {
      erase_hashed(cell, slot);
    }
  }

  /// The list of the cell, in lists(); may be Lists::kNone if it is empty.
  std::uint32_t list(const CellIndex& cell) const {
    return dense_ ? dense_list(cell) : entries_[find_entry(cell)].list;
  }
  const Lists& lists() const { return lists_; }
  /// How far apart the lists of neighbouring cells are, along each axis. Precondition: is_dense().
  const std::array<std::uint32_t, kAxes>& strides() const { return strides_; }
  /// The same, given the cell's list. Precondition: is_dense().
  template <class... Rest>
  void insert(std::uint32_t list, Slot slot, const Rest&... rest) {
    lists_.insert(list, slot, rest...);
  }
  void erase(std::uint32_t list, Slot slot) { lists_.erase(list, slot); }

  bool is_dense() const { return dense_; }
  std::size_t memory_bytes() const;

 private:
  // An entry of the hash table; free while it has no list.
  struct Entry {
    CellIndex cell{};
    std::uint32_t list = Lists::kNone;
  };

  std::uint32_t dense_list(const CellIndex& cell) const {
    std::uint32_t list = 0;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      list += static_cast<std::uint32_t>(cell[axis]) * strides_[axis];
    }
    return list;
  }
  std::size_t home(const CellIndex& cell) const;
  std::size_t find_entry(const CellIndex& cell) const;
  std::uint32_t list_for_insert(const CellIndex& cell);
  void erase_hashed(const CellIndex& cell, Slot slot);
  void erase_entry(std::size_t entry);
  void grow_table();

  bool dense_ = true;
  std::array<std::uint32_t, kAxes> strides_{};  // dense
  std::vector<Entry> entries_;                  // hashed: open addressing, size a power of two
  std::size_t entries_used_ = 0;
  Lists lists_;  // dense: one per cell
};

}  // namespace hardball
