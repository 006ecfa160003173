// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "hardball/measure/result.hpp"

namespace hardball {

/// The static structure factor S(k) = |sum over spheres of exp(i k.x)|^2 / n: what a diffraction experiment
/// on the centers measures.
///
/// Wave vectors fit the period along periodic axes and are zero along the others; without a periodic axis the
/// measurement is empty. They are grouped in shells of about equal length, from each of which a few are
/// chosen, spread evenly over directions: the sharp peaks of a large crystal may fall between them.
class StructureFactor {
 public:
  static constexpr std::string_view kName = "structure_factor";
  static constexpr Definition kDefinition{
      .title = "Static structure factor",
      .formula =
          R"($S(k) = \frac{1}{n} \left| \sum e^{i \mathbf{k} \cdot \mathbf{x}} \right|^2$ over $n$ spheres)",
      .source = "Hansen and McDonald, Theory of Simple Liquids, sections 4.1 and 4.4 (Percus and Yevick)"};
  /// Without a meaning where images of the box slide.
  static constexpr bool kNeedsImagesAtRest = true;

  /// Wave vectors are at most `longest` over the mean diameter long, or have 4096 periods along the longest
  /// axis if that is less; of each of 64 shells up to `vectors_in_shell` are chosen. If that is not given
  /// they are six, or fewer with more than some 25,000 spheres, so that a sample costs hardly more than with
  /// that many.
  explicit StructureFactor(const Scene& scene, double longest = 20,
                           std::optional<std::size_t> vectors_in_shell = {});

  /// What a sample costs [ns]: 3 ns for each sphere and wave vector.
  double sample_cost() const { return sample_cost_; }
  void sample(const Scene& scene);
  void halve_weights() { shells_.halve_weights(); }
  void add_results(const Scene& scene, Measurement& found) const;

 private:
  friend class Persistence;
  StructureFactor() = default;
  static void persist(auto& archive, auto& self) {
    archive(self.unit_, self.longest_, self.waves_, self.shell_ends_, self.diameter_, self.packing_fraction_,
            self.sample_cost_, self.begin_, self.shells_);
  }
  bool restored() const;

  // A wave vector in units of 2 pi / period.
  using Wave = std::array<int, kAxes>;

  void choose_waves(std::size_t shell, double low, double high, std::size_t most);
  double length_of(const Wave& wave) const;

  Vec3 unit_;       // 2 pi / period along periodic axes, zero along the others [1/L]
  Wave longest_{};  // the largest component along each axis
  std::vector<Wave> waves_;
  std::vector<std::size_t> shell_ends_;  // in waves_, of the shells that hold any
  double diameter_ = 0;                  // the mean [L]
  double packing_fraction_;              // of a fluid of one species, see fluid_packing_fraction
  double sample_cost_ = 0;               // [ns]
  Time begin_;
  BlockAverage shells_{0};
};

}  // namespace hardball
