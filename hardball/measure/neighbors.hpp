// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "hardball/measure/result.hpp"
#include "hardball/theory/thermal_motion.hpp"

namespace hardball {

/// How many neighbors spheres have: centers no farther away than 1.2 times the distance at which the two
/// touch.
class Coordination {
 public:
  static constexpr std::string_view kName = "coordination";
  static constexpr Definition kDefinition{
      .title = "Numbers of neighbors",
      .formula = "fraction of the spheres with $k$ neighbors closer than a multiple of the sum of the radii",
      .source = "Bernal and Mason, Nature 188 (1960) 910"};

  /// `reach` [1]: how far away neighbors are at most, as a multiple of the sum of the radii.
  explicit Coordination(const Scene& scene, double reach = 1.2);

  /// What a sample costs [ns]: 300 to 1200 ns for each chosen sphere, see NeighborQuery.
  double sample_cost() const { return sample_cost_; }
  void sample(const Scene& scene);
  void halve_weights() { average_.halve_weights(); }
  void add_results(const Scene& scene, Measurement& found) const;

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

/// The gap between a sphere and the one whose surface is nearest.
///
/// Gaps are known up to the distance within which a sphere of the mean density would find ten others, in an
/// open box up to ten diameters; the mean excludes wider ones.
class NearestNeighbor {
 public:
  static constexpr std::string_view kName = "nearest_neighbor";
  static constexpr Definition kDefinition{
      .title = "Gaps between nearest neighbors",
      .formula = "probability density of the gap between a sphere and the one whose surface is nearest",
      .source = "Torquato, Phys. Rev. E 51 (1995) 3170"};

  explicit NearestNeighbor(const Scene& scene, std::size_t bins = 100);

  /// What a sample costs [ns]: 600 to 1500 ns for each chosen sphere, see NeighborQuery.
  double sample_cost() const { return sample_cost_; }
  void sample(const Scene& scene);
  void halve_weights() { average_.halve_weights(); }
  void add_results(const Scene& scene, Measurement& found) const;

  /// Whether it can continue with this world; false only if its state is damaged.
  bool matches(const World& world) const { return dimensions_ == world.box().dimensions(); }

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
  static constexpr Definition kDefinition{
      .title = "Bond-orientational order",
      .formula =
          R"($Q_l = \left( \frac{4 \pi}{2 l + 1} \sum_m |\langle Y_{lm} \rangle|^2 \right)^{1/2}$ over )"
          R"(all bonds; $q_l$: the same over the bonds of one sphere)",
      .source = "Steinhardt, Nelson and Ronchetti, Phys. Rev. B 28 (1983) 784",
      .formula_of_discs =
          R"($\Psi_l = \left| \langle e^{i l \theta} \rangle \right|$ over all bonds; $\psi_l$: the same )"
          R"(over the bonds of one disc)",
      .source_of_discs = "Halperin and Nelson, Phys. Rev. Lett. 41 (1978) 121"};

  /// `reach` [1]: how far away neighbors are at most, as a multiple of the sum of the radii.
  explicit BondOrder(const Scene& scene, double reach = 1.4);

  /// What a sample costs [ns]: 700 to 2000 ns for each chosen sphere, see NeighborQuery.
  double sample_cost() const { return sample_cost_; }
  void sample(const Scene& scene);
  void halve_weights() { average_.halve_weights(); }
  void add_results(const Scene& scene, Measurement& found) const;

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
