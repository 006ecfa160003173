// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <span>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/world/world.hpp"

// Potentials of steps: which pairs of spheres are inside of which step, and their energy.
namespace hardball {

/// Two spheres that are tied together by a potential of the step table, the one with the lower id first.
struct Bond {
  SphereId first = 0;
  SphereId second = 0;
  StepTable::Number potential = StepTable::kNone;

  friend auto operator<=>(const Bond&, const Bond&) = default;
};

/// Ties two spheres together by a potential of the step table. Error: no sphere has an id; they are one, or
/// tied already; the potential is not a tether. Precondition: assign_levels follows.
HARDBALL_EXPORT void add_bond(World& world, SphereId a, SphereId b, StepTable::Number potential);

/// The bonds by the ids of their spheres, in order. Cost: O(pairs log pairs), O(1) if there are none.
HARDBALL_EXPORT std::vector<Bond> bonds_of(const World& world);

/// The spheres that are inside of a step of their potential with one, in the order of ids: those in its well,
/// tied to it, or that overlap a sensor. Error: no sphere has this id. Cost: O(partners log partners).
HARDBALL_EXPORT std::vector<SphereId> partners_of(const World& world, SphereId id);

/// Finds the levels of all pairs from their distances at `moment`; at the distance of a step those that
/// approach each other are inside. To be called once, before the first event: from then on levels are a
/// state. Cost: O(n). Error: spheres that are tied are too far apart or too close; a step reaches to half
/// of a periodic box.
HARDBALL_EXPORT void assign_levels(World& world, const Time& moment);

/// Finds the levels of one sphere that has been added and others that may be near it, from their distances at
/// `moment`. Cost: O(others). Error: as for all pairs.
HARDBALL_EXPORT void assign_levels(World& world, Slot added, std::span<const Slot> others,
                                   const Time& moment);

/// The potential of two spheres that are inside of no step, by its number; StepTable::kNone if none.
inline StepTable::Number potential_of(const World& world, Slot a, Slot b) {
  return world.is_kinematic(a) && world.is_kinematic(b)
             ? StepTable::kNone
             : world.interactions().steps().of(world.species(a), world.species(b));
}

/// At which distance two spheres bounce off each other, over the sum of their radii [1]; zero if they may
/// take the same place.
HARDBALL_EXPORT double core_ratio(const World& world, Slot a, Slot b);

/// The energy of all steps that a sphere is inside of, half of each pair's [M L^2 T^-2]. Cost: O(pairs of
/// the sphere).
HARDBALL_EXPORT double step_energy(const World& world, Slot slot);

/// The energy of all steps that spheres are inside of [M L^2 T^-2]. Cost: O(n).
HARDBALL_EXPORT double step_energy(const World& world);

}  // namespace hardball
