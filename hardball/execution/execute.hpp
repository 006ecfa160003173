// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "hardball/execution/collapse_guard.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/interaction/contact.hpp"
#include "hardball/world/sphere_edit.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// A contact that has been executed, and what only engines need to know about it.
struct Executed {
  Contact contact;
  /// By how many boxes the centers were folded back into a periodic box.
  std::array<Image, 2> folded{};
  /// Whether the response may have changed the spins of the contact.
  bool may_turn = false;
};

/// The slots of the spheres of a collision or wall event; of a wall event, only the first counts.
struct Participants {
  Slot first = 0;
  Slot second = 0;
  /// Whether the collision is with the nearest image of the second, whatever image the event names.
  bool nearest = false;
};

/// The participants of a collision or wall event. Cost: that of World::slot_of.
Participants participants_of(const World& world, const Event& event);

/// Describes the contact of a collision or wall event in the world before it: centers and velocities from the
/// stored paths at the event's time, and by how many boxes the centers lie outside the box.
void contact_at(const World& world, const Event& event, const Participants& participants, Executed& done);

/// Gives kinematic spheres back the velocities and spins that they had before.
void keep_kinematic(Contact& contact);

/// Error: the response returned a spin that is NaN, infinite or out of the operating range, or not about z in
/// two dimensions.
void check_spins(const Box& box, const Contact& contact);

/// Stores the spins after a contact.
void store_spins(SphereEdit& edit, const Contact& contact, const Participants& participants);

/// Throws the Error of check_velocities.
[[noreturn]] void refuse_velocities(const Box& box, const Contact& contact);

/// Error: the response returned a velocity that is NaN, infinite or out of the operating range (range.hpp),
/// or out of the plane in two dimensions.
inline void check_velocities(const Box& box, const Contact& contact) {
  const double most_along_z = box.is_flat() ? 0 : kLargestMagnitude;
  const auto is_in_range = [most_along_z](const Vec3& v) {
    return std::fabs(v.x) <= kLargestMagnitude && std::fabs(v.y) <= kLargestMagnitude &&
           std::fabs(v.z) <= most_along_z;
  };
  if (is_in_range(contact.after.first) && (!contact.is_collision() || is_in_range(contact.after.second)))
    return;
  refuse_velocities(box, contact);
}

/// What errors name as their place if the response to a contact is not allowed.
std::string place_of_response(const Contact& contact);

/// Lets the response decide about spheres whose sizes change: it sees the velocities of their surfaces where
/// they meet, so that surfaces part as they would at constant size. Error: it merges spheres, or changes a
/// spin. Source: docs/decisions/0033-growth-is-a-motion.md.
void decide_between_surfaces(const Interactions& interactions, Contact& contact);

/// Removes an approach of the bodies of `contact` with the velocities `after`; see settle.
void undo_approach(const World& world, Contact& contact, const Participants& participants);

/// Ensures that the bodies of `contact` do not approach with the velocities `after`: an approach that
/// rounding explains is removed by the least impulse that does so, so that no contact repeats itself. Error:
/// the response left them approaching by more than rounding.
inline void settle(const World& world, Contact& contact, const Participants& participants) {
  if (!world.motion().has_growth() && !world.box().is_sheared() && contact.is_collision() &&
      !(approach(contact.separation, contact.after) < 0))
    return;
  undo_approach(world, contact, participants);
}

/// Sets what two spheres with a potential of steps have come to: the step or the core, its distance, and
/// whether they pass. Precondition: there are potentials of steps; the contact is a collision described
/// otherwise.
void describe_step(const World& world, const Participants& participants, Executed& done);

/// Lets two spheres pass a step of their potential, or bounce off it: the impulse is along their separation,
/// and the kinetic energy changes by the height of the step. They recede afterwards if they move outwards,
/// and approach each other if they move inwards.
/// Source: Alder and Wainwright, J. Chem. Phys. 31 (1959) 459.
void decide_at_step(Contact& contact);

/// Makes the first of the two spheres of a collision one with the mass, momentum, angular momentum and volume
/// of both, at their center of mass; the second remains to be removed. Sets what comes after the contact
/// accordingly. Two kinematic spheres do not merge.
void merge(World& world, Contact& contact, const Participants& participants);

/// Carries out what has been described as a contact at a step.
void execute_at_step(World& world, const Participants& participants, Executed& done);

/// Carries out a collision or wall event: evaluates the paths at its time, calls the response, stores the new
/// paths. The one place, shared by all engines, where a contact changes the motion. Spheres that pass through
/// each other keep their paths; if two have merged, the second remains to be removed. Error:
/// check_velocities, check_spins or settle refuses what the response returned. RunFailure: inelastic
/// collapse, see CollapseGuard. In these cases, and if the response throws, nothing has changed.
inline void execute(World& world, CollapseGuard& guard, const Event& event, const Participants& participants,
                    Executed& done) {
  Contact& contact = done.contact;
  contact_at(world, event, participants, done);
  if (contact.outcome == ContactOutcome::pass) [[unlikely]] {
    done.folded = {};
    return world.note_passage(event);
  }
  const bool is_collision = contact.is_collision();
  if (world.has_steps()) [[unlikely]] {
    if (is_collision) describe_step(world, participants, done);
    if (contact.step.happens()) return execute_at_step(world, participants, done);
  }
  done.may_turn = true;  // until the response decides otherwise, and if it throws
  if (world.motion().has_growth()) [[unlikely]] {
    decide_between_surfaces(world.interactions(), contact);
    done.may_turn = false;
  } else {
    done.may_turn = world.interactions().decide(contact);
  }
  if (contact.outcome == ContactOutcome::merge) [[unlikely]]
    return merge(world, contact, participants);
  if (world.has_traits()) [[unlikely]]
    keep_kinematic(contact);
  check_velocities(world.box(), contact);
  if (done.may_turn) [[unlikely]]
    check_spins(world.box(), contact);
  settle(world, contact, participants);
  guard.note_contact(contact);
  SphereEdit edit(world, event.time, participants.first,
                  is_collision ? participants.second : participants.first);
  edit.store_path(participants.first, {contact.position, contact.after.first, event.time}, done.folded[0]);
  if (is_collision) {
    Vec3 second_velocity = contact.after.second;
    if (world.box().is_sheared()) [[unlikely]]
      second_velocity.x -= contact.image_speed;
    edit.store_path(participants.second, {contact.second_position, second_velocity, event.time},
                    done.folded[1]);
  }
  if (done.may_turn) [[unlikely]]
    store_spins(edit, contact, participants);
}

/// Merges two spheres that overlap if the response does so, whether or not they approach each other; returns
/// false if it does not, and then nothing has happened. Error: what the response throws, or `merge`.
inline bool merge_if_decided(World& world, const Event& collision, const Participants& participants,
                             Executed& done) {
  contact_at(world, collision, participants, done);
  done.may_turn = true;  // until the response decides otherwise, and if it throws
  done.may_turn = world.interactions().decide(done.contact);
  if (done.contact.outcome != ContactOutcome::merge) return false;
  merge(world, done.contact, participants);
  return true;
}

}  // namespace hardball
