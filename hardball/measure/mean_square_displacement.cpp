// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/mean_square_displacement.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hardball/numbers/no_number.hpp"

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
    : conditions_(scene), begin_(scene.now()), average_(scene, interval, most_spheres, {}) {}

void MeanSquareDisplacement::sample(const Scene& scene) {
  const Vec3 drifted = duration(begin_, scene.now()) * conditions_.motion.drift;
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
      return (means[lag] - means[half]) / (2 * conditions_.dimensions * time);
    };
  };
  return read_diffusion(average_, species, conditions_.mean_free_time, up_to);
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
      .source = kSourceOfDiffusion,
      .is_logarithmic_in_argument = true,
      .is_logarithmic_in_value = true};
  const double temperature = conditions_.temperature(scene);
  const double enskog = conditions_.theory.enskog_diffusion(temperature);
  const SpeciesList& species = average_.species();
  const std::vector<double> lags = average_.lags();
  std::vector<double> after_zero = lags;
  if (!lags.empty()) after_zero.erase(after_zero.begin());
  found.add_argument("lag", "T", std::move(after_zero));
  for (std::size_t s = 0; s < species.size(); ++s) {
    conditions_.add(diffusion(scene, s), species, s, temperature, found);
    std::vector<Estimate> squares;
    std::vector<double> theory;
    const double forgetting = enskog * species.mass(s) / temperature;
    for (std::size_t lag = 1; lag < lags.size(); ++lag) {
      squares.push_back(average_.at(s, lag));
      theory.push_back(2 * conditions_.dimensions * enskog *
                       (lags[lag] + forgetting * std::expm1(-lags[lag] / forgetting)));
    }
    found.add_estimates("mean_square_displacement" + species.suffix(s), "L^2", squares);
    if (species.is_one_kind()) found.add_theory(std::move(theory));
  }
  return found;
}

}  // namespace hardball
