// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "hardball/broadphase/places_of.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/events/event.hpp"
#include "hardball/memory/huge_pages.hpp"

namespace hardball {

/// A list of slots for each sphere, which kernels read in place: it is contiguous, and padded to whole
/// vectors with the slot of the sphere itself.
///
/// A short list is in its own cache line; a longer one is in a block of twice, four times, ... the size, and
/// its line names the block. The caller keeps the lengths, next to other data of the sphere. Lists are
/// unordered. Cost: O(1) per operation amortised, O(length) to erase.
class PaddedLists {
 public:
  /// How many slots a line holds.
  static constexpr std::uint32_t kShort = 16;

  /// Makes `count` empty lists and discards all others.
  void reset(std::size_t count) {
    lines_.resize(count);
    for (Slot owner = 0; owner < count; ++owner) lines_[owner].slots.fill(owner);
    blocks_.clear();
  }

  /// The slots of a list of length `length`, and their padding.
  const Slot* slots(Slot owner, std::uint32_t length) const {
    return length <= kShort ? lines_[owner].slots.data() : block(length)[lines_[owner].slots[0]].data();
  }

  void insert(Slot owner, std::uint32_t& length, Slot slot) {
    if (length >= kShort && is_power_of_two(length)) grow(owner, length);
    ++length;
    room(owner, length)[length - 1] = slot;
  }

  /// Precondition: the slot is in the list.
  void erase(Slot owner, std::uint32_t& length, Slot slot) {
    Slot* const slots = room(owner, length);
    Slot* const end = slots + length;
    Slot* const place = length <= kShort ? slots + std::countr_zero(places_of<kShort>(slot, slots))
                                         : std::find(slots, end, slot);
    HARDBALL_CHECK(place < end);
    *place = *(end - 1);
    slots[length - 1] = owner;
    --length;
    if (length >= kShort && is_power_of_two(length)) shrink(owner, length);
  }

  /// Replaces a list by another.
  void assign(Slot owner, std::uint32_t& length, const std::vector<Slot>& slots) {
    if (length <= kShort && slots.size() <= kShort) [[likely]] {
      auto& line = lines_[owner].slots;
      line.fill(owner);
      std::copy(slots.begin(), slots.end(), line.begin());
      length = static_cast<std::uint32_t>(slots.size());
      return;
    }
    while (length > 0) erase(owner, length, this->slots(owner, length)[length - 1]);
    for (const Slot slot : slots) insert(owner, length, slot);
  }

  /// The address of a list's line, for prefetching.
  const void* address(Slot owner) const { return &lines_[owner]; }

  std::size_t memory_bytes() const {
    std::size_t bytes = lines_.capacity() * sizeof(Line);
    for (const Blocks& size : blocks_) {
      for (const std::vector<Slot>& block : size.blocks) bytes += block.capacity() * sizeof(Slot);
      bytes += size.blocks.capacity() * sizeof(std::vector<Slot>);
    }
    return bytes;
  }

 private:
  struct alignas(64) Line {
    std::array<Slot, kShort> slots;  // or the number of the block in the first
  };
  // All blocks of one size.
  struct Blocks {
    std::vector<std::vector<Slot>> blocks;
    std::vector<std::uint32_t> free;
  };

  static bool is_power_of_two(std::uint32_t length) { return (length & (length - 1)) == 0; }

  // Blocks of size 2 kShort come first.
  static std::size_t size_index(std::uint32_t length) {
    return static_cast<std::size_t>(std::bit_width(length - 1) - std::bit_width(kShort));
  }
  const std::vector<std::vector<Slot>>& block(std::uint32_t length) const {
    return blocks_[size_index(length)].blocks;
  }
  Slot* room(Slot owner, std::uint32_t length) {
    return length <= kShort ? lines_[owner].slots.data()
                            : blocks_[size_index(length)].blocks[lines_[owner].slots[0]].data();
  }

  // Moves a list that has filled its place, whose length is a power of two, to a block of twice the size.
  void grow(Slot owner, std::uint32_t length) {
    const std::size_t index = size_index(length + 1);
    if (blocks_.size() <= index) blocks_.resize(index + 1);
    Blocks& size = blocks_[index];
    if (size.free.empty()) {
      size.free.push_back(static_cast<std::uint32_t>(size.blocks.size()));
      size.blocks.emplace_back(2 * length);
    }
    const std::uint32_t number = size.free.back();
    size.free.pop_back();
    const Slot* const from = room(owner, length);
    std::vector<Slot>& to = size.blocks[number];
    std::copy(from, from + length, to.begin());
    std::fill(to.begin() + length, to.end(), owner);
    if (length > kShort) blocks_[index - 1].free.push_back(lines_[owner].slots[0]);
    lines_[owner].slots[0] = number;
  }

  // Moves a list whose length has become a power of two back.
  void shrink(Slot owner, std::uint32_t length) {
    const std::size_t index = size_index(length + 1);
    const std::uint32_t number = lines_[owner].slots[0];
    const std::vector<Slot>& from = blocks_[index].blocks[number];
    blocks_[index].free.push_back(number);
    if (length > kShort) {
      Blocks& size = blocks_[index - 1];
      if (size.free.empty()) {
        size.free.push_back(static_cast<std::uint32_t>(size.blocks.size()));
        size.blocks.emplace_back(length);
      }
      lines_[owner].slots[0] = size.free.back();
      size.free.pop_back();
    }
    std::copy(from.begin(), from.begin() + length, room(owner, length));
  }

  LargeVector<Line> lines_;
  std::vector<Blocks> blocks_;
};

}  // namespace hardball
