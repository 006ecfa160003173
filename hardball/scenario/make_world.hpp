// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "hardball/errors/export.hpp"
#include "hardball/memory/function.hpp"
#include "hardball/scenario/scenario.hpp"
#include "hardball/world/progress.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// The share of space that spheres fill where they are placed along open axes without a size [1].
inline constexpr double kOpenPackingFraction = 0.1;

/// Called with a sentence about how the start came about: what is right, but perhaps not what was meant.
using OnNote = Function<void(const std::string& note)>;

/// The box of a scenario. Error: see Box.
HARDBALL_EXPORT Box make_box(const Scenario& scenario);

/// The world that a scenario describes, at time zero: places the spheres and gives them velocities, or reads
/// the start file.
///
/// One sequence of random numbers, from the scenario's seed, gives first the radii that are distributed, then
/// all positions, then all velocities. Along open axes without a size, placement uses an interval around 0 of
/// which the spheres fill a tenth. Spheres at random avoid listed ones; where they are too dense to be placed
/// one after the other, they grow into place, see place_by_growth. Error, with its location in the scenario
/// or the start file: the spheres do not fit; groups on a lattice have several radii; what draw_radii
/// refuses; what World::add refuses. Overlaps among listed or read positions are not checked here. Calls
/// on_note if spheres grew into place, or if the start file has another box than the scenario, whose box is
/// used.
HARDBALL_EXPORT World make_world(const Scenario& scenario, const OnProgress& on_progress = {},
                                 const OnNote& on_note = {});

/// Makes the part of a world that one of several processes keeps: returns the world without spheres, and
/// calls take(state) for the spheres that are wanted, in the order of ids. Memory: that of all spheres only
/// where they are placed at random or listed, are of several groups, or come from a file. Error: as for
/// make_world.
HARDBALL_EXPORT World make_part(const Scenario& scenario, const Function<bool(SphereId)>& is_wanted,
                                const Function<void(const SphereState&)>& take,
                                const OnProgress& on_progress = {}, const OnNote& on_note = {});

}  // namespace hardball
