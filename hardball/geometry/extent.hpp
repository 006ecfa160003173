// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

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
};

}  // namespace hardball
