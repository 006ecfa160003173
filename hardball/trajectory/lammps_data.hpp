// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/trajectory/snapshot.hpp"
#include "hardball/trajectory/text_snapshot_reader.hpp"
#include "hardball/trajectory/text_trajectory.hpp"

namespace hardball {

/// Writes a data file for the command read_data of LAMMPS, of atom style sphere: `id type diameter density x
/// y z ix iy iz`, and `id vx vy vz omegax omegay omegaz` under Velocities.
///
/// Ids count from one. LAMMPS computes masses from densities, of discs too as those of spheres; kinematic
/// spheres have the mass kLargestMagnitude. The file does not say along which axes the box is periodic.
/// Source: https://docs.lammps.org/read_data.html
TextFrame lammps_data_frame();

/// LAMMPS data files of atom style sphere. The box counts as periodic along all axes, which is LAMMPS's
/// default. Without Velocities, spheres have none. Where Atoms names no style, lines of 7 or 10 values, in a
/// file without Masses, are those of spheres. Error, located by file:line:column: the atoms are of another
/// style or not as many as the file says, the box is triclinic, a value is not a finite number, an id occurs
/// twice.
TextFormat lammps_data_format();

}  // namespace hardball
