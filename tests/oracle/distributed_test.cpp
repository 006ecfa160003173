// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Worlds that several processes run together, played by threads: the history, the sums and the spheres of one
// engine that compares all pairs, to the last bit.
#include "hardball/simulation/simulation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/measure/measures.hpp"
#include "hardball/processes/bytes.hpp"
#include "hardball/world/totals.hpp"
#include "support/effort.hpp"
#include "support/gas.hpp"
#include "support/interacting.hpp"
#include "support/random_world.hpp"
#include "support/refusal.hpp"
#include "support/thread_processes.hpp"

namespace hardball::distributed_test {
namespace {

using namespace support;

struct Setting {
  std::size_t processes;
  Division division;  // of each process
};

const std::vector<Setting>& settings() {
  static const std::vector<Setting> all{{2, {.domains = 1, .halo = 1.05, .window = 0.5}},
                                        {3, {.domains = 1, .halo = 1.75, .window = 0.1}},
                                        {2, {.domains = 3, .threads = 2, .halo = 1.3, .window = 2}},
                                        {5, {.domains = 2, .halo = 2, .window = 0.02}}};
  return all;
}

// The spheres of all blocks.
std::vector<SphereTransfer> gathered(const Simulation& simulation) {
  std::string own;
  for (const std::vector<SphereTransfer>& block : simulation.own_blocks()) own += bytes_of(block);
  std::vector<SphereTransfer> all;
  for (const std::string& part : simulation.processes().gather(own)) append_bytes(part, all);
  std::ranges::sort(all, {}, [](const SphereTransfer& transfer) { return transfer.state.id; });
  return all;
}

void expect_same_state(const Simulation& simulation, const Simulation& expected) {
  ASSERT_EQ(simulation.sums().hash.value(), expected.event_log_hash());
  ASSERT_EQ(simulation.now(), expected.now());
  ASSERT_EQ(simulation.counters().collision, expected.counters().collision);
  ASSERT_EQ(simulation.counters().wall, expected.counters().wall);
  const Tally tally = simulation.sums().tally;
  ASSERT_EQ(tally.virial(), expected.tally().virial());
  ASSERT_EQ(tally.initial_energy(), expected.tally().initial_energy());
  ASSERT_EQ(tally.max_overlap(), expected.tally().max_overlap());
  const Totals totals = simulation.totals();
  ASSERT_EQ(totals.energy.value(), energy(expected.world(), expected.now()));
  ASSERT_EQ(totals.total_momentum(), momentum(expected.world(), expected.now()));
  const std::vector<SphereTransfer> spheres = gathered(simulation);
  ASSERT_EQ(spheres.size(), expected.size());
  for (const SphereTransfer& transfer : spheres)
    ASSERT_EQ(transfer.state, expected.world().state_of(expected.world().slot_of(transfer.state.id)));
}

// Whether processes bring a part of the world each, or all of it.
enum class Brought { parts, whole };

Simulation start(Processes& processes, const World& world, const EngineOptions& options = {},
                 Brought brought = Brought::parts) {
  if (brought == Brought::whole) return Simulation(world, options, processes);
  World part = world.without_spheres();
  for (Slot slot = 0; slot < world.size(); ++slot) {
    if (world.id(slot) % processes.size() == processes.rank()) part.insert(world.state_of(slot));
  }
  return Simulation::from_parts(part, options, processes);
}

class Distributed : public testing::TestWithParam<std::uint64_t> {};

constexpr std::uint64_t kWorlds = 60;
constexpr std::uint64_t kParts = 4;

TEST_P(Distributed, HasTheHistoryOfAllPairs) {
  for (std::uint64_t seed = GetParam(); seed < cases(kWorlds); seed += kParts) {
    const RandomWorld made = any_world(seed);
    if (made.world.interactions().may_merge() || made.world.interactions().function()) continue;
    SCOPED_TRACE(made.name);
    const RunLimits limits{.until = Time(made.until), .contacts = 60 + 60 * (seed % 3)};
    Simulation expected(made.world, {.engine = EngineKind::all_pairs});
    std::vector<Contact> expected_log;
    expected.on_contact([&](const Contact& contact) { expected_log.push_back(contact); });
    std::string failure;
    RunStatus status = RunStatus::stopped;
    try {
      status = expected.run(limits);
    } catch (const RunFailure& failed) {
      failure = failed.what();
    }
    for (const Setting& setting : settings()) {
      SCOPED_TRACE(testing::Message() << setting.processes << " processes");
      // By a log, by a listener, or not at all.
      const bool is_observed = seed % 2 == 0;
      const bool is_listened_to = seed % 4 == 2;
      const Brought brought = seed % 3 == 0 ? Brought::whole : Brought::parts;
      std::vector<Contact> log;
      in_processes(setting.processes, [&](Processes& processes) {
        Simulation simulation = start(processes, made.world, {.division = setting.division}, brought);
        const auto note = [&](const Contact& contact) {
          if (processes.is_first()) log.push_back(contact);
        };
        if (is_listened_to) {
          simulation.on_contact([&](const Contact& contact) {
            EXPECT_EQ(simulation.velocity(contact.first), contact.after.first);
            note(contact);
          });
        } else if (is_observed) {
          simulation.observe({.contact = note});
        }
        try {
          ASSERT_EQ(simulation.run(limits), status);
        } catch (const RunFailure& failed) {
          ASSERT_EQ(failed.what(), failure);
          return;
        }
        ASSERT_EQ(failure, "");
        expect_same_state(simulation, expected);
        simulation.validate();
      });
      if (testing::Test::HasFatalFailure()) return;
      if (!is_observed || !failure.empty()) continue;
      ASSERT_EQ(log.size(), expected_log.size());
      for (std::size_t i = 0; i < log.size(); ++i) {
        ASSERT_EQ(log[i].time, expected_log[i].time) << "contact " << i;
        ASSERT_EQ(log[i].first, expected_log[i].first) << "contact " << i;
        ASSERT_EQ(log[i].second, expected_log[i].second) << "contact " << i;
        ASSERT_EQ(log[i].after, expected_log[i].after) << "contact " << i;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Part, Distributed, testing::Range<std::uint64_t>(0, kParts));

// A gas in pieces, saved and loaded between by other numbers of processes, and by one.
TEST(DistributedGas, ContinuesInAnyNumberOfProcesses) {
  const World world = make_gas({.count = 1000, .packing_fraction = 0.25, .seed = 3});
  Simulation expected(world);
  std::string saved;
  std::vector<std::string> blocks;
  const auto save = [&](const Simulation& simulation) {
    const std::string state = simulation.save_without_spheres();
    std::vector<std::vector<SphereTransfer>> own = simulation.own_blocks();
    if (!own.empty()) blocks.assign(1, Simulation::saved_block(own.front()));
    if (simulation.processes().is_first()) saved = state;
  };
  expected.run_until(0.1);
  in_processes(3, [&](Processes& processes) {
    Simulation simulation = start(processes, world);
    simulation.run({.until = Time(0.1)});
    expect_same_state(simulation, expected);
    save(simulation);
  });
  Simulation whole = Simulation::load_blocks(saved, blocks, "the saved state", one_process());
  double until = 0.1;
  for (const std::size_t count : {1U, 4U, 2U}) {
    until += 0.1;
    expected.run_until(until);
    const std::string before = saved;
    const std::vector<std::string> blocks_before = blocks;
    in_processes(count, [&](Processes& processes) {
      Simulation simulation = Simulation::load_blocks(
          before, processes.is_first() ? blocks_before : std::vector<std::string>(), "state", processes);
      simulation.run({.until = Time(until)});
      expect_same_state(simulation, expected);
      save(simulation);
    });
  }
  whole.run_until(until);
  EXPECT_EQ(whole.event_log_hash(), expected.event_log_hash());
  EXPECT_EQ(whole.positions(), expected.positions());
  in_processes(2, [&](Processes& processes) {
    Simulation simulation = Simulation::load(whole.save(), "state", processes);
    simulation.run({.until = Time(until + 0.1)});
    Simulation further = whole;
    further.run_until(until + 0.1);
    expect_same_state(simulation, further);
  });
}

// In pieces, one of which ends by the number of contacts; saved and loaded by others between.
TEST(DistributedGas, HasTheThermostatOfOneProcess) {
  const World world = make_gas({.count = 300, .packing_fraction = 0.2, .seed = 6});
  const std::vector<ThermostatKind> kinds{Andersen(1.5, 0.7), Rescale(2, 0.03), Heating(0.5, 0.02)};
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    SCOPED_TRACE(name_of(kinds[kind]));
    const Thermostat thermostat(kinds[kind], 7);
    Simulation expected(world);
    expected.set_thermostat(thermostat);
    std::vector<VelocityChange> expected_changes;
    expected.observe({.change = [&](const VelocityChange& change) { expected_changes.push_back(change); }});
    const std::vector<RunLimits> pieces{{.until = Time(0.1)}, {.contacts = 200}, {.until = Time(0.5)}};
    std::vector<Simulation> states;
    for (const RunLimits& piece : pieces) {
      expected.run(piece);
      states.push_back(expected);
    }
    std::string saved;
    std::vector<std::string> blocks;
    std::vector<VelocityChange> changes;
    const auto run = [&](Simulation simulation, std::size_t first, std::size_t last) {
      const bool is_first = simulation.processes().is_first();
      simulation.observe({.change = [&, is_first](const VelocityChange& change) {
        if (is_first) changes.push_back(change);
      }});
      for (std::size_t piece = first; piece <= last; ++piece) {
        simulation.run(pieces[piece]);
        expect_same_state(simulation, states[piece]);
        ASSERT_EQ(simulation.sums().tally.last_change(), states[piece].tally().last_change());
        ASSERT_EQ(simulation.thermostat()->energy(), states[piece].thermostat()->energy());
        ASSERT_EQ(simulation.thermostat()->events(), states[piece].thermostat()->events());
      }
      const std::string state = simulation.save_without_spheres();
      const std::vector<std::vector<SphereTransfer>> own = simulation.own_blocks();
      if (!simulation.processes().is_first()) return;
      saved = state;
      blocks.assign(1, Simulation::saved_block(own.front()));
    };
    in_processes(3, [&](Processes& processes) {
      Simulation simulation =
          start(processes, world, {.division = Division{.domains = 1, .halo = 1.3, .window = 0.5}});
      simulation.set_thermostat(thermostat);
      run(std::move(simulation), 0, 1);
    });
    Simulation whole = Simulation::load_blocks(saved, blocks, "the saved state", one_process());
    whole.run(pieces[2]);
    EXPECT_EQ(whole.event_log_hash(), expected.event_log_hash());
    EXPECT_EQ(whole.positions(), expected.positions());
    const std::string before = saved;
    const std::vector<std::string> blocks_before = blocks;
    in_processes(2, [&](Processes& processes) {
      run(Simulation::load_blocks(before, processes.is_first() ? blocks_before : std::vector<std::string>(),
                                  "state", processes),
          2, 2);
    });
    ASSERT_EQ(changes.size(), expected_changes.size());
    EXPECT_GT(changes.size(), 50U);
    for (std::size_t k = 0; k < changes.size(); ++k) {
      ASSERT_EQ(changes[k].time, expected_changes[k].time);
      ASSERT_EQ(changes[k].sphere, expected_changes[k].sphere);
      ASSERT_EQ(changes[k].position, expected_changes[k].position);
      ASSERT_EQ(changes[k].after, expected_changes[k].after);
    }
    in_processes(
        2, [&](Processes& processes) { run(Simulation::load(states[1].save(), "state", processes), 2, 2); });
  }
}

// A system that is too large for one process.
TEST(DistributedGas, HoldsAllSpheresOnlyWhereSomebodyAsks) {
  const World world = make_gas({.count = 400, .packing_fraction = 0.2, .seed = 8});
  Simulation expected(world);
  expected.run_until(0.3);
  in_processes(2, [&](Processes& processes) {
    Simulation simulation = start(processes, world);
    Measures none({.names = {}});
    simulation.run_until(0.3, none);
    EXPECT_EQ(simulation.totals().kinetic_energy.value(), kinetic_energy(expected.world(), expected.now()));
    EXPECT_TRUE(simulation.audit().is_sound());
    static_cast<void>(simulation.save_without_spheres());
    static_cast<void>(simulation.own_blocks());
    EXPECT_EQ(simulation.setting().size(), 0U);
    EXPECT_EQ(simulation.positions(), expected.positions());
    EXPECT_EQ(simulation.setting().size(), world.size());
  });
}

// The first process is asked.
TEST(DistributedGas, StopsWhereTheFirstProcessIsTold) {
  const World world = make_gas({.count = 200, .packing_fraction = 0.25, .seed = 4});
  in_processes(2, [&](Processes& processes) {
    Simulation simulation = start(processes, world);
    int asked = 0;
    const RunStatus status =
        simulation.run({.until = Time(100), .stop = [&] { return ++asked == 5 && processes.is_first(); }});
    EXPECT_EQ(status, RunStatus::stopped);
    EXPECT_EQ(asked, processes.is_first() ? 5 : 0);
    Simulation expected(world);
    expected.run_until(simulation.time());
    EXPECT_EQ(simulation.sums().hash.value(), expected.event_log_hash());
  });
}

TEST(DistributedGas, RefusesWhatProcessesCannotShare) {
  in_processes(2, [](Processes& processes) {
    World overlapping(Box::periodic({10, 10, 10}));
    overlapping.add({{1, 1, 1}, {1, 0, 0}, 1, 1});
    overlapping.add({{2, 1, 1}, {1, 0, 0}, 1, 1});
    EXPECT_THROW(start(processes, overlapping), Error);
    EXPECT_THROW(start(processes, overlapping, {}, Brought::whole), Error);
    World merging(Box::periodic({10, 10, 10}));
    merging.add({{1, 1, 1}, {1, 0, 0}, 1, 1});
    const World gas = make_gas({.count = 20, .packing_fraction = 0.1, .seed = 5});
    EXPECT_THROW(start(processes, gas, {.engine = EngineKind::paper}), Error);
    EXPECT_THROW(start(processes, gas, {.engine = EngineKind::all_pairs}), Error);
    merging.set_interactions(ResponseTable(Merging(), Bounce()));
    const auto problem_of = [&](const World& world) {
      return support::problem_of([&] { static_cast<void>(start(processes, world)); });
    };
    EXPECT_EQ(problem_of(merging), "processes cannot share spheres that merge");
    const World stepping = interacting(gas, support::stepping({.steps = {{.ratio = 1.2, .energy = -1}}}));
    EXPECT_EQ(problem_of(stepping), "processes cannot share spheres with potentials of steps");
    Box sheared = Box::periodic({10, 10, 10});
    sheared.set_shear({.rate = 0.1});
    EXPECT_EQ(problem_of(World(sheared)), "processes cannot share a sheared box");
  });
}

}  // namespace
}  // namespace hardball::distributed_test
