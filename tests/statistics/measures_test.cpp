// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Measures in equilibrium, against published numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "hardball/measure/measures.hpp"
#include "hardball/simulation/simulation.hpp"
#include "support/gas.hpp"
#include "support/interacting.hpp"
#include "support/measurement.hpp"
#include "support/record.hpp"
#include "support/theory.hpp"

namespace hardball::measures_test {
namespace {

using namespace support;

// One run measured from its start: `contacts` contacts of a gas in equilibrium.
std::vector<Measurement> measured(const Gas& gas, const MeasureSettings& settings, std::uint64_t contacts) {
  Simulation simulation(settled(make_gas(gas), 40));
  Measures measures(settings);
  simulation.run({.contacts = contacts}, measures);
  return measures.results(simulation.world(), simulation.now());
}

// Tolerances as derived in fluid_test.cpp.
void expect_fluid(double packing_fraction, std::size_t count, Start start) {
  constexpr double kContacts = 300000;
  const std::vector<Measurement> all =
      measured({.count = count, .packing_fraction = packing_fraction, .seed = 51, .start = start},
               {.names = {"pressure", "collision_rate", "impact_speeds", "velocity_distribution"}}, 300000);
  const double statistical = 4 / std::sqrt(kContacts);
  const Quantity& z = quantity(named(all, "pressure"), "compressibility");
  const auto n = static_cast<double>(count);
  const double excess = fluid_compressibility(packing_fraction) - 1;
  record("compressibility", z.value);
  EXPECT_NEAR((z.value - 1) / excess, 1, statistical + 1e-3);
  EXPECT_NEAR(z.theory - 1, excess, excess / n);
  // The error is known to within 10 or 20%, and five of them are allowed.
  EXPECT_LT(std::fabs(z.value - z.theory), 5 * z.error + 1e-3 * excess);
  EXPECT_LT(z.error, statistical * excess);
  const Quantity& rate = quantity(named(all, "collision_rate"), "collision_rate");
  EXPECT_NEAR(rate.value / rate.theory, 1, statistical + 1e-3);
  const Quantity& path = quantity(named(all, "collision_rate"), "mean_free_path");
  EXPECT_NEAR(path.value / path.theory, 1, statistical + 3e-3);
  const Measurement& impacts = named(all, "impact_speeds");
  const Quantity& speed = quantity(impacts, "mean_impact_speed");
  const Quantity& square = quantity(impacts, "mean_square_impact_speed");
  EXPECT_NEAR(speed.value / speed.theory, 1, 0.52 * statistical);
  EXPECT_NEAR(square.value / square.theory, 1, statistical);
  // Chi squared of the histogram, with about a hundred degrees of freedom: above 170 once in 1e5.
  const std::vector<double>& density = column(impacts, "probability_density").values;
  const std::vector<double>& expected = column(impacts, "probability_density_theory").values;
  const std::vector<double>& at = column(impacts, "impact_speed").values;
  double chi_squared = 0;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const double mean = expected[i] * (at[1] - at[0]) * kContacts;
    if (mean < 10) continue;
    const double seen = density[i] * (at[1] - at[0]) * kContacts;
    chi_squared += (seen - mean) * (seen - mean) / mean;
  }
  record("chi_squared", chi_squared);
  EXPECT_LT(chi_squared, 170);
  const Quantity& kurtosis = quantity(named(all, "velocity_distribution"), "speed_kurtosis");
  record("kurtosis", kurtosis.value);
  EXPECT_LT(std::fabs(kurtosis.value - kurtosis.theory), 5 * kurtosis.error);
  EXPECT_LT(kurtosis.error, 0.01 * kurtosis.theory);
}

TEST(MeasuredFluid, AgreesWithTheoryAtPackingFraction20) {
  expect_fluid(0.2, 2000, Start::random);
}

TEST(MeasuredFluid, AgreesWithTheoryAtPackingFraction40) {
  expect_fluid(0.4, 13 * 13 * 13, Start::simple_cubic);
}

// Speedy's fit is to runs of about as many spheres; it differs from the literature by 6%.
TEST(MeasuredFluid, DiffusesAsSpeedyFound) {
  const std::vector<Measurement> all =
      measured({.count = 500, .packing_fraction = 0.2, .seed = 52},
               {.names = {"mean_square_displacement", "velocity_autocorrelation"}, .every = 0.0625}, 300000);
  for (const Measurement& found : all) {
    const Quantity& diffusion = quantity(found, "diffusion_constant");
    record(found.name, diffusion.value / diffusion.theory);
    EXPECT_NEAR(diffusion.value / diffusion.theory, 1, 0.06) << found.name;
    EXPECT_LT(diffusion.error, 0.03 * diffusion.theory) << found.name;
  }
  // While a sphere remembers its velocity Enskog's theory holds well.
  const Measurement& velocities = all.back();
  const Column& forgotten = column(velocities, "velocity_autocorrelation");
  const Column& theory = column(velocities, "velocity_autocorrelation_theory");
  for (std::size_t lag = 0; lag < 4; ++lag) {
    EXPECT_NEAR(forgotten.values[lag] / theory.values[lag], 1, 0.03) << lag;
  }
}

// Equal speeds have a kurtosis of 1; it approaches 5/3 within some four collisions of each sphere.
TEST(MeasuredRelaxation, IsLeftOutOfMeans) {
  World world = make_gas({.count = 1000, .packing_fraction = 0.1, .seed = 54});
  Random random(55);
  Vec3 velocity;
  World start(world.box());
  for (Slot slot = 0; slot < world.size(); ++slot) {
    velocity = slot % 2 == 0 ? std::sqrt(3.0) * random.direction() : -velocity;
    start.add(
        {.position = world.path(slot).position, .velocity = velocity, .radius = world.base_radius(slot)});
  }
  Simulation simulation(std::move(start));
  Measures measures({.names = {"velocity_distribution"}, .every = 0.25});
  constexpr double kLong = 25;  // about 44 mean free times
  simulation.run_until(kLong, measures);
  const Measurement found = measures.results(simulation.world(), simulation.now()).front();
  EXPECT_EQ(found.duration, kLong);
  EXPECT_TRUE(found.is_transient_over);
  record("transient", found.transient);
  EXPECT_GE(found.transient, 1);
  EXPECT_LE(found.transient, kLong / 2);
  const Quantity& kurtosis = quantity(found, "speed_kurtosis");
  record("deviation", (kurtosis.value - kurtosis.theory) / kurtosis.error);
  EXPECT_LT(std::fabs(kurtosis.value - kurtosis.theory), 3 * kurtosis.error);
  EXPECT_LT(kurtosis.error, 0.02 * kurtosis.theory);
}

// The temperature of a cooling gas has no error, but its velocities in units of the current temperature
// become stationary.
TEST(MeasuredCooling, HasNoStandardErrorOfATemperature) {
  const World start = settled(make_gas({.count = 1000, .packing_fraction = 0.1, .seed = 56}), 5);
  Simulation simulation(interacting(start, Restitution(0.9)));
  Measures measures({.names = {"temperature", "collision_rate", "velocity_distribution"}, .every = 0.5});
  simulation.run_until(30, measures);
  const std::vector<Measurement> all = measures.results(simulation.world(), simulation.now());
  for (const Quantity& temperature : named(all, "temperature").quantities) {
    EXPECT_TRUE(std::isnan(temperature.error)) << temperature.name;
  }
  EXPECT_TRUE(std::isnan(quantity(named(all, "collision_rate"), "collision_rate").error));
  EXPECT_GT(quantity(named(all, "velocity_distribution"), "speed_kurtosis").error, 0);
}

// The sum rule of wall_pressure and virial; its bound is derived in virial_test.cpp.
TEST(MeasuredWalls, BearThePressureOfTheInterior) {
  constexpr std::size_t kSpheres = 300;
  const Gas gas{.count = kSpheres, .packing_fraction = 0.25, .seed = 53, .boundary = Boundary::wall};
  Simulation simulation(make_gas(gas));
  Measures measures({.names = {"pressure"}});
  simulation.run({.contacts = 300000}, measures);
  const Measurement found = measures.results(simulation.world(), simulation.now()).front();
  const Quantity& z = quantity(found, "compressibility_from_walls");
  const double half = simulation.world().box().size().x / 2 - kDiameter / 2;
  const double twice_energy = 3.0 * kSpheres;
  const double bound = 4 * std::sqrt(2 * kSpheres * half * half) / simulation.time() / twice_energy;
  EXPECT_LT(bound, 3e-3);
  // Opposite faces bear the same force up to the momentum inside at the start and end of the run, which
  // counts by half the length of the box.
  record("sum_rule_error", z.value - z.theory);
  EXPECT_NEAR(z.value, z.theory, 2 * bound);
  for (const char* face : {"x_min", "x_max", "y_min", "y_max", "z_min", "z_max"}) {
    const Quantity& pressure = quantity(found, std::string("wall_pressure_") + face);
    EXPECT_LT(std::fabs(pressure.value - pressure.theory), 5 * pressure.error) << face;
    EXPECT_LT(pressure.error, 0.02 * pressure.theory) << face;
  }
}

}  // namespace
}  // namespace hardball::measures_test
