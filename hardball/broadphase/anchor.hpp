// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "hardball/broadphase/subdivision.hpp"

namespace hardball {

/// The place where a sphere's neighbor list was made. In a sheared box an anchor moves with its row of cells
/// (SlidingAnchors): its position along x is that in its row.
struct Anchor {
  std::array<std::int32_t, 3> position{};  ///< On the grid of CompactPaths, modulo 2^32 steps.
  CellIndex cell{};
  std::uint32_t expiry = 0;  ///< When the list expires where rows slide, modulo 2^32 of its ticks.
};

// On the grid of CompactPaths, modulo 2^32 steps.
inline std::int32_t sum_on_grid(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) + static_cast<std::uint32_t>(b));
}
inline std::int32_t difference_on_grid(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b));
}

}  // namespace hardball
