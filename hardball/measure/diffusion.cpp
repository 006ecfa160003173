// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/diffusion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "hardball/measure/reasons.hpp"
#include "hardball/numbers/no_number.hpp"
#include "hardball/statistics/qualification.hpp"
#include "hardball/theory/kinetic_theory.hpp"

namespace hardball {
namespace {

// By how much D(t) may still change, from the change since half the lag.
double remainder(const Estimate& change) {
  const double beyond_chance = change.value * change.value - change.error * change.error;
  return beyond_chance > 0 ? (1 + std::numbers::sqrt2) * std::sqrt(beyond_chance) : 0;
}

}  // namespace

const char* objection_to_diffusion(const Scene& scene) {
  if (!scene.world().box().is_all(Boundary::periodic))
    return "diffusion is measured where all axes are periodic";
  if (scene.fluid().is_ideal()) return kVelocitiesOfTheStart;
  return scene.settled().is_steady ? nullptr : kNotSteady;
}

std::optional<std::size_t> half_lag(std::span<const double> lags, std::size_t lag) {
  const auto half = std::ranges::lower_bound(lags, lags[lag] / 2);
  if (half == lags.end() || *half != lags[lag] / 2 || *half == 0) return std::nullopt;
  return static_cast<std::size_t>(half - lags.begin());
}

Diffusion read_diffusion(const TimeCorrelation& average, std::size_t species, double mean_free_time,
                         const std::function<std::optional<FunctionOfMeans>(std::size_t lag)>& up_to) {
  constexpr double kFreeTimes = 10;
  const std::vector<double> lags = average.lags();
  Diffusion best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t lag = 1; lag < lags.size(); ++lag) {
    const std::optional<std::size_t> half = half_lag(lags, lag);
    if (!half || !(lags[*half] >= kFreeTimes * mean_free_time)) continue;
    const std::optional<FunctionOfMeans> later = up_to(lag);
    const std::optional<FunctionOfMeans> earlier = up_to(*half);
    if (!later || !earlier) continue;
    Estimate constant = average.estimate(species, *later);
    constant.error =
        std::hypot(constant.error, remainder(average.estimate(species, [&](std::span<const double> means) {
                     return (*later)(means) - (*earlier)(means);
                   })));
    const bool is_first = best.lag == 0;
    if (!is_first && !(constant.error < least)) continue;
    if (!std::isnan(constant.error)) least = constant.error;
    best = {constant, lags[lag], {}};
  }
  if (best.lag == 0) return {.reason = "no lag is long enough for velocities to be forgotten"};
  constexpr double kKnown = 0.5;
  if (!(best.constant.value > 0) || best.constant.error > kKnown * best.constant.value) {
    return {.reason = "the run is too short to know it to within a half"};
  }
  return best;
}

DiffusionConditions::DiffusionConditions(const Scene& scene)
    : theory(scene.fluid()),
      motion(scene.thermal_motion()),
      dimensions(static_cast<double>(scene.world().box().dimensions())),
      mean_free_time(hardball::mean_free_time(scene.statistics())) {}

double DiffusionConditions::temperature(const Scene& scene) const {
  return is_energy_conserved(motion, scene.thermal_motion()) ? motion.temperature() : kNoNumber;
}

void DiffusionConditions::add(const Diffusion& diffusion, const SpeciesList& species, std::size_t which,
                              double temperature, Measurement& found) const {
  const Estimate& constant = diffusion.constant;
  const double expected = theory.diffusion(temperature);
  const std::string suffix = species.suffix(which);
  add_with_enskog(found,
                  {"diffusion_constant" + suffix, "L^2 T^-1", constant.value, constant.error, expected,
                   FluidTheory::kDiffusionTolerance * expected, diffusion.reason},
                  theory.enskog_diffusion(temperature));
  if (diffusion.lag > 0) found.add("diffusion_lag" + suffix, "T", {diffusion.lag}).reason = kLagChosen;
}

void add_with_enskog(Measurement& found, const Quantity& coefficient, double enskog) {
  found.quantities.push_back(coefficient);
  if (std::isnan(enskog)) return;
  const Estimate estimate{coefficient.value, coefficient.error};
  found
      .add(coefficient.name + "_over_enskog", "1", estimate / enskog, coefficient.theory / enskog,
           coefficient.tolerance / enskog)
      .reason = coefficient.reason;
}

}  // namespace hardball
