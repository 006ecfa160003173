// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/run/actors.hpp"

#include <algorithm>

namespace hardball {

Action GrowthActor::act(const World& world, const Tally& tally, const Time& moment) {
  const GrowthEpoch epoch = schedule->act(world, tally, moment);
  changes_.clear();
  if (epoch.speed_factor != 1) {
    world.for_each_by_id([&](Slot slot) {
      const Vec3 velocity = world.velocity(slot, moment);
      changes_.push_back({slot, velocity, epoch.speed_factor * velocity});
    });
  }
  return {.changes = changes_, .epoch = epoch.growth};
}

// At its end, which an epoch has when there are none left, all may happen.
std::uint64_t GrowthActor::contacts_left(const Tally& tally, std::size_t spheres) const {
  const std::uint64_t left = schedule ? schedule->contacts_left(tally, spheres) : kAnyNumber;
  return left > 0 ? left : kAnyNumber;
}

void GrowthActor::note_contacts(const Tally& tally, std::size_t spheres, const Time& moment) {
  if (schedule && schedule->contacts_left(tally, spheres) == 0) schedule->end_by(moment);
}

Action ThermostatActor::act(const World& world, const Tally&, const Time& moment) {
  const double before = thermostat->energy();
  const std::span<const NewVelocity> changes = thermostat->act(world, moment);
  return {.changes = changes, .energy = thermostat->energy() - before};
}

void ThermostatActor::note_added(SphereId sphere, const Time& now) {
  if (thermostat) thermostat->note_added(sphere, now);
}

void ThermostatActor::note_removed(SphereId sphere) {
  if (thermostat) thermostat->note_removed(sphere);
}

Action MotionActor::act(const World& world, const Tally& tally, const Time& moment) {
  const auto impulse_on = [&](std::uint32_t number) { return tally.wall(number).normal_impulse; };
  schedule.act(world, impulse_on, moment);
  return {.places = schedule.places(), .surfaces = schedule.surfaces()};
}

const Actor& Actors::next() const {
  const Actor* first = &growth;
  for_each([&](const Actor& actor) {
    if (actor.next() < first->next()) first = &actor;
  });
  return *first;
}

Actor& Actors::next() {
  Actor* first = &growth;
  for_each([&](Actor& actor) {
    if (actor.next() < first->next()) first = &actor;
  });
  return *first;
}

std::uint64_t Actors::contacts_left(const Tally& tally, std::size_t spheres) const {
  std::uint64_t least = Actor::kAnyNumber;
  for_each([&](const Actor& actor) { least = std::min(least, actor.contacts_left(tally, spheres)); });
  return least;
}

bool Actors::depend_on_sums() const {
  bool any = false;
  for_each([&](const Actor& actor) { any = any || actor.depends_on_sums(); });
  return any;
}

bool Actors::change_setting() const {
  bool any = false;
  for_each([&](const Actor& actor) { any = any || actor.changes_setting(); });
  return any;
}

bool Actors::note_added(SphereId sphere, const Time& now) {
  const Time before = next().next();
  for_each([&](Actor& actor) { actor.note_added(sphere, now); });
  return next().next() != before;
}

bool Actors::note_removed(SphereId sphere) {
  const Time before = next().next();
  for_each([&](Actor& actor) { actor.note_removed(sphere); });
  return next().next() != before;
}

}  // namespace hardball
