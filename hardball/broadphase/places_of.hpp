// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "hardball/events/event.hpp"

namespace hardball {

/// A bit for each of the first `count` slots, 8 or 16, that is `slot`. Branchless, since it is unpredictable
/// which is.
template <std::uint32_t count>
std::uint32_t places_of(Slot slot, const Slot* slots) {
  static_assert(count == 8 || count == 16);
#if defined(__SSE2__)
  const __m128i sought = _mm_set1_epi32(static_cast<int>(slot));
  const auto four = [&](std::uint32_t i) {
    return _mm_cmpeq_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(slots + i)), sought);
  };
  const auto eight = [&](std::uint32_t i) { return _mm_packs_epi32(four(i), four(i + 4)); };
  const __m128i last = count == 16 ? eight(count - 8) : _mm_setzero_si128();
  return static_cast<std::uint32_t>(_mm_movemask_epi8(_mm_packs_epi16(eight(0), last)));
#else
  std::uint32_t places = 0;
  for (std::uint32_t i = 0; i < count; ++i) places |= static_cast<std::uint32_t>(slots[i] == slot) << i;
  return places;
#endif
}

}  // namespace hardball
