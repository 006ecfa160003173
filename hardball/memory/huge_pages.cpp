// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/memory/huge_pages.hpp"

#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace hardball {
namespace {

constexpr std::size_t kHugePage = std::size_t{1} << 21;

// Smaller arrays would leave too much of a page unused.
bool is_large(std::size_t bytes) {
  return bytes >= 2 * kHugePage;
}

std::align_val_t alignment_for(std::size_t bytes, std::size_t alignment) {
  return std::align_val_t{is_large(bytes) ? kHugePage : alignment};
}

}  // namespace

void* allocate_on_huge_pages(std::size_t bytes, std::size_t alignment) {
  void* const memory = ::operator new(bytes, alignment_for(bytes, alignment));
#if defined(__linux__)
  // A hint, which the system may ignore.
  if (is_large(bytes)) static_cast<void>(madvise(memory, bytes, MADV_HUGEPAGE));
#endif
  return memory;
}

void free_from_huge_pages(void* memory, std::size_t bytes, std::size_t alignment) noexcept {
  ::operator delete(memory, alignment_for(bytes, alignment));
}

}  // namespace hardball
