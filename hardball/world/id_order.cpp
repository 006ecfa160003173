// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/world/id_order.hpp"

#include <limits>
#include <numeric>

#include "hardball/standard/ranges.hpp"

namespace hardball {
namespace {

// Slots in a chunk when it is made; it is divided at twice as many.
constexpr std::size_t kChunk = 256;

}  // namespace

std::size_t IdOrder::rank_of(SphereId id, std::span<const SphereId> ids) const {
  if (size_ == 0) return 0;
  const SphereId first = ids[(*this)[0]];
  const SphereId last = ids[(*this)[size_ - 1]];
  if (id <= first || id > last) return id <= first ? 0 : size_;
  // Ids differ, so that few are missing where few spheres have been removed.
  std::size_t low = size_ - std::min(size_, std::size_t{last} - id + 1);
  std::size_t high = std::min(size_, std::size_t{id} - first);
  if (low == high) return low;
  const auto is_lower = [&](Slot slot) { return ids[slot] < id; };
  if (chunks_.empty()) {
    while (low < high) {
      const std::size_t middle = low + (high - low) / 2;
      if (is_lower(static_cast<Slot>(middle))) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }
  // The last chunk that begins with a lower id, if any.
  std::size_t chunk = chunk_of(low);
  std::size_t end = high < size_ ? chunk_of(high) + 1 : chunks_.size();
  while (chunk + 1 < end) {
    const std::size_t middle = chunk + (end - chunk) / 2;
    if (is_lower(chunks_[middle].front())) {
      chunk = middle;
    } else {
      end = middle;
    }
  }
  const std::vector<Slot>& slots = chunks_[chunk];
  const std::size_t begin = begins_[chunk];
  const auto first_in = slots.begin() + static_cast<std::ptrdiff_t>(std::max(low, begin) - begin);
  const auto last_in = slots.begin() + static_cast<std::ptrdiff_t>(std::min(high - begin, slots.size()));
  return begin + static_cast<std::size_t>(std::partition_point(first_in, last_in, is_lower) - slots.begin());
}

void IdOrder::sort(std::span<const SphereId> ids, SphereId end) {
  size_ = ids.size();
  chunks_ = {};
  begins_ = {};
  if (std::is_sorted(ids.begin(), ids.end())) return;
  constexpr std::size_t kFew = 16;
  std::vector<Slot> slots;
  if (end > kFew * size_) {
    slots.resize(size_);
    std::iota(slots.begin(), slots.end(), Slot{0});
    ranges::sort(slots, {}, [ids](Slot slot) { return ids[slot]; });
  } else {
    constexpr Slot kNone = std::numeric_limits<Slot>::max();
    slots.assign(end, kNone);
    for (Slot slot = 0; slot < size_; ++slot) slots[ids[slot]] = slot;
    std::erase(slots, kNone);
  }
  take(slots);
}

void IdOrder::erase(std::size_t rank) {
  if (chunks_.empty() && rank + 1 < size_) list_slots();
  --size_;
  if (chunks_.empty()) return;
  const std::size_t chunk = chunk_of(rank);
  std::vector<Slot>& slots = chunks_[chunk];
  slots.erase(slots.begin() + static_cast<std::ptrdiff_t>(rank - begins_[chunk]));
  for (std::size_t after = chunk + 1; after < begins_.size(); ++after) --begins_[after];
  if (!slots.empty()) return;
  chunks_.erase(chunks_.begin() + static_cast<std::ptrdiff_t>(chunk));
  begins_.erase(begins_.begin() + static_cast<std::ptrdiff_t>(chunk));
}

void IdOrder::insert(std::size_t rank, Slot slot) {
  if (chunks_.empty() && rank == size_ && slot == size_) {
    ++size_;
    return;
  }
  if (chunks_.empty()) list_slots();
  if (chunks_.empty()) {
    chunks_.emplace_back();
    begins_.push_back(0);
  }
  ++size_;
  // One between two chunks belongs to the first.
  const std::size_t chunk = rank == 0 ? 0 : chunk_of(rank - 1);
  std::vector<Slot>& slots = chunks_[chunk];
  slots.insert(slots.begin() + static_cast<std::ptrdiff_t>(rank - begins_[chunk]), slot);
  for (std::size_t after = chunk + 1; after < begins_.size(); ++after) ++begins_[after];
  if (slots.size() < 2 * kChunk) return;
  std::vector<Slot> rest(slots.begin() + kChunk, slots.end());
  slots.resize(kChunk);
  const auto next = static_cast<std::ptrdiff_t>(chunk) + 1;
  chunks_.insert(chunks_.begin() + next, std::move(rest));
  begins_.insert(begins_.begin() + next, begins_[chunk] + static_cast<std::uint32_t>(kChunk));
}

void IdOrder::move(std::size_t rank, Slot slot) {
  if (chunks_.empty() && rank == slot) return;
  if (chunks_.empty()) list_slots();
  const std::size_t chunk = chunk_of(rank);
  chunks_[chunk][rank - begins_[chunk]] = slot;
}

std::size_t IdOrder::memory_bytes() const {
  std::size_t bytes =
      chunks_.capacity() * sizeof(std::vector<Slot>) + begins_.capacity() * sizeof(std::uint32_t);
  for (const std::vector<Slot>& chunk : chunks_) bytes += chunk.capacity() * sizeof(Slot);
  return bytes;
}

void IdOrder::list_slots() {
  std::vector<Slot> slots(size_);
  std::iota(slots.begin(), slots.end(), Slot{0});
  take(slots);
}

void IdOrder::take(std::span<const Slot> slots) {
  for (std::size_t begin = 0; begin < slots.size(); begin += kChunk) {
    const std::span<const Slot> part = slots.subspan(begin, std::min(kChunk, slots.size() - begin));
    chunks_.emplace_back(part.begin(), part.end());
    begins_.push_back(static_cast<std::uint32_t>(begin));
  }
}

}  // namespace hardball
