// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstring>

#include "hardball/events/event.hpp"

namespace hardball {

/// A bit for each of the first `count` slots, 8 or 16, that is `slot`. Branchless, since it is unpredictable
/// which is.
template <std::uint32_t count>
std::uint32_t match_mask(Slot slot, const Slot* slots) {
  static_assert(count == 8 || count == 16);
#if defined(__SSE2__) && defined(__GNUC__)
  using Four = int __attribute__((vector_size(16)));
  const auto sought = static_cast<int>(slot);
  const auto four = [&](std::uint32_t i) {
    Four found;
    std::memcpy(&found, slots + i, sizeof found);
    return found == Four{sought, sought, sought, sought};
  };
  const auto eight = [&](std::uint32_t i) { return __builtin_ia32_packssdw128(four(i), four(i + 4)); };
  const auto first = eight(0);
  const auto last = count == 16 ? eight(count - 8) : first ^ first;
  return static_cast<std::uint32_t>(__builtin_ia32_pmovmskb128(__builtin_ia32_packsswb128(first, last)));
#else
  std::uint32_t matches = 0;
  for (std::uint32_t i = 0; i < count; ++i) matches |= static_cast<std::uint32_t>(slots[i] == slot) << i;
  return matches;
#endif
}

}  // namespace hardball
