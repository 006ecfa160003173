// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/cell_store.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

// With more cells per sphere than this, an array of all cells would outweigh the spheres.
constexpr double kDenseCellsPerSphere = 8;
constexpr double kDenseCellsAlways = 4096;

}  // namespace

void CellStore::reset(const CellIndex& shape, std::size_t expected) {
  const double cells = static_cast<double>(shape[0]) * shape[1] * shape[2];
  dense_ = cells > 0 && cells <= kDenseCellsPerSphere * static_cast<double>(expected) + kDenseCellsAlways;
  shape_ = shape;
  first_blocks_.clear();
  lines_.clear();
  lines_used_ = 0;
  blocks_.clear();
  free_block_ = kNone;
  if (dense_) {
    first_blocks_.assign(static_cast<std::size_t>(cells), kNone);
  } else {
    lines_.resize(std::bit_ceil(4 * expected + 16));
  }
}

void CellStore::insert(const CellIndex& cell, const Occupant& occupant) {
  std::uint32_t& first = first_block_for_insert(cell);
  if (first == kNone || blocks_[first].count == blocks_[first].occupants.size()) first = new_block(first);
  Block& block = blocks_[first];
  block.occupants[block.count++] = occupant;
}

void CellStore::erase(const CellIndex& cell, const Occupant& occupant) {
  const std::size_t line = dense_ ? 0 : find_line(cell);
  std::uint32_t& first = dense_ ? first_blocks_[dense_place(cell)] : lines_[line].first_block;
  // Only the first block of a chain may have room: its last occupant fills the gap.
  for (std::uint32_t b = first; b != kNone; b = blocks_[b].next) {
    Occupant* const begin = blocks_[b].occupants.data();
    Occupant* const end = begin + blocks_[b].count;
    Occupant* const found = std::find(begin, end, occupant);
    if (found == end) continue;
    Block& front = blocks_[first];
    *found = front.occupants[--front.count];
    if (front.count > 0) return;
    const std::uint32_t emptied = first;
    first = std::exchange(front.next, free_block_);
    free_block_ = emptied;
    if (!dense_ && first == kNone) erase_line(line);
    return;
  }
  HARDBALL_CHECK(!"the occupant is in the cell");
}

std::size_t CellStore::memory_bytes() const {
  return first_blocks_.capacity() * sizeof(std::uint32_t) + lines_.capacity() * sizeof(Line) +
         blocks_.capacity() * sizeof(Block);
}

std::size_t CellStore::dense_place(const CellIndex& cell) const {
  const auto at = [](std::int32_t i) { return static_cast<std::size_t>(i); };
  return (at(cell[0]) * at(shape_[1]) + at(cell[1])) * at(shape_[2]) + at(cell[2]);
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

std::uint32_t CellStore::first_block(const CellIndex& cell) const {
  return dense_ ? first_blocks_[dense_place(cell)] : lines_[find_line(cell)].first_block;
}

std::uint32_t& CellStore::first_block_for_insert(const CellIndex& cell) {
  if (dense_) return first_blocks_[dense_place(cell)];
  if (2 * lines_used_ >= lines_.size()) grow_lines();
  Line& line = lines_[find_line(cell)];
  if (line.first_block == kNone) {
    ++lines_used_;
    line.cell = cell;
  }
  return line.first_block;
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

}  // namespace hardball
