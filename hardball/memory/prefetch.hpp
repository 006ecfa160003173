// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace hardball {

/// Prefetches the cache line at `address`, which need not be valid.
inline void prefetch(const void* address) {
#if defined(__x86_64__) && defined(__GNUC__)
  // GCC drops loops whose only effect is its own __builtin_prefetch.
  asm volatile("prefetcht0 %0" : : "m"(*static_cast<const char*>(address)));
#elif defined(__GNUC__)
  __builtin_prefetch(address);
#else
  static_cast<void>(address);
#endif
}

/// Appends to a vector, and prefetches where it will append some time later, to write there: it is memory
/// that was used long ago.
template <class Vector, class Element>
void append_ahead(Vector& vector, const Element& element) {
  constexpr std::size_t kAheadBytes = 1024;
  vector.push_back(element);
#if defined(__GNUC__)
  __builtin_prefetch(reinterpret_cast<const char*>(vector.data() + vector.size()) + kAheadBytes, 1);
#endif
}

}  // namespace hardball
