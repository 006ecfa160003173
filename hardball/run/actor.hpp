// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "hardball/geometry/growth.hpp"
#include "hardball/measure/tally.hpp"
#include "hardball/motions/driven_motion.hpp"
#include "hardball/world/new_place.hpp"
#include "hardball/world/new_velocity.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// What an actor does to the spheres at a moment.
struct Action {
  std::span<const NewVelocity> changes = {};  ///< In the order of ids; valid until the actor acts again.
  double energy = 0;                      ///< Given to the spheres by these, without an epoch [M L^2 T^-2].
  std::optional<Growth> epoch = {};       ///< How spheres grow from then on, if that changes.
  std::span<const NewPlace> places = {};  ///< New paths of kinematic spheres, if there are no changes.
  std::span<const NewSurface> surfaces = {};  ///< Surfaces that go on otherwise.
};

/// An actor changes a run at times of its own. It acts after all contacts whose times round to the same
/// double as its own time or an earlier one, and before all others.
class Actor {
 public:
  static constexpr std::uint64_t kAnyNumber = std::numeric_limits<std::uint64_t>::max();

  virtual ~Actor() = default;
  /// A copy, for copies of the simulation.
  virtual std::unique_ptr<Actor> clone() const = 0;

  /// What it does, for messages: "the thermostat acts".
  virtual std::string_view deed() const = 0;
  /// When it acts next; kNever for never.
  virtual Time next() const = 0;
  /// What it does at `moment`, which rounds to next(). Cost: that of the actor. Error: that of the actor.
  virtual Action act(const World& world, const Tally& tally, const Time& moment) = 0;

  /// The number of further contacts, at least one, after which it acts even if its time has not come.
  virtual std::uint64_t contacts_left(const Tally&, std::size_t /*spheres*/) const { return kAnyNumber; }
  /// To be called when the contacts so far are these, the last at `moment`: if there were enough, next()
  /// rounds to that.
  virtual void note_contacts(const Tally&, std::size_t /*spheres*/, const Time& /*moment*/) {}
  /// Whether what it does depends on sums over the contacts.
  virtual bool depends_on_sums() const { return false; }
  /// Whether it changes more than the paths of spheres, so that it cannot be undone.
  virtual bool changes_setting() const { return false; }
  /// The energy that the changes of its last action have given to the spheres, if that had an epoch.
  virtual void note_energy(double /*given*/) {}
  /// A sphere has been added or removed.
  virtual void note_added(SphereId, const Time& /*now*/) {}
  virtual void note_removed(SphereId) {}
};

}  // namespace hardball
