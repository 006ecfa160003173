// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <tuple>
#include <vector>

#include "hardball/interaction/contact.hpp"
#include "hardball/measure/kinetic_tensor.hpp"
#include "hardball/measure/scene.hpp"
#include "hardball/statistics/block_average.hpp"
#include "hardball/statistics/measurement.hpp"
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

  explicit Temperature(const Scene& scene);

  /// What a sample costs [ns].
  double sample_cost() const { return 16 * spheres_; }
  /// Cost: O(1).
  void note(const Contact& contact);
  void note(const VelocityChange& change);
  /// Cost: O(n).
  void sample(const Scene& scene);
  void halve_weights() { samples_.halve_weights(); }
  /// The result up to the time of the scene.
  Measurement result(const Scene& scene) const;

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

}  // namespace hardball
