// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "hardball/measure/scene.hpp"
#include "hardball/statistics/block_average.hpp"
#include "hardball/statistics/measurement.hpp"

namespace hardball {

/// How density, temperature and flow change from one face of the box to the opposite one, along each axis at
/// whose ends a face is thermal or moves, and across the shear of a sheared box. Where there is no such axis
/// the measurement is empty.
///
/// The room between the positions that the smallest spheres can reach is divided into slabs. The temperature
/// is that of the motion relative to the flow in each.
class FlowProfiles {
 public:
  static constexpr std::string_view kName = "flow_profiles";

  /// In slabs of one mean radius, or wider so that there are no more than 100 along an axis.
  explicit FlowProfiles(const Scene& scene);

  /// What a sample costs [ns].
  double sample_cost() const { return sample_cost_; }
  void sample(const Scene& scene);
  void halve_weights() { average_.halve_weights(); }
  Measurement result(const Scene& scene) const;

  /// Whether it can continue with this world; false only if its state is damaged.
  bool matches(const World& world) const;

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
