// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "hardball/errors/export.hpp"
#include "hardball/theory/species_list.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// Theory of the hard-sphere fluid in equilibrium in a periodic box, with a given number of spheres, fixed
/// energy and no total momentum: all that measured numbers are compared with. Where it does not apply, as
/// with walls, kinematic spheres, spheres some of which pass through each other, or beyond freezing,
/// everything is NaN. Spheres all of which pass through each other are an ideal gas, whatever their radii.
/// Temperatures are k T [M L^2 T^-2].
///
/// With fewer spheres there are fewer pairs, the density about a sphere is lower, and speeds vary less: all
/// in proportion to one over their number. Source: Lebowitz and Percus, Phys. Rev. 122 (1961) 1675;
/// docs/measures.md.
class HARDBALL_EXPORT FluidTheory {
 public:
  /// The densest fluid of equal spheres. Source: Hoover and Ree, J. Chem. Phys. 49 (1968) 3609.
  static constexpr double kFreezing = 0.494;
  /// The densest fluid of equal discs. Source: Bernard and Krauth, Phys. Rev. Lett. 107 (2011) 155704.
  static constexpr double kFreezingOfDiscs = 0.700;

  /// By which fraction diffusion() may be off [1].
  static constexpr double kDiffusionTolerance = 0.05;
  /// By which fractions viscosity(), enskog_bulk_viscosity() and enskog_thermal_conductivity() may be off
  /// [1].
  static constexpr double kViscosityTolerance = 0.05;
  static constexpr double kBulkViscosityTolerance = 0.15;
  static constexpr double kThermalConductivityTolerance = 0.07;

  /// The theory of no fluid; holds() is false.
  FluidTheory() = default;

  FluidTheory(const World& world, const SpeciesList& species);

  bool holds() const { return holds_; }
  /// Whether all spheres pass through each other, and so never reach equilibrium.
  bool is_ideal() const { return is_ideal_; }
  /// By which fraction Z - 1, contact values and collision rates may be off [1]: what the equations of state
  /// leave open, and in dense systems of few spheres what the periodic images do.
  double tolerance() const;

  /// Z = d P V / sum of m v^2 [1]: that of equal radii by fluid_compressibility, of others by the equation of
  /// Carnahan and Starling, extended to mixtures; of discs by fluid_compressibility_of_discs, extended to
  /// mixtures, too. Source: Mansoori, Carnahan, Starling and Leland, J. Chem. Phys. 54 (1971) 1523; Santos,
  /// Yuste and Lopez de Haro, Mol. Phys. 96 (1999) 1, and for contact values J. Chem. Phys. 117 (2002) 5785.
  double compressibility() const;
  /// How much likelier than in a dilute gas spheres of two species touch [1]. Source: as for compressibility.
  double contact_value(std::size_t a, std::size_t b) const;
  /// How often a sphere of species `a` collides with spheres of species `b` [1/T]. Source: Chapman and
  /// Cowling, The Mathematical Theory of Non-Uniform Gases, section 16.2.
  double collision_rate(std::size_t a, std::size_t b, double temperature) const;
  /// How often a sphere collides, averaged over all spheres [1/T]. If there are too many kinds for species,
  /// masses must be equal; otherwise NaN.
  double collision_rate(double temperature) const;
  /// Mean speed of all spheres [L/T].
  double mean_speed(double temperature) const;
  /// Diffusion constant of equal spheres by Enskog's theory [L^2 T^-1]; NaN for mixtures; of discs in the
  /// first approximation. Source: Chapman and Cowling, section 16.3; Gass, J. Chem. Phys. 54 (1971) 1898.
  double enskog_diffusion(double temperature) const;
  /// Diffusion constant of equal spheres from simulations of 500, corrected for the size of a cubic box [L^2
  /// T^-1]; NaN for mixtures, and for discs. Source: Speedy, Mol. Phys. 62 (1987) 509; for the size Yeh and
  /// Hummer, J. Phys. Chem. B 108 (2004) 15873, with the viscosity of Enskog's theory, in dense fluids
  /// corrected by Alder, Gass and Wainwright, J. Chem. Phys. 53 (1970) 3813.
  double diffusion(double temperature) const;
  /// By how much the diffusion constant of an infinite system is larger than that in this box, a cube [L^2
  /// T^-1]; NaN for mixtures, and for discs. Source: Yeh and Hummer, J. Phys. Chem. B 108 (2004) 15873.
  double diffusion_missing(double temperature) const;
  /// Viscosity of equal spheres by Enskog's theory [M L^-1 T^-1]; NaN for mixtures, and for discs. Source:
  /// Chapman and Cowling, section 16.41, with the higher orders of the dilute gas.
  double enskog_viscosity(double temperature) const;
  /// Viscosity of equal spheres by Enskog's theory, multiplied by the correction that simulations find [M
  /// L^-1 T^-1]; within kViscosityTolerance. Source: Alder, Gass and Wainwright, J. Chem. Phys. 53 (1970)
  /// 3813.
  double viscosity(double temperature) const;
  /// Bulk viscosity of equal spheres by Enskog's theory [M L^-1 T^-1]; zero for a dilute gas; NaN for
  /// mixtures, and for discs. Source: Chapman and Cowling, section 16.41.
  double enskog_bulk_viscosity(double temperature) const;
  /// Thermal conductivity of equal spheres over Boltzmann's constant by Enskog's theory [L^-1 T^-1]; NaN for
  /// mixtures, and for discs. Source: Chapman and Cowling, section 16.42.
  double enskog_thermal_conductivity(double temperature) const;

 private:
  friend class Persistence;
  static void persist(auto& archive, auto& self) {
    archive(self.species_, self.is_flat_, self.holds_, self.has_equal_radii_, self.density_,
            self.packing_fraction_, self.surface_, self.compressibility_, self.mean_free_path_,
            self.is_ideal_);
  }

  double spheres() const;
  double fixed_number() const;
  double fixed_energy() const;
  double contact_value_of_many(std::size_t a, std::size_t b) const;
  // Whether there is a theory of transport: equal spheres in a fluid.
  bool has_transport() const { return species_.is_one_kind() && holds_ && !is_flat_ && !is_ideal_; }
  // What the dilute gas has of viscosity [M L^-1 T^-1].
  double dilute_viscosity(double temperature) const;

  SpeciesList species_;
  bool is_flat_ = false;
  bool is_ideal_ = false;
  bool holds_ = false;
  bool has_equal_radii_ = false;
  double density_ = 0;  // [L^-3], of discs [L^-2]
  double packing_fraction_ = 0;
  // pi / 6 times number density times mean square diameter; of discs the mean diameter over its mean square
  // [1/L].
  double surface_ = 0;
  double compressibility_ = 0;  // of many spheres
  // If there are too many kinds for species, of spheres of equal mass [L].
  double mean_free_path_ = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace hardball
