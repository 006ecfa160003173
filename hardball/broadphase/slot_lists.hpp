// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <utility>

#include "hardball/broadphase/match_mask.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/events/event.hpp"
#include "hardball/memory/huge_pages.hpp"

namespace hardball {

/// Many short lists of slots, each in its own cache line; longer ones chain several.
///
/// A list is identified by its first line; lists 0 to n-1 exist after reset(n). They are unordered. Of
/// several lines all are full except the second, where the list grows and shrinks. Cost: O(1) per operation,
/// O(length) to erase.
class SlotLists {
 public:
  static constexpr std::uint32_t kRoom = 14;
  /// The slots that fit into a cache line besides the count and the link.
  using LineOfSlots = std::array<Slot, kRoom>;

  /// Makes `count` empty lists and discards all others.
  void reset(std::size_t count) {
    lines_.clear();
    lines_.resize(count);
    free_line_ = kNone;
  }

  void insert(std::uint32_t list, Slot slot) {
    if (lines_[list].count == kRoom) [[unlikely]]
      list = second_with_room(list);
    Line& line = lines_[list];
    line.slots[line.count++] = slot;
  }

  /// Precondition: the slot is in the list.
  void erase(std::uint32_t list, Slot slot) {
    std::uint32_t at = list;
    std::uint32_t matches;
    while ((matches = matches_in(lines_[at], slot)) == 0) {
      at = lines_[at].next;
      HARDBALL_CHECK(at != kNone);
    }
    Line& first = lines_[list];
    const bool is_single = first.next == kNone;
    Line& end = is_single ? first : lines_[first.next];
    lines_[at].slots[static_cast<std::size_t>(std::countr_zero(matches))] = end.slots[--end.count];
    if (end.count > 0 || is_single) return;
    const std::uint32_t empty = std::exchange(first.next, end.next);
    lines_[empty].next = std::exchange(free_line_, empty);
  }

  /// Calls visit(slots, count) for each line of the list; the array is longer than count.
  template <class Visit>
  void for_each_line(std::uint32_t list, Visit&& visit) const {
    for (; list != kNone; list = lines_[list].next) visit(lines_[list].slots, lines_[list].count);
  }
  /// Calls visit(slot) for each slot of the list.
  template <class Visit>
  void for_each(std::uint32_t list, Visit&& visit) const {
    for_each_line(list, [&](const LineOfSlots& slots, std::uint32_t count) {
      for (std::uint32_t i = 0; i < count; ++i) visit(slots[i]);
    });
  }

  /// Copies the slots in the first line of the list, and returns their number. The whole line is copied.
  std::uint32_t copy_first(std::uint32_t list, Slot* to) const {
    const Line& line = lines_[list];
    std::memcpy(to, line.slots.data(), sizeof line.slots);
    return line.count;
  }

  /// The address of the list's first line, for prefetching.
  const void* address(std::uint32_t list) const { return &lines_[list]; }

  std::size_t memory_bytes() const { return lines_.capacity() * sizeof(Line); }

 private:
  static constexpr std::uint32_t kNone = UINT32_MAX;

  struct alignas(64) Line {
    std::uint32_t count = 0;
    std::uint32_t next = kNone;
    LineOfSlots slots{};
  };

  // A bit for each lane of a line that holds the slot.
  static std::uint32_t matches_in(const Line& line, Slot slot) {
    static_assert(sizeof(Line) == 16 * sizeof(Slot));
    constexpr std::uint32_t kBefore = 2;  // the count and the link
    return match_mask<16>(slot, reinterpret_cast<const Slot*>(&line)) >> kBefore & ((1U << line.count) - 1);
  }

  // The second line of a list whose first is full.
  std::uint32_t second_with_room(std::uint32_t list) {
    const std::uint32_t second = lines_[list].next;
    if (second != kNone && lines_[second].count < kRoom) return second;
    const std::uint32_t added = new_line();
    lines_[added].next = second;
    lines_[list].next = added;
    return added;
  }

  std::uint32_t new_line() {
    if (free_line_ == kNone) {
      append_sparingly(lines_, Line{});
      return static_cast<std::uint32_t>(lines_.size() - 1);
    }
    const std::uint32_t line = free_line_;
    free_line_ = lines_[line].next;
    lines_[line].count = 0;
    lines_[line].next = kNone;
    return line;
  }

  LargeVector<Line> lines_;
  std::uint32_t free_line_ = kNone;
};

}  // namespace hardball
