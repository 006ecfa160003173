// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>

#include "hardball/theory/moments.hpp"

namespace hardball::support {

/// The moments of a gas of equal spheres at mean speed one in a cube. Error: see Box.
inline Moments gas_moments(std::size_t spheres, double packing_fraction, double radius,
                           Boundary boundary = Boundary::periodic) {
  Moments moments;
  moments.spheres = spheres;
  double power = 1;
  for (double& mean : moments.radius_power) {
    mean = power;
    power *= radius;
  }
  moments.largest_radius = radius;
  moments.mean_speed = 1;
  const double volume =
      static_cast<double>(spheres) * 4 * std::numbers::pi / 3 * radius * radius * radius / packing_fraction;
  const double edge = std::cbrt(volume);
  moments.extent = {edge, edge, edge};
  moments.box = Box({boundary, boundary, boundary}, moments.extent);
  return moments;
}

}  // namespace hardball::support
