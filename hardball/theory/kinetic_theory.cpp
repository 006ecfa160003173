// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/theory/kinetic_theory.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>

namespace hardball {
namespace {

constexpr double kDensestFluid = 0.5;
constexpr double kDensestFluidOfDiscs = 0.7;

// The mean over pairs of (r_i + r_j)^2 [L^2].
double mean_square_reach(const GasStatistics& statistics) {
  return 2 * (statistics.radius_power[2] + statistics.radius_power[1] * statistics.radius_power[1]);
}

double fluid_packing(const GasStatistics& statistics) {
  return std::min(statistics.packing_fraction(), statistics.is_flat() ? kDensestFluidOfDiscs : kDensestFluid);
}

// n k T times the compressibility: the variance over the mean of the number of spheres in a large region.
double structure_factor_at_zero(double packing, bool is_flat) {
  const double free = 1 - packing;
  if (is_flat) return free * free * free / (1 + packing + packing * packing * (3 - packing) / 8);
  const double odd = 1 + 2 * packing;
  return free * free * free * free / (odd * odd + packing * packing * packing * (packing - 4));
}

// One plus a sum of powers of the packing fraction over the fraction of free space.
struct Term {
  int power;
  double coefficient;
};
double series(double packing_fraction, std::initializer_list<Term> terms) {
  const double x = packing_fraction / (1 - packing_fraction);
  double z = 1;
  for (const Term& term : terms) z += term.coefficient * std::pow(x, term.power);
  return z;
}

}  // namespace

double fluid_compressibility(double packing_fraction) {
  return series(packing_fraction, {{1, 4},
                                   {2, 6},
                                   {3, 2.3647684},
                                   {4, -0.8698551},
                                   {5, 1.1062803},
                                   {6, -1.1014221},
                                   {7, 0.66605866},
                                   {8, -0.03633431},
                                   {10, -0.20965164},
                                   {14, 0.10555569},
                                   {22, -0.0087238}});
}

double fluid_compressibility_of_discs(double packing_fraction) {
  return series(packing_fraction, {{1, 2},
                                   {2, 1.12801775},
                                   {3, 0.00181895291},
                                   {4, -0.0526134737},
                                   {5, 0.0504960168},
                                   {6, -0.0325537792},
                                   {7, 0.0134578632},
                                   {8, 0.00140888182},
                                   {9, -0.00834273601},
                                   {10, 0.00694127367},
                                   {11, -0.00262254723},
                                   {12, 0.000355746352},
                                   {22, -5.24672938e-9},
                                   {57, 5.88054639e-23}});
}

double contact_value(const GasStatistics& statistics) {
  if (statistics.spheres == 0) return 1;
  const double packing = fluid_packing(statistics);
  const double free = 1 - packing;
  if (statistics.is_flat()) {
    const double alike = statistics.radius_power[1] * statistics.radius_power[1] / statistics.radius_power[2];
    const double of_equal = packing > 0 ? (fluid_compressibility_of_discs(packing) - 1) / (2 * packing) : 1;
    return 1 / free + alike * (of_equal - 1 / free);
  }
  // Surface per volume, over six, times the means over pairs of h and h^2, h = 2 r_i r_j / (r_i + r_j),
  // weighted by (r_i + r_j)^2.
  const double surface = packing * statistics.radius_power[2] / (2 * statistics.radius_power[3]);
  const double first =
      surface * 4 * statistics.radius_power[1] * statistics.radius_power[2] / mean_square_reach(statistics);
  const double second = surface * surface * 4 * statistics.radius_power[2] * statistics.radius_power[2] /
                        mean_square_reach(statistics);
  return 1 / free + 3 * first / (free * free) + 2 * second / (free * free * free);
}

double mean_free_path(const GasStatistics& statistics) {
  if (statistics.spheres < 2) return std::numeric_limits<double>::infinity();
  // Across which one sphere meets another.
  const double section =
      statistics.is_flat() ? 4 * statistics.mean_radius() : std::numbers::pi * mean_square_reach(statistics);
  return 1 / (std::numbers::sqrt2 * section * statistics.number_density() * contact_value(statistics));
}

double mean_free_time(const GasStatistics& statistics) {
  return statistics.mean_speed > 0 ? mean_free_path(statistics) / statistics.mean_speed
                                   : std::numeric_limits<double>::infinity();
}

double compressibility(const GasStatistics& statistics) {
  return 1 + (statistics.is_flat() ? 2 : 4) * fluid_packing(statistics) * contact_value(statistics);
}

double wall_rate(const GasStatistics& statistics) {
  const double packing = fluid_packing(statistics);
  // At each wall [L].
  const double depleted =
      statistics.mean_radius() * (1 - packing) / (1 + (statistics.is_flat() ? 1 : 2) * packing);
  double rate = 0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!statistics.box.is_wall(axis)) continue;
    const double filled = statistics.extent[axis] - 2 * depleted;
    rate += statistics.mean_speed_along_axis() / filled * compressibility(statistics);
  }
  return rate;
}

double excess_about_sphere(const GasStatistics& statistics) {
  return structure_factor_at_zero(fluid_packing(statistics), statistics.is_flat()) - 1;
}

double excess_about_pair(const GasStatistics& statistics) {
  const double packing = fluid_packing(statistics);
  // The derivative of the logarithm of the contact value with respect to that of the density.
  const double crowding = statistics.is_flat() ? packing * (2 / (1 - packing) - 7 / (16 - 7 * packing))
                                               : packing * (3 / (1 - packing) - 1 / (2 - packing));
  return structure_factor_at_zero(packing, statistics.is_flat()) * (2 + crowding) - 1;
}

}  // namespace hardball
