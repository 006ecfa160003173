// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// What callers change, between runs or from the listener.
#include <algorithm>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/measure/measures.hpp"
#include "hardball/run/engine_manager.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/simulation/user_data.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/world/audit.hpp"
#include "hardball/world/images.hpp"
#include "hardball/world/sphere_edit.hpp"
#include "hardball/world/totals.hpp"

namespace hardball {

void Simulation::respond_with(Function<Velocities(const Contact&)> response) {
  if (!response) return respond_with(nullptr);
  respond_with([response = std::move(response)](const Contact& contact) {
    return Outcome(contact, response(contact));
  });
}

void Simulation::respond_with(Function<Outcome(const Contact&)> response) {
  check_editable("respond_with");
  Interactions changed = setting().interactions();
  changed.set_function(std::move(response));
  check_features(options(), processes(), setting().features_with(changed));
  manager_->engine().mutable_world().set_interactions(changed);
  sums_.tally.set_interactions(changed);
}

void Simulation::respond_with(const ResponseTable& table) {
  check_editable("respond_with");
  ResponseTable responses = table;
  responses.pass_as_in(setting().interactions().table());
  Interactions changed(responses);
  changed.set_steps(setting().interactions().steps());
  check_features(options(), processes(), setting().features_with(changed));
  manager_->engine().mutable_world().set_interactions(changed);
  sums_.tally.set_interactions(changed);
}

void Simulation::respond_with(std::nullptr_t) {
  respond_with(Function<Outcome(const Contact&)>());
}

void Simulation::set_thermostat(std::optional<Thermostat> thermostat) {
  check_editable("set_thermostat");
  if (thermostat) thermostat->begin(world(), now_);
  actors_.thermostat.thermostat = std::move(thermostat);
  is_rescheduled_ = true;
}

void Simulation::drive(DrivenMotion motion) {
  check_idle("drive");
  check_exclusions(world().features() | Feature::motions);
  if (growth() && !growth()->is_over()) check_exclusions(Feature::motions, Feature::growth, "motions");
  MotionActor begun = actors_.motions;
  begun.schedule.add(std::move(motion), world(), now_);
  manager_->end_look_ahead(now_);
  const Action first = begun.act(world(), sums_.tally, now_);
  carry_out(first, now_);
  tell_of_motion(first, now_);
  actors_.motions = std::move(begun);
  is_rescheduled_ = true;
}

void Simulation::stop_driving() {
  check_idle("stop_driving");
  manager_->end_look_ahead(now_);
  actors_.motions = {};
  are_driven_ = false;
  is_rescheduled_ = true;
}

double Simulation::work_of(const DrivenMotion& motion) const {
  std::vector<SphereId> spheres(motion.spheres().begin(), motion.spheres().end());
  spheres.insert(spheres.end(), motion.removed_spheres().begin(), motion.removed_spheres().end());
  double work = sums_.tally.kinematic_work(spheres);
  for (const std::uint32_t number : motion.surfaces()) work += sums_.tally.wall(number).work;
  return work;
}

void Simulation::add_actor(std::unique_ptr<Actor> actor) {
  check_editable("add_actor");
  if (!actor) throw Error("there is no actor", "add_actor", "give one");
  if (actor->next() < now_) {
    throw Error(std::string(actor->deed()) + " at " + to_text(actor->next().value()) + ", which is past",
                "add_actor", "let it act first at " + to_text(time()) + " or later");
  }
  actors_.own.emplace_back(std::move(actor));
  is_rescheduled_ = true;
}

void Simulation::grow(const GrowthRules& rules, std::optional<double> compressibility) {
  check_editable("grow");
  check_exclusions(world().features() | Feature::growth);
  if (!motions().empty()) check_exclusions(Feature::motions, Feature::growth, "motions");
  manager_->end_look_ahead(now_);
  GrowthActor growth;
  growth.schedule.emplace(rules);
  const Growth first = growth.schedule->begin(world(), sums_.tally, now_, compressibility);
  begin_epoch({.epoch = first}, growth, now_, nullptr);
  actors_.growth = growth;
  is_rescheduled_ = true;
}

void Simulation::stop_growing() {
  check_editable("stop_growing");
  actors_.growth = {};
  if (!setting().motion().has_growth()) return;
  manager_->end_look_ahead(now_);
  manager_->engine().rewind(now_);
  const Growth last{now_, kNever, world().motion().scale_at(now_), 0};
  manager_->engine().mutable_world().end_growth(now_);
  manager_->rebuild(now_);
  tell_of_epoch(last);
  is_rescheduled_ = true;
}

void Simulation::change_velocity(SphereId id, const Vec3& velocity) {
  check_editable("change_velocity");
  const VelocityEdit edit{id, velocity};
  edit_velocities({&edit, 1}, nullptr);
}

void Simulation::change_velocities(std::span<const VelocityEdit> edits) {
  check_editable("change_velocities");
  edit_velocities(edits, nullptr);
}

void Simulation::change_velocities(std::span<const VelocityEdit> edits, Measures& measures) {
  check_editable("change_velocities");
  measures.check_spheres(world());
  edit_velocities(edits, &measures);
}

void Simulation::edit_velocities(std::span<const VelocityEdit> edits, Measures* measures) {
  std::vector<VelocityEdit> sorted(edits.begin(), edits.end());
  ranges::sort(sorted, {}, &VelocityEdit::id);
  const auto twice = ranges::adjacent_find(sorted, {}, &VelocityEdit::id);
  if (twice != sorted.end()) {
    throw Error("sphere " + to_text(twice->id) + " is given two velocities", "change_velocities",
                "give each sphere once");
  }
  std::vector<NewVelocity> changes;
  std::vector<double> energies;
  for (const VelocityEdit& edit : sorted) {
    const Slot slot = world().slot_of(edit.id);
    static_cast<void>(image_of(world(), slot, now_));  // whether it is where it can be changed
    world().check_velocity(edit.id, edit.velocity);
    changes.push_back({slot, world().velocity(slot, now_), edit.velocity});
    energies.push_back(kinetic_energy(world(), slot, now_));
  }
  manager_->end_look_ahead(now_);
  manager_->engine().change_velocities(now_, changes);
  for (std::size_t i = 0; i < changes.size(); ++i) {
    sums_.tally.note_edit(kinetic_energy(world(), changes[i].slot, now_) - energies[i], now_);
  }
  tell_of_changes(now_, changes, measures);
}

void Simulation::put(std::span<const PlaceEdit> edits) {
  check_idle("put");
  check_not_growing("put");
  if (setting().has_steps()) {
    throw Error("there are potentials of steps, and pairs have levels that depend on their history", "put",
                "begin a new simulation");
  }
  std::vector<PlaceEdit> sorted(edits.begin(), edits.end());
  ranges::sort(sorted, {}, &PlaceEdit::id);
  const auto twice = ranges::adjacent_find(sorted, {}, &PlaceEdit::id);
  if (twice != sorted.end())
    throw Error("sphere " + to_text(twice->id) + " is given two places", "put", "give each sphere once");
  std::vector<SphereState> states;
  double energy = 0;
  for (const PlaceEdit& edit : sorted) {
    if (actors_.motions.schedule.drives(edit.id))
      throw Error("a motion drives sphere " + to_text(edit.id), "put", "end the motion first");
    const Slot slot = world().slot_of(edit.id);
    states.push_back(world().state_of(slot));
    energy -= kinetic_energy(world(), slot, now_);
  }
  manager_->end_look_ahead(now_);
  manager_->engine().rewind(now_);
  World& world = manager_->engine().mutable_world();
  std::vector<NewVelocity> changes;
  try {
    for (const PlaceEdit& edit : sorted) {
      const Slot slot = world.slot_of(edit.id);
      const Vec3 before = world.velocity(slot, now_);
      world.put(slot, now_, edit.position, edit.velocity);
      changes.push_back({slot, before, edit.velocity});
    }
    require_no_overlap(world, now_);
  } catch (...) {
    for (const SphereState& state : states) {
      const Slot slot = world.slot_of(state.id);
      SphereEdit(world, now_, slot).store(slot, state);
    }
    manager_->rebuild(now_);
    throw;
  }
  for (const NewVelocity& change : changes) energy += kinetic_energy(world, change.slot, now_);
  sums_.tally.note_edit(energy, now_);
  tell_of_changes(now_, changes, nullptr);
  manager_->rebuild(now_);
}

SphereId Simulation::add(const Sphere& sphere) {
  check_editable("add");
  check_not_growing("add");
  manager_->end_look_ahead(now_);
  const SphereId id = manager_->engine().add(sphere, now_);
  are_driven_ = false;
  moving_.reset();
  sums_.tally.note_edit(kinetic_energy(world(), world().slot_of(id), now_), now_);
  is_rescheduled_ |= actors_.note_added(id, now_);
  return id;
}

void Simulation::remove(SphereId id) {
  check_editable("remove");
  check_not_growing("remove");
  const double energy = kinetic_energy(world(), world().slot_of(id), now_);
  manager_->end_look_ahead(now_);
  manager_->engine().remove(id, now_);
  moving_.reset();
  sums_.tally.note_edit(-energy, now_);
  note_removed(id);
}

}  // namespace hardball
