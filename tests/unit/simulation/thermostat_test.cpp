// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// A simulation with a thermostat: when it acts, what is seen then, and what is recorded.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/hardball.hpp"
#include "hardball/recording/recording_reader.hpp"
#include "hardball/recording/recording_writer.hpp"
#include "hardball/world/totals.hpp"
#include "support/gas.hpp"
#include "support/interacting.hpp"
#include "support/scratch_folder.hpp"

namespace hardball::thermostat_test {
namespace {

// Two spheres that meet at time 4, at x = 10.
World head_on_pair() {
  World world(Box::walls({20, 10, 10}));
  world.add({{5, 5, 5}, {1, 0, 0}, 1, 1});
  world.add({{15, 5, 5}, {-1, 0, 0}, 1, 1});
  return world;
}

// Doubles the speed of both: their kT is 2/6.
Thermostat speed_doubler(double every) {
  return Thermostat(Rescale(4 * 2.0 / 6, every));
}

double temperature_of(const Simulation& simulation) {
  return 2 * kinetic_energy(simulation.world(), simulation.now()) / 6;
}

TEST(SimulationWithThermostat, ActsAtItsTimes) {
  Simulation simulation(head_on_pair());
  simulation.set_thermostat(speed_doubler(3));
  std::vector<double> contacts;
  std::vector<double> changes;
  simulation.on_contact([&](const Contact& contact) { contacts.push_back(contact.time.value()); });
  simulation.observe(
      {.change = [&](const VelocityChange& change) { changes.push_back(change.time.value()); }});
  simulation.run_until(4);
  EXPECT_EQ(changes, (std::vector<double>{3, 3}));
  EXPECT_EQ(contacts, (std::vector<double>{3.5})) << "twice as fast for the last unit of the way";
  EXPECT_NEAR(temperature_of(simulation), 4 * 2.0 / 6, 1e-15);
  EXPECT_EQ(simulation.thermostat()->events(), 1U);
  EXPECT_NEAR(simulation.thermostat()->energy(), 3, 1e-15);
  EXPECT_EQ(simulation.tally().energy_integral(simulation.now()), 3 * 1 + 1 * 4.0);
}

// At the time of a contact it acts after it, and whoever asks sees the velocities that it has given.
TEST(SimulationWithThermostat, ActsAfterContactsAtTheSameTime) {
  Simulation simulation(head_on_pair());
  simulation.set_thermostat(speed_doubler(4));
  EXPECT_EQ(simulation.next_contact()->time, 4);
  EXPECT_EQ(simulation.run_contacts(1), 1U);
  EXPECT_EQ(simulation.time(), 4);
  EXPECT_EQ(simulation.velocity(0), (Vec3{-1, 0, 0})) << "a limit of contacts is reached before it acts";
  simulation.run_until(4);
  EXPECT_EQ(simulation.velocity(0), (Vec3{-2, 0, 0}));
  simulation.run_until(4);
  EXPECT_EQ(simulation.thermostat()->events(), 1U) << "only once";
}

// A contact whose time rounds to that of the action, but is later: the action comes right after it.
TEST(SimulationWithThermostat, ActsAtTheExactTimeOfAContactThatRoundsToItsOwn) {
  const World world = support::make_gas({.count = 30, .packing_fraction = 0.2});
  std::vector<Contact> contacts;
  Simulation plain(world);
  plain.on_contact([&](const Contact& contact) { contacts.push_back(contact); });
  plain.run_contacts(40);
  for (const Contact& contact : contacts) {
    const Time expected = later(contact.time, Time(contact.time.high));
    for (const EngineKind engine : {EngineKind::cells, EngineKind::all_pairs, EngineKind::paper}) {
      for (const bool is_split : {false, true}) {
        Simulation simulation(world, {.engine = engine});
        simulation.set_thermostat(Thermostat(Heating(1, contact.time.high)));
        if (is_split) simulation.run_contacts(static_cast<std::uint64_t>(&contact - contacts.data()) + 1);
        simulation.run_until(contact.time.high);
        EXPECT_EQ(simulation.thermostat()->events(), 1U);
        EXPECT_EQ(simulation.world().path(contact.first).time, expected);
        simulation.validate();
      }
    }
  }
}

// The time that a run has reached after some steps depends on the engine; when the thermostat acts does not.
TEST(SimulationWithThermostat, DoesNotActAtTheTimeOfACrossing) {
  // Both spheres cross at the same times, so that a run of one step may end between two crossings.
  World world(Box::periodic({10, 10, 10}));
  world.add({{2, 2, 2}, {1, 0.25, 0.75}, 0.5, 1});
  world.add({{7, 7, 7}, {1, 0.25, 0.75}, 0.5, 1});
  Simulation start(world, {.engine = EngineKind::paper, .cell_edge = 2.5});
  start.run_until(0.1);
  for (const SphereId id : {0U, 1U}) start.change_velocity(id, {1, 0.25, 0.75});
  std::vector<Time> crossings;
  Simulation plain(start);
  for (int step = 0; step < 60; ++step) {
    plain.run({.steps = 1});
    if (plain.now().low > 0) crossings.push_back(plain.now());
  }
  int compared = 0;
  for (const Time& crossing : crossings) {
    Simulation simulation(start);
    const double every = crossing.high - start.time();
    if (start.time() + every != crossing.high) continue;
    ++compared;
    simulation.set_thermostat(Thermostat(Heating(1, every)));
    while (simulation.run({.until = Time(crossing.high), .steps = 1}) != RunStatus::time_reached) continue;
    EXPECT_EQ(simulation.thermostat()->events(), 1U);
    EXPECT_EQ(simulation.world().path(0).time, Time(crossing.high));
  }
  EXPECT_GT(compared, 5);
}

TEST(SimulationWithThermostat, TakesSamplesAfterItHasActed) {
  Simulation simulation(head_on_pair());
  simulation.set_thermostat(speed_doubler(1));
  Measures measures({.names = {"temperature"}, .every = 1, .from = 1});
  simulation.run_until(3, measures);
  const auto results = measures.results(simulation.world(), simulation.now());
  EXPECT_NEAR(results[0].quantities[0].value, 4 * 2.0 / 6, 1e-15);
}

TEST(SimulationWithThermostat, LooksAheadOfItsActions) {
  Simulation simulation(head_on_pair());
  simulation.set_thermostat(speed_doubler(3));
  const std::uint64_t hash = simulation.event_log_hash();
  EXPECT_EQ(simulation.next_contact(3.25), std::nullopt);
  EXPECT_EQ(simulation.next_contact()->time, 3.5);
  EXPECT_EQ(simulation.velocity(0), (Vec3{1, 0, 0}));
  EXPECT_EQ(simulation.thermostat()->events(), 0U);
  EXPECT_EQ(simulation.positions_at(3)[0], (Vec3{8, 5, 5}));
  EXPECT_THROW(simulation.positions_at(3.25), Error);
  EXPECT_EQ(simulation.event_log_hash(), hash);
}

// Spheres that cross many cells before they meet, so that who looks ahead has much to do.
Simulation sparse_gas() {
  return Simulation(support::make_gas({.count = 60, .packing_fraction = 0.005}),
                    {.engine = EngineKind::cells, .cell_edge = 1.0});
}

// After an edit that follows a look ahead this is done on a copy, beyond crossings and actions.
TEST(SimulationWithThermostat, LooksAheadAgainAfterAnEdit) {
  Simulation simulation = sparse_gas();
  simulation.set_thermostat(Thermostat(Andersen(1, 0.5), 1));
  Random random(1);
  for (SphereId id = 0; id < 60; ++id) {
    simulation.next_contact(simulation.time() + 10);
    simulation.change_velocity(id, random.direction());
    const std::optional<NextContact> next = simulation.next_contact(simulation.time() + 10);
    ASSERT_TRUE(next);
    std::optional<double> first;
    simulation.on_contact([&](const Contact& contact) { first = contact.time.value(); });
    simulation.run_contacts(1, next->time);
    ASSERT_EQ(first, next->time);
  }
}

// One that is set after a look ahead acts before what was foreseen, and a run may end there.
TEST(SimulationWithThermostat, EndsARunOfOneStepWhenItActs) {
  Simulation simulation = sparse_gas();
  const std::optional<NextContact> next = simulation.next_contact();
  ASSERT_TRUE(next);
  simulation.set_thermostat(Thermostat(Andersen(1, 1 / next->time), 1));
  const double acts = simulation.thermostat()->next();
  ASSERT_LT(acts, next->time / 2);
  EXPECT_EQ(simulation.run({.until = Time(next->time), .steps = 1}), RunStatus::steps_reached);
  EXPECT_EQ(simulation.time(), acts);
  EXPECT_EQ(simulation.thermostat()->events(), 1U);
}

TEST(SimulationWithThermostat, TellsOfNoChangesThatAreOnlyForeseen) {
  Simulation simulation(head_on_pair());
  simulation.set_thermostat(speed_doubler(3));
  int changes = 0;
  simulation.observe({.change = [&](const VelocityChange&) { ++changes; }});
  EXPECT_EQ(simulation.next_contact()->time, 3.5);
  EXPECT_EQ(simulation.contacts_within(3.75).size(), 1U);
  EXPECT_EQ(changes, 0);
}

TEST(SimulationWithThermostat, CanBeCopiedAndStopped) {
  Simulation simulation(head_on_pair());
  simulation.set_thermostat(Thermostat(Andersen(1, 2), 5));
  simulation.run_until(2);
  Simulation copy(simulation);
  Simulation stopped(head_on_pair());
  stopped = simulation;
  stopped.set_thermostat(std::nullopt);
  const double energy = kinetic_energy(stopped.world(), stopped.now());
  simulation.run_until(20);
  copy.run_until(20);
  stopped.run_until(20);
  EXPECT_EQ(copy.event_log_hash(), simulation.event_log_hash());
  EXPECT_EQ(copy.positions(), simulation.positions());
  EXPECT_GT(copy.thermostat()->events(), 40U);
  EXPECT_NEAR(kinetic_energy(stopped.world(), stopped.now()), energy, 1e-14 * energy);
}

TEST(SimulationWithThermostat, CountsItsActionsAsSteps) {
  Simulation simulation(support::make_gas({.count = 50, .packing_fraction = 0.01}));
  simulation.set_thermostat(Thermostat(Heating(1e-3, 1e-6)));
  EXPECT_EQ(simulation.run({.until = Time(1), .steps = 500}), RunStatus::steps_reached);
  EXPECT_LE(simulation.thermostat()->events(), 10U);
  EXPECT_GE(simulation.thermostat()->events(), 9U);
}

TEST(SimulationWithThermostat, RefusesToActMoreOftenThanTimesResolve) {
  for (const ThermostatKind& kind : {ThermostatKind(Andersen(2, 1e20)), ThermostatKind(Rescale(2, 1e-20)),
                                     ThermostatKind(Heating(2, 1e-20))}) {
    Simulation simulation(head_on_pair());
    simulation.run_until(1);
    simulation.set_thermostat(Thermostat(kind));
    EXPECT_THROW(simulation.run_until(2), Error);
  }
}

TEST(SimulationWithThermostat, GivesTheEnergyItSays) {
  for (const ThermostatKind& kind :
       {ThermostatKind(Andersen(2, 1)), ThermostatKind(Rescale(2, 0.1)), ThermostatKind(Heating(0.1, 0.1))}) {
    Simulation simulation(support::make_gas({.count = 200, .packing_fraction = 0.2}));
    simulation.set_thermostat(Thermostat(kind, 6));
    simulation.run_until(5);
    const double gained =
        kinetic_energy(simulation.world(), simulation.now()) - simulation.tally().initial_energy();
    EXPECT_GT(simulation.thermostat()->energy(), 50);
    EXPECT_NEAR(simulation.thermostat()->energy(), gained, 1e-10);
  }
}

void add_where_there_is_room(Simulation& simulation) {
  for (double x = 0;; x += 0.125) {
    try {
      simulation.add({{x, 0, 0}, {1, 0, 0}, 1e-3, 1});
      return;
    } catch (const Error&) {
      // The next place, for every engine.
    }
  }
}

// Set by a listener, it starts at the time of the contact; spheres may come and go.
TEST(SimulationWithThermostat, MayBeSetAndSpheresEditedByAListener) {
  const auto hash_by = [](EngineKind engine) {
    Simulation simulation(support::make_gas({.count = 30, .packing_fraction = 0.2}), {.engine = engine});
    simulation.set_thermostat(Thermostat(Heating(0.1, 0.5)));
    int contacts = 0;
    simulation.on_contact([&](const Contact& contact) {
      ++contacts;
      if (contacts == 20) simulation.set_thermostat(Thermostat(Andersen(1, 0.7), 3));
      if (contacts == 40) simulation.remove(contact.second);
      if (contacts == 60) add_where_there_is_room(simulation);
      if (contacts == 80) simulation.set_thermostat(Thermostat(Rescale(3, 0.1)));
    });
    simulation.run_until(5);
    EXPECT_GT(contacts, 100);
    return simulation.event_log_hash();
  };
  const std::uint64_t expected = hash_by(EngineKind::all_pairs);
  EXPECT_EQ(hash_by(EngineKind::cells), expected);
  EXPECT_EQ(hash_by(EngineKind::paper), expected);
}

TEST(SimulationWithThermostat, MustNotBeEditedByWhoHearsOfVelocities) {
  Simulation simulation(head_on_pair());
  simulation.set_thermostat(speed_doubler(1));
  simulation.observe({.change = [&](const VelocityChange&) { simulation.change_velocity(0, {}); }});
  EXPECT_THROW(simulation.run_until(2), Error);
  simulation.observe({.change = [&](const VelocityChange&) { simulation.run_until(3); }});
  EXPECT_THROW(simulation.change_velocity(0, {1, 0, 0}), Error);
}

// From a recording follows where spheres are at any time, though velocities change without contacts.
TEST(SimulationWithThermostat, IsRecorded) {
  const support::ScratchFolder folder;
  const std::filesystem::path path = folder / "recording.hbr";
  Simulation simulation(support::make_gas({.count = 30, .packing_fraction = 0.1}));
  simulation.set_thermostat(Thermostat(Andersen(1, 2), 7));
  std::uint64_t contacts = 0;
  {
    RecordingWriter writer(path, {.name = "test"}, simulation.world());
    simulation.on_contact([&](const Contact& contact) {
      writer.record(contact, simulation.world());
      ++contacts;
    });
    simulation.observe(
        {.change = [&](const VelocityChange& change) { writer.record(change, simulation.world()); }});
    simulation.run_until(20);
    simulation.change_velocity(4, {3, 0, 0});
    simulation.run_until(40);
    writer.close(40);
  }
  RecordingReader reader(path);
  ASSERT_GT(reader.chunks().size(), 1U);
  std::uint64_t collisions = 0;
  std::uint64_t changes = 0;
  for (std::size_t k = 0; k < reader.chunks().size(); ++k) {
    for (const RecordedContact& contact : reader.read(k).contacts) {
      ++(contact.is_collision() ? collisions : changes);
      EXPECT_FALSE(contact.is_wall());
    }
  }
  EXPECT_EQ(collisions, contacts);
  EXPECT_EQ(changes, simulation.thermostat()->events() + 1);
  const std::vector<RecordedPath> paths = reader.read(reader.chunks().size() - 1).paths_at(40);
  for (SphereId id = 0; id < 30; ++id) {
    const Path& stored = simulation.world().path(simulation.world().slot_of(id));
    EXPECT_EQ(paths[id], (RecordedPath{stored.position, stored.velocity, stored.time.value()}));
  }
}

// Taken with a thermostat, the kinetic part of the pressure follows the velocities that it gives, and the
// theory of a fixed energy is not claimed.
TEST(SimulationWithThermostat, IsFollowedByThePressure) {
  World world(Box::periodic({10, 10, 10}));
  world.add({{2, 2, 2}, {1, 1, 0}, 0.5, 1});
  world.add({{7, 7, 7}, {3, 1, 0}, 0.5, 1});
  Simulation simulation(world);
  simulation.set_thermostat(Thermostat(Rescale(12, 1)));
  Measures measures({.names = {"pressure"}});
  simulation.run_until(1.5, measures);
  ASSERT_EQ(simulation.counters().collision, 0U);
  // Relative to the drift sum m v^2 is 2 for one unit of time, then 3 * 12 for half a unit.
  const Measurement pressure = measures.results(simulation.world(), simulation.now())[0];
  EXPECT_NEAR(pressure.quantities[1].value, (2 + 36 / 2) / 1.5 / 3000, 1e-15);
}

// Even if it has restored the energy of the start.
TEST(SimulationWithThermostat, IsNoEquilibriumOfAFixedEnergy) {
  for (const bool is_driven : {false, true}) {
    Simulation simulation(support::interacting(support::make_gas({.count = 200, .packing_fraction = 0.2}),
                                               Restitution(is_driven ? 0.9 : 1)));
    const double energy = simulation.tally().initial_energy();
    if (is_driven) simulation.set_thermostat(Thermostat(Rescale(2 * energy / (3 * 199), 1)));
    Measures measures({.names = {"pressure", "temperature"}});
    simulation.run_until(2, measures);
    ASSERT_NEAR(kinetic_energy(simulation.world(), simulation.now()), energy, 1e-10 * energy);
    const auto results = measures.results(simulation.world(), simulation.now());
    EXPECT_EQ(std::isnan(results[0].quantities[0].theory), is_driven);
    EXPECT_EQ(results[1].quantities[0].error == 0, !is_driven);
  }
}

// Andersen's thermostat changes the drift, which does not count.
TEST(SimulationWithThermostat, ChangesTheDriftToWhichPressureIsRelative) {
  Simulation simulation(support::make_gas({.count = 20, .packing_fraction = 1e-6}));
  for (SphereId id = 0; id < 20; ++id) {
    simulation.change_velocity(id, simulation.velocity(id) + Vec3{5, 0, 0});
  }
  simulation.set_thermostat(Thermostat(Andersen(1, 1000)));
  Measures measures({.names = {"pressure"}, .from = 0});
  simulation.run_until(1, measures);
  const double volume = simulation.world().box().volume();
  const Measurement pressure = measures.results(simulation.world(), simulation.now())[0];
  // kT (N - 1) / V; of 20,000 velocities the mean square is known to 0.6%, and the start lasts 0.001.
  EXPECT_NEAR(pressure.quantities[1].value * volume / 19, 1, 0.1);
}

}  // namespace
}  // namespace hardball::thermostat_test
