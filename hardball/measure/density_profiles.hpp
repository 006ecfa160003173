// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "hardball/measure/scene.hpp"
#include "hardball/statistics/block_average.hpp"
#include "hardball/statistics/contact_extrapolation.hpp"
#include "hardball/statistics/measurement.hpp"

namespace hardball {

/// How number density and packing fraction change along each axis that is not open, and the density of
/// centers that touch a wall.
///
/// A bin is a slab across the whole box. The number density counts centers; the packing fraction is the exact
/// volume of the slab that lies within spheres. If an axis is open a slab has no volume, and the measurement
/// is empty.
class DensityProfiles {
 public:
  static constexpr std::string_view kName = "density_profiles";

  /// In bins of `bin_width` mean radii, or wider so that there are no more than 2000.
  explicit DensityProfiles(const Scene& scene, double bin_width = 0.1);

  /// What a sample costs [ns]: 5 ns for each sphere and bin it overlaps, along each axis.
  double sample_cost() const { return sample_cost_; }
  void sample(const Scene& scene);
  void halve_weights() { average_.halve_weights(); }
  Measurement result(const Scene& scene) const;

  /// Whether it can continue with this world; false only if its state is damaged.
  bool matches(const World& world) const;

 private:
  friend class Persistence;
  DensityProfiles() = default;
  static void persist(auto& archive, auto& self) {
    archive(self.box_, self.begin_, self.bin_width_, self.bins_, self.most_bins_, self.contact_,
            self.sample_cost_, self.average_);
  }
  bool restored() const;

  double slab_width(std::size_t axis, std::size_t bin) const;
  void add_slices(double center, double radius, std::size_t axis, std::vector<double>& filled) const;

  Box box_;
  Time begin_;
  double bin_width_ = 0;  // [L]; the last bin along an axis may be thinner
  std::array<std::size_t, kAxes> bins_{};
  std::size_t most_bins_ = 0;  // the largest of bins_
  ContactExtrapolation contact_;
  double sample_cost_ = 0;  // [ns]
  // Bins, by axis and slab: counts of centers, then packing fractions, then by kAtWalls.
  std::size_t first_fraction() const { return kAxes * most_bins_; }
  std::size_t first_at_walls() const { return 2 * kAxes * most_bins_; }
  // Of centers that touch a wall, averaged over all walls: the density [L^-3], and its product with the kT of
  // the world, the pressure [M L^-1 T^-2].
  static constexpr std::size_t kAtWalls = 2;
  BlockAverage average_{0};
};

}  // namespace hardball
