// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The number of threads that work on a simulation.
#include <gtest/gtest.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/interaction/bounce.hpp"
#include "hardball/interaction/merging.hpp"
#include "hardball/measure/measures.hpp"
#include "hardball/simulation/simulation.hpp"
#include "support/gas.hpp"
#include "support/refusal.hpp"

namespace hardball::threads_test {
namespace {

using namespace support;

World gas() {
  return make_gas({.count = 500, .packing_fraction = 0.2, .seed = 77});
}

ResponseTable merging() {
  return ResponseTable(Merging(), Bounce());
}

TEST(Threads, CanBeChangedBetweenRuns) {
  Simulation expected(gas());
  Simulation simulation(gas());
  for (int piece = 1; piece <= 4; ++piece) {
    simulation.set_threads(static_cast<std::size_t>(piece) % 3 + 1);
    EXPECT_EQ(simulation.options().threads, static_cast<std::size_t>(piece) % 3 + 1);
    simulation.run_until(0.2 * piece);
    expected.run_until(0.2 * piece);
    EXPECT_EQ(simulation.event_log_hash(), expected.event_log_hash());
    EXPECT_EQ(simulation.positions(), expected.positions());
    EXPECT_EQ(simulation.counters().collision, expected.counters().collision);
    simulation.validate();
  }
}

TEST(Threads, OfALoadedSimulationAreOneAtFirst) {
  Simulation simulation(gas(), {.threads = 2});
  simulation.run_until(0.1);
  Simulation loaded = Simulation::load(simulation.save());
  EXPECT_EQ(loaded.options().threads, 1U);
  loaded.set_threads(2);
  loaded.run_until(0.3);
  simulation.run_until(0.3);
  EXPECT_EQ(loaded.event_log_hash(), simulation.event_log_hash());
}

TEST(Threads, AreRefusedWhereTheyWouldFloodTheMachine) {
  EXPECT_EQ(problem_of([] { Simulation many(gas(), {.threads = 1025}); }), "there are to be 1025 threads");
  Simulation one(gas());
  EXPECT_EQ(problem_of([&] { one.set_threads(std::size_t{1} << 40); }),
            "there are to be 1099511627776 threads");
}

TEST(Threads, AreRefusedWhereTheyCannotShareTheWork) {
  World world = gas();
  world.set_interactions(merging());
  EXPECT_EQ(problem_of([&] { Simulation two(world, {.threads = 2}); }),
            "threads cannot share spheres that merge");
  Simulation one(world);
  EXPECT_EQ(problem_of([&] { one.set_threads(2); }), "threads cannot share spheres that merge");
  Simulation as_many_as_pay(world, {.threads = 0});
  as_many_as_pay.run_until(0.1);
  one.run_until(0.1);
  EXPECT_EQ(as_many_as_pay.event_log_hash(), one.event_log_hash());
  Simulation two(gas(), {.threads = 2});
  EXPECT_EQ(problem_of([&] { two.respond_with(merging()); }), "threads cannot share spheres that merge");
  const auto elastic = [](const Contact& contact) { return Outcome(contact, contact.after); };
  EXPECT_EQ(problem_of([&] { two.respond_with(elastic); }),
            "threads cannot share a response that is a function");
  two.run_until(0.1);
  two.set_threads(1);
  two.respond_with(elastic);
}

// Domains with shallow halos, of which windows fail.
constexpr Division kShallow{.domains = 3, .threads = 2, .halo = 1.05, .window = 0.2, .first_window = 0.2};

TEST(Threads, MeasureWhatOneThreadMeasures) {
  const ResponseTable rough(
      Bounce(BounceRules{.restitution = ConstantRestitution{0.9}, .tangential_restitution = 0.5}));
  for (const bool is_rough : {false, true}) {
    World world = gas();
    if (is_rough) world.set_interactions(rough);
    std::vector<std::string> names{"all"};
    if (!is_rough) names.insert(names.end(), {"diffusion", "viscosity"});
    const MeasureSettings settings{.names = names, .every = 0.03, .from = 0.05};
    Simulation expected(world);
    Simulation simulation(world, {.division = kShallow});
    Measures one(settings);
    Measures several(settings);
    for (int piece = 1; piece <= 4; ++piece) {
      const RunLimits limits{.until = Time(0.1 * piece), .contacts = piece == 2 ? 100U : 100000U};
      expected.run(limits, one);
      simulation.run(limits, several);
      EXPECT_TRUE(several.save() == one.save()) << piece;
      EXPECT_EQ(simulation.event_log_hash(), expected.event_log_hash());
      EXPECT_EQ(simulation.positions(), expected.positions());
      EXPECT_EQ(simulation.world().has_spins(), expected.world().has_spins());
    }
    EXPECT_EQ(expected.world().has_spins(), is_rough);
    EXPECT_GT(simulation.windows().failed, 0U);
  }
}

// A listener sees the world as it is at its contact, and sums over the contacts up to it, also if measures
// are told of them, too.
TEST(Threads, ShowListenersWhatOneThreadShows) {
  const auto seen_by_listener = [](Simulation simulation, bool is_measured) {
    std::vector<std::pair<std::uint64_t, Vec3>> seen;
    simulation.on_contact([&](const Contact& contact) {
      seen.emplace_back(simulation.event_log_hash(),
                        simulation.world().velocity(contact.first, contact.time));
    });
    Measures measures({.names = {"pressure"}, .every = 0.1});
    if (is_measured) {
      simulation.run_until(0.3, measures);
    } else {
      simulation.run_until(0.3);
    }
    return seen;
  };
  const auto expected = seen_by_listener(Simulation(gas()), false);
  EXPECT_GT(expected.size(), 100U);
  EXPECT_TRUE(seen_by_listener(Simulation(gas(), {.division = kShallow}), false) == expected);
  EXPECT_TRUE(seen_by_listener(Simulation(gas(), {.division = kShallow}), true) == expected);
}

TEST(Threads, LogContactsInTheOrderOfOneThread) {
  const auto contacts_of = [](Simulation simulation) {
    std::vector<std::pair<Time, SphereId>> logged;
    simulation.observe(
        {.contact = [&](const Contact& contact) { logged.emplace_back(contact.time, contact.first); }});
    simulation.run_until(0.2);
    simulation.run_contacts(50);
    return logged;
  };
  const auto expected = contacts_of(Simulation(gas()));
  EXPECT_GT(expected.size(), 100U);
  EXPECT_TRUE(contacts_of(Simulation(gas(), {.division = kShallow})) == expected);
}

TEST(Threads, GoOnAfterALogHasThrown) {
  Simulation expected(gas());
  expected.run_until(0.3);
  for (const EngineOptions& options : {EngineOptions(), EngineOptions{.division = kShallow}}) {
    Simulation simulation(gas(), options);
    std::uint64_t logged = 0;
    simulation.observe({.contact = [&](const Contact&) {
      if (++logged == 20) throw std::runtime_error("the disk is full");
    }});
    EXPECT_THROW(simulation.run_until(0.3), std::runtime_error);
    EXPECT_EQ(logged, 20U);
    EXPECT_GE(simulation.counters().contacts(), 20U);
    EXPECT_EQ(simulation.counters().contacts(), simulation.tally().collisions());
    simulation.run_until(0.3);
    EXPECT_EQ(simulation.event_log_hash(), expected.event_log_hash());
    EXPECT_EQ(simulation.positions(), expected.positions());
  }
}

TEST(Threads, RefuseToShowALogTheWorld) {
  Simulation simulation(gas(), {.division = kShallow});
  simulation.observe({.contact = [&](const Contact&) { static_cast<void>(simulation.world()); }});
  EXPECT_EQ(problem_of([&] { simulation.run_until(0.3); }),
            "contacts are logged when later ones have happened");
}

// Every sphere is in one block; the blocks touch.
TEST(Threads, DivideTheBoxIntoBlocks) {
  Simulation simulation(gas(), {.threads = 3});
  simulation.run_until(0.2);
  const std::vector<Block> blocks = simulation.blocks();
  ASSERT_EQ(blocks.size(), 3U);
  std::vector<std::size_t> spheres(3);
  for (const Vec3& position : simulation.positions()) {
    std::size_t held = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (!(blocks[k].distance(position) < 0)) continue;
      ++spheres[k];
      ++held;
    }
    EXPECT_EQ(held, 1U);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(static_cast<double>(spheres[k]), 500 / 3.0, 25) << k;
    EXPECT_LE(blocks[k].distance(blocks[(k + 1) % 3]), 0);
  }
}

TEST(Threads, OfANumberOfOneHaveOneBlockAndNoWindows) {
  Simulation simulation(gas());
  simulation.run_until(0.2);
  ASSERT_EQ(simulation.blocks().size(), 1U);
  EXPECT_EQ(simulation.blocks()[0], Block(simulation.world().box()));
  EXPECT_EQ(simulation.windows(), WindowCounters());
}

TEST(Threads, CountTheirWindows) {
  // Windows of so many contacts fail, as halos are shallow.
  const Division division{.domains = 2, .halo = 1.05, .window = 2, .first_window = 2};
  Simulation simulation(gas(), {.division = division});
  simulation.run_until(0.2);
  const WindowCounters windows = simulation.windows();
  EXPECT_GT(windows.windows, windows.steps);
  EXPECT_GT(windows.failed, 0U);
  const Simulation copy = simulation;
  EXPECT_EQ(copy.windows(), windows);
  // Looking ahead has the domains made anew.
  EXPECT_FALSE(simulation.contacts_within(0.01).empty());
  simulation.run_until(0.3);
  const WindowCounters later = simulation.windows();
  EXPECT_GT(later.windows, windows.windows);
  EXPECT_GE(later.failed, windows.failed);
  simulation.set_threads(1);
  EXPECT_EQ(simulation.windows(), later);
  simulation.run_until(0.4);
  EXPECT_EQ(simulation.windows(), later);
}

// A window has .02 contacts for each sphere, two spheres being in each, or twice as many where domains are
// small and spheres fly only a little way meanwhile.
TEST(Threads, HaveLongerWindowsWhereDomainsAreSmallAndSpheresAreDense) {
  const auto contacts_in_window = [](double packing_fraction) {
    Simulation simulation(make_gas({.count = 4000, .packing_fraction = packing_fraction, .seed = 78}),
                          {.division = Division{.domains = 2, .halo = 3}});
    simulation.run_contacts(4000);
    const double before = static_cast<double>(simulation.windows().windows);
    simulation.run_contacts(8000);
    return 8000 / (static_cast<double>(simulation.windows().windows) - before);
  };
  EXPECT_NEAR(contacts_in_window(0.3), 80, 8);
  EXPECT_NEAR(contacts_in_window(0.01), 40, 8);
}

TEST(Threads, DoNotKeepOthersFromQueriesAtTheSameTime) {
  Simulation simulation(gas(), {.threads = 2});
  Simulation expected(gas());
  expected.run_until(0.2);
  simulation.run_until(0.2);
  const Simulation& shared = simulation;
  std::vector<std::vector<Vec3>> found(4);
  std::vector<std::thread> threads;
  for (std::vector<Vec3>& positions : found)
    threads.emplace_back([&positions, &shared] { positions = shared.positions(); });
  for (std::thread& thread : threads) thread.join();
  for (const std::vector<Vec3>& positions : found) EXPECT_EQ(positions, expected.positions());
}

}  // namespace
}  // namespace hardball::threads_test
