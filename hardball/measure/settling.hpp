// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hardball/measure/scene.hpp"
#include "hardball/statistics/block_average.hpp"
#include "hardball/theory/thermal_motion.hpp"

namespace hardball {

/// Follows how the spheres lose the order in which they started, and whether their temperature settles: the
/// evidence that means are those of equilibrium, or of a steady state.
///
/// Conservation laws say nothing about that, and the noise of a pressure hides a slow change that an order
/// parameter shows clearly. Three kinds of order are looked for at the start: that of a crystal, in the
/// directions of the bonds; uneven density along an axis, of all spheres and of each species; and in a fluid
/// that starts as a crystal, the places themselves. Of a start without order, only the temperature is
/// followed.
class Settling {
 public:
  /// Starts at the time of the scene, with spheres that were placed there, or come from what may be an
  /// equilibrium. Cost: O(n).
  Settling(const Scene& scene, bool is_placed);

  /// What a sample costs [ns].
  double sample_cost() const { return sample_cost_; }
  /// Cost: O(n).
  void sample(const Scene& scene);
  /// What the samples so far say. A part of the run that depends on the start ends where order first comes to
  /// its mean in the second half of the run, and stays within four standard deviations of it; and in a fluid
  /// where spheres have left their places.
  Settled found(const Scene& scene) const;

  /// Whether it can continue with this world; false only if its state is damaged.
  bool matches(const World& world) const { return species_.matches(world); }

 private:
  friend class Persistence;
  Settling() = default;
  static void persist(auto& archive, auto& self) {
    archive(self.motion_, self.species_, self.begin_, self.sample_cost_, self.wave_number_, self.reach_,
            self.is_crystal_, self.must_leave_places_, self.places_, self.modes_, self.starts_,
            self.history_);
  }
  bool restored() const;

  // A wave of the density along an axis, of a species.
  struct Mode {
    std::uint64_t axis = 0;
    std::uint64_t species = 0;
    static void persist(auto& archive, auto& self) { archive(self.axis, self.species); }
  };

  std::vector<double> orders_of(const Scene& scene) const;
  double overlap_with_places(const Scene& scene) const;
  double intensity(const Scene& scene, const Mode& mode) const;
  void judge_temperature(const Scene& scene, Settled& found) const;
  bool is_drifting(const FunctionOfMeans& temperature, const ThermalMotion& now) const;

  ThermalMotion motion_;  // at the start
  SpeciesList species_;
  Time begin_;
  double sample_cost_ = 0;          // [ns]
  double wave_number_ = 0;          // of the lattice [1/L]
  double reach_ = 0;                // of a bond [L]
  bool is_crystal_ = false;         // at the start
  bool must_leave_places_ = false;  // as the equilibrium is a fluid
  std::vector<Vec3> places_;        // at the start, of the spheres followed; none unless they must be left
  std::vector<Mode> modes_;         // those with an uneven density at the start
  std::vector<double> starts_;      // the orders at the start
  BlockAverage history_;            // of the temperature, the overlap with the places, and each order
};

}  // namespace hardball
