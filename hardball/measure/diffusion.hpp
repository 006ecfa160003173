// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>

#include "hardball/measure/time_correlation.hpp"
#include "hardball/statistics/measurement.hpp"
#include "hardball/theory/fluid_theory.hpp"
#include "hardball/theory/thermal_motion.hpp"

namespace hardball {

/// The lag that is half as long as another; none if it is not among them.
std::optional<std::size_t> half_lag(std::span<const double> lags, std::size_t lag);

/// The diffusion constant read from means over lags, and where.
struct Diffusion {
  Estimate constant = {};   ///< [L^2 T^-1]
  double lag = 0;           ///< [T]
  std::string reason = {};  ///< Why there is no value; empty if there is one.
};

/// Why there is no diffusion constant, whatever the lag; null if there may be one.
const char* objection_to_diffusion(const Scene& scene);

/// Reads the diffusion constant as D(t) at one of the lags: the one at which the error is least.
///
/// The error consists of that of the mean and of what may be missing beyond the lag: as velocities are
/// forgotten as t^(-3/2) in the end, D(t) still has to change by 1 + sqrt(2) times as much as since half the
/// lag, as far as that is more than chance. Half the lag must be at least ten mean free times, in which the
/// rest is forgotten. Source of the decay: Alder and Wainwright, Phys. Rev. A 1 (1970) 18.
///
/// `up_to(lag)`: D(t) as a function of the means, none if it is not known at that lag.
Diffusion read_diffusion(const TimeCorrelation& average, std::size_t species, double mean_free_time,
                         const std::function<std::optional<FunctionOfMeans>(std::size_t lag)>& up_to);

/// What diffusion is measured in.
struct DiffusionConditions {
  /// The conditions in the world of the scene, at its time.
  explicit DiffusionConditions(const Scene& scene);

  /// kT at the start if the energy has been conserved until the time of the scene, otherwise NaN.
  double temperature(const Scene& scene) const;
  /// Adds the constant, the constant over that of Enskog's theory, and the lag, of one species.
  void add(const Diffusion& diffusion, const SpeciesList& species, std::size_t which, double temperature,
           Measurement& found) const;

  FluidTheory theory;
  ThermalMotion motion;  ///< At the start.
  double dimensions;
  double mean_free_time;  ///< Expected [T].

 private:
  friend class Persistence;
  friend class MeanSquareDisplacement;
  friend class VelocityAutocorrelation;
  DiffusionConditions() = default;
  static void persist(auto& archive, auto& self) {
    archive(self.theory, self.motion, self.dimensions, self.mean_free_time);
  }
};

/// Where the definitions and the theory of diffusion are from.
inline constexpr const char* kSourceOfDiffusion =
    "Allen and Tildesley, Computer Simulation of Liquids, section 2.7; D: Speedy, Mol. Phys. 62 (1987) 509; "
    "Enskog: Chapman and Cowling, section 16.3";

/// Adds a transport coefficient, and unless Enskog's value is NaN, the coefficient over that value.
void add_with_enskog(Measurement& found, const Quantity& coefficient, double enskog);

}  // namespace hardball
