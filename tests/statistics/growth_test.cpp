// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Spheres that grow slowly enough to be near equilibrium, and until they jam, compared with published
// numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "hardball/simulation/simulation.hpp"
#include "hardball/world/walls.hpp"
#include "support/gas.hpp"
#include "support/record.hpp"
#include "support/theory.hpp"

namespace hardball::growth_test {
namespace {

// Of an epoch: packing fractions at its ends, and the mean compressibility in it.
struct Epoch {
  double begin;
  double end;
  double compressibility;
};

std::vector<Epoch> grow(Simulation& simulation, const GrowthRules& rules) {
  std::vector<Epoch> epochs;
  simulation.grow(rules);
  double begin = packing_fraction(simulation.world(), simulation.now());
  while (!simulation.growth()->is_over()) {
    simulation.run_until(simulation.growth()->next());
    const double end = packing_fraction(simulation.world(), simulation.now());
    epochs.push_back({begin, end, simulation.growth()->compressibility()});
    begin = end;
  }
  return epochs;
}

// The compressibility that an epoch has where it is `of_state` at a packing fraction. It averages over time
// with the energy, which grows by d ln E = 2 (Z - 1) d ln s with the scale s.
template <class OfState>
double expected(const Epoch& epoch, const OfState& of_state) {
  constexpr int kSteps = 1000;
  const double begin = std::cbrt(epoch.begin);
  const double step = (std::cbrt(epoch.end) - begin) / kSteps;
  double energy = 1;
  double weight = 0;
  double sum = 0;
  for (int k = 0; k < kSteps; ++k) {
    const double scale = begin + (k + 0.5) * step;
    const double z = of_state(scale * scale * scale);
    energy *= std::exp(2 * (z - 1) * step / scale);
    weight += energy;
    sum += energy * z;
  }
  return sum / weight;
}

// At .001 the pressure is that of the crystal at rest to within its fluctuations; 864 spheres have 1% less.
TEST(GrowingCrystal, FollowsItsEquationOfState) {
  Simulation simulation(
      support::make_gas({.count = 864, .packing_fraction = 0.5, .start = support::Start::fcc}));
  for (const Epoch& epoch : grow(simulation, {.rate = 0.001, .until_packing_fraction = 0.72})) {
    if (epoch.begin < 0.55) continue;
    EXPECT_NEAR(epoch.compressibility / expected(epoch, support::crystal_compressibility), 1, 0.02)
        << epoch.end;
  }
}

// Without relaxation, growth arrests where the rate has it; spheres come closer the slower it is. Source:
// Lubachevsky and Stillinger, J. Stat. Phys. 60 (1990) 561; our own trials of 1,000 spheres.
TEST(GrowingFluid, ArrestsByItsRate) {
  constexpr double kScatter = 0.004;
  for (const auto& [rate, arrest] : {std::pair{0.1, 0.627}, std::pair{0.01, 0.643}}) {
    Simulation simulation(support::make_gas({.count = 4000, .packing_fraction = 0.3, .seed = 1}));
    const std::vector<Epoch> epochs = grow(simulation, {.rate = rate, .until_compressibility = 1e7});
    EXPECT_EQ(simulation.growth()->state(), GrowthSchedule::State::over_pressure);
    const double jammed = epochs.back().end;
    support::record("arrest_at_rate_" + to_text(rate), jammed);
    EXPECT_NEAR(jammed, arrest, kScatter);
    // Free volume: Z (1 - phi / phi_J) tends to the number of dimensions. Spheres that were stopped early
    // still find a little room, the more the faster they grew.
    const double limit = jammed / (1 - 3 / epochs.back().compressibility);
    for (const Epoch& epoch : epochs) {
      if (epoch.compressibility < 1e4 || epoch.compressibility > 1e6) continue;
      const double of_free_volume = expected(epoch, [&](double phi) { return 3 / (1 - phi / limit); });
      EXPECT_NEAR(epoch.compressibility / of_free_volume, 1, 0.15) << epoch.compressibility;
    }
  }
}

}  // namespace
}  // namespace hardball::growth_test
