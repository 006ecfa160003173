// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "hardball/broadphase/subdivision.hpp"
#include "hardball/events/event.hpp"

namespace hardball {

/// A sphere in a cell. Its region may reach over the edge of a periodic box: `boxes` says how many boxes it
/// lies beyond here, so that the same sphere may stand in a cell more than once.
struct Occupant {
  Slot slot = 0;
  Image boxes;

  friend bool operator==(const Occupant&, const Occupant&) = default;
};

/// The cells that hold spheres: the paper's subspace tree, with tables in place of the tree.
///
/// Where the box has few cells per sphere the directory is a plain array of all cells; where it has many, or
/// no end, it is a hash table of the occupied ones. Either way memory is O(occupants). Cost: O(1) per
/// operation, and O(occupants of the cell) to erase.
class CellStore {
 public:
  /// Empties the store. `shape` is the number of cells along each axis, zero where there is no end;
  /// `expected` is the number of spheres, from which the kind of directory follows.
  void reset(const CellIndex& shape, std::size_t expected);

  /// All cells are given folded into the box.
  void insert(const CellIndex& cell, const Occupant& occupant);
  /// Precondition: the occupant is in the cell.
  void erase(const CellIndex& cell, const Occupant& occupant);

  /// Calls visit(occupant) for everyone in the cell.
  template <class Visit>
  void for_each(const CellIndex& cell, Visit&& visit) const {
    for (std::uint32_t b = first_block(cell); b != kNone; b = blocks_[b].next) {
      const Block& block = blocks_[b];
      for (std::uint32_t i = 0; i < block.count; ++i) visit(block.occupants[i]);
    }
  }

  bool is_dense() const { return dense_; }
  std::size_t memory_bytes() const;

 private:
  static constexpr std::uint32_t kNone = UINT32_MAX;

  // Two cache lines of occupants; fuller cells chain several.
  struct alignas(64) Block {
    std::uint32_t count = 0;
    std::uint32_t next = kNone;
    std::array<Occupant, 7> occupants;
  };
  // A line of the hash table; free while first_block is kNone.
  struct Line {
    CellIndex cell{};
    std::uint32_t first_block = kNone;
  };

  std::size_t dense_place(const CellIndex& cell) const;
  std::size_t home(const CellIndex& cell) const;
  std::size_t find_line(const CellIndex& cell) const;
  std::uint32_t first_block(const CellIndex& cell) const;
  std::uint32_t& first_block_for_insert(const CellIndex& cell);
  void erase_line(std::size_t line);
  void grow_lines();
  std::uint32_t new_block(std::uint32_t next);

  bool dense_ = true;
  CellIndex shape_{};
  std::vector<std::uint32_t> first_blocks_;  // dense: per cell
  std::vector<Line> lines_;                  // hashed: open addressing, a power of two of lines
  std::size_t lines_used_ = 0;
  std::vector<Block> blocks_;
  std::uint32_t free_block_ = kNone;
};

}  // namespace hardball
