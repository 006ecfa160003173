// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <limits>

#include "hardball/geometry/vec3.hpp"

namespace hardball {

/// A part of space: an interval along each axis, by default all of it. In a periodic box it may reach beyond
/// the faces.
struct Extent {
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  Vec3 low{-kInfinity, -kInfinity, -kInfinity};  ///< [L]
  Vec3 high{kInfinity, kInfinity, kInfinity};    ///< [L]

  /// The extent with everything within this distance [L].
  Extent grown(double distance) const {
    const Vec3 all{distance, distance, distance};
    return {low - all, high + all};
  }
  /// Enlarges the extent so that the other lies within it.
  void enclose(const Extent& other) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      low[axis] = std::min(low[axis], other.low[axis]);
      high[axis] = std::max(high[axis], other.high[axis]);
    }
  }
};

/// Whether two extents have a point in common.
inline bool overlap(const Extent& a, const Extent& b) {
  return (a.low.x <= b.high.x) & (b.low.x <= a.high.x) & (a.low.y <= b.high.y) & (b.low.y <= a.high.y) &
         (a.low.z <= b.high.z) & (b.low.z <= a.high.z);
}

/// The distance from a point to the nearest point of an extent [L]; zero inside.
inline double distance_to(const Extent& extent, const Vec3& point) {
  Vec3 apart;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    apart[axis] = std::max<double>({extent.low[axis] - point[axis], point[axis] - extent.high[axis], 0.0});
  }
  return length(apart);
}

}  // namespace hardball
