// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Gases with thermostats, against the ensembles and the steady states that these should give.
#include <gtest/gtest.h>

#include <cmath>

#include "hardball/measure/measures.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/world/totals.hpp"
#include "support/gas.hpp"
#include "support/interacting.hpp"
#include "support/record.hpp"
#include "support/theory.hpp"

namespace hardball::thermostats_test {
namespace {

// The canonical ensemble: <E> = 3/2 N kT and <dE^2> = 3/2 N (kT)^2, from any start.
TEST(AndersenThermostat, SamplesTheCanonicalEnsemble) {
  constexpr std::size_t kSpheres = 100;
  constexpr double kTemperature = 0.25;  // of a gas that starts with 1
  constexpr double kRate = 2;
  constexpr int kSamples = 2000;
  Simulation simulation(support::make_gas({.count = kSpheres, .packing_fraction = 0.2, .seed = 71}));
  simulation.set_thermostat(Thermostat(Andersen(kTemperature, kRate), 72));
  simulation.run_until(20 / kRate);  // the initial energy is forgotten as exp(-rate t)
  const double start = simulation.time();
  double sum = 0;
  double squares = 0;
  for (int k = 1; k <= kSamples; ++k) {
    simulation.run_until(start + 3 * k / kRate);
    const double energy = kinetic_energy(simulation.world(), simulation.now());
    sum += energy;
    squares += energy * energy;
  }
  const double mean = sum / kSamples;
  const double variance = squares / kSamples - mean * mean;
  const double expected = 1.5 * kSpheres * kTemperature;
  const double expected_variance = 1.5 * kSpheres * kTemperature * kTemperature;
  support::record("mean_ratio", mean / expected);
  support::record("variance_ratio", variance / expected_variance);
  // Four deviations of the mean and the variance of 2000 samples, whose correlation is exp(-3), 5%.
  const double deviation = std::sqrt(expected_variance * 1.1 / kSamples);
  EXPECT_NEAR(mean, expected, 4 * deviation);
  EXPECT_NEAR(variance / expected_variance, 1, 4 * std::sqrt(2 * 1.1 / kSamples));
  const double span = simulation.time();
  const double events = kSpheres * kRate * span;
  EXPECT_NEAR(static_cast<double>(simulation.thermostat()->events()), events, 4 * std::sqrt(events));
}

TEST(AndersenThermostat, IsSeenByTheMeasuresOfTemperatureAndPressure) {
  constexpr double kTemperature = 4;
  Simulation simulation(support::make_gas({.count = 500, .packing_fraction = 0.2, .seed = 73}));
  simulation.set_thermostat(Thermostat(Andersen(kTemperature, 1), 74));
  Measures measures({.names = {"temperature", "pressure"}, .from = 10});
  simulation.run_until(110, measures);
  double temperature = 0;
  double compressibility = 0;
  for (const Measurement& measurement : measures.results(simulation.world(), simulation.now())) {
    for (const Quantity& quantity : measurement.quantities) {
      if (quantity.name == "temperature") temperature = quantity.value;
      if (quantity.name == "compressibility") {
        compressibility = quantity.value;
        EXPECT_TRUE(std::isnan(quantity.theory)) << "that of a fixed energy";
      }
    }
  }
  // The energy's relative deviation is sqrt(2 / 3N), 3.7%, and its correlation time 1: a mean over 100 units
  // of time is known to 0.5%.
  EXPECT_NEAR(temperature / kTemperature, 1, 0.02);
  // The collisional part comes from 1e5 collisions: 0.5%.
  EXPECT_NEAR(compressibility, support::fluid_compressibility(0.2), 0.02 * compressibility);
}

// Heating balances the losses (see granular_test.cpp): strength = (1 - e^2) w1 T^(3/2) (1 + 3 a2 / 16) / 3,
// w1 being the collision rate at T = 1, with
//   a2 = 16 (1 - e)(1 - 2e^2) / (241 - 177e + 30e^2 (1 - e)).
// Source: van Noije and Ernst, Granul. Matter 1 (1998) 57, doi:10.1007/s100350050009.
void expect_steady_temperature(double e, double packing_fraction) {
  constexpr std::size_t kSpheres = 2000;
  const double a2 = 16 * (1 - e) * (1 - 2 * e * e) / (241 - 177 * e + 30 * e * e * (1 - e));
  const double rate = support::collision_rate(support::fluid_compressibility(packing_fraction));
  const double strength = (1 - e * e) / 3 * rate * (1 + 3 * a2 / 16);  // for T = 1
  Simulation simulation(support::interacting(
      support::make_gas({.count = kSpheres, .packing_fraction = packing_fraction, .seed = 75}),
      Restitution(e)));
  simulation.set_thermostat(Thermostat(Heating(strength, 0.2 / rate), 76));
  // Deviations decay at the rate (1 - e^2) w / 2, every 11 collisions or faster.
  simulation.run_until(60 / rate);
  const double start = simulation.time();
  const double before = simulation.tally().energy_integral(simulation.now());
  simulation.run_until(start + 200 / rate);
  const double energy =
      (simulation.tally().energy_integral(simulation.now()) - before) / (simulation.time() - start);
  const double temperature = energy / (1.5 * kSpheres);
  support::record("temperature", temperature);
  // The scatter is sqrt(2 / 3N) / sqrt(200 / 22), 0.6%; the mean kick, which is subtracted, 1 / N; the noise
  // builds up correlations of velocities that the theory neglects, 1% at these e.
  EXPECT_NEAR(temperature, 1, 0.03);
  const Vec3 momentum = hardball::momentum(simulation.world(), simulation.now());
  EXPECT_LT(length(momentum), 1e-9);
}

TEST(HeatedGranularGas, ReachesTheSteadyTemperatureAtRestitution90) {
  expect_steady_temperature(0.9, 0.1);
}

TEST(HeatedGranularGas, ReachesTheSteadyTemperatureAtRestitution80) {
  expect_steady_temperature(0.8, 0.05);
}

TEST(RescaleThermostat, KeepsTheTemperatureOfACoolingGas) {
  Simulation simulation(support::interacting(
      support::make_gas({.count = 500, .packing_fraction = 0.1, .seed = 77}), Restitution(0.9)));
  simulation.set_thermostat(Thermostat(Rescale(2, 0.5)));
  for (int k = 1; k <= 40; ++k) {
    simulation.run_until(0.5 * k);
    // The momentum, which is zero, has three degrees of freedom.
    const double temperature = 2 * kinetic_energy(simulation.world(), simulation.now()) / (3.0 * 499);
    EXPECT_NEAR(temperature, 2, 1e-12);
  }
  EXPECT_GT(simulation.thermostat()->energy(), 100);
  EXPECT_LT(length(momentum(simulation.world(), simulation.now())), 1e-10);
}

}  // namespace
}  // namespace hardball::thermostats_test
