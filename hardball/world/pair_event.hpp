// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/errors/export.hpp"
#include "hardball/geometry/contact_time.hpp"
#include "hardball/world/pair_levels.hpp"
#include "hardball/world/world.hpp"

// What two spheres do next, if they meet each other alone.
namespace hardball {

/// Whether the contacts of two spheres do not deflect them.
inline bool pass(const World& world, Slot a, Slot b) {
  return world.interactions().pass(world.species(a), world.species(b)) ||
         (world.is_kinematic(a) && world.is_kinematic(b));
}

/// Whether contacts of some pairs do not deflect them: species that pass, and kinematic spheres.
inline bool has_passing_pairs(const World& world) {
  return world.interactions().has_passing() || world.kinematic_count() > 1;
}

/// The next event of two spheres that meet each other alone.
struct PairEvent {
  Time time = kNever;
  bool is_outward = false;  ///< Whether they come to a step from inside.
};

/// The next event of two spheres with a potential of steps, `image` being that of `b` which `a` meets: a
/// function of their paths and their level.
HARDBALL_EXPORT PairEvent next_pair_event(const World& world, Slot a, Slot b, const Image& image);

/// The next event of a sphere and one of its pairs, `image` being that of the partner which it meets.
HARDBALL_EXPORT PairEvent next_pair_event(const World& world, Slot slot, const PairLevel& pair,
                                          const Image& image);

/// The moment at which two spheres of a sheared box touch; see contact_time.
HARDBALL_EXPORT Time sheared_contact_time(const World& world, Slot a, Slot b, const Image& image);

/// The moment at which two spheres touch, or come to a step, `image` being that of `b` which `a` meets;
/// kNever if never.
inline Time contact_time(const World& world, Slot a, Slot b, const Image& image) {
  if (world.has_steps()) [[unlikely]]
    return next_pair_event(world, a, b, image).time;
  if (world.box().is_sheared()) [[unlikely]]
    return sheared_contact_time(world, a, b, image);
  return contact_time(world.motion(), world.path(a), world.path(b), world.box().shift(image),
                      world.base_radius(a) + world.base_radius(b));
}

/// Whether two spheres are passing through each other, and so will not touch on their present paths: they are
/// inside each other when the later path starts, or their contact has been recorded. Precondition: pass(a,
/// b).
HARDBALL_EXPORT bool are_passing(const World& world, Slot a, Slot b, const Image& image);

}  // namespace hardball
