// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "hardball/measure/diffusion.hpp"
#include "hardball/measure/scene.hpp"
#include "hardball/measure/time_correlation.hpp"
#include "hardball/statistics/measurement.hpp"

namespace hardball {

/// The decay of velocity correlations, and the diffusion constant as its integral. A common drift along axes
/// without walls does not count. Source: Alder and Wainwright, Phys. Rev. A 1 (1970) 18; Allen and Tildesley,
/// Computer Simulation of Liquids, 2nd edition, section 2.7.
class VelocityAutocorrelation {
 public:
  static constexpr std::string_view kName = "velocity_autocorrelation";
  static constexpr bool kNeedsImagesAtRest = true;
  /// What a sample costs for each sphere followed [ns].
  static constexpr double kCostPerSphereFollowed = 50;

  /// Velocities are compared every `interval` [T]; at most `most_spheres` are followed.
  VelocityAutocorrelation(const Scene& scene, double interval,
                          std::size_t most_spheres = TimeCorrelation::kMaxSpheres);

  /// A time that is not a multiple of the interval after the start is ignored. Cost: see TimeCorrelation.
  void sample(const Scene& scene);
  /// The result up to the time of the scene.
  Measurement result(const Scene& scene) const;

  /// Whether it can continue with this world; false only if its state is damaged.
  bool matches(const World& world) const { return average_.matches(world); }

 private:
  friend class Persistence;
  VelocityAutocorrelation() = default;
  static void persist(auto& archive, auto& self) { archive(self.conditions_, self.average_, self.begin_); }
  bool restored() const;

  DiffusionConditions conditions_;
  Time begin_;
  TimeCorrelation average_;
};

}  // namespace hardball
