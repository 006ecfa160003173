// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "hardball/geometry/vec3.hpp"

namespace hardball {

/// A place and points that may be near it, as plain arrays.
struct NearQuery {
  const Vec3* points;          ///< By slot [L].
  const std::uint32_t* slots;  ///< Of the points in question, with room for kWidestVector behind them, filled
                               ///< with any.
  std::size_t count;
  Vec3 place;           ///< [L]
  Vec3 period;          ///< Of the box [L]; zero along axes that are not periodic.
  Vec3 inverse_period;  ///< Zero along axes that are not periodic.
  double reach;         ///< How far points are near [L].
  const double* radii;  ///< By slot: so much farther each point is near [L]; null if none is.
};

/// Writes the slots of those points of which a copy is nearer to the place than reach to `near`, where there
/// must be room for all of them and kWidestVector more; returns how many they are.
using NearKernel = std::size_t (*)(const NearQuery& query, std::uint32_t* near);

}  // namespace hardball
