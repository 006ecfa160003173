// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <cstring>

#include "hardball/errors/language.hpp"
#include "hardball/standard/bit_cast.hpp"

namespace hardball {

/// A copy of a path from a recent moment on, of half its size, from which contact times are bounded: see
/// CompactPaths (bounds/compact_paths.hpp), which also defines the units. It is not part of the motion.
struct alignas(32) CompactPath {
  std::array<std::int32_t, 3> position{};  ///< Center at `tick`, modulo 2^32 steps of the grid.
  std::int32_t tick = 0;                   ///< When, modulo 2^32 ticks.
  std::array<float, 3> velocity{};         ///< NaN if too fast to be bounded.
  /// Eight times how often the path has changed, modulo 2^32, plus the index of its sphere's radius among up
  /// to eight.
  std::uint32_t revision = 0;

  static constexpr std::uint32_t kRadii = 8;

  /// Copies all but the revision. Kernels load the two halves, often just after they have been written: if
  /// that was done number by number, the load would have to wait until all are in the cache.
  void store(const std::array<std::int32_t, 3>& new_place, std::int32_t new_tick,
             const std::array<float, 3>& new_velocity) {
    using Integers = std::int32_t __attribute__((vector_size(16)));
    using Floats = float __attribute__((vector_size(16)));
    const Integers first{new_place[0], new_place[1], new_place[2], new_tick};
    const Floats second{new_velocity[0], new_velocity[1], new_velocity[2], bit_cast<float>(revision)};
    std::memcpy(position.data(), &first, sizeof first);
    std::memcpy(velocity.data(), &second, sizeof second);
  }
};
static_assert(sizeof(CompactPath) == 32);

}  // namespace hardball
