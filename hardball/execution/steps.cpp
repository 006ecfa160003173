// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "hardball/errors/error.hpp"
#include "hardball/execution/execute.hpp"
#include "hardball/geometry/exit_time.hpp"
#include "hardball/world/pair_event.hpp"
#include "hardball/world/sphere_edit.hpp"
#include "hardball/world/step_levels.hpp"

namespace hardball {
namespace {

// The reduced mass of two spheres, and the part of a change of their relative velocity that the first takes.
struct Masses {
  double reduced;
  double share_of_first;
};

Masses masses_of(const Contact& contact) {
  if (std::isinf(contact.first_mass)) return {contact.second_mass, 0};
  if (std::isinf(contact.second_mass)) return {contact.first_mass, 1};
  const double share = contact.second_mass / (contact.first_mass + contact.second_mass);
  return {contact.first_mass * share, share};
}

// Whether spheres at a step move to the side where they belong: the side beyond it if they pass.
bool moves_on(const Contact& contact, const Velocities& velocities) {
  const Vec3 relative = velocities.second - velocities.first;
  const double closing = approach(contact.separation, velocities);
  if (contact.step.is_outward == contact.step.passes) return closing >= 0;
  // What has come along the step from inside would come to it again at once, and again. It leaves by a chord
  // that takes time; the energy of this least speed is 2^-40 of the whole.
  constexpr double kLeastSpeed = 0x1p-20;
  if (contact.step.is_outward) return closing <= -kLeastSpeed * length(relative) * length(contact.separation);
  // What has passed inwards must come to a way out that is later.
  const double excess = squared_excess(contact.separation, contact.reach);
  return closing < 0 && (excess < 0 || chord_discriminant(contact.separation, relative, contact.reach) > 0);
}

Velocities with_exchange(const Contact& contact, double exchange, double share_of_first) {
  return {contact.after.first - (exchange * share_of_first) * contact.separation,
          contact.after.second + (exchange * (1 - share_of_first)) * contact.separation};
}

}  // namespace

void describe_step(const World& world, const Participants& participants, Executed& done) {
  Contact& contact = done.contact;
  const PairLevel* const known = world.pair_levels().find(participants.first, participants.second);
  const StepTable::Number number =
      known ? known->potential : potential_of(world, participants.first, participants.second);
  if (number == StepTable::kNone) return;
  const StepPotential& potential = world.interactions().steps()[number];
  const StepPotential::Level level = known ? known->level : StepPotential::Level{0};
  const Image image = contact.image - done.folded[1] + done.folded[0];
  const PairEvent event = next_pair_event(world, participants.first, participants.second, image);
  HARDBALL_CHECK(event.time == contact.time);
  const bool is_outward = event.is_outward;
  if (!is_outward && potential.is_innermost(level)) {
    contact.reach *= potential.rules().core;
    return;
  }
  contact.reach *= is_outward ? potential.outer_ratio(level) : potential.inner_ratio(level);
  contact.step.potential = number;
  contact.step.step =
      static_cast<std::uint8_t>(is_outward ? potential.step_outside(level) : potential.steps() - level - 1);
  contact.step.is_outward = is_outward;
  contact.step.rise = potential.rise(level, is_outward);
}

void decide_at_step(Contact& contact) {
  const auto [reduced_mass, share] = masses_of(contact);
  const double square = dot(contact.separation, contact.separation);
  // By rounding, what hardly moves to the step may seem to move away from it.
  const double closing = approach(contact.separation, contact.before);
  const double before = contact.step.is_outward ? std::max(closing, 0.0) : std::min(closing, 0.0);
  const double spent = 2 * contact.step.rise * square / reduced_mass;
  const double left = before * before - spent;
  contact.step.passes = left > 0;
  double change = -2 * before;
  if (contact.step.passes) {
    const double after = contact.step.is_outward ? std::sqrt(left) : -std::sqrt(left);
    // The difference of both, without its cancellation.
    change = spent == 0 ? 0 : -spent / (before + after);
  }
  contact.after = with_exchange(contact, change / square, share);
  if (moves_on(contact, contact.after)) return;
  // The least exchange by which they do: rounding alone explains it.
  const Vec3 relative = contact.after.second - contact.after.first;
  const double speed = length(contact.before.first) + length(contact.before.second) + length(relative);
  const bool goes_outward = contact.step.is_outward == contact.step.passes;
  double exchange = (goes_outward ? 1 : -1) * 0x1p-54 * speed / std::sqrt(square);
  while (!moves_on(contact, with_exchange(contact, exchange, share))) exchange *= 2;
  contact.after = with_exchange(contact, exchange, share);
}

void execute_at_step(World& world, const Participants& participants, Executed& done) {
  Contact& contact = done.contact;
  decide_at_step(contact);
  done.may_turn = false;
  check_velocities(world.box(), contact);
  const Slot first = participants.first;
  const Slot second = participants.second;
  SphereEdit edit(world, contact.time, first, second);
  edit.store_path(first, {contact.position, contact.after.first, contact.time}, done.folded[0]);
  edit.store_path(second, {contact.second_position, contact.after.second, contact.time}, done.folded[1]);
  if (!contact.step.passes) return;
  const PairLevel* const known = world.pair_levels().find(first, second);
  const int level = known ? known->level : 0;
  edit.store_level(first, second, contact.step.potential,
                   static_cast<StepPotential::Level>(contact.step.is_outward ? level - 1 : level + 1));
}

}  // namespace hardball
