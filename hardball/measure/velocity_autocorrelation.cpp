// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/velocity_autocorrelation.hpp"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "hardball/measure/diffusion.hpp"
#include "hardball/numbers/no_number.hpp"
#include "hardball/theory/kinetic_theory.hpp"

namespace hardball {
namespace {

constexpr const char* kBegunWithoutPositions = "the run was begun by a version that did not follow positions";

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
    : theory_(scene.fluid()),
      motion_(scene.thermal_motion()),
      dimensions_(static_cast<double>(scene.world().box().dimensions())),
      mean_free_time_(mean_free_time(scene.statistics())),
      begin_(scene.now()),
      average_(scene, interval, most_spheres, kShape) {}

void VelocityAutocorrelation::sample(const Scene& scene) {
  const Vec3 drifted = duration(begin_, scene.now()) * motion_.drift;
  average_.sample(scene, add_products, [&](Slot slot, Vec3* vectors) {
    vectors[0] = scene.world().velocity(slot, scene.now()) - motion_.drift;
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
      .source =
          "Allen and Tildesley, Computer Simulation of Liquids, section 2.7; D: Speedy, Mol. "
          "Phys. 62 (1987) 509; Enskog: Chapman and Cowling, section 16.3"};
  const bool is_conserved = is_energy_conserved(motion_, scene.thermal_motion());
  const double temperature = is_conserved ? motion_.temperature() : kNoNumber;
  const double enskog = theory_.enskog_diffusion(temperature);
  const SpeciesList& species = average_.species();
  const std::vector<double> lags = average_.lags();
  found.columns.push_back({"lag", "T", ColumnRole::argument, lags});
  if (species.size() == 0) {
    found.quantities.push_back(
        {.name = "diffusion_constant", .unit = "L^2 T^-1", .reason = kBegunWithoutPositions});
  }
  // As in mean_speed.
  const bool is_all_energy =
      average_.followed() == scene.world().size() && species.is_one_kind() && is_conserved;
  for (std::size_t s = 0; s < species.size(); ++s) {
    const double square = lags.empty() ? kNoNumber : average_.at(s, 0).value;
    const auto product = [&](std::size_t lag, std::size_t which) -> FunctionOfMeans {
      return [=, this, index = lag * kShape.products + which](std::span<const double> means) {
        return means[index] / (which == kIntegral ? dimensions_ : 1) *
               (is_all_energy ? square / means[0] : 1);
      };
    };
    const auto up_to = [&](std::size_t lag) { return product(lag, kIntegral); };
    const char* const objection = objection_to_diffusion(scene);
    const Diffusion diffusion = objection != nullptr ? Diffusion{.reason = objection}
                                                     : read_diffusion(average_, s, mean_free_time_, up_to);
    add_diffusion(found, diffusion, species, s, theory_, temperature);
    const std::string name = "velocity_autocorrelation" + species.suffix(s);
    const std::string integral_name = "diffusion_integral" + species.suffix(s);
    Column value{name, "L^2 T^-2", ColumnRole::value, {}};
    Column error{name + "_error", "L^2 T^-2", ColumnRole::error, {}};
    Column theory{name + "_theory", "L^2 T^-2", ColumnRole::theory, {}};
    Column up_to_lag{integral_name, "L^2 T^-1", ColumnRole::value, {}};
    Column up_to_lag_error{integral_name + "_error", "L^2 T^-1", ColumnRole::error, {}};
    const double square_speed = dimensions_ * temperature / species.mass(s);
    for (std::size_t lag = 0; lag < lags.size(); ++lag) {
      const Estimate correlation = average_.estimate(s, product(lag, 0));
      const Estimate integral = average_.estimate(s, up_to(lag));
      value.values.push_back(correlation.value);
      error.values.push_back(correlation.error);
      theory.values.push_back(square_speed * std::exp(-lags[lag] * square_speed / (dimensions_ * enskog)));
      up_to_lag.values.push_back(integral.value);
      up_to_lag_error.values.push_back(integral.error);
    }
    found.columns.push_back(std::move(value));
    found.columns.push_back(std::move(error));
    if (species.is_one_kind()) found.columns.push_back(std::move(theory));
    found.columns.push_back(std::move(up_to_lag));
    found.columns.push_back(std::move(up_to_lag_error));
  }
  return found;
}

// Earlier versions did not follow where spheres are: nothing is left of what they have averaged.
bool VelocityAutocorrelation::restored() {
  if (!average_.has(kShape)) average_ = {};
  return true;
}

}  // namespace hardball
