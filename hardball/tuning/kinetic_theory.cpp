// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/tuning/kinetic_theory.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hardball {
namespace {

constexpr double kDensestFluid = 0.5;

// The mean over pairs of (r_i + r_j)^2 [L^2].
double mean_square_reach(const Moments& moments) {
  return 2 * (moments.radius_power[2] + moments.radius_power[1] * moments.radius_power[1]);
}

double fluid_packing(const Moments& moments) {
  return std::min(moments.packing_fraction(), kDensestFluid);
}

// n k T times the compressibility: the variance over the mean of the number of spheres in a large region.
double structure_factor_at_zero(double packing) {
  const double free = 1 - packing;
  const double odd = 1 + 2 * packing;
  return free * free * free * free / (odd * odd + packing * packing * packing * (packing - 4));
}

}  // namespace

double contact_value(const Moments& moments) {
  if (moments.spheres == 0) return 1;
  const double packing = fluid_packing(moments);
  const double free = 1 - packing;
  // Surface per volume, over six, times the means over pairs of h and h^2, h = 2 r_i r_j / (r_i + r_j),
  // weighted by (r_i + r_j)^2.
  const double surface = packing * moments.radius_power[2] / (2 * moments.radius_power[3]);
  const double first =
      surface * 4 * moments.radius_power[1] * moments.radius_power[2] / mean_square_reach(moments);
  const double second =
      surface * surface * 4 * moments.radius_power[2] * moments.radius_power[2] / mean_square_reach(moments);
  return 1 / free + 3 * first / (free * free) + 2 * second / (free * free * free);
}

double mean_free_path(const Moments& moments) {
  if (moments.spheres < 2) return std::numeric_limits<double>::infinity();
  return 1 / (std::numbers::sqrt2 * std::numbers::pi * mean_square_reach(moments) * moments.number_density() *
              contact_value(moments));
}

double mean_free_time(const Moments& moments) {
  return moments.mean_speed > 0 ? mean_free_path(moments) / moments.mean_speed
                                : std::numeric_limits<double>::infinity();
}

double compressibility(const Moments& moments) {
  return 1 + 4 * fluid_packing(moments) * contact_value(moments);
}

double wall_rate(const Moments& moments) {
  const double packing = fluid_packing(moments);
  const double depleted = moments.mean_radius() * (1 - packing) / (1 + 2 * packing);  // at each wall [L]
  double rate = 0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!moments.box.is_wall(axis)) continue;
    const double filled = moments.extent[axis] - 2 * depleted;
    rate += moments.mean_speed / 2 / filled * compressibility(moments);
  }
  return rate;
}

double excess_about_sphere(const Moments& moments) {
  return structure_factor_at_zero(fluid_packing(moments)) - 1;
}

double excess_about_pair(const Moments& moments) {
  const double packing = fluid_packing(moments);
  // The derivative of the logarithm of the contact value with respect to that of the density.
  const double crowding = packing * (3 / (1 - packing) - 1 / (2 - packing));
  return structure_factor_at_zero(packing) * (2 + crowding) - 1;
}

}  // namespace hardball
