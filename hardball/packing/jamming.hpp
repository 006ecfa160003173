// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <span>

#include "hardball/numbers/cube_root.hpp"
#include "hardball/packing/container.hpp"

namespace hardball {

/// base^exponent, for exponents of 2 and 3: a volume from a length.
inline double power(double base, std::size_t exponent) {
  return exponent == 2 ? base * base : base * base * base;
}

/// The length whose power that is.
inline double root(double volume, std::size_t exponent) {
  return exponent == 2 ? std::sqrt(volume) : cube_root(volume);
}

/// Mean and width of the sizes of spheres, and how much of the volume the largest make up.
struct SizeStatistics {
  double mean = 0;                 ///< Mean of the radii [L].
  double largest = 0;              ///< [L]
  double mean_volume = 0;          ///< The mean of radius^dimensions [L^3], of discs [L^2].
  double deviation = 0;            ///< The standard deviation of radii over their mean [1].
  std::size_t half_of_volume = 0;  ///< The number of the largest spheres that make up half of the volume.
};

/// Cost: O(n log n). Precondition: there is a sphere.
SizeStatistics statistics_of(std::span<const double> radii, std::size_t dimensions);

/// The packing fraction at which spheres of these sizes can be expected to jam if they grow at a rate of .01,
/// far from walls [1]: to some 2%, discs of different sizes to some 5%. Cost: O(n log n). Source: Farr and
/// Groot, J. Chem. Phys. 131 (2009) 244104: lines through spheres are as dense as rods that fill a line
/// greedily, with gaps in proportion to the shorter neighbor.
double jamming_in_bulk(std::span<const double> radii, std::size_t dimensions);

/// The packing fraction at which spheres jam between the walls of a container, beside which fewer fit [1].
/// Source: docs/packing.md.
double plausible_packing_fraction(double in_bulk, const SizeStatistics& sizes, const Container& container);

/// The rate at which spheres reach a packing fraction without locking before, given that which is plausible.
double rate_for(double packing_fraction, double plausible);

/// PV/NkT of spheres that grow from a fluid until they jam at a plausible packing fraction: to some 20%.
double expected_compressibility(double packing_fraction, double plausible, std::size_t dimensions);

/// How many collisions for each sphere growth takes between two packing fractions. Source: kinetic theory:
/// each collision of a sphere adds sqrt(pi) / 3 times the rate to the logarithm of the temperature.
double expected_collisions(double begin, double end, double rate, double plausible, std::size_t dimensions);

}  // namespace hardball
