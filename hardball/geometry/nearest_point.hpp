// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "hardball/geometry/vec3.hpp"

namespace hardball {

/// The point of the segment from `a` to `b` that is nearest to a point [L].
inline Vec3 nearest_on_segment(const Vec3& a, const Vec3& b, const Vec3& point) {
  const Vec3 along = b - a;
  const double square = dot(along, along);
  const double part = square > 0 ? std::clamp(dot(point - a, along) / square, 0.0, 1.0) : 0;
  // From the nearer end, so that each end is exact.
  return part < 0.5 ? a + part * along : b - (1 - part) * along;
}

/// The point of an axis-parallel box that is nearest to a point; the point itself within [L].
inline Vec3 nearest_in_box(const Vec3& low, const Vec3& high, const Vec3& point) {
  return {std::clamp(point.x, low.x, high.x), std::clamp(point.y, low.y, high.y),
          std::clamp(point.z, low.z, high.z)};
}

/// The point of a triangle that is nearest to a point [L]; of one without area, on its longest side.
inline Vec3 nearest_on_triangle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& point) {
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const Vec3 normal = cross(ab, ac);
  const double square = dot(normal, normal);
  if (square > 0) {
    // Twice the areas between the projection and two sides, over the area.
    const Vec3 from_a = point - a;
    const double beyond_ab = dot(cross(ab, from_a), normal);
    const double beyond_ac = dot(cross(from_a, ac), normal);
    if (beyond_ab >= 0 && beyond_ac >= 0 && beyond_ab + beyond_ac <= square)
      return point - (dot(from_a, normal) / square) * normal;
  }
  const auto distance_squared = [&](const Vec3& other) {
    const Vec3 apart = point - other;
    return dot(apart, apart);
  };
  Vec3 nearest = nearest_on_segment(a, b, point);
  for (const Vec3& other : {nearest_on_segment(b, c, point), nearest_on_segment(c, a, point)}) {
    if (distance_squared(other) < distance_squared(nearest)) nearest = other;
  }
  return nearest;
}

}  // namespace hardball
