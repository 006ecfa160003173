// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "hardball/geometry/vec3.hpp"

namespace hardball {

/// A place, and points that may be near it, as plain arrays.
struct NearQuery {
  const Vec3* points;          ///< By slot [L].
  const std::uint32_t* slots;  ///< Of the points in question, padded with kWidestVector valid slots.
  std::size_t count;
  Vec3 place;           ///< [L]
  Vec3 period;          ///< Of the box [L]; zero along axes that are not periodic.
  Vec3 inverse_period;  ///< Zero along axes that are not periodic.
  double reach;         ///< The distance within which points are near [L].
  const double* radii;  ///< By slot: added to `reach` for each point [L]; null for none.
};

/// Writes to `near` the slots of the points with an image nearer to the place than `reach`, and returns their
/// number. Precondition: there is room for all points and kWidestVector more.
using NearKernel = std::size_t (*)(const NearQuery& query, std::uint32_t* near);

}  // namespace hardball
