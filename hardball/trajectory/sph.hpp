// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/trajectory/snapshot.hpp"
#include "hardball/trajectory/text_snapshot_reader.hpp"
#include "hardball/trajectory/text_trajectory.hpp"

namespace hardball {

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
