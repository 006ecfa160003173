// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "hardball/measure/fluid_theory.hpp"
#include "hardball/measure/lag_average.hpp"
#include "hardball/measure/measurement.hpp"
#include "hardball/measure/thermal_motion.hpp"
#include "hardball/response/contact.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// How spheres forget their velocities, and the diffusion constant as an integral over that. A common drift
/// along axes without walls does not count. Source: Alder and Wainwright, Phys. Rev. A 1 (1970) 18; Allen and
/// Tildesley, Computer Simulation of Liquids, 2nd edition, section 2.7.
class VelocityAutocorrelation {
 public:
  static constexpr std::string_view kName = "velocity_autocorrelation";
  /// What a sample costs for each sphere followed [ns].
  static constexpr double kCostPerSphereFollowed = 50;

  /// Velocities are compared every `interval` [T]; at most `most_spheres` are followed.
  VelocityAutocorrelation(const World& world, const Time& now, double interval,
                          std::size_t most_spheres = LagAverage::kMostSpheres);

  /// Watches whether the energy is conserved. Cost: O(1).
  void note(const Contact& contact) { energy_.note(contact); }
  /// A moment that is no multiple of the interval after the beginning is passed over. Cost: see LagAverage.
  void sample(const World& world, const Time& now);
  /// What was found up to `now`.
  Measurement result(const Time& now) const;

 private:
  FluidTheory theory_;
  EnergyBalance energy_;
  double mean_free_time_;  // expected [T]
  LagAverage average_;
};

}  // namespace hardball
