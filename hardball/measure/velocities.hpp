// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <tuple>
#include <vector>

#include "hardball/interaction/contact.hpp"
#include "hardball/measure/kinetic_tensor.hpp"
#include "hardball/measure/result.hpp"
#include "hardball/measure/sphere_groups.hpp"
#include "hardball/theory/species_list.hpp"
#include "hardball/theory/thermal_motion.hpp"
#include "hardball/world/velocity_change.hpp"

namespace hardball {

/// Temperature k T, of all spheres, along each axis, of each species and of spins, and its history. In
/// equilibrium all are equal. A common drift along axes without walls does not count. The temperature of all
/// spheres is an exact mean over time, integrated from contact to contact; the others are its parts in
/// samples.
class Temperature {
 public:
  static constexpr std::string_view kName = "temperature";
  static constexpr Definition kDefinition{
      .title = "Temperature",
      .formula =
          R"($kT = \frac{1}{f} \sum m v^2$ with $f$ degrees of freedom, one for each sphere and dimension )"
          R"(less one for each axis without walls)",
      .source = "Equipartition; Allen and Tildesley, Computer Simulation of Liquids, section 2.4"};

  explicit Temperature(const Scene& scene);

  /// What a sample costs [ns].
  double sample_cost() const { return 16 * spheres_; }
  /// Cost: O(1).
  void record(const Contact& contact);
  void record(const VelocityChange& change);
  /// Cost: O(n).
  void sample(const Scene& scene);
  void halve_weights() { samples_.halve_weights(); }
  /// Adds the results up to the time of the scene.
  void add_results(const Scene& scene, Measurement& found) const;

  /// Whether it can continue with this world; false only if its state is damaged.
  bool matches(const World& world) const { return species_.matches(world); }

 private:
  friend class Persistence;
  Temperature() = default;
  static void persist(auto& archive, auto& self) {
    archive(self.species_, self.masses_, self.box_, self.spheres_, self.motion_, self.begin_, self.samples_,
            self.last_, self.is_followed_, self.kinetic_, self.energy_);
  }
  bool restored() const;

  static constexpr std::size_t kComponents = std::tuple_size_v<SymmetricTensor>;

  void advance(const Time& now);
  double freedom(std::size_t axis, double spheres, double mass) const;

  SpeciesList species_;
  std::vector<double> masses_;  // of all spheres of a species but kinematic ones [M]
  Box box_;
  double spheres_;        // how many, without kinematic ones
  ThermalMotion motion_;  // at the start
  Time begin_;
  Time last_;
  bool is_followed_ = false;  // what follows; not in runs that an earlier version began
  KineticTensor kinetic_;
  BlockAverage energy_{kComponents};  // over time
  BlockAverage samples_;
};

/// The distribution of velocities, each in units of sqrt(kT / m), kT being the current temperature: so masses
/// may differ and a granular gas may cool. In equilibrium it is Maxwell's. A common drift along axes without
/// walls does not count. Source: Chapman and Cowling, The Mathematical Theory of Non-Uniform Gases, section
/// 4.1.
class VelocityDistribution {
 public:
  static constexpr std::string_view kName = "velocity_distribution";
  static constexpr Definition kDefinition{
      .title = "Velocity distribution",
      .formula =
          R"(densities of the components and the magnitude of $\mathbf{c} = \mathbf{v} / \sqrt{kT / m}$; )"
          R"(theory: Maxwell's, $\frac{1}{\sqrt{2\pi}} \, e^{-c^2 / 2}$ and $\sqrt{2 / \pi} \, c^2 )"
          R"(e^{-c^2 / 2}$, in two dimensions $c \, e^{-c^2 / 2}$)",
      .source = "Chapman and Cowling, The Mathematical Theory of Non-Uniform Gases, section 4.1"};

  explicit VelocityDistribution(const Scene& scene);

  /// What a sample costs [ns].
  double sample_cost() const { return 30 * spheres_; }
  /// Cost: O(n).
  void sample(const Scene& scene);
  void halve_weights() { average_.halve_weights(); }
  /// Adds the results up to the time of the scene.
  void add_results(const Scene& scene, Measurement& found) const;

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
