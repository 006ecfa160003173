// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "hardball/errors/export.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// The motion of the spheres, kinematic ones aside, at one time, split into their common drift and the motion
/// relative to it; in a sheared box, both relative to the flow.
struct ThermalMotion {
  /// Velocity of the center of mass along axes without walls, kinematic spheres and gravity, where it is
  /// conserved; zero along the others [L/T].
  Vec3 drift;
  /// Kinetic energy relative to the drift [M L^2 T^-2].
  double energy = 0;
  /// How many independent components of velocity there are: one for each sphere and dimension, less one for
  /// each axis without walls.
  double degrees_of_freedom = 0;
  /// Whether its energy changes without losses: by a thermostat, by potentials of steps, or by shear.
  bool is_driven = false;

  /// k T: twice the energy by the degrees of freedom [M L^2 T^-2]; NaN if there are none.
  double temperature() const { return 2 * energy / degrees_of_freedom; }
  static void persist(auto& archive, auto& self) {
    archive(self.drift, self.energy, self.degrees_of_freedom, self.is_driven);
  }
};

/// The mean magnitude of one component of a motion of fixed energy, in f degrees of freedom, over that
/// of a normal distribution with the same variance [1]: 1 + 1 / 4f for many. The direction of the motion is
/// uniform on a sphere in f dimensions.
HARDBALL_EXPORT double mean_over_normal(double degrees_of_freedom);

/// The axes on which momentum is conserved, so that the spheres may drift: those without walls and gravity,
/// if there are no surfaces, no kinematic spheres, and no faces of the box that drag. Cost: O(1).
HARDBALL_EXPORT std::array<bool, kAxes> drift_axes(const World& world);

/// Cost: O(n).
HARDBALL_EXPORT ThermalMotion thermal_motion(const World& world, const Time& moment);

/// Whether the energy is still that of the start but for rounding, and nothing but chance contacts has kept
/// it so, so that there can be the equilibrium of an isolated system of hard spheres.
HARDBALL_EXPORT bool is_energy_conserved(const ThermalMotion& begin, const ThermalMotion& end);

}  // namespace hardball
