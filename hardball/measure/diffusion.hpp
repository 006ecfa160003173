// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include "hardball/measure/result.hpp"
#include "hardball/measure/time_correlation.hpp"
#include "hardball/theory/fluid_theory.hpp"
#include "hardball/theory/thermal_motion.hpp"

namespace hardball {

/// Where the definitions and theories of the diffusion constant are from.
inline constexpr const char* kSourceOfDiffusion =
    "Allen and Tildesley, Computer Simulation of Liquids, section 2.7; D: Speedy, Mol. Phys. 62 (1987) 509; "
    "Enskog: Chapman and Cowling, section 16.3";

/// Adds a transport coefficient, and unless Enskog's value is NaN, the coefficient over that value.
void add_with_enskog(Measurement& found, const Quantity& coefficient, double enskog);

/// What the measures below have in common: vectors of spheres that are followed from sample to sample, and a
/// diffusion constant that is read from their means.
class DiffusionMeasure {
 public:
  /// Without a meaning where images of the box slide.
  static constexpr bool kNeedsImagesAtRest = true;

  /// Whether it can continue with this world; false only if its state is damaged.
  bool matches(const World& world) const { return average_.matches(world); }

 protected:
  /// D(t) at a lag as a function of the means; none if it is not known there.
  using UpToLag = std::function<std::optional<FunctionOfMeans>(std::size_t lag)>;

  DiffusionMeasure() = default;
  DiffusionMeasure(const Scene& scene, double interval, std::size_t most_spheres,
                   const TimeCorrelation::Shape& shape);

  /// How far the common drift has moved the spheres since the start [L].
  Vec3 drifted(const Scene& scene) const { return duration(begin_, scene.now()) * motion_.drift; }
  /// kT at the start if the energy has been conserved until the time of the scene, otherwise NaN.
  double initial_temperature(const Scene& scene) const;
  /// Adds the constant of a species, that over Enskog's value, and the lag at which it was read.
  void add_constant(const Scene& scene, std::size_t species, const UpToLag& up_to, Measurement& found) const;

  FluidTheory theory_;
  ThermalMotion motion_;  ///< At the start.
  double dimensions_;
  double mean_free_time_;  ///< Expected [T].
  Time begin_;
  TimeCorrelation average_;
};

/// How far spheres move in a given time, and the diffusion constant. Paths are followed through periodic
/// boundaries; a common drift along axes without walls does not count. Source: Einstein, Ann. Phys. 322
/// (1905) 549; Allen and Tildesley, Computer Simulation of Liquids, 2nd edition, section 2.7.
class MeanSquareDisplacement : public DiffusionMeasure {
 public:
  static constexpr std::string_view kName = "mean_square_displacement";
  static constexpr Definition kDefinition{
      .title = "Mean square displacement",
      .formula =
          R"($\langle |\mathbf{x}(s + t) - \mathbf{x}(s)|^2 \rangle$ over spheres and times $s$; $D(t)$: )"
          R"(its slope from $t / 2$ to $t$ over $2 d$ in $d$ dimensions, $D$: that at the lag $t$ with )"
          R"(the least error; theory: $2 d D \left( t - \tau (1 - e^{-t / \tau}) \right)$, $\tau = m D / )"
          R"(kT$, with $D$ of Enskog's theory)",
      .source = kSourceOfDiffusion};
  /// What a sample costs for each sphere followed [ns].
  static constexpr double kCostPerSphereFollowed = 60;

  /// Positions are compared every `interval` [T]; at most `most_spheres` are followed.
  MeanSquareDisplacement(const Scene& scene, double interval,
                         std::size_t most_spheres = TimeCorrelation::kMaxSpheres);

  /// A time that is not a multiple of the interval after the start is ignored. Cost: see TimeCorrelation.
  void sample(const Scene& scene);
  /// Adds the results up to the time of the scene.
  void add_results(const Scene& scene, Measurement& found) const;

 private:
  friend class Persistence;
  MeanSquareDisplacement() = default;
  static void persist(auto& archive, auto& self) {
    archive(self.theory_, self.motion_, self.dimensions_, self.mean_free_time_, self.begin_, self.average_);
  }
};

/// The decay of velocity correlations, and the diffusion constant as its integral. A common drift along axes
/// without walls does not count. Source: Alder and Wainwright, Phys. Rev. A 1 (1970) 18; Allen and Tildesley,
/// Computer Simulation of Liquids, 2nd edition, section 2.7.
class VelocityAutocorrelation : public DiffusionMeasure {
 public:
  static constexpr std::string_view kName = "velocity_autocorrelation";
  static constexpr Definition kDefinition{
      .title = "Velocity autocorrelation",
      .formula =
          R"($C(t) = \langle \mathbf{v}(s) \cdot \mathbf{v}(s + t) \rangle$ over spheres and times $s$; )"
          R"($D(t) = \frac{1}{d} \int_0^t C(s) \, \mathrm{d}s$ in $d$ dimensions, $D$: that at the lag )"
          R"($t$ with the least error; theory: $d \frac{kT}{m} e^{-t / \tau}$, $\tau = m D / kT$, with )"
          R"($D$ of Enskog's theory)",
      .source = kSourceOfDiffusion};
  /// What a sample costs for each sphere followed [ns].
  static constexpr double kCostPerSphereFollowed = 50;

  /// Velocities are compared every `interval` [T]; at most `most_spheres` are followed.
  VelocityAutocorrelation(const Scene& scene, double interval,
                          std::size_t most_spheres = TimeCorrelation::kMaxSpheres);

  /// A time that is not a multiple of the interval after the start is ignored. Cost: see TimeCorrelation.
  void sample(const Scene& scene);
  /// Adds the results up to the time of the scene.
  void add_results(const Scene& scene, Measurement& found) const;

 private:
  friend class Persistence;
  VelocityAutocorrelation() = default;
  static void persist(auto& archive, auto& self) {
    archive(self.theory_, self.motion_, self.dimensions_, self.mean_free_time_, self.average_, self.begin_);
  }
  bool restored() const { return average_.has(kShape); }

  // Of each sphere: velocity and position. Of each lag: the product of the velocities; and the displacement
  // times the mean of both velocities, which is the integral of the former up to the lag.
  static constexpr TimeCorrelation::Shape kShape{.vectors = 2, .products = 2};
};

}  // namespace hardball
