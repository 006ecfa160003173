// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/tuning/moments.hpp"

/// Hard spheres in equilibrium: collision rates and correlations. Beyond the fluid range, packing fractions
/// above 0.5 are taken as 0.5.
namespace hardball {

/// The factor by which excluded volume raises the collision rate over that of a dilute gas, the mean over all
/// pairs of radii [1]. Source: Carnahan and Starling, J. Chem. Phys. 51 (1969) 635; for mixtures Mansoori,
/// Carnahan, Starling and Leland, J. Chem. Phys. 54 (1971) 1523.
double contact_value(const Moments& moments);

/// Mean free path [L]; infinite if there are fewer than two spheres.
/// Source: Chapman and Cowling, The Mathematical Theory of Non-Uniform Gases, section 5.21, with the contact
/// value as Enskog's factor.
double mean_free_path(const Moments& moments);

/// Mean free time [T]; infinite if nothing moves.
double mean_free_time(const Moments& moments);

/// Compressibility factor Z = P V / N k T of equal spheres at the same packing fraction [1].
/// Source: Carnahan and Starling, as above.
double compressibility(const Moments& moments);

/// Rate of wall contacts of one sphere [1/T]: the density at a wall is that inside times the compressibility.
/// Source: the contact theorem and, for the density inside, the adsorption by scaled-particle theory, Reiss,
/// Frisch, Helfand and Lebowitz, J. Chem. Phys. 32 (1960) 119.
double wall_rate(const Moments& moments);

/// The excess over the mean of the number of spheres in a large region around a sphere, itself not counted,
/// when it touches a wall or nothing [1]: -1 for a crystal, 0 for points. Source: the compressibility
/// equation, Hansen and McDonald, Theory of Simple Liquids, section 2.6, and Carnahan and Starling's equation
/// of state.
double excess_about_sphere(const Moments& moments);

/// The same when the sphere touches another, which is counted [1].
/// Source: as above, differentiated with respect to density; docs/theory.md.
double excess_about_pair(const Moments& moments);

}  // namespace hardball
