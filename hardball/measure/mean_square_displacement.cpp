// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/mean_square_displacement.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "hardball/tuning/kinetic_theory.hpp"

namespace hardball {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double sum_of_squares(std::span<const Vec3> earlier, std::span<const Vec3> later) {
  double sum = 0;
  for (std::size_t i = 0; i < later.size(); ++i) {
    const Vec3 displacement = later[i] - earlier[i];
    sum += dot(displacement, displacement);
  }
  return sum;
}

// Slope of the straight line through points (x, y), each with its weight.
double slope(std::span<const double> x, std::span<const double> y, std::span<const double> weight) {
  double weights = 0;
  double mean_x = 0;
  double mean_y = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    weights += weight[i];
    mean_x += weight[i] * x[i];
    mean_y += weight[i] * y[i];
  }
  mean_x /= weights;
  mean_y /= weights;
  double covariance = 0;
  double variance = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    covariance += weight[i] * (x[i] - mean_x) * (y[i] - mean_y);
    variance += weight[i] * (x[i] - mean_x) * (x[i] - mean_x);
  }
  return covariance / variance;
}

}  // namespace

MeanSquareDisplacement::MeanSquareDisplacement(const Scene& scene, double interval, std::size_t most_spheres)
    : theory_(scene.fluid()),
      motion_(scene.motion()),
      dimensions_(static_cast<double>(scene.world().box().dimensions())),
      is_periodic_(scene.world().box().is_all(Boundary::periodic)),
      mean_free_time_(mean_free_time(scene.moments())),
      begin_(scene.now()),
      average_(scene, interval, most_spheres) {}

void MeanSquareDisplacement::sample(const Scene& scene) {
  const World& world = scene.world();
  const Time& now = scene.now();
  const Vec3 drifted = duration(begin_, now) * motion_.drift;
  average_.sample(scene, sum_of_squares, [&](Slot slot) {
    return world.position(slot, now) + world.box().shift(world.image(slot, now)) - drifted;
  });
}

// The linear part: lags after which a sphere has forgotten its velocity, ten times the decay time, 3/2 mean
// free times in Enskog's theory or, in two dimensions, one; and has left its cage, having moved by its
// radius.
Estimate MeanSquareDisplacement::diffusion(std::size_t species) const {
  constexpr double kFreeTimes = 15;
  constexpr std::size_t kFewest = 3;
  if (!is_periodic_) return {};
  const std::vector<double> lags = average_.lags();
  const double radius = average_.species().radius(species);
  std::vector<std::size_t> linear;
  std::vector<double> x;
  std::vector<double> weights;
  for (std::size_t lag = 1; lag < lags.size(); ++lag) {
    const Estimate square = average_.at(species, lag);
    if (lags[lag] < kFreeTimes * mean_free_time_ || square.value < radius * radius) continue;
    linear.push_back(lag);
    x.push_back(lags[lag]);
    const double error = square.error > 0 ? square.error : square.value;
    weights.push_back(1 / (error * error));
  }
  if (linear.size() < kFewest) return {};
  return average_.estimate(species, [&](std::span<const double> means) {
    std::vector<double> y;
    for (const std::size_t lag : linear) y.push_back(means[lag]);
    return slope(x, y, weights) / (2 * dimensions_);
  });
}

Measurement MeanSquareDisplacement::result(const Scene& scene) const {
  Measurement found{
      .name = std::string(kName),
      .title = "Mean square displacement",
      .formula = R"($\langle |\mathbf{x}(s + t) - \mathbf{x}(s)|^2 \rangle$ over spheres and times )"
                 R"($s$; $D$: the slope of its linear part over $2 d$ in $d$ dimensions; theory: $2 d )"
                 R"(D \left( t - \tau (1 - e^{-t / \tau}) \right)$, $\tau = m D / kT$, with $D$ of )"
                 R"(Enskog's theory)",
      .source =
          "Allen and Tildesley, Computer Simulation of Liquids, section 2.7; D: Speedy, Mol. "
          "Phys. 62 (1987) 509; Enskog: Chapman and Cowling, section 16.3",
      .is_logarithmic_in_argument = true,
      .is_logarithmic_in_value = true};
  const double temperature = is_energy_conserved(motion_, scene.motion()) ? motion_.temperature() : kNone;
  const double enskog = theory_.enskog_diffusion(temperature);
  const double expected = theory_.diffusion(temperature);
  const Species& species = average_.species();
  const std::vector<double> lags = average_.lags();
  Column lag_column{"lag", "T", ColumnRole::argument, {}};
  for (std::size_t lag = 1; lag < lags.size(); ++lag) lag_column.values.push_back(lags[lag]);
  found.columns.push_back(std::move(lag_column));
  for (std::size_t s = 0; s < species.size(); ++s) {
    const Estimate constant = diffusion(s);
    found.quantities.push_back(
        {"diffusion_constant" + species.suffix(s), "L^2 T^-1", constant.value, constant.error, expected});
    if (species.is_one_kind()) {
      found.quantities.push_back({"diffusion_constant_over_enskog", "1", constant.value / enskog,
                                  constant.error / enskog, expected / enskog});
    }
    const std::string name = "mean_square_displacement" + species.suffix(s);
    Column value{name, "L^2", ColumnRole::value, {}};
    Column error{name + "_error", "L^2", ColumnRole::error, {}};
    Column theory{name + "_theory", "L^2", ColumnRole::theory, {}};
    const double forgetting = enskog * species.mass(s) / temperature;
    for (std::size_t lag = 1; lag < lags.size(); ++lag) {
      const Estimate square = average_.at(s, lag);
      value.values.push_back(square.value);
      error.values.push_back(square.error);
      theory.values.push_back(2 * dimensions_ * enskog *
                              (lags[lag] + forgetting * std::expm1(-lags[lag] / forgetting)));
    }
    found.columns.push_back(std::move(value));
    found.columns.push_back(std::move(error));
    if (species.is_one_kind()) found.columns.push_back(std::move(theory));
  }
  return found;
}

}  // namespace hardball
