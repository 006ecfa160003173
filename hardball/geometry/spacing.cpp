// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/geometry/spacing.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace hardball {

double spacing(const Vec3& extent, double count) {
  if (extent.z == 0) {
    const double square = std::sqrt(extent.x * extent.y / count);
    return square <= std::min(extent.x, extent.y) ? square : std::max(extent.x, extent.y) / count;
  }
  std::array<double, kAxes> lengths{extent.x, extent.y, extent.z};
  std::sort(lengths.begin(), lengths.end());
  const double volume = lengths[0] * lengths[1] * lengths[2] / count;
  const double cube = std::cbrt(volume);
  if (cube <= lengths[0]) return cube;
  const double in_slab = std::sqrt(volume / lengths[0]);
  if (in_slab <= lengths[1]) return in_slab;
  return lengths[2] / count;
}

}  // namespace hardball
