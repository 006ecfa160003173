// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/temperature.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "hardball/measure/measures.hpp"
#include "hardball/simulation/simulation.hpp"
#include "support/gas.hpp"
#include "support/interacting.hpp"
#include "support/measurement.hpp"

namespace hardball::temperature_test {
namespace {

using support::column;
using support::has_quantity;
using support::quantity;

// Two light and two heavy spheres, which drift together.
World mixture(const Vec3& drift, const Box& box) {
  World world(box);
  world.add({{2, 2, 2}, drift + Vec3{2, 0, 0}, 0.5, 1});
  world.add({{4, 4, 4}, drift + Vec3{-2, 0, 0}, 0.5, 1});
  world.add({{6, 6, 6}, drift + Vec3{0, 1, 0}, 1, 3});
  world.add({{8, 8, 8}, drift + Vec3{0, -1, 0}, 1, 3});
  return world;
}

TEST(Temperature, CountsMotionRelativeToTheDriftInAPeriodicBox) {
  const World world = mixture({5, -7, 1}, Box::periodic({10, 10, 10}));
  Temperature temperature({world, Time(3)});
  temperature.sample({world, Time(4)});
  const Measurement found = temperature.result({world, Time(4)});
  // Twice the energy is 8 + 6, and there are 3 * 4 - 3 degrees of freedom.
  EXPECT_NEAR(quantity(found, "temperature").value, 14.0 / 9, 1e-12);
  EXPECT_NEAR(quantity(found, "temperature_along_x").value, 8.0 / 3, 1e-12);
  EXPECT_NEAR(quantity(found, "temperature_along_y").value, 6.0 / 3, 1e-12);
  EXPECT_NEAR(quantity(found, "temperature_along_z").value, 0, 1e-12);
  // Of the motion of the center of mass the light pair has a quarter.
  EXPECT_NEAR(quantity(found, "temperature_of_species_1").value, 8 / (6 - 3 * 0.25), 1e-12);
  EXPECT_NEAR(quantity(found, "temperature_of_species_2").value, 6 / (6 - 3 * 0.75), 1e-12);
  EXPECT_EQ(column(found, "time").values, std::vector<double>{4});
  EXPECT_EQ(column(found, "temperature_along_x").values.size(), 1U);
}

TEST(Temperature, CountsAllMotionBetweenWalls) {
  const World world = mixture({1, 0, 0}, Box::walls({10, 10, 10}));
  Temperature temperature({world, Time(0)});
  temperature.sample({world, Time(0)});
  const Measurement found = temperature.result({world, Time(0)});
  // Twice the energy is 9 + 1 of the light, 3 (1 + 1) each of the heavy.
  EXPECT_NEAR(quantity(found, "temperature").value, 22.0 / 12, 1e-12);
  EXPECT_NEAR(quantity(found, "temperature_of_species_2").value, 12.0 / 6, 1e-12);
}

TEST(Temperature, OfOneKindHasNoSpecies) {
  World world(Box::periodic({10, 10, 10}));
  world.add({{2, 2, 2}, {2, 0, 0}, 0.5});
  world.add({{4, 4, 4}, {-2, 0, 0}, 0.5});
  EXPECT_FALSE(
      has_quantity(Temperature({world, Time(0)}).result({world, Time(0)}), "temperature_of_species_1"));
}

// A spin of w about each axis has I w^2 = k T in equilibrium.
TEST(Temperature, CountsSpins) {
  World world(Box::walls({10, 10, 10}));
  world.add({.position = {2, 2, 2}, .radius = 0.5, .mass = 2, .spin = {1, 2, 3}});
  world.add(
      {.position = {5, 5, 5}, .velocity = {1, 0, 0}, .radius = 1, .spin = {0, 0, 1}, .inertia_factor = 0.5});
  Temperature temperature({world, Time(0)});
  temperature.sample({world, Time(0)});
  const Measurement found = temperature.result({world, Time(0)});
  EXPECT_NEAR(quantity(found, "rotational_temperature").value, (0.4 * 2 * 0.25 * 14 + 0.5 * 1) / 6, 1e-15);
  EXPECT_NEAR(quantity(found, "temperature").value, 1.0 / 6, 1e-15);
  const World still = mixture({}, Box::walls({10, 10, 10}));
  EXPECT_FALSE(
      has_quantity(Temperature({still, Time(0)}).result({still, Time(0)}), "rotational_temperature"));
}

TEST(Temperature, OfDiscsCountsSpinsAboutOneAxis) {
  World world(Box::flat_walls(10, 10));
  world.add({.position = {2, 2, 0},
             .velocity = {1, 0, 0},
             .radius = 0.5,
             .spin = {0, 0, 3},
             .inertia_factor = 0.5});
  Temperature temperature({world, Time(0)});
  temperature.sample({world, Time(0)});
  EXPECT_NEAR(quantity(temperature.result({world, Time(0)}), "rotational_temperature").value, 0.125 * 9,
              1e-15);
}

TEST(Temperature, TellsSpeciesApartThatDifferInNothingElse) {
  World world(Box::walls({10, 10, 10}));
  world.add({.position = {2, 2, 2}, .velocity = {1, 0, 0}, .radius = 0.5});
  world.add({.position = {5, 5, 5}, .velocity = {2, 0, 0}, .radius = 0.5, .species = 4});
  Temperature temperature({world, Time(0)});
  temperature.sample({world, Time(0)});
  EXPECT_NEAR(quantity(temperature.result({world, Time(0)}), "temperature_of_species_2").value, 4.0 / 3,
              1e-15);
}

// The mean temperature of a run with measures by default is that of the kinetic energy at many times. Either
// leaves out a transient.
void expect_mean_over_time(const Simulation& start, double until, int times, double tolerance) {
  Simulation simulation = start;
  Measures measures({.names = {"temperature"}});
  simulation.run_until(until, measures);
  const Measurement found = measures.results(simulation.world(), simulation.now()).front();
  const double begin = found.is_transient_over ? found.transient : 0;
  simulation = start;
  double expected = 0;
  for (int k = 0; k < times; ++k) {
    simulation.run_until(begin + (k + 0.5) * (until - begin) / times);
    expected += thermal_motion(simulation.world(), simulation.now()).temperature() / times;
  }
  EXPECT_NEAR(quantity(found, "temperature").value / expected, 1, tolerance);
}

// Samples of a gas that cools are denser at the start, and those at the beat of a thermostat see it at one
// phase: neither may matter.
TEST(Temperature, IsTheMeanOverTimeOfAGasThatCools) {
  const World gas = support::make_gas({.count = 200, .packing_fraction = 0.1, .seed = 3});
  expect_mean_over_time(Simulation(support::interacting(gas, Restitution(0.8))), 200, 40000, 1e-3);
}

TEST(Temperature, IsTheMeanOverTimeOfAGasThatIsRescaled) {
  const World gas = support::make_gas({.count = 200, .packing_fraction = 0.2, .seed = 4});
  for (const double every : {1.0, 0.25}) {
    Simulation driven(support::interacting(gas, Restitution(0.7)));
    driven.set_thermostat(Thermostat(Rescale(1, every)));
    expect_mean_over_time(driven, 100, 40000, 1e-3);
  }
}

// Samples at the beat of the thermostat would see the speeds right after it has acted.
TEST(MeanSpeed, SharesNoBeatWithAThermostat) {
  const World gas = support::make_gas({.count = 500, .packing_fraction = 0.15, .seed = 5});
  Simulation driven(support::interacting(gas, Restitution(0.7)));
  driven.set_thermostat(Thermostat(Rescale(1, 1)));
  Measures measures({.names = {"temperature", "velocity_distribution"}});
  driven.run_until(200, measures);
  const std::vector<Measurement> found = measures.results(driven.world(), driven.now());
  const double temperature = quantity(found[0], "temperature").value;
  const double speed = quantity(found[1], "mean_speed").value;
  // Nearly Maxwell's distribution; at the beat it would be .06 higher.
  EXPECT_NEAR(speed / std::sqrt(8 * temperature / std::numbers::pi), 1, 0.02);
}

TEST(Temperature, IsTheMeanOverTimeWhileSpheresFall) {
  World world(Box::walls({10, 10, 10}), {0, 0, -1});
  world.add({.position = {2, 3, 8}, .velocity = {1, 0.5, 0}, .radius = 0.5});
  world.add({.position = {6, 5, 3}, .velocity = {-1, 0.2, 2}, .radius = 0.7, .mass = 3});
  expect_mean_over_time(Simulation(world), 20, 20000, 1e-4);
}

TEST(Temperature, IsTheMeanOverTimeUnderShear) {
  Box box = Box::periodic({10, 10, 10});
  box.set_shear({.rate = 0.2});
  World world(box);
  world.add({.position = {2, 3, 8}, .velocity = {1, 0.5, 0}, .radius = 0.5});
  world.add({.position = {6, 5, 3}, .velocity = {-1, 0.2, 2}, .radius = 0.7, .mass = 3});
  expect_mean_over_time(Simulation(world), 30, 30000, 1e-4);
}

TEST(Temperature, LeavesOutKinematicSpheres) {
  World world(Box::walls({10, 10, 10}));
  world.add({.position = {2, 2, 2}, .velocity = {1, 0, 0}, .radius = 0.5});
  world.add({.position = {5, 5, 5},
             .velocity = {0, 2, 0},
             .radius = 0.5,
             .mass = std::numeric_limits<double>::infinity()});
  Temperature temperature({world, Time(0)});
  temperature.sample({world, Time(0)});
  const Measurement found = temperature.result({world, Time(0)});
  EXPECT_NEAR(quantity(found, "temperature").value, 1.0 / 3, 1e-15);
  EXPECT_NEAR(quantity(found, "temperature_along_x").value, 1, 1e-15);
  EXPECT_NEAR(quantity(found, "temperature_along_y").value, 0, 1e-15);
}

}  // namespace
}  // namespace hardball::temperature_test
