// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Whether the energies of random starts are as far apart as each of them says, and the numbers of runs as
// far apart as their errors say.
#include "hardball/measure/random_start.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "hardball/measure/measures.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/world/totals.hpp"
#include "support/gas.hpp"
#include "support/interacting.hpp"

namespace hardball::random_start_test {
namespace {

using support::Gas;

World with_steps(const Gas& gas, double ratio, double energy) {
  return support::interacting(support::make_gas(gas), support::stepping({.steps = {{ratio, energy}}}));
}

struct Scatter {
  double found = 0;  // of the temperatures that starts lead to, if places do not change with them
  double said = 0;   // by the starts, on average
};

Scatter scatter_of(const std::function<World(std::uint64_t)>& make) {
  constexpr std::uint64_t kStarts = 60;
  double sum = 0;
  double squares = 0;
  double said = 0;
  for (std::uint64_t seed = 1; seed <= kStarts; ++seed) {
    const Simulation simulation(make(seed));
    const World& world = simulation.world();
    const Scene scene(world, Time(0));
    const ThermalMotion motion = scene.thermal_motion();
    const double temperature = 2 * energy(world, Time(0)) / motion.degrees_of_freedom / motion.temperature();
    sum += temperature;
    squares += temperature * temperature;
    said += RandomStart(scene).spread(scene).temperature;
  }
  const double mean = sum / kStarts;
  return {std::sqrt((squares - kStarts * mean * mean) / (kStarts - 1)), said / kStarts};
}

// The standard deviation of 60 starts has an error of a tenth.
void expect_honest(const Scatter& scatter, double at_most) {
  EXPECT_GT(scatter.said, 0.75 * scatter.found);
  EXPECT_LT(scatter.said, at_most * scatter.found);
}

TEST(RandomStart, KnowsTheEnergiesOfOthersInWells) {
  for (const double density : {0.02, 0.1, 0.25, 0.33}) {
    for (const double ratio : {1.2, 1.5, 2.0}) {
      expect_honest(scatter_of([&](std::uint64_t seed) {
                      return with_steps({.count = 500, .packing_fraction = density, .seed = seed}, ratio, -1);
                    }),
                    2.2);
    }
  }
}

TEST(RandomStart, KnowsTheEnergiesOfOthersUnderGravity) {
  expect_honest(
      scatter_of([](std::uint64_t seed) {
        Random random(seed);
        const Vec3 size{6, 6, 20};
        World world(Box({Boundary::wall, Boundary::wall, Boundary::wall}, size), {0, 0, -0.3});
        std::vector<double> radii(100, 0.3);
        const std::vector<Vec3> centers = place_randomly(world.box(), {{}, size}, radii, random, "");
        const std::vector<Vec3> velocities =
            support::thermal_velocities(std::vector<double>(radii.size(), 1), random);
        for (std::size_t k = 0; k < radii.size(); ++k)
          world.add({.position = centers[k], .velocity = velocities[k], .radius = radii[k]});
        return world;
      }),
      1.3);
}

TEST(RandomStart, SaysNothingWherePlacesHaveNoEnergyOrItDoesNotLast) {
  const auto spread_after = [](World world, double until) {
    Simulation simulation(std::move(world));
    const RandomStart start(Scene(simulation.world(), simulation.now()));
    simulation.run_until(until);
    return start.spread(Scene(simulation.world(), simulation.now())).temperature;
  };
  const Gas gas{.count = 108, .packing_fraction = 0.2};
  EXPECT_EQ(spread_after(support::make_gas(gas), 1), 0);
  EXPECT_GT(spread_after(with_steps(gas, 1.5, -0.5), 1), 0.01);
  Interactions lossy(Restitution(0.9));
  lossy.set_steps(support::stepping({.steps = {{1.5, -0.5}}}).steps());
  EXPECT_EQ(spread_after(support::interacting(support::make_gas(gas), lossy), 1), 0);
  // All spheres of a lattice have as many neighbors, whatever its velocities are.
  EXPECT_LT(
      spread_after(
          with_steps({.count = 256, .packing_fraction = 0.2, .start = support::Start::fcc}, 1.5, -0.5), 0),
      1e-12);
}

// Each of these runs knows its own temperature to .3%, and they differ by 2%.
TEST(RandomStart, MakesErrorsIncludeWhatOtherStartsWouldGive) {
  constexpr std::uint64_t kRuns = 12;
  std::map<std::string, std::vector<Quantity>> all;
  for (std::uint64_t seed = 1; seed <= kRuns; ++seed) {
    Simulation simulation(with_steps({.count = 108, .packing_fraction = 0.15, .seed = seed}, 1.5, -0.5));
    Measures measures(
        {.names = {"temperature", "pressure"}, .is_start_placed = true, .is_energy_random = true});
    simulation.run_until(60, measures);
    for (const Measurement& found : measures.results(simulation.world(), simulation.now())) {
      for (const Quantity& each : found.quantities) all[each.name].push_back(each);
    }
  }
  for (const char* const name : {"temperature", "compressibility", "pressure"}) {
    double sum = 0;
    double squares = 0;
    double errors = 0;
    for (const Quantity& each : all.at(name)) {
      sum += each.value;
      squares += each.value * each.value;
      errors += each.error;
    }
    const double mean = sum / kRuns;
    const double scatter = std::sqrt((squares - kRuns * mean * mean) / (kRuns - 1));
    EXPECT_GT(errors / kRuns, 0.7 * scatter) << name;
    EXPECT_LT(errors / kRuns, 4 * scatter) << name;
  }
}

}  // namespace
}  // namespace hardball::random_start_test
