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
  lines_.clear();
  lines_used_ = 0;
  if (dense_) {
    strides_ = {static_cast<std::uint32_t>(shape[1] * shape[2]), static_cast<std::uint32_t>(shape[2]), 1};
    lists_.reset(static_cast<std::size_t>(cells));
  } else {
    lists_.reset(0);
  }
  if (!dense_) lines_.resize(std::bit_ceil(4 * expected + 16));
}

void CellStore::erase_hashed(const CellIndex& cell, Slot slot) {
  const std::size_t line = find_line(cell);
  const std::uint32_t list = lines_[line].list;
  HARDBALL_CHECK(list != SlotLists::kNone);
  lists_.erase(list, slot);
  if (!lists_.is_empty(list)) return;
  lists_.give_up(list);
  erase_line(line);
}

std::size_t CellStore::memory_bytes() const {
  return lines_.capacity() * sizeof(Line) + lists_.memory_bytes();
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
  while (lines_[line].list != SlotLists::kNone && lines_[line].cell != cell)
    line = (line + 1) & (lines_.size() - 1);
  return line;
}

std::uint32_t CellStore::list_for_insert(const CellIndex& cell) {
  if (2 * lines_used_ >= lines_.size()) grow_lines();
  Line& line = lines_[find_line(cell)];
  if (line.list == SlotLists::kNone) {
    ++lines_used_;
    line.cell = cell;
    line.list = lists_.make();
  }
  return line.list;
}

// Closes the gap by moving back the lines that stand behind their home because of it.
void CellStore::erase_line(std::size_t gap) {
  const std::size_t mask = lines_.size() - 1;
  for (std::size_t line = (gap + 1) & mask; lines_[line].list != SlotLists::kNone; line = (line + 1) & mask) {
    const std::size_t from_home = (line - home(lines_[line].cell)) & mask;
    if (from_home < ((line - gap) & mask)) continue;
    lines_[gap] = lines_[line];
    gap = line;
  }
  lines_[gap].list = SlotLists::kNone;
  --lines_used_;
}

void CellStore::grow_lines() {
  std::vector<Line> old(2 * lines_.size());
  std::swap(old, lines_);
  for (const Line& line : old) {
    if (line.list != SlotLists::kNone) lines_[find_line(line.cell)] = line;
  }
}

}  // namespace hardball
