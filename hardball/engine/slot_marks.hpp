// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "hardball/events/event.hpp"

namespace hardball {

/// A few slots, marked for as long as this exists, in a table small enough for the nearest cache.
class SlotMarks {
 public:
  /// Where the marks are: empty between uses.
  class Table {
   private:
    friend class SlotMarks;
    static constexpr std::size_t kSize = 1024;
    static constexpr Slot kEmpty = std::numeric_limits<Slot>::max();
    std::vector<Slot> places_ = std::vector<Slot>(kSize, kEmpty);
  };

  explicit SlotMarks(Table& table) : places_(table.places_.data()) {}
  SlotMarks(const SlotMarks&) = delete;
  SlotMarks& operator=(const SlotMarks&) = delete;
  ~SlotMarks() {
    for (std::size_t k = 0; k < count_; ++k) places_[used_[k]] = Table::kEmpty;
  }

  /// Marks a slot; false if its place is taken, or there are too many marks.
  bool mark(Slot slot) {
    Slot& place = places_[slot % Table::kSize];
    if (place != Table::kEmpty || count_ == kMost) return false;
    place = slot;
    used_[count_++] = static_cast<std::uint16_t>(slot % Table::kSize);
    return true;
  }
  bool is_marked(Slot slot) const { return places_[slot % Table::kSize] == slot; }

 private:
  static constexpr std::size_t kMost = 64;
  Slot* places_;
  std::size_t count_ = 0;
  std::uint16_t used_[kMost];
};

}  // namespace hardball
