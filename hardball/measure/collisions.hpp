// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "hardball/interaction/contact.hpp"
#include "hardball/measure/result.hpp"
#include "hardball/measure/sphere_groups.hpp"
#include "hardball/theory/fluid_theory.hpp"
#include "hardball/theory/species_list.hpp"
#include "hardball/theory/thermal_motion.hpp"

namespace hardball {

/// How often spheres collide, with which species, the mean free time and path, and how often spheres hit a
/// wall. Source: Chapman and Cowling, The Mathematical Theory of Non-Uniform Gases, sections 5.2 and 16.2.
class CollisionRate {
 public:
  static constexpr std::string_view kName = "collision_rate";
  static constexpr Definition kDefinition{
      .title = "Collision rate",
      .formula = R"($\omega = 2 c / (N t)$ of $c$ collisions; mean free time $1 / \omega$, path $\langle v )"
                 R"(\rangle / \omega$; theory: $\omega = \frac{2 d}{\sqrt{\pi}} (Z - 1) \frac{1}{\sigma} )"
                 R"(\sqrt{kT / m}$ for diameters $\sigma$ in $d$ dimensions)",
      .source = "Chapman and Cowling, The Mathematical Theory of Non-Uniform Gases, sections 5.2 and 16.2"};

  explicit CollisionRate(const Scene& scene);

  /// Cost: O(1).
  void record(const Contact& contact);
  /// What a sample costs [ns].
  double sample_cost() const { return 8 * spheres_; }
  /// Samples the speeds, from which the mean free path follows. Cost: O(n).
  void sample(const Scene& scene);
  void halve_weights() { speed_.halve_weights(); }
  /// Adds the results up to the time of the scene.
  void add_results(const Scene& scene, Measurement& found) const;

  /// Whether it can continue with this world; false only if its state is damaged.
  bool matches(const World& world) const { return species_.matches(world); }

 private:
  friend class Persistence;
  CollisionRate() = default;
  static void persist(auto& archive, auto& self) {
    archive(self.species_, self.theory_, self.motion_, self.spheres_, self.has_walls_, self.begin_,
            self.last_, self.contacts_, self.speed_);
  }
  bool restored() const {
    return contacts_.has(kPairs + species_.size() * species_.size()) && speed_.has(3, kSphereGroups);
  }

  // Bins: collisions of all, wall contacts, then collisions of each pair of species.
  enum : std::size_t { kCollisions, kWalls, kPairs };
  std::size_t pair_bin(std::size_t a, std::size_t b) const;
  enum : std::size_t { kSpeed, kSquare, kSpheres };
  void advance(const Time& now);

  SpeciesList species_;
  FluidTheory theory_;
  ThermalMotion motion_;  // at the start
  double spheres_;
  bool has_walls_;
  Time begin_;
  Time last_;
  BlockAverage contacts_;  // each count per unit time [1/T]
  // Sums over spheres, by groups of spheres: of the speed [L/T] and of m v^2, since at fixed energy the mean
  // speed varies less than that of independent spheres.
  BlockAverage speed_{3, kSphereGroups};
};

/// The relative speed of colliding spheres along their line of centers. In equilibrium the distribution is
/// Rayleigh's at every density, in the gas, the liquid and the crystal: the sharpest test that velocities and
/// contacts are right. Source: docs/measures.md.
class ImpactSpeeds {
 public:
  static constexpr std::string_view kName = "impact_speeds";
  static constexpr Definition kDefinition{
      .title = "Impact speeds",
      .formula =
          R"($p(u)$ of the speed $u$ at which two surfaces touch; theory: Rayleigh's distribution, )"
          R"($\frac{m}{2kT} \, u \, e^{-m u^2 / 4kT}$ for equal masses, mean $\sqrt{\pi kT / m}$, mean )"
          R"(square $4kT / m$; exact for a fixed energy)",
      .source =
          "Kinetic theory: pairs collide in proportion to their normal relative speed; docs/measures.md"};

  explicit ImpactSpeeds(const Scene& scene);

  /// Cost: O(1).
  void record(const Contact& contact);
  /// Adds the results up to the time of the scene.
  void add_results(const Scene& scene, Measurement& found) const;

  /// Whether it can continue with this world; false only if its state is damaged.
  bool matches(const World& world) const { return species_.matches(world); }

 private:
  friend class Persistence;
  ImpactSpeeds() = default;
  static void persist(auto& archive, auto& self) {
    archive(self.species_, self.motion_, self.begin_, self.width_, self.bins_per_speed_, self.average_);
  }
  bool restored() const {
    return average_.has(kPairs + species_.size() * species_.size()) && !(bins_per_speed_ < 0);
  }

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
