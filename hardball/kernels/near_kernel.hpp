// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace hardball {

/// Points on the integer grid of CompactPaths (world/compact_paths.hpp) and the slots of their owners,
/// number by number, as kernels load them.
struct alignas(64) PointBlock {
  static constexpr std::size_t kRoom = 8;
  /// The slot of a gap.
  static constexpr std::uint32_t kNoSlot = UINT32_MAX;

  PointBlock() { slots.fill(kNoSlot); }

  std::array<std::array<std::uint32_t, kRoom>, 3> places{};  ///< By axis, modulo 2^32 steps.
  std::array<std::uint32_t, kRoom> slots;
};

/// A place, and points that may be near it, as plain arrays.
struct NearQuery {
  const PointBlock* blocks;
  const std::uint32_t* numbers;       ///< Of the blocks in question.
  std::size_t count;                  ///< Of these blocks.
  std::array<std::int32_t, 3> place;  ///< Modulo 2^32 steps.
  std::array<float, 3> grid;          ///< The step along each axis [L].
  float reach;                        ///< The distance within which points are near [L].
  const float* radii;                 ///< By slot: added to `reach` for each point [L]; null for none.
  float margin;                       ///< Added to each of these radii [L].
};

/// Writes to `near` the slots of the points with an image nearer to the place than `reach`, and returns their
/// number. Distances are those of single precision, but the same in both directions. Precondition: there is
/// room for all points and kWidestVector more.
using NearKernel = std::size_t (*)(const NearQuery& query, std::uint32_t* near);

}  // namespace hardball
