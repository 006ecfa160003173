// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/trajectory/snapshot.hpp"
#include "hardball/trajectory/text_trajectory.hpp"

namespace hardball {

/// Writes extended XYZ, for OVITO, ASE and hardball itself.
///
/// Numbers have as many digits as needed to read back the same bits. Centers are folded into a periodic box;
/// `map_shift` counts the boxes. Along open axes the lattice spans the spheres, and the frame says
/// `unbounded=T`; in two dimensions it says `dimensions=2`. The columns `momenta` and `masses` are for ASE,
/// which computes velocities from them; there kinematic spheres have the mass kLargestMagnitude. Where types
/// are finer than species, `species_id` is the species, from one on.
TextFrame extended_xyz_frame();

}  // namespace hardball
