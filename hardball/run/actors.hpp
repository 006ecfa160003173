// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "hardball/growth/growth_schedule.hpp"
#include "hardball/memory/value_pointer.hpp"
#include "hardball/motions/motion_schedule.hpp"
#include "hardball/run/actor.hpp"
#include "hardball/thermostats/thermostat.hpp"

namespace hardball {

/// A growth, if there is one.
class GrowthActor final : public Actor {
 public:
  std::optional<GrowthSchedule> schedule;

  std::unique_ptr<Actor> clone() const override { return std::make_unique<GrowthActor>(*this); }
  std::string_view deed() const override { return "an epoch of growth begins"; }
  Time next() const override { return schedule ? Time(schedule->next()) : kNever; }
  Action act(const World& world, const Tally& tally, const Time& moment) override;
  std::uint64_t contacts_left(const Tally& tally, std::size_t spheres) const override;
  void note_contacts(const Tally& tally, std::size_t spheres, const Time& moment) override;
  bool depends_on_sums() const override { return schedule && !schedule->is_over(); }
  void note_energy(double given) override { schedule->note_energy(given); }

 private:
  std::vector<NewVelocity> changes_;
};

/// A thermostat, if there is one.
class ThermostatActor final : public Actor {
 public:
  std::optional<Thermostat> thermostat;

  std::unique_ptr<Actor> clone() const override { return std::make_unique<ThermostatActor>(*this); }
  std::string_view deed() const override { return "the thermostat acts"; }
  Time next() const override { return thermostat ? Time(thermostat->next()) : kNever; }
  Action act(const World& world, const Tally& tally, const Time& moment) override;
  void note_added(SphereId sphere, const Time& now) override;
  void note_removed(SphereId sphere) override;
};

/// The motions that are prescribed, if there are any.
class MotionActor final : public Actor {
 public:
  MotionSchedule schedule;

  std::unique_ptr<Actor> clone() const override { return std::make_unique<MotionActor>(*this); }
  std::string_view deed() const override { return "a chord of a prescribed motion begins"; }
  Time next() const override { return Time(schedule.next()); }
  Action act(const World& world, const Tally& tally, const Time& moment) override;
  bool depends_on_sums() const override { return schedule.depends_on_pressure(); }
  bool changes_setting() const override { return schedule.drives_surfaces(); }
  void note_removed(SphereId sphere) override { schedule.note_removed(sphere); }
};

/// The actors of a run: the one place that knows them by name, where a new kind of actor is added.
class Actors {
 public:
  GrowthActor growth;
  ThermostatActor thermostat;
  MotionActor motions;

  std::vector<ValuePointer<Actor>> own;  ///< What Simulation::add_actor has added.

  /// Calls visit(actor) for all actors, in the order in which they act at the same time.
  template <class Visit>
  void for_each(Visit&& visit) {
    visit(growth);
    visit(thermostat);
    visit(motions);
    for (ValuePointer<Actor>& actor : own) visit(*actor);
  }
  template <class Visit>
  void for_each(Visit&& visit) const {
    visit(growth);
    visit(thermostat);
    visit(motions);
    for (const ValuePointer<Actor>& actor : own) visit(*actor);
  }

  /// The actor that acts next.
  Actor& next();
  const Actor& next() const;
  /// The least number of contacts after which one of them acts.
  std::uint64_t contacts_left(const Tally& tally, std::size_t spheres) const;
  /// Whether what they do depends on sums over the contacts.
  bool depend_on_sums() const;
  /// Whether what they do cannot be undone by a journal.
  bool change_setting() const;
  /// A sphere has been added or removed; returns whether they act at other times now.
  bool note_added(SphereId sphere, const Time& now);
  bool note_removed(SphereId sphere);
};

}  // namespace hardball
