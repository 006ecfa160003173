// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hardball/events/event.hpp"

namespace hardball {

/// A set of slots: a bit for each.
class SlotSet {
 public:
  /// Makes the set empty, with room for `slots` slots. Cost: O(slots).
  void reset(std::size_t slots) { words_.assign(slots / kBits + 1, 0); }

  /// Precondition: the set has room for the slot.
  bool contains(Slot slot) const { return (words_[slot / kBits] >> (slot % kBits) & 1) != 0; }

  /// Inserts a slot, or erases it. There may be more slots than before.
  void set(Slot slot, bool is_in) {
    if (slot / kBits >= words_.size()) words_.resize(slot / kBits + 1);
    const std::uint64_t bit = std::uint64_t{1} << (slot % kBits);
    words_[slot / kBits] = (words_[slot / kBits] & ~bit) | (is_in ? bit : 0);
  }

  std::size_t memory_bytes() const { return words_.capacity() * sizeof(std::uint64_t); }

 private:
  static constexpr Slot kBits = 64;

  std::vector<std::uint64_t> words_;
};

}  // namespace hardball
