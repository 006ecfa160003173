// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "hardball/geometry/extent.hpp"
#include "hardball/geometry/four_numbers.hpp"
#include "hardball/geometry/vec3.hpp"

namespace hardball {

/// Four extents beside each other.
struct FourExtents {
  std::array<FourNumbers, kAxes> low;   ///< [L], by axis
  std::array<FourNumbers, kAxes> high;  ///< [L], by axis

  Extent operator[](std::size_t i) const {
    return {{low[0][i], low[1][i], low[2][i]}, {high[0][i], high[1][i], high[2][i]}};
  }
};

/// The distances from a point to the nearest points of extents [L]; zero inside.
inline FourNumbers distance_to(const FourExtents& extents, const Vec3& point) {
  const FourNumbers zero;
  FourNumbers square;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const FourNumbers place(point[axis]);
    const FourNumbers beyond = larger(larger(extents.low[axis] - place, place - extents.high[axis]), zero);
    square = square + beyond * beyond;
  }
  return square_root(square);
}

}  // namespace hardball
