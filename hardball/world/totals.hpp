// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "hardball/numbers/exact_sum.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// Sums over spheres, the same to the bit in whichever order they are added, and however they are divided
/// among several such sums. See World for what the sums are.
struct Totals {
  ExactSum kinetic_energy;               ///< [M L^2 T^-2]
  ExactSum rotational_energy;            ///< [M L^2 T^-2]
  ExactSum energy;                       ///< [M L^2 T^-2]
  std::array<ExactSum, kAxes> momentum;  ///< [M L/T]
  ExactSum sphere_volume;                ///< [L^3], in two dimensions [L^2].
  ExactSum mass;                         ///< Without kinematic spheres [M].
  /// The highest speed that a sphere has, or had when its velocity last changed [L/T].
  double highest_speed = 0;

  /// Adds a sphere as it is at `moment`.
  void note(const World& world, Slot slot, const Time& moment);
  void add(const Totals& other);
  Vec3 total_momentum() const { return {momentum[0].value(), momentum[1].value(), momentum[2].value()}; }

  static void persist(auto& archive, auto& self) {
    archive(self.kinetic_energy, self.rotational_energy, self.energy, self.momentum, self.sphere_volume,
            self.mass, self.highest_speed);
  }
};

/// The totals of all spheres of a world. Cost: O(n).
HARDBALL_EXPORT Totals totals_of(const World& world, const Time& moment);

}  // namespace hardball
