// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstring>

#include "hardball/events/event.hpp"

namespace hardball {

/// A bit for each of the first `count` slots, a multiple of four, that is `slot`. Branchless, since it is
/// unpredictable which is.
template <std::uint32_t count>
std::uint32_t places_of(Slot slot, const Slot* slots) {
  using Four = Slot __attribute__((vector_size(16)));
  static_assert(count % 4 == 0 && count <= 32);
  const Four sought{slot, slot, slot, slot};
  Four bit{1, 2, 4, 8};
  Four found{};
  for (std::uint32_t i = 0; i < count; i += 4) {
    Four four;
    std::memcpy(&four, slots + i, sizeof four);
    found |= (four == sought) & bit;
    bit <<= 4;
  }
  return found[0] | found[1] | found[2] | found[3];
}

}  // namespace hardball
