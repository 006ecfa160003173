// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/memory/huge_pages.hpp"

#include <new>

#include "hardball/memory/page_arena.hpp"
#include "hardball/platform/processors.hpp"

namespace hardball {
namespace {

constexpr std::size_t kHugePage = std::size_t{1} << 21;

// Arrays of this size and more begin on a huge page of their own; smaller ones would leave too much of it
// unused.
constexpr std::size_t kLeastOwnPages = 2 * kHugePage;
// Arrays of this size and more share huge pages; smaller ones fill few pages.
constexpr std::size_t kLeastShared = std::size_t{1} << 15;

// Address sanitizers know the ends of arrays that they allocate, not of those in a page.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool kAreShared = false;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
constexpr bool kAreShared = false;
#else
constexpr bool kAreShared = true;
#endif
#else
constexpr bool kAreShared = true;
#endif

bool has_own_pages(std::size_t bytes) {
  return bytes >= kLeastOwnPages;
}

bool is_shared(std::size_t bytes) {
  return kAreShared && bytes >= kLeastShared && !has_own_pages(bytes);
}

void* allocate_pages(std::size_t bytes) {
  void* const memory = ::operator new (bytes, std::align_val_t{kHugePage});
  platform::advise_huge_pages(memory, bytes);
  return memory;
}

void free_pages(void* memory) noexcept {
  ::operator delete (memory, std::align_val_t{kHugePage});
}

// Never destroyed: arrays of static lifetime may be freed later than anything here.
PageArena& arena() {
  static PageArena& shared = *new PageArena(2 * kHugePage, allocate_pages, free_pages);
  return shared;
}

}  // namespace

void* allocate_on_huge_pages(std::size_t bytes, std::size_t alignment) {
  if (has_own_pages(bytes)) return allocate_pages(bytes);
  if (is_shared(bytes)) return arena().allocate(bytes);
  return ::operator new (bytes, std::align_val_t{alignment});
}

void free_from_huge_pages(void* memory, std::size_t bytes, std::size_t alignment) noexcept {
  if (has_own_pages(bytes)) return free_pages(memory);
  if (is_shared(bytes)) return arena().free(memory, bytes);
  ::operator delete (memory, std::align_val_t{alignment});
}

}  // namespace hardball
