// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/mean_square_displacement.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hardball/numbers/no_number.hpp"
#include "hardball/theory/kinetic_theory.hpp"

namespace hardball {
namespace {

void add_squares(std::span<const Vec3> earlier, std::span<const Vec3> later, double* sum) {
  for (std::size_t i = 0; i < later.size(); ++i) {
    const Vec3 displacement = later[i] - earlier[i];
    *sum += dot(displacement, displacement);
  }
}

}  // namespace

MeanSquareDisplacement::MeanSquareDisplacement(const Scene& scene, double interval, std::size_t most_spheres)
    : theory_(scene.fluid()),
      motion_(scene.thermal_motion()),
      dimensions_(static_cast<double>(scene.world().box().dimensions())),
      mean_free_time_(mean_free_time(scene.statistics())),
      begin_(scene.now()),
      average_(scene, interval, most_spheres, {}) {}

void MeanSquareDisplacement::sample(const Scene& scene) {
  const Vec3 drifted = duration(begin_, scene.now()) * motion_.drift;
  average_.sample(scene, add_squares,
                  [&](Slot slot, Vec3* center) { *center = scene.unfolded_center(slot) - drifted; });
}

// D(t) is the slope from half the lag to the lag, at which a sphere has left its cage: moved by its radius.
Diffusion MeanSquareDisplacement::diffusion(const Scene& scene, std::size_t species) const {
  if (const char* const objection = objection_to_diffusion(scene)) return {.reason = objection};
  const std::vector<double> lags = average_.lags();
  const double radius = average_.species().radius(species);
  const auto up_to = [&](std::size_t lag) -> std::optional<FunctionOfMeans> {
    const std::optional<std::size_t> half = half_lag(lags, lag);
    if (!half || average_.at(species, lag).value < radius * radius) return std::nullopt;
    return [this, lag, half = *half, time = lags[lag] - lags[*half]](std::span<const double> means) {
      return (means[lag] - means[half]) / (2 * dimensions_ * time);
    };
  };
  return read_diffusion(average_, species, mean_free_time_, up_to);
}

Measurement MeanSquareDisplacement::result(const Scene& scene) const {
  Measurement found{
      .name = std::string(kName),
      .title = "Mean square displacement",
      .formula = R"($\langle |\mathbf{x}(s + t) - \mathbf{x}(s)|^2 \rangle$ over spheres and times )"
                 R"($s$; $D(t)$: its slope from $t / 2$ to $t$ over $2 d$ in $d$ dimensions, $D$: that at )"
                 R"(the lag $t$ with the least error; theory: $2 d )"
                 R"(D \left( t - \tau (1 - e^{-t / \tau}) \right)$, $\tau = m D / kT$, with $D$ of )"
                 R"(Enskog's theory)",
      .source =
          "Allen and Tildesley, Computer Simulation of Liquids, section 2.7; D: Speedy, Mol. "
          "Phys. 62 (1987) 509; Enskog: Chapman and Cowling, section 16.3",
      .is_logarithmic_in_argument = true,
      .is_logarithmic_in_value = true};
  const double temperature =
      is_energy_conserved(motion_, scene.thermal_motion()) ? motion_.temperature() : kNoNumber;
  const double enskog = theory_.enskog_diffusion(temperature);
  const SpeciesList& species = average_.species();
  const std::vector<double> lags = average_.lags();
  Column lag_column{"lag", "T", ColumnRole::argument, {}};
  for (std::size_t lag = 1; lag < lags.size(); ++lag) lag_column.values.push_back(lags[lag]);
  found.columns.push_back(std::move(lag_column));
  for (std::size_t s = 0; s < species.size(); ++s) {
    add_diffusion(found, diffusion(scene, s), species, s, theory_, temperature);
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
