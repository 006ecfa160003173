// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "hardball/errors/export.hpp"
#include "hardball/numbers/exact_sum.hpp"
#include "hardball/world/images.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// m v^2 / 2 of one sphere at `moment` [M L^2 T^-2]; zero of a kinematic one. In a sheared box, relative to
/// the flow.
inline double kinetic_energy(const World& world, Slot slot, const Time& moment) {
  if (world.is_kinematic(slot)) return 0;
  const Vec3 velocity = peculiar_velocity(world, slot, moment);
  return world.mass(slot) * dot(velocity, velocity) / 2;
}

/// m v of one sphere at `moment` [M L/T]; zero of a kinematic one. In a sheared box, relative to the flow.
inline Vec3 momentum(const World& world, Slot slot, const Time& moment) {
  return world.is_kinematic(slot) ? Vec3{} : world.mass(slot) * peculiar_velocity(world, slot, moment);
}

/// I w^2 / 2 of one sphere [M L^2 T^-2]; zero of a kinematic one.
HARDBALL_EXPORT double rotational_energy(const World& world, Slot slot);

/// Kinetic and rotational energy of one sphere at `moment`, with its potential energy in gravity and steps [M
/// L^2 T^-2]; zero of a kinematic one.
HARDBALL_EXPORT double energy(const World& world, Slot slot, const Time& moment);

/// The sum of m v^2 / 2 of all spheres at `moment` [M L^2 T^-2]. This and the sums below exclude kinematic
/// spheres, and are exact until they are rounded, so that the order of spheres does not matter; in a sheared
/// box they are relative to the flow. Cost: O(n).
HARDBALL_EXPORT double kinetic_energy(const World& world, const Time& moment);
/// The sum of I w^2 / 2 of all spheres, with the spin w [M L^2 T^-2]. Cost: O(n).
HARDBALL_EXPORT double rotational_energy(const World& world);
/// Kinetic, rotational and potential energy of all spheres at `moment` [M L^2 T^-2]. The potential energy of
/// gravity is zero at the origin, and uses unwrapped positions in a periodic box. Cost: O(n).
HARDBALL_EXPORT double energy(const World& world, const Time& moment);
/// The sum of m v of all spheres at `moment` [M L/T]. Cost: O(n).
HARDBALL_EXPORT Vec3 momentum(const World& world, const Time& moment);
/// The volume of all spheres at `moment` [L^3], in two dimensions the area of the discs [L^2]. Cost: O(n).
HARDBALL_EXPORT double sphere_volume(const World& world, const Time& moment);

/// Sums over spheres, the same to the bit in whichever order they are noted, and however they are divided
/// among several such sums.
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
  void record(const World& world, Slot slot, const Time& moment);
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
