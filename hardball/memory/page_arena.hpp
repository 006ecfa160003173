// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <mutex>

namespace hardball {

/// Divides large blocks of memory among arrays, so that they share huge pages. May be called by several
/// threads.
///
/// Each array gets the first gap that is large enough, by address; adjacent gaps are one. A block that is
/// empty is given back, but for one.
class PageArena {
 public:
  using Allocate = void* (*)(std::size_t bytes);
  using Free = void (*)(void* memory) noexcept;

  /// `block_bytes` is the size of a block; `allocate_block` and `free_block` get and return one.
  PageArena(std::size_t block_bytes, Allocate allocate_block, Free free_block)
      : block_bytes_(block_bytes), allocate_block_(allocate_block), free_block_(free_block) {}

  /// Memory for an array, on a cache line. Precondition: it fits a block. Error: std::bad_alloc. Cost:
  /// O(gaps).
  void* allocate(std::size_t bytes);
  /// Takes back what allocate(bytes) returned. Cost: O(log gaps).
  void free(void* memory, std::size_t bytes) noexcept;

  /// The memory of all blocks [bytes].
  std::size_t memory_bytes() const;

 private:
  // The next array begins on a line of its own, and not a multiple of a page behind: if the same elements of
  // several arrays had the same place in their pages, they would compete for the same lines of the cache.
  static constexpr std::size_t kLine = 64;
  static std::size_t room_for(std::size_t bytes) { return (bytes + 2 * kLine - 1) / kLine * kLine; }

  std::size_t block_bytes_;
  Allocate allocate_block_;
  Free free_block_;
  mutable std::mutex mutex_;
  std::map<char*, std::size_t> gaps_;    // sizes by where they begin
  std::map<char*, std::size_t> blocks_;  // bytes in use by where they begin
};

}  // namespace hardball
