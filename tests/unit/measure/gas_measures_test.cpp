// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/collisions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "hardball/measure/measures.hpp"
#include "hardball/measure/pressure.hpp"
#include "hardball/measure/velocities.hpp"
#include "hardball/simulation/simulation.hpp"
#include "support/gas.hpp"
#include "support/interacting.hpp"
#include "support/measurement.hpp"

namespace hardball::gas_measures_test {
namespace {

using namespace support;

Contact collision(double time, SphereId first, SphereId second) {
  Contact contact;
  contact.time = Time(time);
  contact.first = first;
  contact.second = second;
  contact.first_mass = 1;
  contact.second_mass = 1;
  contact.separation = {1, 0, 0};
  return contact;
}

Contact wall_contact(double time, SphereId sphere) {
  Contact contact = collision(time, sphere, face_of(0, true));
  contact.kind = EventKind::wall;
  return contact;
}

TEST(CollisionRate, CountsEachSphereAndPairOfSpecies) {
  World world(Box::walls({10, 10, 10}));
  world.add({{2, 2, 2}, {2, 0, 0}, 0.5});
  world.add({{4, 4, 4}, {4, 0, 0}, 1});
  world.add({{8, 8, 8}, {0, 0, 0}, 1});
  CollisionRate rate({world, Time(10)});
  rate.sample({world, Time(10)});
  rate.record(collision(11, 0, 1));
  rate.record(collision(12, 1, 2));
  rate.record(collision(13, 1, 2));
  rate.record(wall_contact(14, 0));
  const Measurement found = result_of(rate, {world, Time(14)});
  EXPECT_EQ(quantity(found, "collisions").value, 3);
  EXPECT_EQ(quantity(found, "wall_contacts").value, 1);
  // Two spheres collide at each collision, of three, in 4 units of time.
  EXPECT_DOUBLE_EQ(quantity(found, "collision_rate").value, 6.0 / 12);
  EXPECT_DOUBLE_EQ(quantity(found, "mean_free_time").value, 2);
  EXPECT_DOUBLE_EQ(quantity(found, "mean_free_path").value, 2 * 2);
  EXPECT_DOUBLE_EQ(quantity(found, "wall_rate").value, 1.0 / 12);
  EXPECT_EQ(quantity(found, "collision_rate_1_1").value, 0);
  EXPECT_DOUBLE_EQ(quantity(found, "collision_rate_1_2").value, 1.0 / 4);
  // The two large ones meet twice, each of them.
  EXPECT_DOUBLE_EQ(quantity(found, "collision_rate_2_2").value, 2 * 2.0 / (2 * 4));
  EXPECT_TRUE(std::isnan(quantity(found, "collision_rate").theory)) << "there are walls";
}

TEST(CollisionRate, HasNoFreeTimeWithoutCollisions) {
  World world(Box::periodic({10, 10, 10}));
  world.add({{2, 2, 2}, {2, 0, 0}, 0.5});
  const Measurement found = result_of(CollisionRate({world, Time(0)}), {world, Time(5)});
  EXPECT_EQ(quantity(found, "collision_rate").value, 0);
  EXPECT_TRUE(std::isnan(quantity(found, "mean_free_time").value));
  EXPECT_FALSE(has_quantity(found, "wall_rate"));
}

// Nearly points: pi d^2 n sqrt(16 kT / pi m) for one kind, and the same with the reduced mass for two.
TEST(CollisionRate, HasTheTheoryOfADiluteGas) {
  constexpr double kRadius = 0.005;
  World world(Box::periodic({10, 10, 10}));
  for (int i = 0; i < 8; ++i) {
    const double x = 1 + i;
    const double v = i % 2 == 0 ? 1 : -1;
    world.add({{x, x, x}, {v, v, v}, kRadius, i < 4 ? 1.0 : 4.0});
  }
  const Measurement found = result_of(CollisionRate({world, Time(0)}), {world, Time(1)});
  const double temperature = (4 * 3 + 4 * 12) / (3.0 * 7);
  const double area = std::numbers::pi * 4 * kRadius * kRadius;
  // Seven others rather than eight, and the mean of a motion of fixed energy in 21 degrees of freedom.
  const double few = 7.0 / 8 * mean_over_normal(21);
  const auto expected = [&](double reduced_mass) {
    return few * area * 4 / 1000 * std::sqrt(8 * temperature / (std::numbers::pi * reduced_mass));
  };
  EXPECT_NEAR(quantity(found, "collision_rate_1_1").theory / expected(0.5), 1, 1e-4);
  EXPECT_NEAR(quantity(found, "collision_rate_1_2").theory / expected(0.8), 1, 1e-4);
  EXPECT_NEAR(quantity(found, "collision_rate_2_2").theory / expected(2), 1, 1e-4);
}

Contact collision_at(double speed) {
  Contact contact;
  contact.separation = {1, 0, 0};
  contact.first = 0;
  contact.second = 1;
  contact.first_mass = 1;
  contact.second_mass = 1;
  contact.before = {{speed, 7, 0}, {0, 0, 0}};
  contact.after = {{0, 7, 0}, {speed, 0, 0}};
  return contact;
}

TEST(ImpactSpeeds, AreThoseAlongTheLineOfCenters) {
  const World world = make_gas({.count = 1000, .seed = 3});
  ImpactSpeeds speeds({world, Time(0)});
  for (const double speed : {1.0, 2.0, 2.0, 3.0}) speeds.record(collision_at(speed));
  const Measurement found = result_of(speeds, {world, Time(1)});
  EXPECT_EQ(quantity(found, "mean_impact_speed").value, 2);
  EXPECT_EQ(quantity(found, "mean_square_impact_speed").value, 4.5);
  const Column& speed = column(found, "impact_speed");
  const Column& density = column(found, "probability_density");
  const double width = speed.values[1] - speed.values[0];
  double sum = 0;
  double at_two = 0;
  for (std::size_t i = 0; i < density.values.size(); ++i) {
    sum += density.values[i] * width;
    if (std::fabs(speed.values[i] - 2) < width / 2) at_two = density.values[i] * width;
  }
  EXPECT_NEAR(sum, 1, 1e-12);
  EXPECT_NEAR(at_two, 0.5, 1e-12);
}

TEST(ImpactSpeeds, HaveRayleighsDistributionForManySpheres) {
  // kT = 3 n / (3 n - 3) for gases of the support library.
  constexpr double kSpheres = 4000;
  const double temperature = kSpheres / (kSpheres - 1);
  const World world = make_gas({.count = 4000, .seed = 3});
  ImpactSpeeds speeds({world, Time(0)});
  speeds.record(collision_at(1));
  const Measurement found = result_of(speeds, {world, Time(1)});
  EXPECT_NEAR(quantity(found, "mean_impact_speed").theory, std::sqrt(std::numbers::pi * temperature), 2e-4);
  EXPECT_NEAR(quantity(found, "mean_square_impact_speed").theory, 4 * temperature, 1e-3);
  const Column& speed = column(found, "impact_speed");
  const Column& theory = column(found, "probability_density_theory");
  for (std::size_t i = 0; i < speed.values.size(); ++i) {
    const double u = speed.values[i];
    EXPECT_NEAR(theory.values[i], u / (2 * temperature) * std::exp(-u * u / (4 * temperature)), 1e-3) << u;
  }
}

// With two spheres in a periodic box there is one relative velocity, of fixed size s, in a random direction:
// colliding pairs have the mean |cos| = 2/3 and the mean cos^2 = 1/2.
TEST(ImpactSpeeds, AreExactForTwoSpheres) {
  World world(Box::periodic({10, 10, 10}));
  world.add({{2, 2, 2}, {1, 0, 0}, 0.5});
  world.add({{4, 4, 4}, {-1, 0, 0}, 0.5});
  ImpactSpeeds speeds({world, Time(0)});
  speeds.record(collision_at(1));
  const Measurement found = result_of(speeds, {world, Time(1)});
  EXPECT_NEAR(quantity(found, "mean_impact_speed").theory, 2 * 2.0 / 3, 1e-12);
  EXPECT_NEAR(quantity(found, "mean_square_impact_speed").theory, 4 * 0.5, 1e-12);
}

TEST(ImpactSpeeds, HaveNoTheoryOutOfEquilibrium) {
  World open;
  open.add({{2, 2, 2}, {1, 0, 0}, 0.5});
  open.add({{4, 4, 4}, {-1, 0, 0}, 0.5});
  ImpactSpeeds speeds({open, Time(0)});
  speeds.record(collision_at(1));
  EXPECT_TRUE(std::isnan(quantity(result_of(speeds, {open, Time(1)}), "mean_impact_speed").theory));
}

// The pressure in a run.
Measurement pressure_of(Simulation& simulation, const RunLimits& limits) {
  Pressure pressure({simulation.world(), simulation.now()});
  simulation.on_contact([&](const Contact& contact) { pressure.record(contact); });
  simulation.run(limits);
  simulation.on_contact(nullptr);
  return result_of(pressure, {simulation.world(), simulation.now()});
}

// Two spheres of diameter 1 and mass 2 meet head-on at relative speed 4, at 1, 3.25 and 5.5.
TEST(Pressure, OfAHeadOnPairInAPeriodicBoxMatchesAHandCalculation) {
  World world(Box::periodic({10, 10, 10}));
  world.add({{1, 5, 5}, {3, 0, 0}, 0.5, 2});
  world.add({{6, 5, 5}, {-1, 0, 0}, 0.5, 2});
  Simulation simulation(world);
  const Measurement found = pressure_of(simulation, {.until = Time(6)});
  // Relative to the drift of 1 both move at 2: sum m v v = 16. Each collision gives the impulse 8 over the
  // distance 1, three in 6 units of time.
  EXPECT_DOUBLE_EQ(quantity(found, "pressure_xx").value, (16 + 24.0 / 6) / 1000);
  EXPECT_DOUBLE_EQ(quantity(found, "pressure").value, (16 + 24.0 / 6) / 3000);
  EXPECT_DOUBLE_EQ(quantity(found, "compressibility").value, 1 + 4.0 / 16);
  for (const char* name : {"pressure_yy", "pressure_zz", "pressure_xy", "pressure_xz", "pressure_yz"}) {
    EXPECT_NEAR(quantity(found, name).value, 0, 1e-15) << name;
  }
  EXPECT_FALSE(has_quantity(found, "wall_pressure"));
}

// A sphere at 2 meets one at rest, and stops: relative to the drift of 1 at the start both move at 1, before
// and after. The impulse is 2 over the distance 1, once in 4 units of time.
TEST(Pressure, DoesNotAssumeConservedMomentum) {
  World world(Box::periodic({10, 10, 10}));
  world.add({{1, 5, 5}, {2, 0, 0}, 0.5});
  world.add({{4, 5, 5}, {}, 0.5});
  Simulation simulation(world);
  simulation.respond_with([](const Contact&) { return Velocities{}; });
  const Measurement found = pressure_of(simulation, {.until = Time(4)});
  EXPECT_DOUBLE_EQ(quantity(found, "pressure_xx").value, (2 + 2.0 / 4) / 1000);
}

// Head-on along the diagonal of the xy plane: all four components of that plane are equal.
TEST(Pressure, HasOffDiagonalComponents) {
  const double a = std::sqrt(0.5);
  World world(Box::periodic({10, 10, 10}));
  world.add({{3, 3, 5}, {a, a, 0}, 0.5});
  world.add({{5, 5, 5}, {-a, -a, 0}, 0.5});
  Simulation simulation(world);
  const Measurement found = pressure_of(simulation, {.until = Time(4)});
  // sum m v v = 1 in each component; one collision of impulse 2 over distance 1, half of it in each.
  const double expected = (1 + 1.0 / 4) / 1000;
  for (const char* name : {"pressure_xx", "pressure_yy", "pressure_xy"}) {
    EXPECT_NEAR(quantity(found, name).value, expected, 1e-15) << name;
  }
  EXPECT_NEAR(quantity(found, "pressure_xz").value, 0, 1e-15);
  EXPECT_NEAR(quantity(found, "compressibility").value, 1.25, 1e-12);
}

// A sphere that bounces back and forth over a length of 9 at speed 3 hits each wall every 6 units of time
// with the impulse 6.
TEST(Pressure, OfOneSphereOnWallsIsItsImpulse) {
  World world(Box::walls({10, 20, 20}));
  world.add({{5, 5, 5}, {3, 0, 0}, 0.5});
  Simulation simulation(world);
  const Measurement found = pressure_of(simulation, {.until = Time(60)});
  for (const char* name : {"wall_pressure_x_min", "wall_pressure_x_max"}) {
    EXPECT_NEAR(quantity(found, name).value, 1.0 / 400, 1e-15) << name;
    EXPECT_NEAR(quantity(found, name).theory, 1.0 / 400, 1e-15) << name;
  }
  EXPECT_EQ(quantity(found, "wall_pressure_y_min").value, 0);
  EXPECT_NEAR(quantity(found, "wall_pressure").value, 1.0 / (400 + 200 + 200), 1e-15);
  EXPECT_NEAR(quantity(found, "compressibility_from_walls").value, 1, 1e-12);
  EXPECT_NEAR(quantity(found, "compressibility").value, 1, 1e-12);
}

TEST(Pressure, AgreesWithTheTallyOfTheRun) {
  for (const Boundary boundary : {Boundary::periodic, Boundary::wall}) {
    Simulation simulation(make_gas({.count = 200, .packing_fraction = 0.2, .seed = 6, .boundary = boundary}));
    const Measurement found = pressure_of(simulation, {.contacts = 5000});
    ASSERT_EQ(found.transient, 0) << "the tally counts all of the run";
    const Tally& tally = simulation.tally();
    EXPECT_NEAR(quantity(found, "compressibility").value, tally.compressibility(simulation.now()), 1e-12);
    if (boundary == Boundary::periodic) continue;
    EXPECT_NEAR(quantity(found, "wall_pressure").value,
                tally.wall_pressure(simulation.world().box(), simulation.now()), 1e-12);
  }
}

TEST(Pressure, HasNoTheoryWhereEnergyIsLost) {
  Simulation simulation(
      interacting(make_gas({.count = 100, .packing_fraction = 0.2, .seed = 6}), Restitution(0.9)));
  Pressure pressure({simulation.world(), simulation.now()});
  EXPECT_GT(quantity(result_of(pressure, {simulation.world(), simulation.now()}), "compressibility").theory,
            2);
  simulation.on_contact([&](const Contact& contact) { pressure.record(contact); });
  simulation.run_contacts(100);
  EXPECT_TRUE(std::isnan(
      quantity(result_of(pressure, {simulation.world(), simulation.now()}), "compressibility").theory));
}

TEST(Pressure, HasNoMeaningInOpenSpace) {
  const World world = make_gas({.count = 10, .boundary = Boundary::open});
  const Pressure pressure({world, Time(0)});
  EXPECT_TRUE(result_of(pressure, {world, Time(1)}).quantities.empty());
}

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
  const Measurement found = result_of(temperature, {world, Time(4)});
  // Twice the energy is 8 + 6, and there are 3 * 4 - 3 degrees of freedom.
  EXPECT_NEAR(quantity(found, "temperature").value, 14.0 / 9, 1e-12);
  EXPECT_NEAR(quantity(found, "temperature_along_x").value, 8.0 / 3, 1e-12);
  EXPECT_NEAR(quantity(found, "temperature_along_y").value, 6.0 / 3, 1e-12);
  EXPECT_NEAR(quantity(found, "temperature_along_z").value, 0, 1e-12);
  // Of the motion of the center of mass the light pair has a quarter.
  EXPECT_NEAR(quantity(found, "temperature_of_species_1").value, 8 / (6 - 3 * 0.25), 1e-12);
  EXPECT_NEAR(quantity(found, "temperature_of_species_2").value, 6 / (6 - 3 * 0.75), 1e-12);
  EXPECT_EQ(values(found, "time"), std::vector<double>{4});
  EXPECT_EQ(values(found, "temperature_along_x").size(), 1U);
}

TEST(Temperature, CountsAllMotionBetweenWalls) {
  const World world = mixture({1, 0, 0}, Box::walls({10, 10, 10}));
  const Measurement found = measured<Temperature>(world);
  // Twice the energy is 9 + 1 of the light, 3 (1 + 1) each of the heavy.
  EXPECT_NEAR(quantity(found, "temperature").value, 22.0 / 12, 1e-12);
  EXPECT_NEAR(quantity(found, "temperature_of_species_2").value, 12.0 / 6, 1e-12);
}

TEST(Temperature, OfOneKindHasNoSpecies) {
  World world(Box::periodic({10, 10, 10}));
  world.add({{2, 2, 2}, {2, 0, 0}, 0.5});
  world.add({{4, 4, 4}, {-2, 0, 0}, 0.5});
  EXPECT_FALSE(
      has_quantity(result_of(Temperature({world, Time(0)}), {world, Time(0)}), "temperature_of_species_1"));
}

// A spin of w about each axis has I w^2 = k T in equilibrium.
TEST(Temperature, CountsSpins) {
  World world(Box::walls({10, 10, 10}));
  world.add({.position = {2, 2, 2}, .radius = 0.5, .mass = 2, .spin = {1, 2, 3}});
  world.add(
      {.position = {5, 5, 5}, .velocity = {1, 0, 0}, .radius = 1, .spin = {0, 0, 1}, .inertia_factor = 0.5});
  const Measurement found = measured<Temperature>(world);
  EXPECT_NEAR(quantity(found, "rotational_temperature").value, (0.4 * 2 * 0.25 * 14 + 0.5 * 1) / 6, 1e-15);
  EXPECT_NEAR(quantity(found, "temperature").value, 1.0 / 6, 1e-15);
  const World still = mixture({}, Box::walls({10, 10, 10}));
  EXPECT_FALSE(
      has_quantity(result_of(Temperature({still, Time(0)}), {still, Time(0)}), "rotational_temperature"));
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
  EXPECT_NEAR(quantity(result_of(temperature, {world, Time(0)}), "rotational_temperature").value, 0.125 * 9,
              1e-15);
}

TEST(Temperature, TellsSpeciesApartThatDifferInNothingElse) {
  World world(Box::walls({10, 10, 10}));
  world.add({.position = {2, 2, 2}, .velocity = {1, 0, 0}, .radius = 0.5});
  world.add({.position = {5, 5, 5}, .velocity = {2, 0, 0}, .radius = 0.5, .species = 4});
  Temperature temperature({world, Time(0)});
  temperature.sample({world, Time(0)});
  EXPECT_NEAR(quantity(result_of(temperature, {world, Time(0)}), "temperature_of_species_2").value, 4.0 / 3,
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
  const World gas = make_gas({.count = 200, .packing_fraction = 0.1, .seed = 3});
  expect_mean_over_time(Simulation(interacting(gas, Restitution(0.8))), 200, 40000, 1e-3);
}

TEST(Temperature, IsTheMeanOverTimeOfAGasThatIsRescaled) {
  const World gas = make_gas({.count = 200, .packing_fraction = 0.2, .seed = 4});
  for (const double every : {1.0, 0.25}) {
    Simulation driven(interacting(gas, Restitution(0.7)));
    driven.set_thermostat(Thermostat(Rescale(1, every)));
    expect_mean_over_time(driven, 100, 40000, 1e-3);
  }
}

// Samples at the beat of the thermostat would see the speeds right after it has acted.
TEST(MeanSpeed, SharesNoBeatWithAThermostat) {
  const World gas = make_gas({.count = 500, .packing_fraction = 0.15, .seed = 5});
  Simulation driven(interacting(gas, Restitution(0.7)));
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
  const Measurement found = measured<Temperature>(world);
  EXPECT_NEAR(quantity(found, "temperature").value, 1.0 / 3, 1e-15);
  EXPECT_NEAR(quantity(found, "temperature_along_x").value, 1, 1e-15);
  EXPECT_NEAR(quantity(found, "temperature_along_y").value, 0, 1e-15);
}

// Equal speeds of 3 along the axes, and a drift that does not count; half the spheres are nine times as heavy
// and three times as slow.
World equal_speeds() {
  World world(Box::periodic({100, 100, 100}));
  for (int i = 0; i < 12; ++i) {
    Vec3 velocity;
    velocity[static_cast<std::size_t>(i) / 2 % 3] = (i % 2 == 0 ? 3 : -3) / (i < 6 ? 1.0 : 3.0);
    const double x = 5.0 * (i + 1);
    world.add({{x, x, x}, velocity + Vec3{4, 0, 0}, 0.5, i < 6 ? 1.0 : 9.0});
  }
  return world;
}

TEST(VelocityDistribution, IsOfVelocitiesInUnitsOfTheThermalOne) {
  const World world = equal_speeds();
  const Measurement found = measured<VelocityDistribution>(world);
  EXPECT_NEAR(quantity(found, "speed_kurtosis").value, 1, 1e-12);
  EXPECT_NEAR(quantity(found, "mean_speed").value, 2, 1e-12);
  EXPECT_NEAR(quantity(found, "speed_kurtosis").theory, 5.0 / 3 * 33 / 35, 1e-12);
  // m v^2 = 9 = kT (3 * 12 - 3) / 12 for all.
  const double temperature = 9 * 12.0 / 33;
  const double c = 3 / std::sqrt(temperature);
  const Column& argument = column(found, "reduced_velocity");
  for (std::size_t i = 0; i < argument.values.size(); ++i) {
    const double middle = argument.values[i];
    const auto holds = [&](double value) { return std::fabs(value - middle) < 0.05; };
    const double of_components = holds(0.05) ? 2.0 / 3 : holds(c) || holds(-c) ? 1.0 / 6 : 0;
    EXPECT_NEAR(values(found, "component_density")[i] * 0.1, of_components, 1e-12) << middle;
    if (middle < 0) {
      EXPECT_TRUE(std::isnan(values(found, "speed_density")[i]));
    } else {
      EXPECT_NEAR(values(found, "speed_density")[i] * 0.1, holds(c) ? 1 : 0, 1e-12) << middle;
    }
  }
  // The mean of sqrt(8 kT / pi m), at fixed energy in 33 degrees of freedom and without what spheres of mass
  // 1 and 9, of 60 in all, have of the motion of the center of mass.
  const double of_light = std::sqrt(1 - 1.0 / 60);
  const double of_heavy = std::sqrt(1 - 9.0 / 60) / 3;
  const double expected =
      std::sqrt(8 * temperature / std::numbers::pi) * mean_over_normal(33) * (of_light + of_heavy) / 2;
  EXPECT_NEAR(quantity(found, "mean_speed").theory, expected, 1e-12);
}

TEST(VelocityDistribution, HasMaxwellsAsTheory) {
  const World world = equal_speeds();
  const Measurement found = result_of(VelocityDistribution({world, Time(0)}), {world, Time(0)});
  const Column& argument = column(found, "reduced_velocity");
  double components = 0;
  double speeds = 0;
  for (std::size_t i = 0; i < argument.values.size(); ++i) {
    const double c = argument.values[i];
    const double gauss = std::exp(-c * c / 2) / std::sqrt(2 * std::numbers::pi);
    EXPECT_NEAR(values(found, "component_density_theory")[i], gauss, 5e-4);
    components += gauss * 0.1;
    if (c < 0) continue;
    EXPECT_NEAR(values(found, "speed_density_theory")[i], 2 * c * c * gauss, 1e-3);
    speeds += values(found, "speed_density_theory")[i] * 0.1;
  }
  EXPECT_NEAR(components, 1, 1e-4);
  EXPECT_NEAR(speeds, 1, 1e-4);
}

TEST(VelocityDistribution, OfSpheresAtRestIsEmpty) {
  World world(Box::periodic({10, 10, 10}));
  world.add({{2, 2, 2}, {}, 0.5});
  world.add({{4, 4, 4}, {}, 0.5});
  VelocityDistribution velocities({world, Time(0)});
  velocities.sample({world, Time(0)});
  EXPECT_TRUE(std::isnan(quantity(result_of(velocities, {world, Time(0)}), "speed_kurtosis").value));
}

}  // namespace
}  // namespace hardball::gas_measures_test
