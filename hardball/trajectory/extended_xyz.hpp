// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/trajectory/text_snapshot_reader.hpp"
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

/// Extended XYZ, from which a run can start.
///
/// The columns `pos:R:3`, `velo:R:3` and `radius:R:1` are required, in any order; `mass:R:1` (default 1),
/// `id:I:1`, `type:I:1`, `map_shift:I:3`, `angular_velocity:R:3` and `moment:R:1` are optional, and others
/// are ignored. As ASE has it, `masses:R:1` may stand for `mass`, and `momenta:R:3` with either for `velo`.
/// Error, located by file:line:column: a column is missing, a line has too few values, a value is not a
/// finite number, an id occurs twice, the last frame is incomplete.
TextFormat extended_xyz_format();

}  // namespace hardball
