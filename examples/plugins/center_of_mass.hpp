// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/simulation.hpp"

/// A measure of one's own: the mean height of the spheres at the times of samples, and the energy that
/// contacts dissipate between them.
class CenterOfMass {
 public:
  /// To be called with every contact.
  void record(const hardball::Contact& contact) {
    const auto energy = [&](const hardball::Velocities& velocities) {
      const double of_second =
          contact.is_collision() ? contact.second_mass * dot(velocities.second, velocities.second) : 0;
      return (contact.first_mass * dot(velocities.first, velocities.first) + of_second) / 2;
    };
    dissipated_ += energy(contact.before) - energy(contact.after);
  }
  /// To be called at the times of samples.
  void sample(const hardball::World& world, const hardball::Time& now) {
    double heights = 0;
    world.for_each_by_id([&](hardball::Slot slot) { heights += world.position(slot, now).z; });
    height_ = heights / static_cast<double>(world.size());
  }

  /// At the last sample [L].
  double height() const { return height_; }
  /// So far [M L^2 T^-2].
  double dissipated() const { return dissipated_; }

 private:
  double height_ = 0;
  double dissipated_ = 0;
};
