// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/world/id_order.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace hardball {

void IdOrder::sort(std::span<const SphereId> ids, SphereId end) {
  size_ = ids.size();
  slots_ = {};
  gaps_ = {};
  if (std::is_sorted(ids.begin(), ids.end())) return;
  constexpr std::size_t kFew = 16;
  if (end > kFew * size_) {
    list_slots();
    std::ranges::sort(slots_, {}, [ids](Slot slot) { return ids[slot]; });
    return;
  }
  constexpr Slot kNone = std::numeric_limits<Slot>::max();
  slots_.assign(end, kNone);
  for (Slot slot = 0; slot < size_; ++slot) slots_[ids[slot]] = slot;
  std::erase(slots_, kNone);
}

void IdOrder::append() {
  if (!slots_.empty()) slots_.push_back(static_cast<Slot>(size_));
  ++size_;
}

void IdOrder::erase(std::size_t rank) {
  if (slots_.empty() && rank + 1 < size_) list_slots();
  --size_;
  if (slots_.empty()) return;
  const auto index = static_cast<std::uint32_t>(skip_empty(rank));
  gaps_.insert(std::ranges::lower_bound(gaps_, index), index);
  constexpr std::size_t kFew = 64;
  constexpr std::size_t kShare = 256;
  if (gaps_.size() > size_ / kShare + kFew) close_gaps();
}

void IdOrder::insert(std::size_t rank, Slot slot) {
  if (slots_.empty() && rank == size_ && slot == size_) return append();
  if (slots_.empty()) list_slots();
  // Gaps between the neighbors in rank, if any, end just before the next one.
  const std::size_t next = rank < size_ ? skip_empty(rank) : slots_.size();
  ++size_;
  const auto above = std::ranges::lower_bound(gaps_, next);
  if (next > 0 && above != gaps_.begin() && *(above - 1) == next - 1) {
    slots_[next - 1] = slot;
    gaps_.erase(above - 1);
    return;
  }
  close_gaps();
  slots_.insert(slots_.begin() + static_cast<std::ptrdiff_t>(rank), slot);
}

void IdOrder::move(std::size_t rank, Slot slot) {
  if (slots_.empty() && rank == slot) return;
  if (slots_.empty()) list_slots();
  slots_[skip_empty(rank)] = slot;
}

// The index of a rank: so many gaps come before it.
std::size_t IdOrder::skip_empty(std::size_t rank) const {
  std::size_t low = 0;
  std::size_t high = gaps_.size();
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    if (gaps_[middle] - middle <= rank) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return rank + low;
}

void IdOrder::list_slots() {
  slots_.resize(size_);
  std::iota(slots_.begin(), slots_.end(), Slot{0});
}

void IdOrder::close_gaps() {
  std::size_t end = 0;
  for_each([&](Slot slot) { slots_[end++] = slot; });
  slots_.resize(end);
  gaps_.clear();
}

}  // namespace hardball
