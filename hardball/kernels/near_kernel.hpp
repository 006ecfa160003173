// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace hardball {

/// A point on the integer grid of CompactPaths (world/compact_paths.hpp), the cell in which it lies, and
/// what its owner notes there.
struct alignas(32) GridPoint {
  std::array<std::int32_t, 3> place{};  ///< Modulo 2^32 steps.
  std::array<std::int32_t, 3> cell{};
  std::uint32_t mark = 0;
  std::uint32_t count = 0;
};

/// A place, and points that may be near it, as plain arrays.
struct NearQuery {
  const GridPoint* points;     ///< By slot.
  const std::uint32_t* slots;  ///< Of the points in question, padded with kWidestVector valid slots.
  std::size_t count;
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
