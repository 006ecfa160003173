// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/world/journal.hpp"

#include <cmath>

#include "hardball/errors/error.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

void World::begin_journal() {
  journal_.clear();
  has_journal_ = true;
}

void World::end_journal() {
  journal_.clear();
  has_journal_ = false;
}

void World::record(WorldChange::Kind kind, Time moment, Slot slot) {
  WorldChange& change = journal_.emplace_back();
  change.kind = kind;
  change.time = moment;
  change.slot = slot;
  change.passage = last_passage_;
  if (kind != WorldChange::Kind::passage) change.before = state_of(slot);
}

void World::record_spheres(Time moment, Slot first, Slot second) {
  record(WorldChange::Kind::sphere, moment, first);
  if (second != first) record(WorldChange::Kind::sphere, moment, second);
}

SphereState World::state_of(Slot slot) const {
  return {ids_[slot],    paths_[slot], radii_[slot], masses_[slot], inertia_factors_[slot],
          folded_[slot], spin(slot),   species(slot)};
}

void World::set_state(Slot slot, const SphereState& state) {
  if (is_kinematic(slot)) --kinematic_count_;
  if (std::isinf(state.mass)) ++kinematic_count_;
  ids_[slot] = state.id;
  paths_[slot] = state.path;
  radii_.set(slot, state.radius);
  masses_.set(slot, state.mass);
  inertia_factors_.set(slot, state.inertia_factor);
  folded_[slot] = state.folded;
  if (!spins_.empty()) spins_[slot] = state.spin;
  if (!species_.empty()) species_[slot] = state.species;
}

// Stores a sphere in the next slot.
void World::append(const SphereState& state) {
  ids_.push_back(state.id);
  paths_.push_back(state.path);
  radii_.push_back(state.radius);
  masses_.push_back(state.mass);
  inertia_factors_.push_back(state.inertia_factor);
  folded_.push_back(state.folded);
  if (!spins_.empty()) spins_.emplace_back();
  store_spin(static_cast<Slot>(size() - 1), state.spin);
  if (state.species != 0 && species_.empty()) species_.assign(size() - 1, 0);
  if (state.species != 0 || !species_.empty()) species_.push_back(state.species);
  if (std::isinf(state.mass)) ++kinematic_count_;
  note_traits();
}

void World::undo() {
  HARDBALL_CHECK(!journal_.empty());
  const WorldChange change = journal_.back();
  switch (change.kind) {
    case WorldChange::Kind::sphere:
      set_state(change.slot, change.before);
      break;
    case WorldChange::Kind::passage:
      last_passage_ = change.passage;
      break;
    case WorldChange::Kind::birth:
      return undo_add();
    case WorldChange::Kind::death:
      const auto last = static_cast<Slot>(size());
      if (change.slot == last) {
        append(change.before);
      } else {
        // The sphere that took its place goes back to the last slot.
        append(state_of(change.slot));
        order_.move(rank_of(ids_[last]), last);
        set_state(change.slot, change.before);
      }
      order_.insert(rank_of(change.before.id), change.slot);
  }
  journal_.pop_back();
}

}  // namespace hardball
