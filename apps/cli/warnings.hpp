// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "hardball/scenario.hpp"
#include "hardball/simulation.hpp"
#include "hardball/theory.hpp"

namespace hardball::cli {

/// Warnings of what the author of a run may not expect, a sentence each: no spheres can ever touch, or
/// spheres come to rest by inelastic collapse.
std::vector<std::string> warnings_of(const Scenario& scenario, const GasStatistics& statistics);

/// Warnings of walls that are meshes, a sentence each: holes, triangles that are inside out or far smaller
/// than spheres, or that lie in a face of the box.
std::vector<std::string> warnings_of_meshes(const World& world);

/// Warnings of prescribed motions, a sentence each: kinematic spheres overlap, chords are far shorter than
/// the time between collisions, or walls or spheres close a gap in which others are. `until`: the end of the
/// run [T].
std::vector<std::string> warnings_of_motions(const Simulation& simulation, const GasStatistics& statistics,
                                             double until);

}  // namespace hardball::cli
