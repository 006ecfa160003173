// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/world/world.hpp"

namespace hardball {

/// The one way to change spheres that a world holds: an edit of one or two of them at a moment. If the world
/// keeps a journal, it records first what they were.
class SphereEdit {
 public:
  SphereEdit(World& world, const Time& moment, Slot slot) : SphereEdit(world, moment, slot, slot) {}
  SphereEdit(World& world, const Time& moment, Slot first, Slot second) : world_(world), moment_(moment) {
    if (!world.has_journal()) [[likely]]
      return;
    world.journal_.note_path(moment, first, world.path(first));
    if (second != first) world.journal_.note_path(moment, second, world.path(second));
  }

  /// Replaces a path by one that starts inside the box, `folded` boxes back from where the old one led.
  void store_path(Slot slot, const Path& path, const Image& folded) {
    world_.set_path(slot, path);
    if (folded.is_zero()) return;
    world_.set_folded(slot, world_.folded(slot) + folded);
    if (world_.has_journal()) world_.journal_.note_folded(slot, folded);
  }
  /// Makes a sphere what it is in another world with the same box. Precondition: `state` has its id.
  void store(Slot slot, const SphereState& state) {
    note_state(slot);
    world_.set_state(slot, state);
  }
  /// Gives a sphere the path and the spin that it has in another world with the same box. Several threads may
  /// do so at once for different spheres if spheres have spun here, or none has in the other world. Cost: as
  /// of store_spin.
  void store_motion(Slot slot, const World& other, Slot from) {
    note_state(slot);
    world_.set_path(slot, other.path(from));
    world_.set_folded(slot, other.folded(from));
    world_.set_spin(slot, other.spin(from));
  }
  /// Stores a new angular velocity [1/T]. Cost: O(n) for the first sphere that spins.
  void store_spin(Slot slot, const Vec3& spin) {
    note_state(slot);
    world_.set_spin(slot, spin);
  }
  /// Stores the level of a pair with this potential, see PairLevels.
  void store_level(Slot a, Slot b, StepTable::Number potential, StepPotential::Level level) {
    world_.set_level(a, b, potential, level, moment_);
  }
  /// Gives a sphere a new radius [L], mass [M] and moment of inertia over mass and squared radius [1]. Error:
  /// as for World::add; then nothing has changed.
  void reshape(Slot slot, double radius, double mass, double inertia_factor) {
    note_state(slot);
    world_.reshape(slot, radius, mass, inertia_factor);
  }

 private:
  void note_state(Slot slot) {
    if (world_.has_journal())
      world_.journal_.record(Journal::Kind::state, moment_, slot, world_.state_of(slot));
  }

  World& world_;
  Time moment_;
};

}  // namespace hardball
