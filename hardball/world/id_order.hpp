// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/events/event.hpp"

namespace hardball {

/// The slots of all spheres in the order of their ids. A rank is the number of spheres with lower ids.
///
/// Entries of removed spheres stay empty, as gaps, until they are many, so removing one moves no others.
/// Takes no memory while slots are in the order of ids.
class HARDBALL_EXPORT IdOrder {
 public:
  std::size_t size() const { return size_; }

  /// The slot of a rank. Precondition: rank < size(). Cost: O(log(gaps)).
  Slot operator[](std::size_t rank) const {
    return slots_.empty() ? static_cast<Slot>(rank) : slots_[index_of(rank)];
  }

  /// Calls visit(slot) for all, in the order of ids. Cost: O(n).
  template <class Visit>
  void for_each(Visit&& visit) const {
    if (slots_.empty()) {
      for (std::size_t rank = 0; rank < size_; ++rank) visit(static_cast<Slot>(rank));
      return;
    }
    std::size_t empty = 0;
    for (std::size_t index = 0; index < slots_.size(); ++index) {
      if (empty < gaps_.size() && gaps_[empty] == index) {
        ++empty;
      } else {
        visit(slots_[index]);
      }
    }
  }

  /// Sorts the slots of spheres by their ids, which are below `end`. Cost: O(n log n), or O(end).
  void sort(std::span<const SphereId> ids, SphereId end);
  /// A sphere with a higher id than all others is stored in slot size(). Cost: O(1) amortized.
  void append();
  /// The sphere of this rank is no more. Cost: O(sqrt n) amortized, less than a cache miss.
  void erase(std::size_t rank);
  /// A sphere of this rank is stored in a slot again. Cost: as of `erase`, if it was the last to be erased.
  void insert(std::size_t rank, Slot slot);
  /// The sphere of this rank is stored elsewhere.
  void move(std::size_t rank, Slot slot);

  std::size_t memory_bytes() const {
    return slots_.capacity() * sizeof(Slot) + gaps_.capacity() * sizeof(std::uint32_t);
  }

 private:
  std::size_t index_of(std::size_t rank) const { return gaps_.empty() ? rank : skip_empty(rank); }
  std::size_t skip_empty(std::size_t rank) const;
  void list_slots();
  void close_gaps();

  std::size_t size_ = 0;
  std::vector<Slot> slots_;          // none while each rank is stored in the slot of the same number
  std::vector<std::uint32_t> gaps_;  // in slots_, ascending
};

}  // namespace hardball
