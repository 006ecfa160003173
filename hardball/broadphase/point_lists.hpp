// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "hardball/broadphase/match_mask.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/events/event.hpp"
#include "hardball/kernels/near_kernel.hpp"
#include "hardball/memory/huge_pages.hpp"

namespace hardball {

/// Many short lists of points and their owners' slots, in blocks that a kernel reads as they are; longer
/// lists chain several.
///
/// A list is identified by its first block, which is full if there are others; lists 0 to n-1 exist after
/// reset(n). They are unordered, and may have gaps. Cost: O(1) per operation for short lists, O(length) for
/// long ones.
class PointLists {
 public:
  static constexpr std::uint32_t kNone = PointBlock::kNone;

  /// Makes `count` empty lists and discards all others.
  void reset(std::size_t count) {
    blocks_.clear();
    blocks_.resize(count);
    next_.assign(count, kNone);
    free_block_ = kNone;
  }

  void insert(std::uint32_t list, Slot slot, PackedPosition position) {
    std::uint32_t at = list;
    std::uint32_t gaps;
    while ((gaps = matches_in(at, PointBlock::kNoSlot)) == 0) {
      if (next_[at] == kNone) {
        const std::uint32_t added = new_block();
        next_[at] = added;
      }
      at = next_[at];
    }
    const auto lane = static_cast<std::size_t>(std::countr_zero(gaps));
    PointBlock& block = blocks_[at];
    block.slots[lane] = slot;
    block.positions[lane] = position.bits();
  }

  /// Precondition: the slot is in the list.
  void erase(std::uint32_t list, Slot slot) {
    std::uint32_t at = list;
    std::uint32_t before = kNone;
    std::uint32_t matches;
    while ((matches = matches_in(at, slot)) == 0) {
      before = at;
      at = next_[at];
      HARDBALL_CHECK(at != kNone);
    }
    const bool was_full = matches_in(list, PointBlock::kNoSlot) == 0;
    const auto lane = static_cast<std::size_t>(std::countr_zero(matches));
    blocks_[at].slots[lane] = PointBlock::kNoSlot;
    if (at == list) {
      if (!was_full || next_[list] == kNone) [[likely]]
        return;
      before = list;
      at = next_[list];
      move_point(at, list, lane);
    }
    if (matches_in(at, PointBlock::kNoSlot) != kAll) return;
    next_[before] = std::exchange(next_[at], std::exchange(free_block_, at));
  }

  /// All blocks, by number; a list's first has the number of the list.
  const PointBlock* blocks() const { return blocks_.data(); }
  /// By block, the number of the next one of its list; kNone after the last.
  const std::uint32_t* next() const { return next_.data(); }

  std::size_t memory_bytes() const {
    return blocks_.capacity() * sizeof(PointBlock) + next_.capacity() * sizeof(std::uint32_t);
  }

 private:
  static constexpr std::uint32_t kAll = (1U << PointBlock::kRoom) - 1;

  std::uint32_t new_block() {
    if (free_block_ == kNone) {
      append_sparingly(blocks_, PointBlock{});
      append_sparingly(next_, kNone);
      return static_cast<std::uint32_t>(blocks_.size() - 1);
    }
    return std::exchange(free_block_, std::exchange(next_[free_block_], kNone));
  }

  // A bit for each lane of a block that holds the slot.
  std::uint32_t matches_in(std::uint32_t block, Slot slot) const {
    return match_mask<PointBlock::kRoom>(slot, blocks_[block].slots.data());
  }

  // Fills a gap of a block with some point of another.
  void move_point(std::uint32_t from, std::uint32_t to, std::size_t gap) {
    const std::uint32_t points = kAll & ~matches_in(from, PointBlock::kNoSlot);
    const auto lane = static_cast<std::size_t>(std::countr_zero(points));
    blocks_[to].slots[gap] = std::exchange(blocks_[from].slots[lane], PointBlock::kNoSlot);
    blocks_[to].positions[gap] = blocks_[from].positions[lane];
  }

  LargeVector<PointBlock> blocks_;
  LargeVector<std::uint32_t> next_;  // of the same list
  std::uint32_t free_block_ = kNone;
};

}  // namespace hardball
