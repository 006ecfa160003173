// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/events/event.hpp"
#include "hardball/standard/ranges.hpp"

namespace hardball {

/// The slots of all spheres in the order of their ids. A rank is the number of spheres with lower ids.
///
/// Slots are listed in chunks of some hundred, so that one more or one less moves few others. Takes no memory
/// while slots are in the order of ids.
class HARDBALL_EXPORT IdOrder {
 public:
  std::size_t size() const { return size_; }

  /// The slot of a rank. Precondition: rank < size(). Cost: O(log n).
  Slot operator[](std::size_t rank) const {
    if (chunks_.empty()) return static_cast<Slot>(rank);
    const std::size_t chunk = chunk_of(rank);
    return chunks_[chunk][rank - begins_[chunk]];
  }

  /// Calls visit(slot) for all, in the order of ids. Cost: O(n).
  template <class Visit>
  void for_each(Visit&& visit) const {
    if (chunks_.empty()) {
      for (std::size_t rank = 0; rank < size_; ++rank) visit(static_cast<Slot>(rank));
    }
    for (const std::vector<Slot>& chunk : chunks_) {
      for (const Slot slot : chunk) visit(slot);
    }
  }

  /// How many spheres have lower ids than this one; `ids` are those of the slots. Cost: O(log n), less where
  /// few ids are missing.
  std::size_t rank_of(SphereId id, std::span<const SphereId> ids) const;

  /// Sorts the slots of spheres by their ids, which are below `end`. Cost: O(n log n), or O(end).
  void sort(std::span<const SphereId> ids, SphereId end);
  /// A sphere with a higher id than all others is stored in slot size(). Cost: O(1) amortized.
  void append() { insert(size_, static_cast<Slot>(size_)); }
  /// The sphere of this rank is no more. Cost: O(sqrt n), less than a cache miss; O(n) for the first.
  void erase(std::size_t rank);
  /// A sphere of this rank is stored in a slot. Cost: as of `erase`; O(1) for the last rank.
  void insert(std::size_t rank, Slot slot);
  /// The sphere of this rank is stored elsewhere. Cost: as of operator[].
  void move(std::size_t rank, Slot slot);

  std::size_t memory_bytes() const;

 private:
  std::size_t chunk_of(std::size_t rank) const {
    return static_cast<std::size_t>(ranges::upper_bound(begins_, rank) - begins_.begin()) - 1;
  }
  void list_slots();
  void take(std::span<const Slot> slots);

  std::size_t size_ = 0;
  std::vector<std::vector<Slot>> chunks_;  // none while each rank is stored in the slot of the same number
  std::vector<std::uint32_t> begins_;      // the first rank of each chunk
};

}  // namespace hardball
