// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/velocity_autocorrelation.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "hardball/tuning/kinetic_theory.hpp"

namespace hardball {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double sum_of_products(std::span<const Vec3> earlier, std::span<const Vec3> later) {
  double sum = 0;
  for (std::size_t i = 0; i < later.size(); ++i) sum += dot(earlier[i], later[i]);
  return sum;
}

// The integral up to one of the lags, by the trapezoidal rule.
double integral(std::span<const double> lags, std::span<const double> means, std::size_t last) {
  double sum = 0;
  for (std::size_t i = 1; i <= last; ++i) sum += (means[i - 1] + means[i]) / 2 * (lags[i] - lags[i - 1]);
  return sum;
}

}  // namespace

VelocityAutocorrelation::VelocityAutocorrelation(const Scene& scene, double interval,
                                                 std::size_t most_spheres)
    : theory_(scene.fluid()),
      motion_(scene.motion()),
      dimensions_(static_cast<double>(scene.world().box().dimensions())),
      mean_free_time_(mean_free_time(scene.moments())),
      average_(scene, interval, most_spheres) {}

void VelocityAutocorrelation::sample(const Scene& scene) {
  average_.sample(scene, sum_of_products,
                  [&](Slot slot) { return scene.world().velocity(slot, scene.now()) - motion_.drift; });
}

Measurement VelocityAutocorrelation::result(const Scene& scene) const {
  // Beyond, there is little but noise; the rest of the slow decay is a few per cent of D in a dense fluid.
  constexpr double kFreeTimes = 50;
  Measurement found{
      .name = std::string(kName),
      .title = "Velocity autocorrelation",
      .formula =
          R"($C(t) = \langle \mathbf{v}(s) \cdot \mathbf{v}(s + t) \rangle$ over spheres and )"
          R"(times $s$; $D(t) = \frac{1}{d} \int_0^t C(s) \, \mathrm{d}s$ in $d$ dimensions, $D$ at 50 mean free )"
          R"(times; theory: $d \frac{kT}{m} e^{-t / \tau}$, $\tau = m D / kT$, with $D$ of )"
          R"(Enskog's theory)",
      .source =
          "Allen and Tildesley, Computer Simulation of Liquids, section 2.7; D: Speedy, Mol. "
          "Phys. 62 (1987) 509; Enskog: Chapman and Cowling, section 16.3"};
  const double temperature = is_energy_conserved(motion_, scene.motion()) ? motion_.temperature() : kNone;
  const double enskog = theory_.enskog_diffusion(temperature);
  const double expected = theory_.diffusion(temperature);
  const Species& species = average_.species();
  const std::vector<double> lags = average_.lags();
  std::size_t last = 0;
  while (last + 1 < lags.size() && lags[last + 1] <= kFreeTimes * mean_free_time_) ++last;
  found.columns.push_back({"lag", "T", ColumnRole::argument, lags});
  // As in mean_speed.
  const bool is_all_energy = average_.followed() == scene.world().size() && species.is_one_kind() &&
                             is_energy_conserved(motion_, scene.motion());
  for (std::size_t s = 0; s < species.size(); ++s) {
    const double square = lags.empty() ? kNone : average_.at(s, 0).value;
    const auto estimate = [&](const FunctionOfMeans& quantity) {
      return average_.estimate(s, [&](std::span<const double> means) {
        return quantity(means) * (is_all_energy ? square / means[0] : 1);
      });
    };
    const auto integral_to = [&](std::size_t lag) {
      return estimate(
          [&](std::span<const double> means) { return integral(lags, means, lag) / dimensions_; });
    };
    if (last > 0) {
      const Estimate constant = integral_to(last);
      found.quantities.push_back(
          {"diffusion_constant" + species.suffix(s), "L^2 T^-1", constant.value, constant.error, expected});
      if (species.is_one_kind()) {
        found.quantities.push_back({"diffusion_constant_over_enskog", "1", constant.value / enskog,
                                    constant.error / enskog, expected / enskog});
      }
    }
    const std::string name = "velocity_autocorrelation" + species.suffix(s);
    const std::string integral_name = "diffusion_integral" + species.suffix(s);
    Column value{name, "L^2 T^-2", ColumnRole::value, {}};
    Column error{name + "_error", "L^2 T^-2", ColumnRole::error, {}};
    Column theory{name + "_theory", "L^2 T^-2", ColumnRole::theory, {}};
    Column up_to_lag{integral_name, "L^2 T^-1", ColumnRole::value, {}};
    Column up_to_lag_error{integral_name + "_error", "L^2 T^-1", ColumnRole::error, {}};
    const double square_speed = dimensions_ * temperature / species.mass(s);
    for (std::size_t lag = 0; lag < lags.size(); ++lag) {
      const Estimate product = estimate([lag](std::span<const double> means) { return means[lag]; });
      const Estimate up_to = integral_to(lag);
      value.values.push_back(product.value);
      error.values.push_back(product.error);
      theory.values.push_back(square_speed * std::exp(-lags[lag] * square_speed / (dimensions_ * enskog)));
      up_to_lag.values.push_back(up_to.value);
      up_to_lag_error.values.push_back(up_to.error);
    }
    found.columns.push_back(std::move(value));
    found.columns.push_back(std::move(error));
    if (species.is_one_kind()) found.columns.push_back(std::move(theory));
    found.columns.push_back(std::move(up_to_lag));
    found.columns.push_back(std::move(up_to_lag_error));
  }
  return found;
}

}  // namespace hardball
