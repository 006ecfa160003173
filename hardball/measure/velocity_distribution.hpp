// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "hardball/measure/scene.hpp"
#include "hardball/measure/sphere_groups.hpp"
#include "hardball/statistics/block_average.hpp"
#include "hardball/statistics/measurement.hpp"
#include "hardball/theory/thermal_motion.hpp"

namespace hardball {

/// The distribution of velocities, each in units of sqrt(kT / m), kT being the current temperature: so masses
/// may differ and a granular gas may cool. In equilibrium it is Maxwell's. A common drift along axes without
/// walls does not count. Source: Chapman and Cowling, The Mathematical Theory of Non-Uniform Gases, section
/// 4.1.
class VelocityDistribution {
 public:
  static constexpr std::string_view kName = "velocity_distribution";

  explicit VelocityDistribution(const Scene& scene);

  /// What a sample costs [ns].
  double sample_cost() const { return 30 * spheres_; }
  /// Cost: O(n).
  void sample(const Scene& scene);
  void halve_weights() { average_.halve_weights(); }
  /// The result up to the time of the scene.
  Measurement result(const Scene& scene) const;

 private:
  friend class Persistence;
  VelocityDistribution() = default;
  static void persist(auto& archive, auto& self) {
    archive(self.spheres_, self.dimensions_, self.motion_, self.begin_, self.average_);
  }
  bool restored() const {
    return average_.has(kAllBins, kSphereGroups) && (dimensions_ == 2 || dimensions_ == 3);
  }

  static constexpr std::size_t kBins = 100;  // from -5 to 5
  static constexpr double kWidth = 0.1;
  static constexpr double kEdge = kWidth * kBins / 2;
  // Bins of the averages: counts, and sums over spheres, by groups of spheres.
  static constexpr std::size_t kComponents = 0;
  static constexpr std::size_t kSpeeds = kComponents + kBins;
  static constexpr std::size_t kSpheres = kSpeeds + kBins / 2;
  static constexpr std::size_t kSquare = kSpheres + 1;       // of c^2
  static constexpr std::size_t kFourth = kSquare + 1;        // of c^4
  static constexpr std::size_t kSpeed = kFourth + 1;         // of |v| [L/T]
  static constexpr std::size_t kExpectedSpeed = kSpeed + 1;  // that of Maxwell's distribution [L/T]
  static constexpr std::size_t kAllBins = kExpectedSpeed + 1;

  double spheres_;
  std::size_t dimensions_;
  ThermalMotion motion_;  // at the start
  Time begin_;
  BlockAverage average_;
};

}  // namespace hardball
