// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <utility>

#include "hardball/response/collapse_guard.hpp"
#include "hardball/response/contact.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// What carrying out a contact changed beside the velocities.
struct Executed {
  Contact contact;
  /// By how many boxes the centres were folded back into a periodic box.
  std::array<Image, 2> folded{};
};

/// Where the spheres of a collision or wall event are stored; of a wall event, only the first counts.
struct Participants {
  Slot first = 0;
  Slot second = 0;
};

/// The participants of a collision or wall event. Cost: that of World::slot_of.
Participants participants_of(const World& world, const Event& event);

/// The contact that a collision or wall event is, in the world as it was before it: centres and velocities as
/// the stored paths give them at the event's time, and by how many boxes the centres lie beyond.
void contact_at(const World& world, const Event& event, const Participants& participants, Executed& done);

/// Makes sure that the bodies of `contact`, having `after` as velocities, do not approach: an approach that
/// rounding explains is undone by the least impulse that does it, so that no contact follows itself.
/// Error: the response left them truly approaching.
void settle(Contact& contact);

/// Carries out a collision or wall event: evaluates the paths at its time, asks the response, stores the new
/// paths. The one place, shared by all engines, where a contact changes the motion. If the response throws,
/// nothing has changed. Error (RunFailure): inelastic collapse, see CollapseGuard.
template <Response R>
void execute(World& world, CollapseGuard& guard, const Event& event, const Participants& participants,
             const R& response, Executed& done) {
  contact_at(world, event, participants, done);
  done.contact.after = response(std::as_const(done.contact));
  settle(done.contact);
  guard.note_contact(world, participants.first, event.time);
  if (done.contact.is_collision()) guard.note_contact(world, participants.second, event.time);
  world.rewrite_path(participants.first, event.time, done.contact.after.first);
  if (done.contact.is_collision()) {
    world.rewrite_path(participants.second, event.time, done.contact.after.second);
  }
}

}  // namespace hardball
