// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include "hardball/measure/block_average.hpp"
#include "hardball/measure/measurement.hpp"
#include "hardball/measure/scene.hpp"
#include "hardball/theory/species_list.hpp"
#include "hardball/theory/thermal_motion.hpp"

namespace hardball {

/// Temperature k T, of all spheres, along each axis, of each species and of spins, and its history. In
/// equilibrium all are equal. A common drift along axes without walls does not count. The temperature of all
/// spheres is exact if energy is conserved; if they cool, its error is not known.
class Temperature {
 public:
  static constexpr std::string_view kName = "temperature";

  explicit Temperature(const Scene& scene);

  /// What a sample costs [ns].
  double sample_cost() const { return 16 * spheres_; }
  /// Cost: O(n).
  void sample(const Scene& scene);
  /// The result up to the time of the scene.
  Measurement result(const Scene& scene) const;

  /// Whether it can continue with this world; false only if its state is damaged.
  bool matches(const World& world) const;

 private:
  friend class Persistence;
  Temperature() = default;
  static void persist(auto& archive, auto& self) {
    archive(self.species_, self.masses_, self.box_, self.spheres_, self.motion_, self.begin_, self.average_);
  }
  bool restored() const;

  double freedom(std::size_t axis, double spheres, double mass) const;

  SpeciesList species_;
  std::vector<double> masses_;  // of all spheres of a species [M]
  Box box_;
  double spheres_;
  ThermalMotion motion_;  // at the start
  Time begin_;
  BlockAverage average_;
};

}  // namespace hardball
