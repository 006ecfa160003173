// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/response/execute.hpp"

#include <limits>
#include <string>

#include "hardball/errors/error.hpp"
#include "hardball/world/range.hpp"

namespace hardball {
namespace {

// An approach is attributed to rounding if it is below this fraction of the speeds involved, or below the
// operating range, where numbers lose precision.
constexpr double kRounding = 1e-12;

[[noreturn]] void refuse_response(const Contact& contact, const std::string& what, const char* remedy) {
  throw Error(what + " at the contact at time " + to_text(contact.time.value()),
              "response to sphere " + to_text(contact.first) + " and " +
                  (contact.is_collision() ? "sphere " : "face ") + to_text(contact.second),
              remedy);
}

void refuse_approach(const Contact& contact) {
  refuse_response(contact, "the bodies are left approaching each other",
                  "return velocities with which they separate or keep their distance");
}

std::string to_text(const Vec3& vector) {
  using hardball::to_text;
  return "(" + to_text(vector.x) + ", " + to_text(vector.y) + ", " + to_text(vector.z) + ")";
}

void undo_approach_to_wall(Contact& contact) {
  double& velocity = contact.after.first[axis_of(contact.second)];
  const bool approaching = is_upper(contact.second) ? velocity > 0 : velocity < 0;
  if (!approaching) return;
  if (std::fabs(velocity) > kRounding * length(contact.before.first)) refuse_approach(contact);
  velocity = 0;
}

void undo_approach_of_spheres(Contact& contact) {
  const Vec3& r = contact.separation;
  const double excess = approach(r, contact.after);
  const double speeds = length(contact.before.first) + length(contact.before.second) +
                        length(contact.after.first) + length(contact.after.second);
  if (-excess > length(r) * (kRounding * speeds + kSmallestMagnitude)) refuse_approach(contact);
  const double total_mass = contact.first_mass + contact.second_mass;
  double exchange = excess / dot(r, r);
  Velocities settled = contact.after;
  while (approach(r, settled) < 0) {
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
  const Box& box = world.box();
  const Path& path = world.path(participants.first);
  const double radius = world.radius(participants.first);
  Vec3 position = position_at(path, event.time);
  done.were_idle[0] = is_idle(path, radius, event.time);
  done.folded[0] = box.fold(position);
  Velocities before;
  Contact& contact = done.contact;
  contact.time = event.time;
  contact.kind = event.kind;
  contact.first = event.first;
  contact.second = event.second;
  contact.position = position;
  contact.first_radius = radius;
  contact.first_mass = world.mass(participants.first);
  if (event.kind == EventKind::collision) {
    const Path& second_path = world.path(participants.second);
    const double second_radius = world.radius(participants.second);
    Vec3 second_position = position_at(second_path, event.time);
    done.were_idle[1] = is_idle(second_path, second_radius, event.time);
    done.folded[1] = box.fold(second_position);
    contact.image = participants.nearest ? box.nearest_image(position - second_position)
                                         : event.image + done.folded[1] - done.folded[0];
    contact.second_position = second_position;
    contact.separation = (second_position - position) + box.shift(contact.image);
    contact.reach = radius + second_radius;
    contact.second_mass = world.mass(participants.second);
    before = {path.velocity, second_path.velocity};
  } else {
    const std::size_t axis = axis_of(event.second);
    contact.image = {};
    contact.second_position = {};
    contact.separation = {};
    contact.separation[axis] = (is_upper(event.second) ? box.size()[axis] : 0) - contact.position[axis];
    contact.reach = radius;
    contact.second_mass = std::numeric_limits<double>::infinity();
    before = {path.velocity, {}};
  }
  // Twice from registers: reading back what has just been written would stall.
  contact.before = before;
  contact.after = before;
}

void refuse_velocities(const Contact& contact) {
  std::string what = "the velocity " + to_text(contact.after.first) + " is returned";
  if (contact.is_collision()) {
    what = "the velocities " + to_text(contact.after.first) + " and " + to_text(contact.after.second) +
           " are returned";
  }
  refuse_response(contact, what, "return finite velocities of magnitude at most 1e60");
}

void undo_approach(Contact& contact) {
  if (contact.is_collision()) {
    undo_approach_of_spheres(contact);
  } else {
    undo_approach_to_wall(contact);
  }
}

}  // namespace hardball
