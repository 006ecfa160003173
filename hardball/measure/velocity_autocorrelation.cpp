// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/velocity_autocorrelation.hpp"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "hardball/numbers/no_number.hpp"

namespace hardball {
namespace {

// Of each sphere: velocity and position. Of each lag: the product of the velocities; and the displacement
// times the mean of both velocities, which is the integral of the former up to the lag.
constexpr TimeCorrelation::Shape kShape{.vectors = 2, .products = 2};
constexpr std::size_t kIntegral = 1;

void add_products(std::span<const Vec3> earlier, std::span<const Vec3> later, double* sums) {
  for (std::size_t i = 0; i < later.size(); i += kShape.vectors) {
    sums[0] += dot(earlier[i], later[i]);
    sums[kIntegral] += dot(earlier[i] + later[i], later[i + 1] - earlier[i + 1]) / 2;
  }
}

}  // namespace

VelocityAutocorrelation::VelocityAutocorrelation(const Scene& scene, double interval,
                                                 std::size_t most_spheres)
    : conditions_(scene), begin_(scene.now()), average_(scene, interval, most_spheres, kShape) {}

void VelocityAutocorrelation::sample(const Scene& scene) {
  const Vec3 drifted = duration(begin_, scene.now()) * conditions_.motion.drift;
  average_.sample(scene, add_products, [&](Slot slot, Vec3* vectors) {
    vectors[0] = scene.world().velocity(slot, scene.now()) - conditions_.motion.drift;
    vectors[1] = scene.unfolded_center(slot) - drifted;
  });
}

Measurement VelocityAutocorrelation::result(const Scene& scene) const {
  Measurement found{
      .name = std::string(kName),
      .title = "Velocity autocorrelation",
      .formula =
          R"($C(t) = \langle \mathbf{v}(s) \cdot \mathbf{v}(s + t) \rangle$ over spheres and )"
          R"(times $s$; $D(t) = \frac{1}{d} \int_0^t C(s) \, \mathrm{d}s$ in $d$ dimensions, $D$: that at the )"
          R"(lag $t$ with the least error; theory: $d \frac{kT}{m} e^{-t / \tau}$, $\tau = m D / kT$, with $D$ of )"
          R"(Enskog's theory)",
      .source = kSourceOfDiffusion};
  const double temperature = conditions_.temperature(scene);
  const double dimensions = conditions_.dimensions;
  const double enskog = conditions_.theory.enskog_diffusion(temperature);
  const SpeciesList& species = average_.species();
  const std::vector<double> lags = average_.lags();
  found.add_argument("lag", "T", lags);
  // As in mean_speed.
  const bool is_all_energy = average_.followed() == scene.world().size() && species.is_one_kind() &&
                             is_energy_conserved(conditions_.motion, scene.thermal_motion());
  for (std::size_t s = 0; s < species.size(); ++s) {
    const double square = lags.empty() ? kNoNumber : average_.at(s, 0).value;
    const auto product = [&](std::size_t lag, std::size_t which) -> FunctionOfMeans {
      return [=, index = lag * kShape.products + which](std::span<const double> means) {
        return means[index] / (which == kIntegral ? dimensions : 1) * (is_all_energy ? square / means[0] : 1);
      };
    };
    const auto up_to = [&](std::size_t lag) { return product(lag, kIntegral); };
    const char* const objection = objection_to_diffusion(scene);
    const Diffusion diffusion = objection != nullptr
                                    ? Diffusion{.reason = objection}
                                    : read_diffusion(average_, s, conditions_.mean_free_time, up_to);
    conditions_.add(diffusion, species, s, temperature, found);
    std::vector<Estimate> correlations;
    std::vector<double> theory;
    std::vector<Estimate> integrals;
    const double square_speed = dimensions * temperature / species.mass(s);
    for (std::size_t lag = 0; lag < lags.size(); ++lag) {
      correlations.push_back(average_.estimate(s, product(lag, 0)));
      theory.push_back(square_speed * std::exp(-lags[lag] * square_speed / (dimensions * enskog)));
      integrals.push_back(average_.estimate(s, up_to(lag)));
    }
    found.add_estimates("velocity_autocorrelation" + species.suffix(s), "L^2 T^-2", correlations);
    if (species.is_one_kind()) found.add_theory(std::move(theory));
    found.add_estimates("diffusion_integral" + species.suffix(s), "L^2 T^-1", integrals);
  }
  return found;
}

bool VelocityAutocorrelation::restored() const {
  return average_.has(kShape);
}

}  // namespace hardball
