// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/theory/gas_statistics.hpp"

/// Hard spheres or discs in equilibrium: collision rates and correlations. Beyond the fluid range, packing
/// fractions above 0.5 are taken as 0.5, of discs those above 0.7 as 0.7.
namespace hardball {

/// Z = P V / N k T of the fluid of equal spheres [1], within 4e-5 of simulations up to freezing, at a packing
/// fraction of 0.494. Source: Kolafa, Labik and Malijevsky, Phys. Chem. Chem. Phys. 6 (2004) 2335.
HARDBALL_EXPORT double fluid_compressibility(double packing_fraction);

/// Z = P V / N k T of the fluid of equal discs [1], within 4e-5 of simulations up to freezing, at a packing
/// fraction of 0.700. Source: Kolafa and Rottner, Mol. Phys. 104 (2006) 3435, the fit to densities up to
/// 0.90.
HARDBALL_EXPORT double fluid_compressibility_of_discs(double packing_fraction);

/// The factor by which excluded volume raises the collision rate over that of a dilute gas, the mean over all
/// pairs of radii [1]. Source: Carnahan and Starling, J. Chem. Phys. 51 (1969) 635; for mixtures Mansoori,
/// Carnahan, Starling and Leland, J. Chem. Phys. 54 (1971) 1523; for discs as for
/// fluid_compressibility_of_discs, for mixtures of them Santos, Yuste and Lopez de Haro, Mol. Phys. 96 (1999)
/// 1.
HARDBALL_EXPORT double contact_value(const GasStatistics& statistics);

/// Mean free path [L]; infinite if there are fewer than two spheres.
/// Source: Chapman and Cowling, The Mathematical Theory of Non-Uniform Gases, section 5.21, with the contact
/// value as Enskog's factor.
HARDBALL_EXPORT double mean_free_path(const GasStatistics& statistics);

/// Mean free time [T]; infinite if nothing moves.
HARDBALL_EXPORT double mean_free_time(const GasStatistics& statistics);

/// Compressibility factor Z = P V / N k T of equal spheres at the same packing fraction [1].
/// Source: Carnahan and Starling, as above.
HARDBALL_EXPORT double compressibility(const GasStatistics& statistics);

/// Rate of wall contacts of one sphere [1/T]: the density at a wall is that inside times the compressibility.
/// Source: the contact theorem and, for the density inside, the adsorption by scaled-particle theory, Reiss,
/// Frisch, Helfand and Lebowitz, J. Chem. Phys. 32 (1960) 119; docs/theory.md for discs.
HARDBALL_EXPORT double wall_rate(const GasStatistics& statistics);

/// The excess over the mean of the number of spheres in a large region around a sphere, itself not counted,
/// when it touches a wall or nothing [1]: -1 for a crystal, 0 for points. Source: the compressibility
/// equation, Hansen and McDonald, Theory of Simple Liquids, section 2.6, and Carnahan and Starling's equation
/// of state; for discs that of Henderson, Mol. Phys. 30 (1975) 971.
HARDBALL_EXPORT double excess_about_sphere(const GasStatistics& statistics);

/// The excess over the mean of the number of spheres in a large region around a sphere that touches another,
/// which is counted [1].
/// Source: as above, differentiated with respect to density; docs/theory.md.
HARDBALL_EXPORT double excess_about_pair(const GasStatistics& statistics);

}  // namespace hardball
