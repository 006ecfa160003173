// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/fluid_structure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hardball/theory/kinetic_theory.hpp"
#include "hardball/world/totals.hpp"

namespace hardball {

double fluid_packing_fraction(const Scene& scene) {
  const World& world = scene.world();
  const FluidTheory& fluid = scene.fluid();
  if (fluid.holds() && fluid.is_ideal()) return 0;
  const bool holds = world.base_radii().is_common() && fluid.holds();
  return holds ? sphere_volume(world, scene.now()) / world.box().volume()
               : std::numeric_limits<double>::quiet_NaN();
}

double percus_yevick_structure_factor(double packing_fraction, double wave_number) {
  // Closer to zero the closed form suffers from cancellation, and the structure factor is constant.
  const double q = std::max(wave_number, 0.02);
  const double sine = std::sin(q);
  const double cosine = std::cos(q);
  // Integrals of x sin(q x), x^2 sin(q x) and x^4 sin(q x) over the overlap, x from 0 to 1.
  const double first = (sine - q * cosine) / (q * q);
  const double second = (2 * q * sine + (2 - q * q) * cosine - 2) / (q * q * q);
  const double fourth =
      (4 * q * (q * q - 6) * sine - (q * q * (q * q - 12) + 24) * cosine + 24) / (q * q * q * q * q);
  const double free = 1 - packing_fraction;
  const double constant = std::pow(1 + 2 * packing_fraction, 2) / std::pow(free, 4);
  const double linear = -std::pow(1 + packing_fraction / 2, 2) / std::pow(free, 4);
  // Density times the Fourier transform of the direct correlation function.
  const double direct =
      -24 * packing_fraction / q *
      (constant * first + 6 * packing_fraction * linear * second + packing_fraction / 2 * constant * fourth);
  return 1 / (1 - direct);
}

double nearest_neighbor_beyond(double packing_fraction, double distance, std::size_t dimensions) {
  const double p = packing_fraction;
  const double x = std::max(distance, 1.0);
  if (dimensions == 2) {
    // The density of discs at the edge of an empty disc of radius x is a0 + a1 / x times the mean: the
    // contact value at x = 1, and Z far beyond.
    const double a0 = fluid_compressibility_of_discs(p);
    const double a1 = (a0 - 1) / (2 * p) - a0;
    return std::exp(-p * (4 * a0 * (x * x - 1) + 8 * a1 * (x - 1)));
  }
  const double cube = std::pow(1 - p, 3);
  // The density of spheres at the surface of an empty ball of radius x is a0 + a1 / x + a2 / x^2 times the
  // mean.
  const double a0 = (1 + p + p * p - p * p * p) / cube;
  const double a1 = p * (3 * p * p - 4 * p - 3) / (2 * cube);
  const double a2 = p * p * (2 - p) / (2 * cube);
  return std::exp(-p * (8 * a0 * (x * x * x - 1) + 12 * a1 * (x * x - 1) + 24 * a2 * (x - 1)));
}

}  // namespace hardball
