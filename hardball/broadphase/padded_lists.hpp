// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "hardball/broadphase/match_mask.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/events/event.hpp"
#include "hardball/kernels/instruction_set.hpp"
#include "hardball/memory/huge_pages.hpp"

namespace hardball {

/// A set of slots for each sphere, its owner, in lanes that kernels read as they are: whole vectors, in which
/// the owner's own slot stands for none.
///
/// Short lists are in their owner's cache lines; longer ones are elsewhere, and the first lane says where.
/// Nothing else need be read to change a list. Cost: O(lanes) per operation, sixteen at a time.
class PaddedLists {
 public:
  static constexpr std::uint32_t kLine = 16;
  static_assert(kLine % kWidestVector == 0);

  /// Makes `count` empty lists with `lines` cache lines each, and discards all others. Precondition: fewer
  /// than 2^31 lists.
  void reset(std::size_t count, std::uint32_t lines = 1) {
    HARDBALL_CHECK(count < kElsewhere);
    lines_per_owner_ = lines;
    lines_.resize(count * lines);
    for (Slot owner = 0; owner < count; ++owner) {
      for (std::uint32_t i = 0; i < lines; ++i) lines_[owner * std::size_t{lines} + i].fill(owner);
    }
    elsewhere_.clear();
    free_.clear();
  }

  /// Makes an empty list for an owner, if it has none. Precondition: all lower numbers have one.
  void add_owner(Slot owner) {
    HARDBALL_CHECK(owner < kElsewhere);
    if (owner * std::size_t{lines_per_owner_} < lines_.size()) return;
    Line line;
    line.fill(owner);
    for (std::uint32_t i = 0; i < lines_per_owner_; ++i) append_sparingly(lines_, line);
  }

  /// The lanes of a list.
  std::span<const Slot> of(Slot owner) const {
    const Slot* const in_place = first_lane(owner);
    if ((*in_place & kElsewhere) != 0) [[unlikely]]
      return elsewhere_[*in_place & ~kElsewhere];
    return {in_place, lanes_in_place()};
  }

  /// The number of slots in a list.
  std::uint32_t size(Slot owner) const {
    std::uint32_t gaps = 0;
    const std::span<const Slot> all = of(owner);
    for (std::size_t i = 0; i < all.size(); i += kLine) gaps += count_of(owner, all.data() + i);
    return static_cast<std::uint32_t>(all.size()) - gaps;
  }

  /// Precondition: the slot is not in the list, and not the owner.
  void insert(Slot owner, Slot slot) {
    if (replace(owner, owner, slot)) [[likely]]
      return;
    const std::span<const Slot> all = of(owner);
    std::vector<Slot> longer(all.begin(), all.end());
    longer.push_back(slot);
    assign(owner, longer);
  }

  /// Precondition: the slot is in the list.
  void erase(Slot owner, Slot slot) {
    const bool is_found = replace(owner, slot, owner);
    HARDBALL_CHECK(is_found);
  }

  /// Replaces a list by others, which need not differ from the owner.
  void assign(Slot owner, std::span<const Slot> slots) {
    Slot& first = *first_lane(owner);
    if ((first & kElsewhere) != 0) [[unlikely]]
      free_.push_back(first & ~kElsewhere);
    std::span<Slot> lanes(&first, lanes_in_place());
    if (slots.size() > lanes.size()) [[unlikely]] {
      first = kElsewhere | index_elsewhere();
      std::vector<Slot>& longer = elsewhere_[first & ~kElsewhere];
      longer.resize((slots.size() + kLine - 1) / kLine * kLine);
      lanes = longer;
    }
    std::fill(std::copy(slots.begin(), slots.end(), lanes.begin()), lanes.end(), owner);
  }

  /// The address of a list's first line, for prefetching.
  const void* address(Slot owner) const { return first_lane(owner); }

  std::size_t memory_bytes() const {
    std::size_t bytes = lines_.capacity() * sizeof(Line) + elsewhere_.capacity() * sizeof(std::vector<Slot>);
    for (const std::vector<Slot>& longer : elsewhere_) bytes += longer.capacity() * sizeof(Slot);
    return bytes + free_.capacity() * sizeof(std::uint32_t);
  }

 private:
  struct alignas(64) Line : std::array<Slot, kLine> {};

  // Added to the index of a list elsewhere.
  static constexpr std::uint32_t kElsewhere = 1U << 31;

  static std::uint32_t count_of(Slot slot, const Slot* line) {
    return static_cast<std::uint32_t>(std::popcount(match_mask<kLine>(slot, line)));
  }

  std::size_t lanes_in_place() const { return std::size_t{lines_per_owner_} * kLine; }
  const Slot* first_lane(Slot owner) const { return lines_[std::size_t{owner} * lines_per_owner_].data(); }
  Slot* first_lane(Slot owner) { return lines_[std::size_t{owner} * lines_per_owner_].data(); }

  std::span<Slot> lanes(Slot owner) {
    Slot* const in_place = first_lane(owner);
    if ((*in_place & kElsewhere) != 0) [[unlikely]]
      return elsewhere_[*in_place & ~kElsewhere];
    return {in_place, lanes_in_place()};
  }

  // Puts a slot in place of another, once; false if that is not in the list.
  bool replace(Slot owner, Slot old, Slot by) {
    const std::span<Slot> all = lanes(owner);
    for (std::size_t i = 0; i < all.size(); i += kLine) {
      const std::uint32_t matches = match_mask<kLine>(old, all.data() + i);
      if (matches == 0) continue;
      all[i + static_cast<std::size_t>(std::countr_zero(matches))] = by;
      return true;
    }
    return false;
  }

  // An index for a list elsewhere.
  std::uint32_t index_elsewhere() {
    if (free_.empty()) {
      free_.push_back(static_cast<std::uint32_t>(elsewhere_.size()));
      elsewhere_.emplace_back();
    }
    const std::uint32_t index = free_.back();
    free_.pop_back();
    return index;
  }

  std::uint32_t lines_per_owner_ = 1;
  LargeVector<Line> lines_;
  std::vector<std::vector<Slot>> elsewhere_;  // whole lines each
  std::vector<std::uint32_t> free_;           // indices in `elsewhere_`
};

}  // namespace hardball
