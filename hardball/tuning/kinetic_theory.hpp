// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/tuning/moments.hpp"

/// Hard spheres in equilibrium: how often they meet and how they crowd. Beyond the fluid's range, packing
/// fractions above 0.5, densities enter as if they were there.
namespace hardball {

/// The factor by which excluded volume raises the collision rate over that of a dilute gas, the mean over all
/// pairs of radii [1]. Source: Carnahan and Starling, J. Chem. Phys. 51 (1969) 635; for mixtures Mansoori,
/// Carnahan, Starling and Leland, J. Chem. Phys. 54 (1971) 1523.
double contact_value(const Moments& moments);

/// Mean path of a sphere between collisions [L]; infinite if there are fewer than two spheres.
/// Source: Chapman and Cowling, The Mathematical Theory of Non-Uniform Gases, section 5.21, with the contact
/// value as Enskog's factor.
double mean_free_path(const Moments& moments);

/// Mean time between the collisions of one sphere [T]; infinite if nothing moves.
double mean_free_time(const Moments& moments);

/// Pressure over density and kT, Z = P V / N k T, of equal spheres as densely packed [1].
/// Source: Carnahan and Starling, as above.
double compressibility(const Moments& moments);

/// How often one sphere touches a wall [1/T]: the density at a wall is that inside times the compressibility.
/// Source: the contact theorem and, for the density inside, the adsorption by scaled-particle theory, Reiss,
/// Frisch, Helfand and Lebowitz, J. Chem. Phys. 32 (1960) 119.
double wall_rate(const Moments& moments);

/// By how many the spheres in a large region about a sphere exceed the mean of that volume, the sphere not
/// counted, at a moment at which it touches a wall or nothing [1]: -1 for a crystal, 0 for points.
/// Source: the compressibility equation, Hansen and McDonald, Theory of Simple Liquids, section 2.6, and
/// Carnahan and Starling's equation of state.
double excess_about_sphere(const Moments& moments);

/// The same at a moment at which the sphere touches another, which is counted [1].
/// Source: as above, differentiated by the density; docs/theory.md.
double excess_about_pair(const Moments& moments);

}  // namespace hardball
