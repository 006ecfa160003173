// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/memory/page_arena.hpp"

#include <algorithm>
#include <iterator>

#include "hardball/errors/error.hpp"
#include "hardball/standard/ranges.hpp"

namespace hardball {

void* PageArena::allocate(std::size_t bytes) {
  const std::size_t room = room_for(bytes);
  HARDBALL_CHECK(room <= block_bytes_);
  const std::scoped_lock lock(mutex_);
  auto gap = ranges::find_if(gaps_, [&](const auto& each) { return each.second >= room; });
  if (gap == gaps_.end()) {
    char* const block = static_cast<char*>(allocate_block_(block_bytes_));
    blocks_.emplace(block, 0);
    gap = gaps_.emplace(block, block_bytes_).first;
  }
  const auto [begin, size] = *gap;
  gaps_.erase(gap);
  if (size > room) gaps_.emplace(begin + room, size - room);
  std::prev(blocks_.upper_bound(begin))->second += room;
  return begin;
}

void PageArena::free(void* memory, std::size_t bytes) noexcept {
  char* const begin = static_cast<char*>(memory);
  std::size_t room = room_for(bytes);
  const std::scoped_lock lock(mutex_);
  const auto block = std::prev(blocks_.upper_bound(begin));
  char* const block_end = block->first + block_bytes_;
  block->second -= room;
  if (block->second == 0 && blocks_.size() > 1) {
    gaps_.erase(gaps_.lower_bound(block->first), gaps_.lower_bound(block_end));
    free_block_(block->first);
    blocks_.erase(block);
    return;
  }
  auto behind = gaps_.lower_bound(begin);
  if (behind != gaps_.end() && behind->first == begin + room && behind->first < block_end) {
    room += behind->second;
    behind = gaps_.erase(behind);
  }
  if (behind != gaps_.begin()) {
    const auto before = std::prev(behind);
    if (before->first >= block->first && before->first + before->second == begin) {
      before->second += room;
      return;
    }
  }
  gaps_.emplace_hint(behind, begin, room);
}

std::size_t PageArena::memory_bytes() const {
  const std::scoped_lock lock(mutex_);
  return blocks_.size() * block_bytes_;
}

}  // namespace hardball
