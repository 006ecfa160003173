// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Runs that RunLimits::stop ends.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "hardball/archive/archive.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/hardball.hpp"
#include "support/effort.hpp"
#include "support/history.hpp"
#include "support/random_world.hpp"

namespace hardball::stopped_run_test {
namespace {

const std::vector<EngineKind> kEngines{EngineKind::cells, EngineKind::neighbors, EngineKind::all_pairs,
                                       EngineKind::paper};

// Two spheres whose paths never meet, in a periodic box or in open space.
World lone_pair(const Box& box) {
  World world(box);
  world.add({{2, 2, 2}, {1, 0.25, 0}, 0.5});
  world.add({{6, 6, 6}, {-1, 0.125, 0}, 0.5});
  return world;
}

World gas() {
  World world(Box::periodic({10, 10, 10}));
  for (int i = 0; i < 27; ++i) {
    const Vec3 cell{1.0 * (i % 3), 1.0 * (i / 3 % 3), 1.0 * (i / 9)};
    world.add({{1 + 3 * cell.x, 1 + 3 * cell.y, 1 + 3 * cell.z},
               {0.7 - cell.y, 0.4 * cell.z - 0.3, 0.9 - 0.8 * cell.x},
               1});
  }
  return world;
}

// Runs on and on, stopped as often as the run asks, which is when it has got somewhere; returns how often.
int run_in_stops(Simulation& simulation, RunLimits limits, Measures& measures) {
  for (int stops = 0;; ++stops) {
    bool has_advanced = false;
    limits.stop = [&] { return std::exchange(has_advanced, true); };
    const std::uint64_t before = simulation.counters().contacts();
    const RunStatus status = simulation.run(limits, measures);
    limits.contacts -= simulation.counters().contacts() - before;
    if (status != RunStatus::stopped) return stops;
  }
}

TEST(StoppedRun, BeforeItBeginsDoesNothing) {
  for (const EngineKind engine : kEngines) {
    Simulation simulation(gas(), {.engine = engine});
    const RunLimits limits{.until = Time(1), .stop = [] { return true; }};
    EXPECT_EQ(simulation.run(limits), RunStatus::stopped);
    Measures measures;
    EXPECT_EQ(simulation.run(limits, measures), RunStatus::stopped);
    EXPECT_FALSE(measures.has_begun());
    ASSERT_TRUE(simulation.next_contact(9)) << "the engine goes ahead, not the time";
    EXPECT_EQ(simulation.run(limits), RunStatus::stopped);
    EXPECT_EQ(simulation.time(), 0);
    EXPECT_EQ(simulation.counters().contacts(), 0U);
    EXPECT_EQ(simulation.run({.until = Time(1), .stop = [] { return false; }}), RunStatus::time_reached);
    EXPECT_EQ(simulation.time(), 1);
  }
}

TEST(StoppedRun, EndsSoonAfterAnotherThreadHasAskedForIt) {
  using namespace std::chrono_literals;
  for (const EngineKind engine : kEngines) {
    for (const World& world : {gas(), lone_pair(Box::periodic({10, 10, 10}))}) {
      Simulation simulation(world, {.engine = engine});
      std::atomic<bool> is_enough = false;
      const std::jthread other([&] {
        std::this_thread::sleep_for(30ms);
        is_enough = true;
      });
      EXPECT_EQ(simulation.run({.stop = [&] { return is_enough.load(); }}), RunStatus::stopped);
      EXPECT_GT(simulation.time(), 0);
      simulation.validate();
    }
  }
}

TEST(StoppedRun, EndsWhereNothingEverMeets) {
  for (const Box& box : {Box::open(), Box::periodic({10, 10, 10})}) {
    for (const EngineKind engine : {EngineKind::cells, EngineKind::paper}) {
      Simulation simulation(lone_pair(box), {.engine = engine, .cell_edge = 3.0});
      double asked_at = -1;
      int asked = 0;
      const auto stop = [&] {
        EXPECT_GT(simulation.time(), asked_at) << "it tells how far the run has got";
        asked_at = simulation.time();
        return ++asked == 5;
      };
      EXPECT_EQ(simulation.run({.until = Time(1e30), .stop = stop}), RunStatus::stopped);
      EXPECT_EQ(simulation.time(), asked_at);
      EXPECT_EQ(simulation.counters().contacts(), 0U);
    }
  }
}

TEST(StoppedRun, IsRunOnToTheSameHistory) {
  int stops = 0;
  for (std::uint64_t seed = 0; seed < support::cases(60); ++seed) {
    const support::RandomWorld made = support::make_random_world(seed);
    SCOPED_TRACE(made.name);
    const RunLimits limits{.until = Time(200 * made.until), .contacts = 10000};
    const auto history_of = [&](bool is_stopped) {
      Simulation simulation(made.world);
      Measures none({.names = {}});
      if (is_stopped) stops += run_in_stops(simulation, limits, none);
      return support::run_on(simulation, is_stopped ? RunLimits{.contacts = 0} : limits);
    };
    support::History expected;
    ASSERT_NO_THROW(expected = history_of(false));
    if (!expected.failure.empty()) continue;
    EXPECT_EQ(support::difference(history_of(true), expected), "");
  }
  EXPECT_GT(stops, 20);
}

TEST(StoppedRun, LeavesThermostatAndMeasuresAsTheyWouldBe) {
  for (const EngineKind engine : {EngineKind::cells, EngineKind::all_pairs}) {
    const RunLimits limits{.until = Time(1000)};
    const auto outcome_of = [&](bool is_stopped) {
      Simulation simulation(gas(), {.engine = engine});
      simulation.set_thermostat(Thermostat(Andersen(1, 0.5), 7));
      Measures measures({.names = {"pressure", "velocity_autocorrelation"}, .every = 0.37});
      if (is_stopped) {
        EXPECT_GT(run_in_stops(simulation, limits, measures), 3);
      } else {
        simulation.run(limits, measures);
      }
      return std::pair(simulation.event_log_hash(), archived(measures, *simulation.thermostat()));
    };
    EXPECT_EQ(outcome_of(true), outcome_of(false));
  }
}

TEST(StoppedRun, MayBeQueriedAndNotEditedByWhoStopsIt) {
  Simulation simulation(gas());
  const auto stop = [&] {
    EXPECT_EQ(simulation.positions().size(), 27U);
    for (const auto& call :
         std::vector<std::function<void()>>{[&] { simulation.remove(0); }, [&] { simulation.run_until(1); },
                                            [&] { simulation.next_contact(); }}) {
      EXPECT_THROW(call(), Error);
    }
    return false;
  };
  EXPECT_EQ(simulation.run({.until = Time(1), .stop = stop}), RunStatus::time_reached);
  const auto fail = []() -> bool { throw std::runtime_error("enough"); };
  EXPECT_THROW(simulation.run({.until = Time(2), .stop = fail}), std::runtime_error);
  simulation.run_until(2);
  Simulation undisturbed(gas());
  undisturbed.run_until(2);
  EXPECT_EQ(simulation.event_log_hash(), undisturbed.event_log_hash());
}

}  // namespace
}  // namespace hardball::stopped_run_test
