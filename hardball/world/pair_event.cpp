// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/world/pair_event.hpp"

#include "hardball/geometry/exit_time.hpp"
#include "hardball/world/images.hpp"
#include "hardball/world/step_levels.hpp"

namespace hardball {

PairEvent next_pair_event(const World& world, Slot a, Slot b, const Image& image) {
  if (const PairLevel* const pair = world.pair_levels().find(a, b))
    return next_pair_event(world, a, *pair, image);
  const StepTable::Number number = potential_of(world, a, b);
  const double radii = world.base_radius(a) + world.base_radius(b);
  const double reach =
      number == StepTable::kNone ? radii : world.interactions().steps()[number].inner_ratio(0) * radii;
  return {contact_time(world.motion(), world.path(a), world.path(b), world.box().shift(image), reach), false};
}

PairEvent next_pair_event(const World& world, Slot slot, const PairLevel& pair, const Image& image) {
  const StepPotential& potential = world.interactions().steps()[pair.potential];
  const double radii = world.base_radius(slot) + world.base_radius(pair.partner);
  const Path& a = world.path(slot);
  const Path& b = world.path(pair.partner);
  const Time start = later(a.time, b.time);
  const State relative = relative_state_at(StraightMotion(), a, b, world.box().shift(image), start);
  const WaitBetween<double> wait =
      wait_between<double>(relative.position, relative.velocity, potential.inner_ratio(pair.level) * radii,
                           potential.outer_ratio(pair.level) * radii);
  const bool is_outward = !(wait.inward < kNever.high);
  return {after(start, is_outward ? wait.outward : wait.inward), is_outward};
}

Time sheared_contact_time(const World& world, Slot a, Slot b, const Image& image) {
  // The same bits, at less cost.
  if (image[1] == 0) {
    return contact_time(world.motion(), world.path(a), world.path(b), world.box().shift(image),
                        world.base_radius(a) + world.base_radius(b));
  }
  const Vec3 boxes{static_cast<double>(image[0]), static_cast<double>(image[1]),
                   static_cast<double>(image[2])};
  return contact_time_of_sliding(world.box().images(), world.box().period(), world.path(a), world.path(b),
                                 boxes, world.base_radius(a) + world.base_radius(b));
}

bool are_passing(const World& world, Slot a, Slot b, const Image& image) {
  const Time start = later(world.path(a).time, world.path(b).time);
  const Vec3 separation = relative_state(world, a, b, image, start).position;
  return are_inside(separation, world.base_radius(a) + world.base_radius(b)) ||
         is_recorded(make_collision(contact_time(world, a, b, image), world.id(a), world.id(b), {}),
                     world.last_passage());
}

}  // namespace hardball
