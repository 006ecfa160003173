// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/packing/packed_spheres.hpp"

namespace hardball {

/// The share of spheres in crystals [1]: those that have at least eight neighbors whose surroundings are
/// oriented like their own, of discs at least four. Neighbors are centers no farther away than 1.4 times the
/// distance at which the two touch; surroundings are oriented alike if the normalized scalar product of their
/// vectors q6 of bonds exceeds .7. Spheres next to walls are left out: that they have no neighbors on one
/// side makes them alike. Cost: O(n). Source: ten Wolde, Ruiz-Montero and Frenkel, J. Chem. Phys. 104 (1996)
/// 9932.
double crystalline_share(const PackedSpheres& spheres);

}  // namespace hardball
