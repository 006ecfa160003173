// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/response/execute.hpp"

#include <limits>

#include "hardball/errors/error.hpp"
#include "hardball/world/range.hpp"

namespace hardball {
namespace {

// An approach is put down to rounding if it is below this fraction of the speeds involved, or below the
// operating range, where numbers lose their digits.
constexpr double kRounding = 1e-12;

void refuse_approach(const Contact& contact) {
  throw Error("the response leaves the bodies of the contact at time " + to_text(contact.time.value()) +
                  " approaching each other",
              "response to sphere " + to_text(contact.first) + " and " +
                  (contact.is_collision() ? "sphere " : "face ") + to_text(contact.second),
              "return velocities with which they separate or keep their distance");
}

void settle_wall(Contact& contact) {
  double& velocity = contact.after.first[axis_of(contact.second)];
  const bool approaching = is_upper(contact.second) ? velocity > 0 : velocity < 0;
  if (!approaching) return;
  if (std::fabs(velocity) > kRounding * length(contact.before.first)) refuse_approach(contact);
  velocity = 0;
}

void settle_collision(Contact& contact) {
  const Vec3& r = contact.separation;
  // The very expression whose sign decides whether a contact is predicted.
  const auto approach = [&r](const Velocities& v) { return dot(r, v.second - v.first); };
  const double excess = approach(contact.after);
  if (!(excess < 0)) return;
  const double speeds = length(contact.before.first) + length(contact.before.second) +
                        length(contact.after.first) + length(contact.after.second);
  if (-excess > length(r) * (kRounding * speeds + kSmallestMagnitude)) refuse_approach(contact);
  const double total_mass = contact.first_mass + contact.second_mass;
  double exchange = excess / dot(r, r);
  Velocities settled = contact.after;
  while (approach(settled) < 0) {
    settled.first = contact.after.first + (exchange * (contact.second_mass / total_mass)) * r;
    settled.second = contact.after.second - (exchange * (contact.first_mass / total_mass)) * r;
    exchange *= 2;
  }
  contact.after = settled;
}

}  // namespace

Participants participants_of(const World& world, const Event& event) {
  const bool is_collision = event.kind == EventKind::collision;
  return {world.slot_of(event.first), is_collision ? world.slot_of(event.second) : 0};
}

void contact_at(const World& world, const Event& event, const Participants& participants, Executed& done) {
  Contact& contact = done.contact;
  contact.time = event.time;
  contact.kind = event.kind;
  contact.first = event.first;
  contact.second = event.second;
  contact.first_radius = world.radius(participants.first);
  contact.first_mass = world.mass(participants.first);
  contact.before.first = world.path(participants.first).velocity;
  const Vec3 unfolded = position_at(world.path(participants.first), event.time);
  done.folded[0] = world.box().boxes_beyond(unfolded);
  contact.position = unfolded - world.box().shift(done.folded[0]);
  if (event.kind == EventKind::collision) {
    contact.reach = contact.first_radius + world.radius(participants.second);
    contact.second_mass = world.mass(participants.second);
    contact.before.second = world.path(participants.second).velocity;
    const Vec3 other_unfolded = position_at(world.path(participants.second), event.time);
    done.folded[1] = world.box().boxes_beyond(other_unfolded);
    contact.second_position = other_unfolded - world.box().shift(done.folded[1]);
    contact.image = event.image + done.folded[1] - done.folded[0];
    contact.separation = (contact.second_position - contact.position) + world.box().shift(contact.image);
  } else {
    contact.reach = contact.first_radius;
    contact.second_mass = std::numeric_limits<double>::infinity();
    contact.before.second = {};
    contact.image = {};
    contact.second_position = {};
    contact.separation = {};
    const std::size_t axis = axis_of(event.second);
    contact.separation[axis] =
        (is_upper(event.second) ? world.box().size()[axis] : 0) - contact.position[axis];
  }
  contact.after = contact.before;
}

void settle(Contact& contact) {
  if (contact.is_collision()) {
    settle_collision(contact);
  } else {
    settle_wall(contact);
  }
}

}  // namespace hardball
