// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hardball/measure/result.hpp"
#include "hardball/statistics/contact_extrapolation.hpp"
#include "hardball/theory/species_list.hpp"
#include "hardball/theory/thermal_motion.hpp"

namespace hardball {

/// The radial distribution function g(r): the density of spheres at the distance r from a sphere over that of
/// an ideal gas of as many points in the same box; and its value at contact.
///
/// Of two or three species there is a function for each pair of species; of more, one for all spheres,
/// without a contact value. The ideal gas fills the space in which centers can be: it ends a radius before
/// walls, and so do shells about a sphere near a wall, which is allowed for exactly (for two species, to the
/// difference of their radii over the size of the box). In a box open along an axis there is no density to
/// compare with, and the measurement is empty. Source: Allen and Tildesley, Computer Simulation of Liquids,
/// section 2.6.
class RadialDistribution {
 public:
  static constexpr std::string_view kName = "radial_distribution";
  static constexpr Definition kDefinition{
      .title = "Radial distribution function",
      .formula = "$g(r)$: pairs at the distance $r$ over those of an ideal gas in the same box",
      .source =
          "Allen and Tildesley, Computer Simulation of Liquids, section 2.6; contact value of equal "
          "spheres: Kolafa, Labik and Malijevsky, Phys. Chem. Chem. Phys. 6 (2004) 2335; of mixtures: "
          "Mansoori et al., J. Chem. Phys. 54 (1971) 1523",
      .source_of_discs =
          "Allen and Tildesley, Computer Simulation of Liquids, section 2.6; contact value of discs: "
          "Kolafa and Rottner, Mol. Phys. 104 (2006) 3435; of mixtures: Santos, Yuste and Lopez de Haro, "
          "J. Chem. Phys. 117 (2002) 5785"};

  /// Extends to `range` mean diameters, at most to half the smallest edge of the box, in bins of `bin_width`
  /// mean diameters.
  explicit RadialDistribution(const Scene& scene, double range = 5, double bin_width = 0.02);

  /// What a sample costs [ns]: mostly 30 ns for each neighbor within the range, see NeighborQuery.
  double sample_cost() const { return sample_cost_; }
  /// Precondition: the spheres are those of the start.
  void sample(const Scene& scene);
  void halve_weights() { average_.halve_weights(); }
  void add_results(const Scene& scene, Measurement& found) const;

  /// Whether it can continue with this world; false only if its state is damaged.
  bool matches(const World& world) const;

 private:
  friend class Persistence;
  RadialDistribution() = default;
  static void persist(auto& archive, auto& self) {
    archive(self.box_, self.species_, self.is_by_species_, self.kinds_, self.kind_of_, self.low_,
            self.bin_width_, self.bins_, self.sample_cost_, self.begin_, self.average_, self.motion_,
            self.is_smooth_);
  }
  bool restored() const;

  // A pair of species, or all spheres.
  struct Kind {
    double reach;        // the sum of the radii [L]
    double theory;       // the contact value [1]; NaN if there is none
    std::string suffix;  // of names: "", or "_1_2"
    ContactExtrapolation contact;
    double tolerance = 0;  // of the theory [1]
    static void persist(auto& archive, auto& self) {
      archive(self.reach, self.theory, self.suffix, self.contact, self.tolerance);
    }
  };

  bool has_meaning() const { return bins_ > 0; }
  bool has_contact() const;
  std::size_t species_of(SphereId id) const { return is_by_species_ ? species_.of(id) : 0; }
  double ideal_share(double distance, double reach) const;
  std::size_t contact_bin(std::size_t kind) const { return kinds_.size() * bins_ + kind; }
  std::size_t near_bin(std::size_t kind) const { return contact_bin(kind) + kinds_.size(); }
  std::size_t pairs_bin(std::size_t kind) const { return near_bin(kind) + kinds_.size(); }

  ThermalMotion motion_;  // at the start
  Box box_;
  SpeciesList species_;
  bool is_by_species_;
  bool is_smooth_ = true;  // near contact; steps of a potential make the function jump
  std::vector<Kind> kinds_;
  std::vector<std::size_t> kind_of_;  // shape (species, species)
  double low_ = 0;                    // where the bins start: the least distance of centers [L]
  double bin_width_ = 0;              // [L]
  std::size_t bins_ = 0;              // of each kind
  double sample_cost_ = 0;            // [ns]
  Time begin_;
  // By groups of spheres: counts of neighbors by kind and bin; by kind the density at contact times pairs,
  // and the pairs that could be neighbors.
  BlockAverage average_{0};
};

}  // namespace hardball
