// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/trajectory/snapshot.hpp"
#include "hardball/trajectory/text_snapshot_reader.hpp"
#include "hardball/trajectory/text_trajectory.hpp"

namespace hardball {

/// Writes a LAMMPS dump: `id type x y z ix iy iz vx vy vz radius mass` and, where spheres spin,
/// `omegax omegay omegaz moment`; where types are finer than species, `species_id`. The time step is the
/// number of the frame: the readers that users have understand no time.
TextFrame lammps_dump_frame();

/// LAMMPS dumps in text, also those with ITEM: TIME, and those of LIGGGHTS. Required are a position for each
/// axis, `x`, `xu` (not folded), `xs` (scaled by the box) or `xsu` (both), of several the first of these, and
/// `radius` or `diameter`. Centers that are not folded are folded into the box. Of columns that stand twice,
/// the first counts. Error, located by file:line:column: a column is missing, the box is triclinic, a value
/// is not a finite number, an id occurs twice, columns of one name differ, the last frame is incomplete.
TextFormat lammps_dump_format();

}  // namespace hardball
