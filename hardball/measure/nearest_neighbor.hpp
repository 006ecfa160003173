// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "hardball/measure/scene.hpp"
#include "hardball/statistics/block_average.hpp"
#include "hardball/statistics/measurement.hpp"
#include "hardball/theory/thermal_motion.hpp"

namespace hardball {

/// The gap between a sphere and the one whose surface is nearest.
///
/// Gaps are known up to the distance within which a sphere of the mean density would find ten others, in an
/// open box up to ten diameters; the mean excludes wider ones.
class NearestNeighbor {
 public:
  static constexpr std::string_view kName = "nearest_neighbor";

  explicit NearestNeighbor(const Scene& scene, std::size_t bins = 100);

  /// What a sample costs [ns]: 600 to 1500 ns for each chosen sphere, see NeighborQuery.
  double sample_cost() const { return sample_cost_; }
  void sample(const Scene& scene);
  void halve_weights() { average_.halve_weights(); }
  Measurement result(const Scene& scene) const;

  /// Whether it can continue with this world; false only if its state is damaged.
  bool matches(const World& world) const;

 private:
  friend class Persistence;
  NearestNeighbor() = default;
  static void persist(auto& archive, auto& self) {
    archive(self.widest_, self.diameter_, self.sample_cost_, self.dimensions_, self.packing_fraction_,
            self.begin_, self.bins_, self.average_, self.motion_);
  }
  bool restored() const;

  std::size_t spheres_bin() const { return bins_; }
  std::size_t known_bin() const { return bins_ + 1; }
  std::size_t gaps_bin() const { return bins_ + 2; }

  ThermalMotion motion_;    // at the start
  double widest_ = 0;       // the widest gap that is known [L]
  double diameter_ = 0;     // the largest [L]
  double sample_cost_ = 0;  // [ns]
  std::size_t dimensions_;
  double packing_fraction_;  // of a fluid of one species, see fluid_packing_fraction
  Time begin_;
  std::size_t bins_;
  // Counts by bins of the gap, all chosen spheres, and those with a known gap, and the sum of these [L], by
  // groups of spheres.
  BlockAverage average_;
};

}  // namespace hardball
