// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/measure/scene.hpp"

/// The structure of the fluid of equal hard spheres in equilibrium, for comparison with the measures of
/// structure. Lengths are in diameters.
namespace hardball {

/// Packing fraction of spheres to which this theory applies: those of equal radius to which FluidTheory
/// applies; zero for those of an ideal gas, NaN for any others. Cost: O(n).
double fluid_packing_fraction(const Scene& scene);

/// The static structure factor in the approximation of Percus and Yevick [1]; `wave_number` in 1 / diameter.
/// Source: Wertheim, Phys. Rev. Lett. 10 (1963) 321; Hansen and McDonald, Theory of Simple Liquids, section
/// 4.4.
double percus_yevick_structure_factor(double packing_fraction, double wave_number);

/// By which fraction the mean gap by nearest_neighbor_beyond may be off [1].
inline constexpr double kGapTolerance = 0.015;

/// The probability that no other center is closer than `distance` to that of a sphere [1].
/// Source: Torquato, Phys. Rev. E 51 (1995) 3170; docs/measures.md for discs.
double nearest_neighbor_beyond(double packing_fraction, double distance, std::size_t dimensions = 3);

}  // namespace hardball
