// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "hardball/measure/scene.hpp"
#include "hardball/statistics/block_average.hpp"
#include "hardball/statistics/measurement.hpp"

namespace hardball {

/// The order in the directions to neighbors: the invariants Q4 and Q6 of all bonds, and q4 and q6 of the
/// bonds of each sphere.
///
/// Neighbors are centers no farther away than 1.4 times the distance at which the two touch. Q6 of all bonds
/// is 0.575 for a face-centered, 0.511 for a body-centered and 0.354 for a simple cubic crystal, 0.485 for a
/// hexagonal close packing, and goes to zero as one over the square root of the number of bonds for a fluid.
/// In two dimensions Psi_l takes the place of Q_l: Psi6 is 1 for a hexagonal crystal, Psi4 for a square one.
class BondOrder {
 public:
  static constexpr std::string_view kName = "bond_order";

  /// `reach` [1]: how far away neighbors are at most, as a multiple of the sum of the radii.
  explicit BondOrder(const Scene& scene, double reach = 1.4);

  /// What a sample costs [ns]: 700 to 2000 ns for each chosen sphere, see NeighborQuery.
  double sample_cost() const { return sample_cost_; }
  void sample(const Scene& scene);
  void halve_weights() { average_.halve_weights(); }
  Measurement result(const Scene& scene) const;

 private:
  friend class Persistence;
  BondOrder() = default;
  static void persist(auto& archive, auto& self) {
    archive(self.reach_, self.is_flat_, self.sample_cost_, self.begin_, self.average_);
  }
  bool restored() const;

  template <class Bonds>
  void sample_bonds(const Scene& scene);

  double reach_;
  bool is_flat_;
  double sample_cost_ = 0;  // [ns]
  Time begin_;
  BlockAverage average_;  // by groups of spheres
};

}  // namespace hardball
