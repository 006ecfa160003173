// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "hardball/measure/scene.hpp"
#include "hardball/statistics/block_average.hpp"
#include "hardball/statistics/measurement.hpp"

namespace hardball {

/// How many neighbors spheres have: centers no farther away than 1.2 times the distance at which the two
/// touch.
class Coordination {
 public:
  static constexpr std::string_view kName = "coordination";

  /// `reach` [1]: how far away neighbors are at most, as a multiple of the sum of the radii.
  explicit Coordination(const Scene& scene, double reach = 1.2);

  /// What a sample costs [ns]: 300 to 1200 ns for each chosen sphere, see NeighborQuery.
  double sample_cost() const { return sample_cost_; }
  void sample(const Scene& scene);
  void halve_weights() { average_.halve_weights(); }
  Measurement result(const Scene& scene) const;

 private:
  friend class Persistence;
  Coordination() = default;
  static void persist(auto& archive, auto& self) {
    archive(self.reach_, self.sample_cost_, self.begin_, self.average_);
  }
  bool restored() const;

  double reach_;
  double sample_cost_ = 0;  // [ns]
  Time begin_;
  BlockAverage average_;  // counts, by groups of spheres
};

}  // namespace hardball
