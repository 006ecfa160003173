// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "hardball/broadphase/subdivision.hpp"
#include "hardball/events/event.hpp"

namespace hardball {

/// The cells that hold spheres: the paper's subspace tree, with tables in place of the tree.
///
/// Where the box has few cells per sphere there is an array with a block for each cell; where it has many, or
/// no end, a hash table leads to the blocks of the occupied ones. Either way memory is O(occupants). A sphere
/// may stand in a cell more than once, when its region reaches around a periodic box. Cost: O(1) per
/// operation, and O(occupants of the cell) to erase.
class CellStore {
 public:
  /// Empties the store. `shape` is the number of cells along each axis, zero where there is no end;
  /// `expected` is the number of spheres, from which the kind of directory follows.
  void reset(const CellIndex& shape, std::size_t expected);

  /// All cells are given folded into the box.
  void insert(const CellIndex& cell, Slot slot) {
    std::uint32_t first = dense_ ? dense_place(cell) : first_block_for_insert(cell);
    if (blocks_[first].count == kRoom) first = block_with_room(first);
    Block& block = blocks_[first];
    block.slots[block.count++] = slot;
  }
  /// Precondition: the sphere is in the cell.
  void erase(const CellIndex& cell, Slot slot);

  /// Calls visit(slots, count) for each block of the cell.
  template <class Visit>
  void for_each_block(const CellIndex& cell, Visit&& visit) const {
    for (std::uint32_t b = first_block(cell); b != kNone; b = blocks_[b].next) {
      visit(blocks_[b].slots.data(), blocks_[b].count);
    }
  }
  /// Calls visit(slot) for everyone in the cell.
  template <class Visit>
  void for_each(const CellIndex& cell, Visit&& visit) const {
    for_each_block(cell, [&](const Slot* slots, std::uint32_t count) {
      for (std::uint32_t i = 0; i < count; ++i) visit(slots[i]);
    });
  }

  bool is_dense() const { return dense_; }
  std::size_t memory_bytes() const;

 private:
  static constexpr std::uint32_t kNone = UINT32_MAX;
  static constexpr std::uint32_t kRoom = 14;

  // A cache line of occupants; fuller cells chain several.
  struct alignas(64) Block {
    std::uint32_t count = 0;
    std::uint32_t next = kNone;
    std::array<Slot, kRoom> slots;
  };
  // A line of the hash table; free while first_block is kNone.
  struct Line {
    CellIndex cell{};
    std::uint32_t first_block = kNone;
  };

  std::uint32_t dense_place(const CellIndex& cell) const {
    const auto at = [](std::int32_t i) { return static_cast<std::uint32_t>(i); };
    return (at(cell[0]) * at(shape_[1]) + at(cell[1])) * at(shape_[2]) + at(cell[2]);
  }
  std::uint32_t first_block(const CellIndex& cell) const {
    return dense_ ? dense_place(cell) : lines_[find_line(cell)].first_block;
  }
  std::size_t home(const CellIndex& cell) const;
  std::size_t find_line(const CellIndex& cell) const;
  std::uint32_t first_block_for_insert(const CellIndex& cell);
  std::uint32_t block_with_room(std::uint32_t first);
  void erase_line(std::size_t line);
  void grow_lines();
  std::uint32_t new_block(std::uint32_t next);
  void free_block(std::uint32_t block);

  bool dense_ = true;
  CellIndex shape_{};
  std::vector<Line> lines_;  // hashed: open addressing, a power of two of lines
  std::size_t lines_used_ = 0;
  std::vector<Block> blocks_;  // dense: one for each cell, then those that chain on
  std::uint32_t free_block_ = kNone;
};

}  // namespace hardball
