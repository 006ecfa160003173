// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/cell_store.hpp"

#include <bit>
#include <utility>

#include "hardball/broadphase/point_lists.hpp"
#include "hardball/broadphase/slot_lists.hpp"
#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

// With more cells per sphere than this, an array of all cells would take more memory than the spheres.
constexpr double kDenseCellsPerSphere = 2;
constexpr double kDenseCellsAlways = 4096;

}  // namespace

template <class Lists>
void CellStore<Lists>::reset(const CellIndex& shape, std::size_t expected) {
  const double cells = static_cast<double>(shape[0]) * shape[1] * shape[2];
  dense_ = cells > 0 && cells <= kDenseCellsPerSphere * static_cast<double>(expected) + kDenseCellsAlways;
  entries_.clear();
  entries_used_ = 0;
  if (dense_) {
    strides_ = {static_cast<std::uint32_t>(shape[1] * shape[2]), static_cast<std::uint32_t>(shape[2]), 1};
    lists_.reset(static_cast<std::size_t>(cells));
  } else {
    lists_.reset(0);
  }
  if (!dense_) entries_.resize(std::bit_ceil(4 * expected + 16));
}

template <class Lists>
void CellStore<Lists>::erase_hashed(const CellIndex& cell, Slot slot) {
  const std::size_t entry = find_entry(cell);
  const std::uint32_t list = entries_[entry].list;
  HARDBALL_CHECK(list != Lists::kNone);
  lists_.erase(list, slot);
  if (!lists_.is_empty(list)) return;
  lists_.release(list);
  erase_entry(entry);
}

template <class Lists>
std::size_t CellStore<Lists>::memory_bytes() const {
  return entries_.capacity() * sizeof(Entry) + lists_.memory_bytes();
}

template <class Lists>
std::size_t CellStore<Lists>::home(const CellIndex& cell) const {
  std::uint64_t hash = 0;
  for (const std::int32_t index : cell) {
    hash = (hash ^ static_cast<std::uint32_t>(index)) * 0x9e3779b97f4a7c15;
    hash ^= hash >> 32;
  }
  return hash & (entries_.size() - 1);
}

// The entry of the cell, or the free entry where it would go.
template <class Lists>
std::size_t CellStore<Lists>::find_entry(const CellIndex& cell) const {
  std::size_t entry = home(cell);
  while (entries_[entry].list != Lists::kNone && !is_same(entries_[entry].cell, cell))
    entry = (entry + 1) & (entries_.size() - 1);
  return entry;
}

template <class Lists>
std::uint32_t CellStore<Lists>::list_for_insert(const CellIndex& cell) {
  if (2 * entries_used_ >= entries_.size()) grow_table();
  Entry& entry = entries_[find_entry(cell)];
  if (entry.list == Lists::kNone) {
    ++entries_used_;
    entry.cell = cell;
    entry.list = lists_.make();
  }
  return entry.list;
}

// Closes the gap by moving back the entries displaced from their home by it.
template <class Lists>
void CellStore<Lists>::erase_entry(std::size_t gap) {
  const std::size_t mask = entries_.size() - 1;
  for (std::size_t entry = (gap + 1) & mask; entries_[entry].list != Lists::kNone;
       entry = (entry + 1) & mask) {
    const std::size_t from_home = (entry - home(entries_[entry].cell)) & mask;
    if (from_home < ((entry - gap) & mask)) continue;
    entries_[gap] = entries_[entry];
    gap = entry;
  }
  entries_[gap].list = Lists::kNone;
  --entries_used_;
}

template <class Lists>
void CellStore<Lists>::grow_table() {
  std::vector<Entry> old(2 * entries_.size());
  std::swap(old, entries_);
  for (const Entry& entry : old) {
    if (entry.list != Lists::kNone) entries_[find_entry(entry.cell)] = entry;
  }
}

template class CellStore<SlotLists>;
template class CellStore<PointLists>;

}  // namespace hardball
