// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/cell_store.hpp"

#include <bit>
#include <utility>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

// With more cells per sphere than this, an array of all cells would outweigh the spheres.
constexpr double kDenseCellsPerSphere = 2;
constexpr double kDenseCellsAlways = 4096;

}  // namespace

void CellStore::reset(const CellIndex& shape, std::size_t expected) {
  const double cells = static_cast<double>(shape[0]) * shape[1] * shape[2];
  dense_ = cells > 0 && cells <= kDenseCellsPerSphere * static_cast<double>(expected) + kDenseCellsAlways;
  shape_ = shape;
  lines_.clear();
  lines_used_ = 0;
  blocks_.clear();
  free_block_ = kNone;
  if (dense_) {
    blocks_.resize(static_cast<std::size_t>(cells));
  } else {
    lines_.resize(std::bit_ceil(4 * expected + 16));
  }
}

void CellStore::erase(const CellIndex& cell, Slot slot) {
  const std::size_t line = dense_ ? 0 : find_line(cell);
  const std::uint32_t first = dense_ ? dense_place(cell) : lines_[line].first_block;
  std::uint32_t before = kNone;
  for (std::uint32_t b = first; b != kNone; before = b, b = blocks_[b].next) {
    Block& block = blocks_[b];
    std::uint32_t i = 0;
    while (i < block.count && block.slots[i] != slot) ++i;
    if (i == block.count) continue;
    block.slots[i] = block.slots[--block.count];
    if (block.count > 0 || (dense_ && b == first)) return;
    const std::uint32_t next = block.next;
    free_block(b);
    if (before != kNone) {
      blocks_[before].next = next;
    } else {
      lines_[line].first_block = next;
      if (next == kNone) erase_line(line);
    }
    return;
  }
  HARDBALL_CHECK(!"the occupant is in the cell");
}

std::size_t CellStore::memory_bytes() const {
  return lines_.capacity() * sizeof(Line) + blocks_.capacity() * sizeof(Block);
}

std::size_t CellStore::home(const CellIndex& cell) const {
  std::uint64_t hash = 0;
  for (const std::int32_t index : cell) {
    hash = (hash ^ static_cast<std::uint32_t>(index)) * 0x9e3779b97f4a7c15;
    hash ^= hash >> 32;
  }
  return hash & (lines_.size() - 1);
}

// The line of the cell, or the free line where it would go.
std::size_t CellStore::find_line(const CellIndex& cell) const {
  std::size_t line = home(cell);
  while (lines_[line].first_block != kNone && lines_[line].cell != cell)
    line = (line + 1) & (lines_.size() - 1);
  return line;
}

std::uint32_t CellStore::first_block_for_insert(const CellIndex& cell) {
  if (2 * lines_used_ >= lines_.size()) grow_lines();
  Line& line = lines_[find_line(cell)];
  if (line.first_block == kNone) {
    ++lines_used_;
    line.cell = cell;
    line.first_block = new_block(kNone);
  }
  return line.first_block;
}

// A block of a chain whose first is full that has room, made if need be.
std::uint32_t CellStore::block_with_room(std::uint32_t first) {
  std::uint32_t block = first;
  while (blocks_[block].count == kRoom && blocks_[block].next != kNone) block = blocks_[block].next;
  if (blocks_[block].count < kRoom) return block;
  const std::uint32_t added = new_block(kNone);
  blocks_[block].next = added;
  return added;
}

// Closes the gap by moving back the lines that stand behind their home because of it.
void CellStore::erase_line(std::size_t gap) {
  const std::size_t mask = lines_.size() - 1;
  for (std::size_t line = (gap + 1) & mask; lines_[line].first_block != kNone; line = (line + 1) & mask) {
    const std::size_t from_home = (line - home(lines_[line].cell)) & mask;
    if (from_home < ((line - gap) & mask)) continue;
    lines_[gap] = lines_[line];
    gap = line;
  }
  lines_[gap].first_block = kNone;
  --lines_used_;
}

void CellStore::grow_lines() {
  std::vector<Line> old(2 * lines_.size());
  std::swap(old, lines_);
  for (const Line& line : old) {
    if (line.first_block != kNone) lines_[find_line(line.cell)] = line;
  }
}

std::uint32_t CellStore::new_block(std::uint32_t next) {
  std::uint32_t block = free_block_;
  if (block == kNone) {
    block = static_cast<std::uint32_t>(blocks_.size());
    blocks_.emplace_back();
  } else {
    free_block_ = blocks_[block].next;
  }
  blocks_[block].count = 0;
  blocks_[block].next = next;
  return block;
}

void CellStore::free_block(std::uint32_t block) {
  blocks_[block].next = std::exchange(free_block_, block);
}

}  // namespace hardball
