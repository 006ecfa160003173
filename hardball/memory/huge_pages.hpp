// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "hardball/errors/export.hpp"

namespace hardball {

/// Memory for a large array, on huge pages where the system offers them: events access memory at random, and
/// with small pages every access also misses the TLB. Error: std::bad_alloc.
HARDBALL_EXPORT void* allocate_on_huge_pages(std::size_t bytes, std::size_t alignment);
HARDBALL_EXPORT void free_from_huge_pages(void* memory, std::size_t bytes, std::size_t alignment) noexcept;

/// The standard allocator, with allocate_on_huge_pages.
template <class T>
struct HugePageAllocator {
  using value_type = T;

  HugePageAllocator() = default;
  template <class U>
  HugePageAllocator(const HugePageAllocator<U>&) {}

  T* allocate(std::size_t count) {
    return static_cast<T*>(allocate_on_huge_pages(count * sizeof(T), alignof(T)));
  }
  void deallocate(T* memory, std::size_t count) noexcept {
    free_from_huge_pages(memory, count * sizeof(T), alignof(T));
  }

  friend bool operator==(const HugePageAllocator&, const HugePageAllocator&) { return true; }
};

/// A vector of up to millions of elements, accessed at random.
template <class T>
using LargeVector = std::vector<T, HugePageAllocator<T>>;

/// Appends to a large vector, growing it by an eighth rather than twofold, which would leave half of hundreds
/// of megabytes unused.
template <class T>
void append_sparingly(LargeVector<T>& vector, const T& element) {
  constexpr std::size_t kLeast = 16;
  if (vector.size() == vector.capacity()) vector.reserve(vector.size() + vector.size() / 8 + kLeast);
  vector.push_back(element);
}

}  // namespace hardball
