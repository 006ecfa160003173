// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "hardball/measure/block_average.hpp"
#include "hardball/measure/measurement.hpp"
#include "hardball/measure/scene.hpp"

namespace hardball {

/// The distribution of velocities, each in units of sqrt(kT / m), kT being the temperature of the moment: so
/// masses may differ and a granular gas may cool. In equilibrium it is Maxwell's. A common drift along axes
/// without walls does not count. Source: Chapman and Cowling, The Mathematical Theory of Non-Uniform Gases,
/// section 4.1.
class VelocityDistribution {
 public:
  static constexpr std::string_view kName = "velocity_distribution";

  explicit VelocityDistribution(const Scene& scene);

  /// What a sample costs [ns].
  double sample_cost() const { return 30 * spheres_; }
  /// Cost: O(n).
  void sample(const Scene& scene);
  /// What was found up to the moment of the scene.
  Measurement result(const Scene& scene) const;

 private:
  static constexpr std::size_t kBins = 100;  // from -5 to 5
  static constexpr double kWidth = 0.1;
  static constexpr double kEdge = kWidth * kBins / 2;
  // Bins of the averages.
  static constexpr std::size_t kComponents = 0;                  // share of all components
  static constexpr std::size_t kSpeeds = kComponents + kBins;    // share of all speeds
  static constexpr std::size_t kSquare = kSpeeds + kBins / 2;    // <c^2>
  static constexpr std::size_t kFourth = kSquare + 1;            // <c^4>
  static constexpr std::size_t kMeanSpeed = kFourth + 1;         // [L/T]
  static constexpr std::size_t kExpectedSpeed = kMeanSpeed + 1;  // [L/T]
  static constexpr std::size_t kAllBins = kExpectedSpeed + 1;

  double spheres_;
  double degrees_of_freedom_;
  BlockAverage average_{kAllBins};
};

}  // namespace hardball
