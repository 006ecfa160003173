// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string_view>
#include <tuple>

#include "hardball/interaction/contact.hpp"
#include "hardball/measure/kinetic_tensor.hpp"
#include "hardball/measure/result.hpp"
#include "hardball/theory/fluid_theory.hpp"
#include "hardball/theory/thermal_motion.hpp"
#include "hardball/world/velocity_change.hpp"

namespace hardball {

/// The pressure tensor from its kinetic and collisional parts, the compressibility, and the pressure on the
/// walls; in a sheared box relative to the flow, with the viscosity. With an open axis there is no volume,
/// and so no pressure. Source: Allen and Tildesley, Computer Simulation of Liquids, 2nd edition, section 2.4;
/// for walls the virial theorem.
class Pressure {
 public:
  static constexpr std::string_view kName = "pressure";
  static constexpr Definition kDefinition{
      .title = "Pressure",
      .formula =
          R"($P_{ab} = \frac{1}{V} \left( \sum m v_a v_b + \frac{1}{t} \sum_{\text{collisions}} r_a )"
          R"(\Delta p_b \right)$; $P$: the mean of $P_{aa}$; $Z = d P V / \sum m v^2$ in $d$ dimensions)",
      .source =
          "Allen and Tildesley, Computer Simulation of Liquids, section 2.4; theory of equal spheres: "
          "Kolafa, Labik and Malijevsky, Phys. Chem. Chem. Phys. 6 (2004) 2335; of mixtures: Mansoori et "
          "al., J. Chem. Phys. 54 (1971) 1523",
      .source_of_discs =
          "Allen and Tildesley, Computer Simulation of Liquids, section 2.4; theory of discs: Kolafa and "
          "Rottner, Mol. Phys. 104 (2006) 3435; of mixtures: Santos, Yuste and Lopez de Haro, Mol. Phys. "
          "96 (1999) 1"};

  /// Starts at the time of the scene. Cost: O(n).
  explicit Pressure(const Scene& scene);

  /// Cost: O(1).
  void record(const Contact& contact);
  void record(const VelocityChange& change);
  /// Adds the results up to the time of the scene.
  void add_results(const Scene& scene, Measurement& found) const;

 private:
  friend class Persistence;
  Pressure() = default;
  static void persist(auto& archive, auto& self) {
    archive(self.box_, self.dimensions_, self.is_homogeneous_, self.theory_, self.motion_, self.spheres_,
            self.mean_free_time_, self.begin_, self.last_, self.kinetic_, self.average_);
  }
  bool restored() const { return average_.has(kBins); }

  static constexpr std::size_t kComponents = std::tuple_size_v<SymmetricTensor>;
  static constexpr std::size_t kXy = 3;
  // Bins of the averages.
  static constexpr std::size_t kKinetic = 0;                              // sum of m v v [M L^2 T^-2]
  static constexpr std::size_t kCollisional = kKinetic + kComponents;     // [M L^2 T^-2]
  static constexpr std::size_t kFaceForces = kCollisional + kComponents;  // force on each face [M L T^-2]
  static constexpr std::size_t kRadii = kFaceForces + 2 * kAxes;          // force times radius [M L^2 T^-2]
  static constexpr std::size_t kHits = kRadii + kAxes;                    // contacts with walls [1/T]
  static constexpr std::size_t kBins = kHits + 1;

  void advance(const Time& now);
  double kinetic_error(std::size_t component, double elapsed) const;
  void add_viscosity(Measurement& found, const BlockAverage& average, const Estimate& pressure_xy,
                     bool is_elastic) const;
  void add_walls(Measurement& found, const BlockAverage& average) const;

  Box box_;
  double dimensions_;
  bool is_homogeneous_;  // no open axes, gravity or surfaces: one pressure everywhere
  FluidTheory theory_;
  ThermalMotion motion_;  // at the start
  double spheres_;
  double mean_free_time_;  // expected [T]
  Time begin_;
  Time last_;
  KineticTensor kinetic_;
  BlockAverage average_{kBins};
};

}  // namespace hardball
