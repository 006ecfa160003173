// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/measures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/statistics/measurement.hpp"
#include "support/gas.hpp"
#include "support/interacting.hpp"
#include "support/measurement.hpp"

namespace hardball::measures_test {
namespace {

using namespace support;

// All results of measures, to the last bit.
std::string text_of(const std::vector<Measurement>& measurements) {
  std::string text = quantities_csv(measurements);
  for (const Measurement& measurement : measurements) text += columns_csv(measurement);
  return text;
}

std::vector<std::string> names_of(const std::vector<Measurement>& measurements) {
  std::vector<std::string> names;
  for (const Measurement& measurement : measurements) names.push_back(measurement.name);
  return names;
}

TEST(Measures, AreThoseThatAreNamed) {
  const World gas = make_gas({.count = 20});
  const World world = interacting(gas, stepping({.steps = {{1.5, -1}}}));
  const std::vector<std::string> known(measure_names().begin(), measure_names().end());
  Measures every({.names = known});
  every.sample(world, Time(0));
  EXPECT_EQ(names_of(every.results(world, Time(1))), known);
  // Those of transport are taken by name alone.
  Measures all;
  all.sample(world, Time(0));
  std::vector<std::string> others = known;
  std::erase_if(others, [](const std::string& name) {
    return name == "diffusion" || name == "mutual_diffusion" || name.ends_with("viscosity") ||
           name == "thermal_conductivity";
  });
  EXPECT_EQ(others.size() + 5, known.size());
  EXPECT_EQ(names_of(all.results(world, Time(1))), others);
  // Without potentials there is nothing to tell of steps.
  Measures of_gas;
  of_gas.sample(gas, Time(0));
  std::erase(others, "steps");
  EXPECT_EQ(names_of(of_gas.results(gas, Time(1))), others);
  Measures two({.names = {"temperature", "pressure", "pressure"}});
  two.sample(world, Time(0));
  EXPECT_EQ(names_of(two.results(world, Time(1))), (std::vector<std::string>{"pressure", "temperature"}));
}

TEST(Measures, TakeNoSamplesIfThereAreNone) {
  Measures none({.names = {}});
  EXPECT_EQ(none.next_sample(), kNever);
  const World world = make_gas({.count = 20});
  none.sample(world, Time(0));
  EXPECT_TRUE(none.results(world, Time(1)).empty());
}

TEST(Measures, RefuseWhatMakesNoSense) {
  EXPECT_THROW(Measures({.names = {"presure"}}), Error);
  EXPECT_THROW(Measures({.every = 0.0}), Error);
  EXPECT_THROW(Measures({.every = std::nan("")}), Error);
  EXPECT_THROW(Measures({.from = std::numeric_limits<double>::infinity()}), Error);
}

TEST(Measures, StartAtTheGivenTime) {
  Simulation simulation(make_gas({.count = 100, .packing_fraction = 0.2}));
  Measures measures({.names = {"collision_rate", "temperature"}, .every = 0.5, .from = 2});
  EXPECT_EQ(measures.next_sample(), Time(2));
  simulation.run_until(1.9, measures);
  EXPECT_TRUE(measures.results(simulation.world(), simulation.now()).empty());
  const std::uint64_t before = [&] {
    Simulation copy = simulation;
    copy.run_until(2);
    return copy.counters().collision;
  }();
  simulation.run_until(3.5, measures);
  const std::vector<Measurement> found = measures.results(simulation.world(), simulation.now());
  const std::vector<double> times = column(found[0], "time").values;
  ASSERT_EQ(times.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(std::floor((times[k] - 2) / 0.5), static_cast<double>(k)) << "one sample in each interval";
  }
  EXPECT_EQ(quantity(found[1], "collisions").value,
            static_cast<double>(simulation.counters().collision - before));
}

TEST(Measures, TakeAMissedSampleAtOnce) {
  Simulation simulation(make_gas({.count = 20}));
  Measures measures({.names = {"temperature"}, .every = 1.0});
  simulation.run_until(0.1, measures);
  simulation.run_until(2.5);
  simulation.run_until(2.6, measures);
  EXPECT_EQ(column(measures.results(simulation.world(), simulation.now()).front(), "time").values,
            std::vector<double>{2.5});
}

// In a box so long that a sample of its structure costs more than is free.
TEST(Measures, TakeTheRestAtTheEndOfAShortRun) {
  World world(Box::periodic({1e5, 10, 10}));
  for (int i = 0; i < 20000; ++i) world.add({{5.0 * i, 5, 5}, {0, i % 2 == 0 ? 1.0 : -1.0, 0}, 0.5});
  Simulation simulation(world);
  Measures measures({.names = {"structure_factor", "temperature"}});
  simulation.run_until(0.01, measures);
  const auto factor = [&] {
    const std::vector<Measurement> found = measures.results(simulation.world(), simulation.now());
    return column(found.back(), "structure_factor").values.front();
  };
  EXPECT_TRUE(std::isnan(factor()));
  measures.sample_the_rest(simulation.world(), simulation.now());
  EXPECT_FALSE(std::isnan(factor()));
  const double once = factor();
  simulation.run_until(0.02);
  measures.sample_the_rest(simulation.world(), simulation.now());
  EXPECT_EQ(factor(), once) << "it has a sample";
}

// Laws 1 and 4: the contacts are the same with measures and without.
TEST(Measures, TakeEditsOfVelocitiesIntoAccount) {
  // They pass by each other.
  World world(Box::periodic({10, 10, 10}));
  world.add({.position = {1, 2, 5}, .velocity = {1, 0, 0}, .radius = 0.5});
  world.add({.position = {1, 8, 5}, .velocity = {-1, 0, 0}, .radius = 0.5});
  Simulation simulation(std::move(world));
  Measures measures({.names = {"pressure"}});
  simulation.run_until(1, measures);
  EXPECT_TRUE(measures.has_begun());
  const auto pressure = [&](const char* name) {
    const std::vector<Measurement> results = measures.results(simulation.world(), simulation.now());
    return Quantity(quantity(results.at(0), name));
  };
  const double before = pressure("pressure_xx").value;
  EXPECT_TRUE(std::isfinite(pressure("pressure").theory));
  const std::vector<VelocityEdit> twice{{0, {2, 0, 0}}, {1, {-2, 0, 0}}};
  simulation.change_velocities(twice, measures);
  simulation.run_until(3, measures);
  // For two thirds of the time it was four times as high.
  EXPECT_NEAR(pressure("pressure_xx").value, 3 * before, 1e-12);
  EXPECT_TRUE(std::isnan(pressure("pressure").theory));
}

TEST(Measures, RefuseEditsOfASimulationThatIsNotTheirs) {
  Simulation simulation(make_gas({.count = 20}));
  Measures measures({.names = {"pressure"}});
  simulation.run_until(0.1, measures);
  simulation.remove(3);
  const std::vector<VelocityEdit> edits{{0, {1, 0, 0}}};
  const Vec3 velocity = simulation.velocity(0);
  EXPECT_THROW(simulation.change_velocities(edits, measures), Error);
  EXPECT_EQ(simulation.velocity(0), velocity);
}

TEST(Measures, ChangeNoContact) {
  for (const Boundary boundary : {Boundary::periodic, Boundary::wall, Boundary::open}) {
    const World world = make_gas({.count = 300, .packing_fraction = 0.2, .boundary = boundary});
    // With cells of a fixed size: when they are rebuilt depends on the pieces in which the simulation runs.
    Simulation alone(world, {.cell_edge = 2});
    alone.run_until(3);
    Simulation watched(world, {.cell_edge = 2});
    Measures measures({.every = 0.013});
    watched.run_until(3, measures);
    EXPECT_EQ(watched.event_log_hash(), alone.event_log_hash());
    EXPECT_EQ(watched.positions(), alone.positions());
    EXPECT_EQ(watched.counters(), alone.counters());
  }
}

TEST(Measures, FindTheSameBitsByEveryEngine) {
  const World world = make_gas({.count = 500, .packing_fraction = 0.25, .seed = 8});
  const auto found_by = [&](EngineKind engine, double piece) {
    Simulation simulation(world, {.engine = engine});
    Measures measures;
    for (double time = piece; time < 2; time += piece) simulation.run_until(time, measures);
    simulation.run_until(2, measures);
    return text_of(measures.results(simulation.world(), simulation.now()));
  };
  const std::string expected = found_by(EngineKind::all_pairs, 2);
  EXPECT_GT(expected.size(), 10000U);
  EXPECT_EQ(found_by(EngineKind::cells, 2), expected);
  EXPECT_EQ(found_by(EngineKind::neighbors, 2), expected);
  EXPECT_EQ(found_by(EngineKind::paper, 2), expected);
  EXPECT_EQ(found_by(EngineKind::cells, 0.017), expected) << "run in pieces";
}

// So many spheres are stored in an order chosen by the engine.
TEST(Measures, FindTheSameBitsHoweverSpheresAreStored) {
  const World world = make_gas({.count = 12000, .packing_fraction = 0.1, .seed = 9});
  const auto found_by = [&](EngineKind engine) {
    Simulation simulation(world, {.engine = engine});
    Measures measures;
    simulation.run_until(1, measures);
    return text_of(measures.results(simulation.world(), simulation.now()));
  };
  EXPECT_EQ(found_by(EngineKind::cells), found_by(EngineKind::paper));
}

TEST(Measures, ComposeWithLimitsOnContactsAndSteps) {
  const World world = make_gas({.count = 100, .packing_fraction = 0.2});
  Simulation simulation(world);
  Measures measures({.every = 0.01});
  EXPECT_EQ(simulation.run({.until = Time(100), .contacts = 1000}, measures), RunStatus::contacts_reached);
  EXPECT_EQ(simulation.counters().contacts(), 1000U);
  EXPECT_EQ(simulation.run({.until = Time(100), .steps = 100}, measures), RunStatus::steps_reached);
  EXPECT_LE(simulation.counters().contacts(), 1100U);
}

TEST(Measures, SampleSpheresAtRestOccasionally) {
  World world(Box::periodic({10, 10, 10}));
  world.add({{2, 2, 2}, {}, 0.5});
  Simulation simulation(world);
  Measures measures;
  simulation.run_until(1e9, measures);
  EXPECT_EQ(simulation.time(), 1e9);
  // Eight samples for each doubling of the interval, 30 of them.
  EXPECT_LE(column(measures.results(simulation.world(), simulation.now())[2], "time").values.size(), 64U);
}

}  // namespace
}  // namespace hardball::measures_test
