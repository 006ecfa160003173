// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>

#include "hardball/theory/gas_statistics.hpp"

namespace hardball::support {

/// The statistics of a gas of equal spheres at mean speed one in a cube. Error: see Box.
inline GasStatistics some_gas(std::size_t spheres, double packing_fraction, double radius,
                              Boundary boundary = Boundary::periodic) {
  GasStatistics statistics;
  statistics.spheres = spheres;
  double power = 1;
  for (double& mean : statistics.radius_power) {
    mean = power;
    power *= radius;
  }
  statistics.largest_radius = radius;
  statistics.mean_speed = 1;
  const double volume =
      static_cast<double>(spheres) * 4 * std::numbers::pi / 3 * radius * radius * radius / packing_fraction;
  const double edge = std::cbrt(volume);
  statistics.extent = {edge, edge, edge};
  statistics.box = Box({boundary, boundary, boundary}, statistics.extent);
  return statistics;
}

}  // namespace hardball::support
