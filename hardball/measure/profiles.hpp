// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "hardball/measure/result.hpp"
#include "hardball/statistics/contact_extrapolation.hpp"

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
  static constexpr Definition kDefinition{
      .title = "Density profiles",
      .formula =
          "number density: centers in a slab over its volume; packing fraction: volume of spheres in a "
          "slab over its volume; pressure: $kT$ times the density of centers that touch a wall",
      .source = "Henderson, Blum and Lebowitz, J. Electroanal. Chem. 102 (1979) 315 (contact theorem)"};

  /// In bins of `bin_width` mean radii, or wider so that there are no more than 2000.
  explicit DensityProfiles(const Scene& scene, double bin_width = 0.1);

  /// What a sample costs [ns]: 5 ns for each sphere and bin it overlaps, along each axis.
  double sample_cost() const { return sample_cost_; }
  void sample(const Scene& scene);
  void halve_weights() { average_.halve_weights(); }
  void add_results(const Scene& scene, Measurement& found) const;

  /// Whether it can continue with this world; false only if its state is damaged.
  bool matches(const World& world) const { return is_same_box(box_, world.box()); }

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

/// How density, temperature and flow change from one face of the box to the opposite one, along each axis at
/// whose ends a face is thermal or moves, and across the shear of a sheared box. Where there is no such axis
/// the measurement is empty.
///
/// The room between the positions that the smallest spheres can reach is divided into slabs. The temperature
/// is that of the motion relative to the flow in each.
class FlowProfiles {
 public:
  static constexpr std::string_view kName = "flow_profiles";
  static constexpr const char* kTitleAcrossShear = "Profiles across the shear";
  static constexpr Definition kDefinition{
      .title = "Profiles between driven faces",
      .formula =
          R"(number density: centers in a slab over its volume; flow velocity $\mathbf{u} = \sum m )"
          R"(\mathbf{v} / \sum m$ in a slab; $kT = \frac{1}{d N} \sum m (\mathbf{v} - \mathbf{u})^2$ of )"
          R"($N$ spheres in $d$ dimensions)",
      .source = "sums over the spheres in each slab"};

  /// In slabs of one mean radius, or wider so that there are no more than 100 along an axis.
  explicit FlowProfiles(const Scene& scene);

  /// What a sample costs [ns].
  double sample_cost() const { return sample_cost_; }
  void sample(const Scene& scene);
  void halve_weights() { average_.halve_weights(); }
  void add_results(const Scene& scene, Measurement& found) const;

  /// Whether it can continue with this world; false only if its state is damaged.
  bool matches(const World& world) const { return is_same_box(box_, world.box()); }

 private:
  friend class Persistence;
  FlowProfiles() = default;
  static void persist(auto& archive, auto& self) {
    archive(self.box_, self.begin_, self.least_radius_, self.slabs_, self.sample_cost_, self.average_);
  }
  bool restored() const;

  // Sums over the spheres in a slab.
  static constexpr std::size_t kCount = 0;
  static constexpr std::size_t kMass = 1;      // [M]
  static constexpr std::size_t kMomentum = 2;  // along each axis [M L/T]
  static constexpr std::size_t kSquare = 5;    // m v^2 [M L^2 T^-2]
  static constexpr std::size_t kSums = 6;

  // The first sum of a slab across an axis.
  std::size_t bin(std::size_t axis, std::size_t slab) const;
  std::size_t bins() const { return bin(kAxes, 0); }
  double slab_width(std::size_t axis) const {
    return (box_.size()[axis] - 2 * margin(axis)) / static_cast<double>(slabs_[axis]);
  }
  // How far from the faces the slabs begin: where centers can be.
  double margin(std::size_t axis) const { return box_.is_wall(axis) ? least_radius_ : 0; }
  void add_profiles(Measurement& found, const BlockAverage& average, std::size_t axis) const;

  Box box_;
  Time begin_;
  double least_radius_ = 0;                 // [L]
  std::array<std::size_t, kAxes> slabs_{};  // none along axes that are not measured
  double sample_cost_ = 0;                  // [ns]
  BlockAverage average_{0};
};

}  // namespace hardball
