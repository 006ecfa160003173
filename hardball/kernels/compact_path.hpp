// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

namespace hardball {

/// A copy of a path from a recent moment on, of half its size, from which contact times are bounded: see
/// CompactPaths (world/compact_paths.hpp), which also defines the units. It is no part of the motion.
struct alignas(32) CompactPath {
  std::array<std::int32_t, 3> place{};  ///< Of the centre at `tick`, modulo 2^32 steps of the grid.
  std::int32_t tick = 0;                ///< When, modulo 2^32 ticks.
  std::array<float, 3> velocity{};      ///< NaN if too fast to be bounded.
  std::uint32_t revision = 0;           ///< How often the path has changed, modulo 2^32.
};

}  // namespace hardball
