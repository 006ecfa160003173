// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
// Whether runs that still depend on their start are told from those that do not, with all measures by
// default.
#include "hardball/measure/settling.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "hardball/measure/measures.hpp"
#include "hardball/measure/random_start.hpp"
#include "hardball/measure/reasons.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/theory/kinetic_theory.hpp"
#include "hardball/world/totals.hpp"
#include "support/discs.hpp"
#include "support/gas.hpp"
#include "support/interacting.hpp"
#include "support/measurement.hpp"

namespace hardball::settling_test {
namespace {

using namespace support;

std::vector<Measurement> measured(Simulation simulation, double free_times, bool is_placed = false) {
  const double until = free_times * mean_free_time(Scene(simulation.world(), Time(0)).statistics());
  Measures measures({.is_start_placed = is_placed});
  simulation.run_until(until, measures);
  measures.sample_the_rest(simulation.world(), simulation.now());
  return measures.results(simulation.world(), simulation.now());
}

// Every number has an error, or a reason why it has none or is left out; none that must be positive is not.
void expect_qualified(const std::vector<Measurement>& all) {
  for (const Measurement& found : all) {
    for (const Quantity& each : found.quantities) {
      EXPECT_EQ(std::isnan(each.error) || std::isnan(each.value), !each.reason.empty())
          << each.name << ": " << each.value << " +- " << each.error << ", " << each.reason;
      EXPECT_EQ(each.reason.find(','), std::string::npos) << each.reason;
      const bool must_be_positive =
          each.name.starts_with("contact_value") || each.name.starts_with("mean_gap") ||
          each.name.starts_with("diffusion_constant") || each.name.starts_with("compressibility");
      EXPECT_FALSE(must_be_positive && each.value < 0) << each.name;
    }
  }
}

void expect_unsettled(const std::vector<Measurement>& all, const std::string& reason) {
  expect_qualified(all);
  for (const Measurement& found : all) {
    EXPECT_FALSE(found.is_transient_over) << found.name;
    EXPECT_EQ(found.unsettled, reason) << found.name;
    for (const Quantity& each : found.quantities) {
      EXPECT_FALSE(each.error > 0) << each.name;
      EXPECT_FALSE(std::isfinite(each.theory) && std::isfinite(each.tolerance) && each.error != 0)
          << each.name;
    }
  }
}

// Its pressure and rate are off by a quarter, and the noise of a sixteenth of the run hides what is left of
// that; the places of the spheres do not.
TEST(Settling, TellsACrystalThatHasNotMelted) {
  const World crystal = make_gas({.count = 500, .packing_fraction = 0.49, .seed = 1, .start = Start::fcc});
  expect_unsettled(measured(Simulation(crystal), 2), kStillCrystal);
  expect_unsettled(measured(Simulation(crystal), 50), kStillCrystal);
  expect_unsettled(measured(Simulation(make_discs(1058, 0.65, 1)), 30), kStillCrystal);
}

TEST(Settling, LeavesOutTheTimeInWhichACrystalMelts) {
  const World crystal = make_gas({.count = 500, .packing_fraction = 0.3, .seed = 1, .start = Start::fcc});
  const std::vector<Measurement> all = measured(Simulation(crystal), 200);
  expect_qualified(all);
  const double free_time = mean_free_time(Scene(crystal, Time(0)).statistics());
  for (const char* const name : {"pressure", "collision_rate", "radial_distribution", "bond_order"}) {
    const Measurement& found = named(all, name);
    EXPECT_TRUE(found.is_transient_over) << name;
    EXPECT_GE(found.transient, 5 * free_time) << name;
    EXPECT_LE(found.transient, 60 * free_time) << name;
  }
  const Quantity& z = quantity(named(all, "pressure"), "compressibility");
  EXPECT_LT(std::fabs(z.value - z.theory), 4 * z.error);
}

// Beyond freezing a crystal is in equilibrium, though no sphere leaves its place.
TEST(Settling, LetsACrystalBeThatIsStable) {
  const World crystal = make_gas({.count = 500, .packing_fraction = 0.6, .seed = 1, .start = Start::fcc});
  const std::vector<Measurement> all = measured(Simulation(crystal), 200);
  expect_qualified(all);
  EXPECT_TRUE(named(all, "pressure").is_transient_over);
  EXPECT_GT(quantity(named(all, "pressure"), "compressibility").error, 0);
}

TEST(Settling, IsOverAtOnceWhereTheStartHasNoOrder) {
  for (const double packing_fraction : {0.02, 0.3}) {
    const World gas = make_gas({.count = 500, .packing_fraction = packing_fraction, .seed = 2});
    const Settling settling(Scene(gas, Time(0)), false);
    const Settled found = settling.found(Scene(gas, Time(0)));
    EXPECT_TRUE(found.is_over);
    EXPECT_EQ(found.end, 0);
    expect_qualified(measured(Simulation(gas), 20));
  }
  // A fluid that was a crystal long ago.
  const World fluid =
      settled(make_gas({.count = 500, .packing_fraction = 0.4, .seed = 2, .start = Start::fcc}), 200);
  EXPECT_TRUE(Settling(Scene(fluid, Time(0)), false).found(Scene(fluid, Time(0))).is_over);
}

// In places at random there are too few neighbors at a distance, which shows in the order of bonds until the
// spheres have left them.
TEST(Settling, TellsSpheresThatAreStillWhereTheyWerePlaced) {
  const World placed = make_gas({.count = 4000, .packing_fraction = 0.33, .seed = 2});
  expect_unsettled(measured(Simulation(placed), 5, true), kStillInPlace);
  const std::vector<Measurement> all = measured(Simulation(placed), 60, true);
  const Quantity& bonds = quantity(named(all, "bond_order"), "mean_bonds");
  EXPECT_LT(std::fabs(bonds.value - 7.1194), 4 * bonds.error) << "the mean of long runs";
  EXPECT_GT(named(all, "bond_order").transient, 5 * mean_free_time(Scene(placed, Time(0)).statistics()));
  // Of a dilute gas they leave them within a mean free time.
  const World gas = make_gas({.count = 500, .packing_fraction = 0.02, .seed = 2});
  EXPECT_TRUE(named(measured(Simulation(gas), 5, true), "pressure").is_transient_over);
}

// A gas set free in one half of the box.
TEST(Settling, TellsAGasThatSpreads) {
  const World half = make_gas({.count = 500, .packing_fraction = 0.1, .seed = 3});
  const double edge = half.box().size().x;
  World world(Box::periodic({4 * edge, edge, edge}));
  for (const Path& path : half.paths()) {
    world.add({.position = path.position, .velocity = path.velocity, .radius = 0.5});
  }
  expect_unsettled(measured(Simulation(world), 1), kStillSpreading);
  const std::vector<Measurement> all = measured(Simulation(world), 300);
  EXPECT_TRUE(named(all, "pressure").is_transient_over);
  EXPECT_GT(named(all, "pressure").transient, 0);
}

TEST(Settling, TellsAGasThatCools) {
  const World gas = make_gas({.count = 300, .packing_fraction = 0.1, .seed = 4});
  const std::vector<Measurement> all = measured(Simulation(interacting(gas, Restitution(0.8))), 200);
  expect_qualified(all);
  for (const char* const name : {"mean_square_displacement", "velocity_autocorrelation"}) {
    const Quantity& constant = quantity(named(all, name), "diffusion_constant");
    EXPECT_TRUE(std::isnan(constant.value));
    EXPECT_EQ(constant.reason, kNotSteady);
  }
  EXPECT_EQ(quantity(named(all, "pressure"), "pressure").reason, kNotSteady);
  EXPECT_EQ(quantity(named(all, "velocity_distribution"), "mean_speed").reason, kNotSteady);
  EXPECT_GT(quantity(named(all, "velocity_distribution"), "speed_kurtosis").error, 0)
      << "in units of the speed";
  EXPECT_FALSE(named(all, "temperature").is_transient_over);
}

TEST(Settling, LetsADrivenGasBeSteady) {
  const World gas = make_gas({.count = 300, .packing_fraction = 0.1, .seed = 5});
  Simulation driven(interacting(gas, Restitution(0.9)));
  driven.set_thermostat(Thermostat(Rescale(1, 1)));
  const std::vector<Measurement> all = measured(driven, 2000);
  expect_qualified(all);
  EXPECT_GT(quantity(named(all, "temperature"), "temperature").error, 0);
  const Quantity& by_displacement = quantity(named(all, "mean_square_displacement"), "diffusion_constant");
  const Quantity& by_velocity = quantity(named(all, "velocity_autocorrelation"), "diffusion_constant");
  EXPECT_LT(std::fabs(by_displacement.value - by_velocity.value),
            4 * std::hypot(by_displacement.error, by_velocity.error));
}

// Velocities stay those of the start, so that runs from other starts say more about errors than this one.
TEST(Settling, LetsSpheresThatPassThroughEachOtherBeAnIdealGas) {
  const World gas =
      interacting(make_gas({.count = 500, .packing_fraction = 0.2, .seed = 6}), passing({{0, 0}}));
  const std::vector<Measurement> all = measured(Simulation(gas), 30);
  expect_qualified(all);
  EXPECT_EQ(quantity(named(all, "pressure"), "compressibility").value, 1);
  EXPECT_EQ(quantity(named(all, "pressure"), "compressibility").theory, 1);
  EXPECT_TRUE(std::isnan(quantity(named(all, "nearest_neighbor"), "mean_gap").value));
  EXPECT_TRUE(std::isnan(quantity(named(all, "velocity_autocorrelation"), "diffusion_constant").value));
  EXPECT_FALSE(quantity(named(all, "collision_rate"), "collision_rate").error > 0);
}

TEST(Settling, GoesOnAfterBeingSaved) {
  const World crystal = make_gas({.count = 256, .packing_fraction = 0.3, .seed = 7, .start = Start::fcc});
  Simulation simulation(crystal);
  Measures measures;
  simulation.run_until(2, measures);
  Measures restored = Measures::load(measures.save());
  Simulation copy = simulation;
  simulation.run_until(8, measures);
  copy.run_until(8, restored);
  const std::vector<Measurement> all = measures.results(simulation.world(), simulation.now());
  const std::vector<Measurement> again = restored.results(copy.world(), copy.now());
  ASSERT_EQ(all.size(), again.size());
  EXPECT_GT(named(all, "pressure").transient, 0);
  EXPECT_EQ(named(all, "pressure").transient, named(again, "pressure").transient);
}

// Whether the energies of random starts are as far apart as each of them says, and the numbers of runs as
// far apart as their errors say.

World with_steps(const Gas& gas, double ratio, double energy) {
  return interacting(make_gas(gas), stepping({.steps = {{ratio, energy}}}));
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
        const std::vector<Vec3> velocities = thermal_velocities(std::vector<double>(radii.size(), 1), random);
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
  EXPECT_EQ(spread_after(make_gas(gas), 1), 0);
  EXPECT_GT(spread_after(with_steps(gas, 1.5, -0.5), 1), 0.01);
  Interactions lossy(Restitution(0.9));
  lossy.set_steps(stepping({.steps = {{1.5, -0.5}}}).steps());
  EXPECT_EQ(spread_after(interacting(make_gas(gas), lossy), 1), 0);
  // All spheres of a lattice have as many neighbors, whatever its velocities are.
  EXPECT_LT(
      spread_after(with_steps({.count = 256, .packing_fraction = 0.2, .start = Start::fcc}, 1.5, -0.5), 0),
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
}  // namespace hardball::settling_test
