// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include "hardball/interaction/contact.hpp"
#include "hardball/measure/scene.hpp"
#include "hardball/statistics/block_average.hpp"
#include "hardball/statistics/measurement.hpp"
#include "hardball/theory/species_list.hpp"
#include "hardball/theory/thermal_motion.hpp"

namespace hardball {

/// The relative speed of colliding spheres along their line of centers. In equilibrium the distribution is
/// Rayleigh's at every density, in the gas, the liquid and the crystal: the sharpest test that velocities and
/// contacts are right. Source: docs/measures.md.
class ImpactSpeeds {
 public:
  static constexpr std::string_view kName = "impact_speeds";

  explicit ImpactSpeeds(const Scene& scene);

  /// Cost: O(1).
  void note(const Contact& contact);
  /// The result up to the time of the scene.
  Measurement result(const Scene& scene) const;

  /// Whether it can continue with this world; false only if its state is damaged.
  bool matches(const World& world) const;

 private:
  friend class Persistence;
  ImpactSpeeds() = default;
  static void persist(auto& archive, auto& self) {
    archive(self.species_, self.motion_, self.begin_, self.width_, self.bins_per_speed_, self.average_);
  }
  bool restored() const;

  static constexpr std::size_t kBins = 120;
  // Further bins of the averages.
  static constexpr std::size_t kSpeed = kBins;             // [L/T]
  static constexpr std::size_t kSpeedSquare = kSpeed + 1;  // [L^2 T^-2]
  static constexpr std::size_t kPairs = kSpeedSquare + 1;  // fraction of each pair of species

  SpeciesList species_;
  ThermalMotion motion_;  // at the start
  Time begin_;
  double width_;           // of a bin [L/T]
  double bins_per_speed_;  // its inverse
  BlockAverage average_;
};

}  // namespace hardball
