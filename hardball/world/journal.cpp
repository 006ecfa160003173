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

SphereState World::state_of(Slot slot) const {
  return {.path = paths_[slot],
          .radius = radii_[slot],
          .mass = masses_[slot],
          .inertia_factor = inertia_factors_[slot],
          .spin = spin(slot),
          .folded = folded_[slot],
          .id = ids_[slot],
          .species = species(slot)};
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
  set_spin(slot, state.spin);
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
  set_spin(static_cast<Slot>(size() - 1), state.spin);
  if (state.species != 0 && species_.empty()) species_.assign(size() - 1, 0);
  if (state.species != 0 || !species_.empty()) species_.push_back(state.species);
  if (std::isinf(state.mass)) ++kinematic_count_;
  note_traits();
}

void World::undo() {
  HARDBALL_CHECK(!journal_.empty());
  const Journal::Change change = journal_.back();
  switch (change.kind) {
    case Journal::Kind::path:
      paths_[change.slot] = journal_.path();
      folded_[change.slot] = folded_[change.slot] - journal_.folded();
      break;
    case Journal::Kind::state:
      set_state(change.slot, journal_.state());
      break;
    case Journal::Kind::passage:
      last_passage_ = journal_.passage();
      break;
    case Journal::Kind::level:
      levels_.set(change.slot, journal_.level().partner, journal_.level().potential, journal_.level().level);
      break;
    case Journal::Kind::birth:
      return undo_add();
    case Journal::Kind::death:
      const SphereState before = journal_.state();
      const auto last = static_cast<Slot>(size());
      if (change.slot == last) {
        append(before);
      } else {
        // The sphere that took its place goes back to the last slot.
        append(state_of(change.slot));
        levels_.give_back(change.slot, last);
        order_.move(rank_of(ids_[last]), last);
        set_state(change.slot, before);
      }
      order_.insert(rank_of(before.id), change.slot);
  }
  journal_.pop();
}

}  // namespace hardball
