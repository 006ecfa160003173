// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/trajectory/snapshot.hpp"
#include "hardball/trajectory/text_trajectory.hpp"

namespace hardball {

/// Appends a frame of an extended XYZ file, for OVITO, ASE and hardball itself.
///
/// Numbers have as many digits as needed to read back the same bits. Centers are folded into a periodic box;
/// `map_shift` counts the boxes. Along open axes the lattice spans the spheres, and the frame says
/// `unbounded=T`; in two dimensions it says `dimensions=2`. The columns `momenta` and `masses` are for ASE,
/// which computes velocities from them; there kinematic spheres have the mass kLargestMagnitude. Where types
/// are finer than species, `species_id` is the species, from one on.
void append_extended_xyz(const Snapshot& snapshot, std::uint64_t frame, const AppendText& append);
void append_extended_xyz_head(const Snapshot& head, std::size_t spheres, const SphereTypes& types,
                              std::uint64_t frame, const AppendText& append);
void append_extended_xyz_spheres(const Snapshot& part, const SphereTypes& types, const AppendText& append);

inline constexpr TextFrame kExtendedXyz{append_extended_xyz, append_extended_xyz_head,
                                        append_extended_xyz_spheres};

}  // namespace hardball
