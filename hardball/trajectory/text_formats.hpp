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

/// Writes a table of comma-separated values (CSV), with a line for each sphere under the names of the columns
/// (see SphereColumns).
TextFrame csv_frame();

/// Tables of numbers under the names of columns (see known_columns), separated by commas, semicolons, tabs or
/// blanks. Lines that begin with # are ignored, unless the table has no other names: then the last such line
/// that names x, y and z does. Values may be in quotes, and numbers may have decimal commas where something
/// else separates them. Error, located by file:line:column: see SphereColumns.
TextFormat csv_format();

/// Writes Smallenburg's format: the number of spheres, the edges of the box, and for each sphere
/// a letter for its species, its center, not folded into the box, and its radius. It has no velocities,
/// masses or ids. Source: the section "Snapshot file format" of the EDMD codes' README (Smallenburg, Eur.
/// Phys. J. E 45, 22, 2022).
TextFrame sph_frame();

/// The format of sph_frame; the box is periodic, centers are folded into it, and lines that begin with # are
/// passed over. Error, located by file:line:column: a line has not as many values, a
/// value is not a finite number, the last frame is incomplete.
TextFormat sph_format();

}  // namespace hardball
