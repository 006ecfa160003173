// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

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

}  // namespace hardball
