// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/describe/field.hpp"
#include "hardball/geometry/vec3.hpp"

/// The fields that several shapes of surfaces have.
namespace hardball {

/// The unit normal of a plane.
template <class Get>
constexpr Field<Get> normal_field(Get get) {
  return {.name = "normal",
          .get = get,
          .meaning = "a vector of any length that points from the plane to the side where the spheres are",
          .example = "[0.0, 0.0, 1.0]"};
}

/// A unit vector along an axis of revolution.
template <class Get>
constexpr Field<Get> axis_field(Get get) {
  return {.name = "axis",
          .get = get,
          .meaning = "a vector of any length along the axis; of a cone, from the apex into it",
          .example = "[0.0, 0.0, 1.0]"};
}

/// The radius of a tube or a sphere.
template <class Get>
constexpr Field<Get> radius_field(Get get) {
  return {.name = "radius",
          .get = get,
          .range = NumberRange::positive,
          .dimension = "L",
          .meaning = "its radius",
          .example = "4.0"};
}

/// The axis of a box along which a unit vector lies; kAxes if there is none.
constexpr std::size_t axis_along(const Vec3& direction) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (direction[axis] == 1 || direction[axis] == -1) return axis;
  }
  return kAxes;
}

}  // namespace hardball
