// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/thermostats/andersen.hpp"
#include "hardball/thermostats/heating.hpp"
#include "hardball/thermostats/rescale.hpp"
#include "hardball/world/new_velocity.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// A thermostat exchanges energy with the spheres between contacts. Kinematic spheres and spins do not
/// change.
using ThermostatKind = std::variant<Andersen, Rescale, Heating>;

/// The name of a kind in scenarios.
HARDBALL_EXPORT std::string_view name_of(const ThermostatKind& kind);

/// A thermostat in use: when it acts next, what it does then, and what it has done so far.
///
/// Its times and random numbers are functions of the seed, of the spheres' ids and of the times at which it
/// was started and spheres were added: how a run is executed does not affect them. It acts at a time once
/// no contact that rounds to that time, or an earlier one, remains.
class HARDBALL_EXPORT Thermostat {
 public:
  explicit Thermostat(ThermostatKind kind, std::uint64_t seed = 1) : kind_(kind), seed_(seed) {}

  const ThermostatKind& kind() const { return kind_; }
  std::uint64_t seed() const { return seed_; }
  /// How often it has acted: on one sphere (Andersen) or on all.
  std::uint64_t events() const { return events_; }
  /// The energy it has given to the spheres, negative if it has taken more; in a sheared box, relative to the
  /// flow [M L^2 T^-2].
  double energy() const { return energy_; }

  /// Restarts. Cost: O(n).
  void begin(const World& world, const Time& now);
  /// Spheres have been added or removed. Cost: as for World.
  void note_added(SphereId sphere, const Time& now);
  void note_removed(SphereId sphere);

  /// When it acts next [T]; infinity for never. Precondition: it has begun.
  double next() const;
  /// The velocities that it gives to spheres then, in the order of ids, valid until the next call.
  /// Precondition: `moment` rounds to next(), and no path starts after it. Error: it acts so often that times
  /// do not resolve it. Cost: see the kinds.
  std::span<const NewVelocity> act(const World& world, const Time& moment);

 private:
  friend class Persistence;
  Thermostat() : Thermostat(Rescale(1, 1), 0) {}
  static void persist(auto& archive, auto& self) {
    archive(self.kind_, self.seed_, self.events_, self.energy_);
  }

  ThermostatKind kind_;
  std::uint64_t seed_;
  std::uint64_t events_ = 0;
  double energy_ = 0;
  std::vector<NewVelocity> changes_;
};

}  // namespace hardball
