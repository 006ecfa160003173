// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "hardball/theory/kinetic_theory.hpp"

/// What is known about hard spheres; diameter, mass and kT are one unless said otherwise.
namespace hardball::support {

/// Z = P V / N k T of the fluid, accurate to 4e-5; a unit test compares it with a table.
using hardball::fluid_compressibility;

/// Z of the face-centered cubic crystal. Source: Speedy, J. Phys.: Condens. Matter 10 (1998) 4387, table 1.
inline double crystal_compressibility(double packing_fraction) {
  const double density = 6 * packing_fraction / std::numbers::pi;
  const double z = density / std::numbers::sqrt2;
  return 3 / (1 - z) - 0.5921 * (z - 0.7072) / (z - 0.601);
}

/// One species of a mixture.
struct Species {
  double density;  ///< Number per volume.
  double diameter;
};

/// Z of a fluid mixture. Against simulations at size ratios up to three it is accurate to 0.5% or better.
/// Source: Mansoori, Carnahan, Starling and Leland, J. Chem. Phys. 54 (1971) 1523, doi:10.1063/1.1675048.
inline double mixture_compressibility(std::span<const Species> mixture) {
  std::array<double, 4> xi{};
  for (const Species& species : mixture) {
    for (std::size_t k = 0; k < xi.size(); ++k) {
      xi[k] += std::numbers::pi / 6 * species.density * std::pow(species.diameter, static_cast<double>(k));
    }
  }
  const double free = 1 - xi[3];
  return 1 / free + 3 * xi[1] * xi[2] / (xi[0] * free * free) +
         xi[2] * xi[2] * xi[2] * (3 - xi[3]) / (xi[0] * free * free * free);
}

/// Collisions of one sphere per time, from the pressure: 6 / sqrt(pi) (Z - 1). Both follow from the density
/// of pairs at contact. Source: Chapman and Cowling, The Mathematical Theory of Non-Uniform Gases,
/// section 16.2.
inline double collision_rate(double compressibility) {
  return 6 / std::sqrt(std::numbers::pi) * (compressibility - 1);
}

/// Mean speed at kT = m = 1.
inline double mean_speed() {
  return std::sqrt(8 / std::numbers::pi);
}

/// Velocities of spheres whose total energy is fixed: a point uniform on a sphere in as many dimensions as
/// there are degrees of freedom. Exact for any number of spheres, where Maxwell's distribution is off by 1/n.
/// Hard spheres: velocities do not depend on positions, so that all this holds at every density.
///
/// One of the coordinates, u, is distributed as (1 - u^2 / 2E)^((f - 3) / 2); hence
/// <|u|> = sqrt(2E / pi) G(f / 2) / G((f + 1) / 2), <u^2> = 2E / f and <|u|^3> / <|u|> = 4E / (f + 1), G
/// being Euler's gamma function. The normal relative velocity of a pair of mass one is sqrt(2) u, and a pair
/// meets in proportion to it.
class FixedEnergy {
 public:
  FixedEnergy(double energy, double degrees_of_freedom) : energy_(energy), freedom_(degrees_of_freedom) {}

  /// The energy of n spheres at kT = 1 in a periodic box whose total momentum is zero.
  static FixedEnergy periodic(std::size_t spheres) {
    const auto n = static_cast<double>(spheres);
    return {1.5 * n, 3 * (n - 1)};
  }

  /// <|u|>
  double mean_coordinate() const {
    const double gammas = std::exp(std::lgamma(freedom_ / 2) - std::lgamma((freedom_ + 1) / 2));
    return std::sqrt(2 * energy_ / std::numbers::pi) * gammas;
  }
  /// Mean and mean square of the impact speeds of spheres of mass one.
  double mean_impact_speed() const {
    return std::numbers::sqrt2 * (2 * energy_ / freedom_) / mean_coordinate();
  }
  double mean_square_impact_speed() const { return 8 * energy_ / (freedom_ + 1); }
  /// <v^4> / <v^2>^2 of one sphere, 5/3 for many.
  double speed_kurtosis() const { return 5.0 / 3 * freedom_ / (freedom_ + 2); }

 private:
  double energy_;
  double freedom_;
};

}  // namespace hardball::support
