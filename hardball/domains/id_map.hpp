// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "hardball/events/event.hpp"

namespace hardball {

/// A number for each of some spheres: a hash table that is probed linearly.
class IdMap {
 public:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  /// The number of a sphere, or kNone.
  std::uint32_t find(SphereId id) const {
    for (std::size_t at = start_of(id);; at = (at + 1) & mask()) {
      if (entries_[at].number == kNone || entries_[at].id == id) return entries_[at].number;
    }
  }

  /// Sets the number of a sphere, which is not kNone.
  void set(SphereId id, std::uint32_t number) {
    if (2 * (size_ + 1) > entries_.size()) grow();
    std::size_t at = start_of(id);
    while (entries_[at].number != kNone && entries_[at].id != id) at = (at + 1) & mask();
    if (entries_[at].number == kNone) ++size_;
    entries_[at] = {id, number};
  }

  /// Precondition: the sphere has a number.
  void erase(SphereId id) {
    std::size_t at = start_of(id);
    while (entries_[at].id != id || entries_[at].number == kNone) at = (at + 1) & mask();
    --size_;
    // Later entries that could stand here move up.
    for (std::size_t next = (at + 1) & mask(); entries_[next].number != kNone; next = (next + 1) & mask()) {
      const std::size_t start = start_of(entries_[next].id);
      if (((next - start) & mask()) < ((next - at) & mask())) continue;
      entries_[at] = entries_[next];
      at = next;
    }
    entries_[at].number = kNone;
  }

  std::size_t size() const { return size_; }
  std::size_t memory_bytes() const { return entries_.capacity() * sizeof(Entry); }

 private:
  struct Entry {
    SphereId id = 0;
    std::uint32_t number = kNone;
  };

  std::size_t mask() const { return entries_.size() - 1; }
  std::size_t start_of(SphereId id) const {
    // Source: Knuth, The Art of Computer Programming 3, 6.4, multiplicative hashing.
    return (std::uint64_t{id} * 0x9e3779b97f4a7c15 >> 32) & mask();
  }

  void grow() {
    std::vector<Entry> before = std::exchange(entries_, std::vector<Entry>(2 * entries_.size()));
    size_ = 0;
    for (const Entry& entry : before) {
      if (entry.number != kNone) set(entry.id, entry.number);
    }
  }

  std::vector<Entry> entries_ = std::vector<Entry>(16);  // a power of two
  std::size_t size_ = 0;
};

}  // namespace hardball
