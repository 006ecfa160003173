// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Wells, shoulders and tethers: what is exact at every density, the dilute gas, and what the measure of steps
// says of it.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "hardball/measure/measures.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/world/step_levels.hpp"
#include "hardball/world/totals.hpp"
#include "support/effort.hpp"
#include "support/gas.hpp"
#include "support/interacting.hpp"
#include "support/measurement.hpp"

namespace hardball::steps_test {
namespace {

using namespace support;

constexpr double kPi = std::numbers::pi;

World with_potential(World world, const StepRules& rules) {
  return interacting(std::move(world), stepping(rules));
}

// Spheres with diameter and mass one, at kT = 1 at first.
World fluid(std::size_t count, double density, const StepRules& rules) {
  return with_potential(
      make_gas({.count = count, .packing_fraction = density * kPi / 6, .seed = 5, .start = Start::random}),
      rules);
}

// How often spheres have come to a step, and what became of it.
struct Counts {
  std::uint64_t cores = 0;
  std::uint64_t came_in = 0;
  std::uint64_t passed_in = 0;
  std::uint64_t came_out = 0;
  std::uint64_t passed_out = 0;

  void record(const Contact& contact) {
    if (!contact.step.happens()) {
      ++cores;
    } else if (contact.step.is_outward) {
      ++came_out;
      passed_out += contact.step.passes ? 1 : 0;
    } else {
      ++came_in;
      passed_in += contact.step.passes ? 1 : 0;
    }
  }
};

// A run after its transient, with its counts, mean temperature and mean potential energy.
struct Equilibrium {
  Counts counts;
  double duration = 0;
  double temperature = 0;
  double energy_per_sphere = 0;
  double drift = 0;  // of the total energy, relative to the kinetic one
};

Equilibrium equilibrium_of(const World& world, std::uint64_t contacts) {
  Simulation simulation(world);
  simulation.run_contacts(contacts / 4);
  const double begin = simulation.time();
  const double energy = hardball::energy(simulation.world(), simulation.now());
  const auto spheres = static_cast<double>(world.size());
  Equilibrium found;
  double kinetic = kinetic_energy(simulation.world(), simulation.now());
  double potential = step_energy(simulation.world());
  double kinetic_sum = 0;
  double potential_sum = 0;
  Time last = simulation.now();
  simulation.on_contact([&](const Contact& contact) {
    const double elapsed = duration(last, contact.time);
    last = contact.time;
    kinetic_sum += kinetic * elapsed;
    potential_sum += potential * elapsed;
    kinetic -= contact.step.gain();
    potential += contact.step.gain();
    found.counts.record(contact);
  });
  simulation.run_contacts(contacts);
  found.duration = simulation.time() - begin;
  found.temperature = 2 * kinetic_sum / found.duration / (3 * (spheres - 1));
  found.energy_per_sphere = potential_sum / found.duration / spheres;
  found.drift = (hardball::energy(simulation.world(), simulation.now()) - energy) /
                kinetic_energy(simulation.world(), simulation.now());
  EXPECT_NEAR(potential, step_energy(simulation.world()), 1e-9 * spheres);
  EXPECT_NEAR(kinetic, kinetic_energy(simulation.world(), simulation.now()), 1e-9 * spheres);
  return found;
}

double ratio(std::uint64_t part, std::uint64_t whole) {
  return static_cast<double>(part) / static_cast<double>(whole);
}

// Of attempts to climb a step exp(-rise / kT) succeed: less than four standard errors, and what the fixed
// energy of few spheres changes.
void expect_fraction(std::uint64_t passed, std::uint64_t came, double rise, double temperature,
                     std::size_t spheres) {
  const double x = rise / temperature;
  const double expected = std::exp(-x);
  const double error = std::sqrt(expected * (1 - expected) / static_cast<double>(came));
  // Attempts of one pair come one after the other.
  EXPECT_NEAR(ratio(passed, came), expected,
              8 * error + 2 * (x + x * x) * expected / (3.0 * static_cast<double>(spheres)));
}

TEST(Steps, LetTwoSpheresMeetAtExactTimes) {
  // On a line through both centers: a well of depth 3/8, mu = 1/2, so that u^2 = 1 becomes 5/2 within it.
  World world(Box::open());
  world.add({.position = {0, 0, 0}, .velocity = {0.5, 0, 0}, .radius = 0.5});
  world.add({.position = {3, 0, 0}, .velocity = {-0.5, 0, 0}, .radius = 0.5});
  Simulation simulation(with_potential(world, {.steps = {{2, -0.375}}}));
  std::vector<double> times;
  simulation.on_contact([&](const Contact& contact) { times.push_back(contact.time.value()); });
  simulation.run_until(100);
  const double inside = std::sqrt(2.5);
  ASSERT_EQ(times.size(), 3U);
  EXPECT_DOUBLE_EQ(times[0], 1);
  EXPECT_DOUBLE_EQ(times[1], 1 + 1 / inside);
  EXPECT_DOUBLE_EQ(times[2], 1 + 2 / inside);
  EXPECT_DOUBLE_EQ(simulation.velocity(1).x, 0.5);
  EXPECT_EQ(simulation.tally().steps_passed(), 2U);
}

TEST(Steps, KeepTwoSpheresBoundThatHaveNotTheEnergy) {
  World world(Box::open());
  world.add({.position = {0, 0, 0}, .velocity = {0.25, 0.1, 0}, .radius = 0.5});
  world.add({.position = {1.25, 0, 0}, .velocity = {-0.25, 0.1, 0}, .radius = 0.5});
  Simulation simulation(with_potential(world, {.steps = {{1.5, -1}}}));
  simulation.run_contacts(100000);
  EXPECT_EQ(simulation.tally().steps_passed(), 0U);
  EXPECT_EQ(simulation.tally().steps_refused(), 50000U);
  EXPECT_EQ(step_energy(simulation.world()), -1);
}

// The same instants in reverse order: velocities reversed at a contact lead back to the start.
TEST(Steps, AreReversible) {
  for (const double energy : {-1.0, 1.0}) {
    const World start = fluid(100, 0.2, {.steps = {{1.2, 2 * energy}, {1.5, energy}}});
    Simulation there(start);
    there.run_contacts(150);
    const double end = there.time() + 1e-3;
    there.run_until(end);
    Simulation back = there;
    std::vector<VelocityEdit> edits;
    for (SphereId id = 0; id < start.size(); ++id) edits.push_back({id, -there.velocity(id)});
    back.change_velocities(edits);
    back.run_until(2 * end);
    EXPECT_EQ(back.counters().collision, 2 * there.counters().collision);
    for (SphereId id = 0; id < start.size(); ++id) {
      const Vec3 apart = back.position(id) - start.position(start.slot_of(id), Time(0));
      EXPECT_LT(length(apart), 1e-6);
    }
    EXPECT_EQ(step_energy(back.world()), step_energy(Simulation(start).world()));
  }
}

// Exact at every density.
TEST(Steps, AreClimbedByTheFractionThatHasTheEnergy) {
  const std::uint64_t contacts = cases(1'000'000);
  for (const double density : {0.05, 0.4}) {
    const Equilibrium well = equilibrium_of(fluid(500, density, {.steps = {{1.5, -1}}}), contacts);
    EXPECT_NEAR(ratio(well.counts.passed_in, well.counts.came_in), 1, 0);
    expect_fraction(well.counts.passed_out, well.counts.came_out, 1, well.temperature, 500);
    // As many pass inwards as outwards, but for the pairs that are there at the end.
    EXPECT_NEAR(ratio(well.counts.passed_in, well.counts.passed_out), 1,
                500 * 6 / static_cast<double>(well.counts.passed_in));
    EXPECT_LT(std::fabs(well.drift), 1e-12);
    const Equilibrium shoulder = equilibrium_of(fluid(500, density, {.steps = {{1.5, 1}}}), contacts);
    expect_fraction(shoulder.counts.passed_in, shoulder.counts.came_in, 1, shoulder.temperature, 500);
    EXPECT_EQ(shoulder.counts.passed_out, shoulder.counts.came_out);
    EXPECT_LT(std::fabs(shoulder.drift), 1e-12);
  }
}

// The first order in the density, at the temperature that the run has.
TEST(Steps, GiveTheDiluteGasItsSecondVirialCoefficient) {
  const double density = 0.02;
  const double epsilon = 0.5;
  const double range = 1.5;
  const std::size_t spheres = 864;
  const double volume_ratio = range * range * range - 1;
  const World start = fluid(spheres, density, {.steps = {{range, -epsilon}}});
  const Equilibrium found = equilibrium_of(start, cases(2'000'000));
  const double boltzmann = std::exp(epsilon / found.temperature);
  const double energy = -2 * kPi / 3 * density * epsilon * volume_ratio * boltzmann;
  const double root = 4 * std::sqrt(kPi) * density * std::sqrt(found.temperature);
  const double per_sphere = 2 / found.duration / static_cast<double>(spheres);
  // Of second order in the density are some 2%.
  const double tolerance = kIsSlowBuild ? 0.08 : 0.03;
  EXPECT_NEAR(found.energy_per_sphere / energy, 1, tolerance);
  EXPECT_NEAR(static_cast<double>(found.counts.cores) * per_sphere / (root * boltzmann), 1, tolerance);
  EXPECT_NEAR(static_cast<double>(found.counts.came_in) * per_sphere / (root * range * range), 1, tolerance);
  Simulation simulation(start);
  simulation.run_contacts(cases(2'000'000));
  const double virial = 2 * kPi / 3 * (1 - volume_ratio * (boltzmann - 1));
  EXPECT_NEAR(simulation.tally().compressibility(simulation.now()), 1 + virial * density,
              kIsSlowBuild ? 0.015 : 0.005);
}

// A reference state: 864 spheres at a density of .0382 and kT = 2.005, in units of the depth of their wells.
TEST(Steps, GiveADiluteGasOfWellsItsEnergyAndRates) {
  const std::size_t spheres = 864;
  const double depth = 1 / 1.93;  // falling into wells heats the gas
  const Equilibrium found =
      equilibrium_of(fluid(spheres, 0.0382, {.steps = {{1.5, -depth}}}), cases(2'000'000));
  EXPECT_NEAR(found.temperature / depth, 2.005, 0.02);
  const double per_sphere = 2 / found.duration / static_cast<double>(spheres) / std::sqrt(depth);
  const double tolerance = kIsSlowBuild ? 0.05 : 0.02;
  EXPECT_NEAR(found.energy_per_sphere / depth, -0.307, 0.307 * tolerance);
  EXPECT_NEAR(static_cast<double>(found.counts.cores) * per_sphere, 0.630, 0.630 * tolerance);
  EXPECT_NEAR(static_cast<double>(found.counts.came_in) * per_sphere, 0.844, 0.844 * tolerance);
}

// How many others stick to a sphere, by the Percus-Yevick approximation. Source: Baxter, J. Chem. Phys. 49
// (1968) 2770.
double sticking(double stickiness, double packing_fraction) {
  const double eta = packing_fraction;
  const double tau = 1 / stickiness;
  const double b = tau + eta / (1 - eta);
  const double contact = (b - std::sqrt(b * b - eta / 3 * (1 + eta / 2) / ((1 - eta) * (1 - eta)))) * 6 / eta;
  return 2 * eta * contact;
}

// In the limit of narrow wells only the stickiness matters. Besides those that stick there are as many within
// the well as there would be without it.
TEST(Steps, OfNarrowWellsMakeSpheresStick) {
  for (const double packing_fraction : {0.1, 0.3}) {
    const double range = 1.01;
    const double depth = 3.5;
    const World start = fluid(500, packing_fraction * 6 / kPi, {.steps = {{range, -depth}}});
    const Equilibrium found = equilibrium_of(start, cases(4'000'000));
    const double boltzmann = std::exp(depth / found.temperature);
    const double stickiness = 4 * (range * range * range - 1) * (boltzmann - 1);
    const double within = -2 * found.energy_per_sphere / depth;
    EXPECT_GT(stickiness, 0.5);
    // The approximation and the width of the well are good to a percent each.
    EXPECT_NEAR(within * (1 - 1 / boltzmann) / sticking(stickiness, packing_fraction), 1,
                kIsSlowBuild ? 0.1 : 0.03)
        << stickiness;
  }
}

// Three beads with walls all around: for ever within their tethers.
TEST(Tethers, HoldForManyEvents) {
  World world({{Boundary::wall, Boundary::wall, Boundary::wall}, {4, 4, 4}});
  Interactions interactions;
  StepTable table;
  const StepTable::Number bond =
      table.add_bond(StepPotential({.steps = {{1.2, 0}}, .core = 0.9, .is_tether = true}));
  interactions.set_steps(table);
  world.add({.position = {1, 1, 1}, .velocity = {1, 0.3, 0}, .radius = 0.5});
  world.add({.position = {2.1, 1, 1}, .velocity = {0, 0.2, 0.7}, .radius = 0.5});
  world.add({.position = {2.1, 2.1, 1}, .velocity = {0.1, 0, -0.4}, .radius = 0.5});
  world.set_interactions(interactions);
  add_bond(world, 0, 1, bond);
  add_bond(world, 1, 2, bond);
  Simulation simulation(world);
  const double energy = kinetic_energy(world, Time(0));
  double shortest = 1;
  double longest = 1;
  simulation.on_contact([&](const Contact& contact) {
    if (!contact.is_collision()) return;
    for (SphereId id = 0; id < 2; ++id) {
      const double distance = length(simulation.position(id + 1) - simulation.position(id));
      shortest = std::min(shortest, distance);
      longest = std::max(longest, distance);
    }
  });
  simulation.run_contacts(cases(10'000'000));
  EXPECT_NEAR(shortest, 0.9, 1e-12);
  EXPECT_NEAR(longest, 1.2, 1e-12);
  EXPECT_GT(simulation.tally().steps_refused(), cases(10'000'000) / 10);
  EXPECT_EQ(simulation.tally().steps_passed(), 0U);
  EXPECT_NEAR(hardball::energy(simulation.world(), simulation.now()), energy, 1e-12 * energy * 10);
}

// A dumbbell at the end of its tether that turns without vibrating: it glides along the end.
TEST(Tethers, HoldWhatTurnsAtTheirEnd) {
  World world(Box::open());
  Interactions interactions;
  StepTable table;
  const StepTable::Number bond = table.add_bond(StepPotential({.steps = {{1.5, 0}}, .is_tether = true}));
  interactions.set_steps(table);
  world.add({.position = {0, 0, 0}, .velocity = {0, 1, 0}, .radius = 0.5});
  world.add({.position = {1.5, 0, 0}, .velocity = {0, -1, 0}, .radius = 0.5});
  world.set_interactions(interactions);
  add_bond(world, 0, 1, bond);
  Simulation simulation(world);
  simulation.run_until(0.1);
  EXPECT_LT(simulation.counters().collision, 100000U);
  EXPECT_NEAR(length(simulation.position(1) - simulation.position(0)), 1.5, 1e-9);
  EXPECT_NEAR(kinetic_energy(simulation.world(), simulation.now()), 1, 1e-9);
}

TEST(StepsMeasured, AreThoseOfTheEvents) {
  const double density = 0.3;
  Simulation simulation(fluid(500, density, {.steps = {{1.5, -1}}}));
  simulation.run_contacts(cases(200'000));
  Measures measures({.names = {"steps", "radial_distribution", "collision_rate", "viscosity"}});
  Counts counts;
  const double begin = simulation.time();
  const auto run = [&](std::uint64_t contacts) {
    simulation.run({.until = kNever, .contacts = contacts}, measures);
  };
  simulation.on_contact([&](const Contact& contact) { counts.record(contact); });
  run(cases(2'000'000));
  const double per_sphere = 2 / (simulation.time() - begin) / 500;
  const std::vector<Measurement> results = measures.results(simulation.world(), simulation.now());
  const Measurement& steps = named(results, "steps");
  const Measurement& structure = named(results, "radial_distribution");
  // A transient may have been left out.
  EXPECT_NEAR(quantity(steps, "rate_inward").value, static_cast<double>(counts.came_in) * per_sphere,
              0.05 * static_cast<double>(counts.came_in) * per_sphere);
  const Quantity& passed = quantity(steps, "passed_outward");
  EXPECT_NEAR(passed.value, passed.theory, 4 * passed.error + passed.tolerance);
  EXPECT_GT(passed.error, 0);
  EXPECT_FALSE(has_quantity(steps, "passed_inward")) << "a way down is no climb";
  // The function jumps by exp(-dU/kT).
  const double outside = quantity(steps, "g_outside").value;
  const double inside = quantity(steps, "g_inside").value;
  EXPECT_NEAR(outside / inside, passed.theory, 0.05 * passed.theory);
  // What is counted in the bins on both sides.
  const Column& distance = column(structure, "distance");
  const Column& g = column(structure, "g");
  for (std::size_t bin = 0; bin < distance.values.size(); ++bin) {
    if (std::fabs(distance.values[bin] - 1.47) < 0.011) {
      EXPECT_NEAR(g.values[bin] / inside, 1, 0.06);
    }
    if (std::fabs(distance.values[bin] - 1.53) < 0.011) {
      EXPECT_NEAR(g.values[bin] / outside, 1, 0.06);
    }
  }
  const Quantity& capacity = quantity(steps, "heat_capacity");
  // From the energies and temperatures of two runs with velocities smaller and larger by a tenth: 2.21.
  EXPECT_NEAR(capacity.value, 2.21, 4 * capacity.error);
  EXPECT_LT(capacity.error, kIsSlowBuild ? 1 : 0.2);
  EXPECT_NEAR(quantity(named(results, "collision_rate"), "collision_rate").value,
              static_cast<double>(counts.cores) * per_sphere,
              0.05 * static_cast<double>(counts.cores) * per_sphere)
      << "of cores alone";
  EXPECT_TRUE(std::isnan(quantity(named(results, "collision_rate"), "collision_rate").theory));
  EXPECT_EQ(quantity(named(results, "viscosity"), "viscosity").reason,
            "transport is measured without potentials of steps");
}

}  // namespace
}  // namespace hardball::steps_test
