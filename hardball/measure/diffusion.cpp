// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/diffusion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "hardball/measure/reasons.hpp"
#include "hardball/numbers/no_number.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/theory/kinetic_theory.hpp"

namespace hardball {
namespace {

// By how much D(t) may still change, from the change since half the lag.
double remainder(const Estimate& change) {
  const double beyond_chance = change.value * change.value - change.error * change.error;
  return beyond_chance > 0 ? (1 + std::numbers::sqrt2) * std::sqrt(beyond_chance) : 0;
}

void add_squares(std::span<const Vec3> earlier, std::span<const Vec3> later, double* sum) {
  for (std::size_t i = 0; i < later.size(); ++i) {
    const Vec3 displacement = later[i] - earlier[i];
    *sum += dot(displacement, displacement);
  }
}

// Of two vectors of each sphere, velocity and position.
constexpr std::size_t kIntegral = 1;
void add_products(std::span<const Vec3> earlier, std::span<const Vec3> later, double* sums) {
  for (std::size_t i = 0; i < later.size(); i += 2) {
    sums[0] += dot(earlier[i], later[i]);
    sums[kIntegral] += dot(earlier[i] + later[i], later[i + 1] - earlier[i + 1]) / 2;
  }
}

// The diffusion constant read from means over lags, and where.
struct Diffusion {
  Estimate constant = {};   // [L^2 T^-1]
  double lag = 0;           // [T]
  std::string reason = {};  // why there is no value; empty if there is one
};

// Why there is no diffusion constant, whatever the lag; null if there may be one.
const char* objection_to_diffusion(const Scene& scene) {
  if (!scene.world().box().is_all(Boundary::periodic))
    return "diffusion is measured where all axes are periodic";
  if (scene.fluid().is_ideal()) return kVelocitiesOfTheStart;
  return scene.settled().is_steady ? nullptr : kNotSteady;
}

// The lag that is half as long as another; none if it is not among them.
std::optional<std::size_t> half_lag(std::span<const double> lags, std::size_t lag) {
  const auto half = ranges::lower_bound(lags, lags[lag] / 2);
  if (half == lags.end() || *half != lags[lag] / 2 || *half == 0) return std::nullopt;
  return static_cast<std::size_t>(half - lags.begin());
}

// Reads the diffusion constant as D(t) at one of the lags: the one at which the error is least.
//
// The error consists of that of the mean and of what may be missing beyond the lag: as velocities are
// forgotten as t^(-3/2) in the end, D(t) still has to change by 1 + sqrt(2) times as much as since half the
// lag, as far as that is more than chance. Half the lag must be at least ten mean free times, in which the
// rest is forgotten. Source of the decay: Alder and Wainwright, Phys. Rev. A 1 (1970) 18.
Diffusion read_diffusion(const TimeCorrelation& average, std::size_t species, double mean_free_time,
                         const auto& up_to) {
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
    constant.error = std::hypot(constant.error, remainder(average.estimate(species, [&](Means means) {
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

}  // namespace

void add_with_enskog(Measurement& found, const Quantity& coefficient, double enskog) {
  found.quantities.push_back(coefficient);
  if (std::isnan(enskog)) return;
  const Estimate relative{coefficient.value / enskog, coefficient.error / enskog};
  Quantity& quantity = found.add(coefficient.name + "_over_enskog", "1", relative,
                                 coefficient.theory / enskog, coefficient.tolerance / enskog);
  quantity.reason = coefficient.reason;
}

DiffusionMeasure::DiffusionMeasure(const Scene& scene, double interval, std::size_t most_spheres,
                                   const TimeCorrelation::Shape& shape)
    : theory_(scene.fluid()),
      motion_(scene.thermal_motion()),
      dimensions_(static_cast<double>(scene.world().box().dimensions())),
      mean_free_time_(mean_free_time(scene.statistics())),
      begin_(scene.now()),
      average_(scene, interval, most_spheres, shape) {}

double DiffusionMeasure::initial_temperature(const Scene& scene) const {
  return is_energy_conserved(motion_, scene.thermal_motion()) ? motion_.temperature() : kNoNumber;
}

void DiffusionMeasure::add_constant(const Scene& scene, std::size_t species, const UpToLag& up_to,
                                    Measurement& found) const {
  const char* const objection = objection_to_diffusion(scene);
  const auto [constant, lag, reason] = objection != nullptr
                                           ? Diffusion{.reason = objection}
                                           : read_diffusion(average_, species, mean_free_time_, up_to);
  const std::string suffix = average_.species().suffix(species);
  const double expected = theory_.diffusion(initial_temperature(scene));
  add_with_enskog(found,
                  {"diffusion_constant" + suffix, "L^2 T^-1", constant.value, constant.error, expected,
                   FluidTheory::kDiffusionTolerance * expected, reason},
                  theory_.enskog_diffusion(initial_temperature(scene)));
  if (lag > 0) found.add("diffusion_lag" + suffix, "T", Estimate{lag}).reason = kLagChosen;
}

MeanSquareDisplacement::MeanSquareDisplacement(const Scene& scene, double interval, std::size_t most_spheres)
    : DiffusionMeasure(scene, interval, most_spheres, {}) {}

void MeanSquareDisplacement::sample(const Scene& scene) {
  const Vec3 drift = drifted(scene);
  average_.sample(scene, add_squares,
                  [&](Slot slot, Vec3* center) { *center = scene.unfolded_center(slot) - drift; });
}

void MeanSquareDisplacement::add_results(const Scene& scene, Measurement& found) const {
  found.is_logarithmic_in_argument = found.is_logarithmic_in_value = true;
  const double temperature = initial_temperature(scene);
  const double enskog = theory_.enskog_diffusion(temperature);
  const SpeciesList& species = average_.species();
  const std::vector<double> lags = average_.lags();
  // Without the lag zero.
  const std::size_t rows = lags.empty() ? 0 : lags.size() - 1;
  found.add_argument("lag", "T", tabulated(rows, [&](std::size_t row) { return lags[row + 1]; }));
  for (std::size_t s = 0; s < species.size(); ++s) {
    // D(t) is the slope from half the lag to the lag, at which a sphere has left its cage: moved by its
    // radius.
    const double radius = species.radius(s);
    const auto up_to = [&](std::size_t lag) -> std::optional<FunctionOfMeans> {
      const std::optional<std::size_t> half = half_lag(lags, lag);
      if (!half || average_.at(s, lag).value < radius * radius) return std::nullopt;
      return [this, lag, half = *half, time = lags[lag] - lags[*half]](Means means) {
        return (means[lag] - means[half]) / (2 * dimensions_ * time);
      };
    };
    add_constant(scene, s, up_to, found);
    const double forgetting = enskog * species.mass(s) / temperature;
    const auto theory = [&](std::size_t row) {
      const double lag = lags[row + 1];
      return 2 * dimensions_ * enskog * (lag + forgetting * std::expm1(-lag / forgetting));
    };
    found.add("mean_square_displacement" + species.suffix(s), "L^2",
              tabulated(rows, [&](std::size_t row) { return average_.at(s, row + 1); }),
              species.is_one_kind() ? std::optional(tabulated(rows, theory)) : std::nullopt);
  }
}

VelocityAutocorrelation::VelocityAutocorrelation(const Scene& scene, double interval,
                                                 std::size_t most_spheres)
    : DiffusionMeasure(scene, interval, most_spheres, kShape) {}

void VelocityAutocorrelation::sample(const Scene& scene) {
  const Vec3 drift = drifted(scene);
  average_.sample(scene, add_products, [&](Slot slot, Vec3* vectors) {
    vectors[0] = scene.world().velocity(slot, scene.now()) - motion_.drift;
    vectors[1] = scene.unfolded_center(slot) - drift;
  });
}

void VelocityAutocorrelation::add_results(const Scene& scene, Measurement& found) const {
  const double temperature = initial_temperature(scene);
  const double enskog = theory_.enskog_diffusion(temperature);
  const SpeciesList& species = average_.species();
  const std::vector<double> lags = average_.lags();
  found.add_argument("lag", "T", lags);
  // As in mean_speed.
  const bool is_all_energy = average_.followed() == scene.world().size() && species.is_one_kind() &&
                             is_energy_conserved(motion_, scene.thermal_motion());
  for (std::size_t s = 0; s < species.size(); ++s) {
    const double square = lags.empty() ? kNoNumber : average_.at(s, 0).value;
    const auto product = [&](std::size_t lag, std::size_t which) -> FunctionOfMeans {
      return [=, this, index = lag * kShape.products + which](Means means) {
        return means[index] / (which == kIntegral ? dimensions_ : 1) *
               (is_all_energy ? square / means[0] : 1);
      };
    };
    const auto up_to = [&](std::size_t lag) { return product(lag, kIntegral); };
    add_constant(scene, s, up_to, found);
    const double square_speed = dimensions_ * temperature / species.mass(s);
    const auto theory = [&](std::size_t lag) {
      return square_speed * std::exp(-lags[lag] * square_speed / (dimensions_ * enskog));
    };
    const auto at_lags = [&](std::size_t which) {
      return tabulated(lags.size(),
                       [&](std::size_t lag) { return average_.estimate(s, product(lag, which)); });
    };
    found.add("velocity_autocorrelation" + species.suffix(s), "L^2 T^-2", at_lags(0),
              species.is_one_kind() ? std::optional(tabulated(lags.size(), theory)) : std::nullopt);
    found.add("diffusion_integral" + species.suffix(s), "L^2 T^-1", at_lags(kIntegral));
  }
}

}  // namespace hardball
