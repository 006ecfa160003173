// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "hardball/broadphase/places_of.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/events/event.hpp"
#include "hardball/kernels/instruction_set.hpp"
#include "hardball/memory/huge_pages.hpp"

namespace hardball {

/// A set of slots for each sphere, its owner, in lanes that kernels read as they are: whole vectors, in which
/// the owner's own slot stands for none.
///
/// Short lists are in their owner's cache lines; longer ones are in blocks of twice, four times, ... the
/// size, which the first lane names. Nothing else need be read to change a list. Cost: O(lanes) per
/// operation, sixteen at a time.
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
    blocks_.clear();
  }

  /// The lanes of a list.
  std::span<const Slot> of(Slot owner) const {
    const Slot* const in_place = lines_[std::size_t{owner} * lines_per_owner_].data();
    if ((*in_place & kElsewhere) != 0) [[unlikely]]
      return block(*in_place);
    return {in_place, std::size_t{lines_per_owner_} * kLine};
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
    const std::size_t in_place = std::size_t{lines_per_owner_} * kLine;
    Slot* const first = lines_[std::size_t{owner} * lines_per_owner_].data();
    if ((*first & kElsewhere) != 0) [[unlikely]]
      release(*first);
    Slot* to = first;
    std::size_t room = in_place;
    if (slots.size() > in_place) [[unlikely]] {
      *first = take_block(slots.size());
      const std::span<Slot> elsewhere = block(*first);
      to = elsewhere.data();
      room = elsewhere.size();
    }
    std::copy(slots.begin(), slots.end(), to);
    std::fill(to + slots.size(), to + room, owner);
  }

  /// The address of a list's first line, for prefetching.
  const void* address(Slot owner) const { return &lines_[std::size_t{owner} * lines_per_owner_]; }

  std::size_t memory_bytes() const {
    std::size_t bytes = lines_.capacity() * sizeof(Line);
    for (const Blocks& size : blocks_) {
      bytes += size.lines.capacity() * sizeof(Line) + size.free.capacity() * sizeof(std::uint32_t);
    }
    return bytes;
  }

 private:
  struct alignas(64) Line : std::array<Slot, kLine> {};
  // All blocks of 2^k lines.
  struct Blocks {
    LargeVector<Line> lines;
    std::vector<std::uint32_t> free;
  };

  // Of a list elsewhere, the first lane has the highest bit, k, and the number of the block.
  static constexpr std::uint32_t kElsewhere = 1U << 31;
  static constexpr std::uint32_t kNumberBits = 26;
  static std::uint32_t size_of(std::uint32_t name) { return (name & ~kElsewhere) >> kNumberBits; }
  static std::uint32_t number_of(std::uint32_t name) { return name & ((1U << kNumberBits) - 1); }

  static std::uint32_t count_of(Slot slot, const Slot* line) {
    return static_cast<std::uint32_t>(std::popcount(places_of<kLine>(slot, line)));
  }

  std::span<const Slot> block(std::uint32_t name) const {
    const std::uint32_t size = size_of(name);
    return {blocks_[size].lines[std::size_t{number_of(name)} << size].data(), std::size_t{kLine} << size};
  }
  std::span<Slot> block(std::uint32_t name) {
    const std::uint32_t size = size_of(name);
    return {blocks_[size].lines[std::size_t{number_of(name)} << size].data(), std::size_t{kLine} << size};
  }

  std::span<Slot> lanes(Slot owner) {
    Slot* const in_place = lines_[std::size_t{owner} * lines_per_owner_].data();
    if ((*in_place & kElsewhere) != 0) [[unlikely]]
      return block(*in_place);
    return {in_place, std::size_t{lines_per_owner_} * kLine};
  }

  // Puts a slot in place of another, once; false if that is not in the list.
  bool replace(Slot owner, Slot old, Slot by) {
    const std::span<Slot> all = lanes(owner);
    for (std::size_t i = 0; i < all.size(); i += kLine) {
      const std::uint32_t places = places_of<kLine>(old, all.data() + i);
      if (places == 0) continue;
      all[i + static_cast<std::size_t>(std::countr_zero(places))] = by;
      return true;
    }
    return false;
  }

  std::uint32_t take_block(std::size_t slots) {
    const auto size = static_cast<std::uint32_t>(std::bit_width((slots - 1) / kLine));
    if (blocks_.size() <= size) blocks_.resize(size + 1);
    Blocks& blocks = blocks_[size];
    if (blocks.free.empty()) {
      const std::size_t number = blocks.lines.size() >> size;
      HARDBALL_CHECK(number < 1U << kNumberBits);
      for (std::size_t i = 0; i < std::size_t{1} << size; ++i) append_sparingly(blocks.lines, Line{});
      blocks.free.push_back(static_cast<std::uint32_t>(number));
    }
    const std::uint32_t number = blocks.free.back();
    blocks.free.pop_back();
    return kElsewhere | size << kNumberBits | number;
  }
  void release(std::uint32_t name) { blocks_[size_of(name)].free.push_back(number_of(name)); }

  std::uint32_t lines_per_owner_ = 1;
  LargeVector<Line> lines_;
  std::vector<Blocks> blocks_;
};

}  // namespace hardball
