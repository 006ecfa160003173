// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/simulation/simulation.hpp"

#include <gtest/gtest.h>
#include <algorithm>
#include <functional>

#include "hardball/errors/error.hpp"
#include "hardball/hardball.hpp"
#include "support/effort.hpp"
#include "support/history.hpp"
#include "support/random_world.hpp"
#include "support/refusal.hpp"

namespace hardball::simulation_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

World head_on_pair() {
  World world(Box::walls({20, 10, 10}));
  world.add({{5, 5, 5}, {1, 0, 0}, 1, 1});
  world.add({{15, 5, 5}, {-1, 0, 0}, 1, 1});
  return world;
}

// Whatever was tried with the pair has changed nothing.
void expect_undisturbed(const Simulation& simulation) {
  Simulation undisturbed(head_on_pair());
  undisturbed.run_until(simulation.time());
  EXPECT_EQ(simulation.event_log_hash(), undisturbed.event_log_hash());
}

std::vector<EngineKind> all_engines() {
  return {EngineKind::cells, EngineKind::neighbors, EngineKind::all_pairs, EngineKind::paper};
}

TEST(Simulation, IsEmbeddedInAFewLines) {
  World world(Box::periodic({10, 10, 10}));
  world.add({{2, 5, 5}, {1, 0, 0}});
  world.add({{7, 5, 5}, {0, 0, 0}});
  Simulation simulation(world);
  std::vector<double> times;
  simulation.on_contact([&](const Contact& contact) { times.push_back(contact.time.value()); });
  simulation.run_until(12);
  EXPECT_EQ(times, (std::vector<double>{3, 9}));
  EXPECT_EQ(simulation.time(), 12);
  EXPECT_EQ(simulation.position(0), (Vec3{8, 5, 5}));
  EXPECT_EQ(simulation.velocity(1), (Vec3{0, 0, 0}));
}

TEST(Simulation, WithoutSpheresJustLetsTimePass) {
  for (const EngineKind engine : all_engines()) {
    for (const Box& box : {Box::open(), Box::periodic({1, 1, 1}), Box::walls({1, 1, 1})}) {
      Simulation simulation(World(box), {.engine = engine});
      EXPECT_EQ(simulation.next_contact(), std::nullopt);
      EXPECT_EQ(simulation.run({}), RunStatus::time_reached);
      simulation.run_until(5);
      EXPECT_EQ(simulation.time(), 5);
      EXPECT_TRUE(simulation.positions().empty());
      EXPECT_TRUE(simulation.positions_at(7).empty());
      simulation.validate();
      EXPECT_EQ(simulation.add({{0.5, 0.5, 0.5}, {1, 0, 0}, 0.25, 1}), 0U) << "it can be filled later";
      simulation.run_until(5.5);
      EXPECT_EQ(simulation.velocity(0), (Vec3{box.is_wall(0) ? -1.0 : 1.0, 0, 0}));
    }
  }
}

TEST(Simulation, WithOneSphereBouncesWithAnExactPeriod) {
  for (const EngineKind engine : all_engines()) {
    World world(Box::walls({10, 10, 10}));
    world.add({{5, 5, 5}, {2, 0, 0}, 1, 1});
    Simulation simulation(world, {.engine = engine});
    double expected = 2;
    simulation.on_contact([&](const Contact& contact) {
      EXPECT_EQ(contact.time, Time(expected));
      expected += 4;
    });
    EXPECT_EQ(simulation.run_contacts(100), 100U);
    EXPECT_EQ(simulation.time(), 398);
  }
}

TEST(Simulation, PredictsTheNextContactAnyNumberOfTimes) {
  Simulation simulation(head_on_pair());
  EXPECT_EQ(simulation.next_contact(3.5), std::nullopt);
  for (int i = 0; i < 2; ++i) {
    const std::optional<NextContact> next = simulation.next_contact();
    ASSERT_TRUE(next);
    EXPECT_EQ(next->time, 4);
    EXPECT_EQ(next->kind, EventKind::collision);
    EXPECT_EQ(next->first, 0U);
    EXPECT_EQ(next->second, 1U);
  }
  EXPECT_EQ(simulation.time(), 0);
  simulation.run_until(4);
  const std::optional<NextContact> wall = simulation.next_contact();
  ASSERT_TRUE(wall);
  EXPECT_EQ(wall->time, 12);
  EXPECT_EQ(wall->kind, EventKind::wall);
  EXPECT_EQ(wall->second, face_of(0, false));
}

// Times are finer than doubles, yet a run to the double returned for the next contact reaches it.
TEST(Simulation, RunToTheNextContactCarriesItOut) {
  for (std::uint64_t seed = 0; seed < support::cases(200); ++seed) {
    const support::RandomWorld made = support::make_random_world(seed);
    SCOPED_TRACE(made.name);
    Simulation simulation(made.world, {});
    for (int i = 0; i < 30; ++i) {
      const std::optional<NextContact> next = simulation.next_contact(made.until);
      if (!next) break;
      const std::uint64_t before = simulation.counters().contacts();
      ASSERT_EQ(simulation.positions_at(next->time).size(), simulation.size());
      simulation.run({.until = Time(next->time), .contacts = 1});
      ASSERT_EQ(simulation.counters().contacts(), before + 1);
    }
  }
}

TEST(Simulation, RunWithoutEndStopsAtTheLastContact) {
  for (const EngineKind engine : all_engines()) {
    // At rest after a perfectly inelastic bounce: no event is left, in spite of the walls.
    World world(Box::walls({20, 10, 10}));
    world.add({{5, 5, 5}, {-1, 0, 0}, 1, 1});
    world.set_interactions(Restitution(0));
    Simulation simulation(world, {.engine = engine});
    EXPECT_EQ(simulation.run({}), RunStatus::time_reached);
    EXPECT_EQ(simulation.time(), 4);
    EXPECT_EQ(simulation.velocity(0), (Vec3{0, 0, 0}));
    // A prediction of the next contact advances the engine, not the time.
    simulation.change_velocity(0, {0.25, 0, 0});
    EXPECT_TRUE(simulation.next_contact());
    EXPECT_EQ(simulation.run_contacts(0), 0U);
    EXPECT_EQ(simulation.time(), 4);
  }
}

TEST(Simulation, PositionsAtAreThoseOfTheRunThatFollows) {
  for (std::uint64_t seed = 0; seed < support::cases(200); ++seed) {
    const support::RandomWorld made = support::make_random_world(seed);
    Simulation simulation(made.world);
    // A sphere that just fits between two walls bounces infinitely often at one moment.
    if (!support::run_on(simulation, {.until = Time(made.until / 2), .contacts = 10}).failure.empty())
      continue;
    const std::optional<NextContact> next = simulation.next_contact(made.until);
    if (next && next->time == simulation.time()) continue;
    const double end = next ? next->time : made.until;
    const double between = simulation.time() + 0.5 * (end - simulation.time());
    const std::vector<Vec3> positions = simulation.positions_at(between);
    simulation.run_until(between);
    ASSERT_EQ(simulation.positions(), positions) << made.name;
  }
}

TEST(Simulation, RefusesTimesInThePastAndBeyondTheNextContact) {
  Simulation simulation(head_on_pair());
  simulation.run_until(1);
  for (const double bad : {0.5, -1.0, kNan}) {
    EXPECT_THROW(simulation.run_until(bad), Error);
    EXPECT_THROW(simulation.next_contact(bad), Error);
    EXPECT_THROW(simulation.positions_at(bad), Error);
    EXPECT_THROW(simulation.run_contacts(1, bad), Error);
  }
  for (const double bad : {kInfinity, 1e300, -kInfinity, kNan}) {
    EXPECT_THROW(simulation.positions_at(bad), Error);
    EXPECT_THROW(Simulation(World()).positions_at(bad), Error);
  }
  for (const double bad : {1e300, -kInfinity, kNan}) {
    EXPECT_THROW(simulation.run_until(bad), Error);
    EXPECT_THROW(simulation.next_contact(bad), Error);
    EXPECT_THROW(simulation.run({.until = Time(1, bad)}), Error);
  }
  EXPECT_THROW(simulation.positions_at(4.5), Error);
  EXPECT_NO_THROW(simulation.positions_at(4));
  EXPECT_NO_THROW(simulation.run_until(1));
  EXPECT_EQ(simulation.time(), 1);
}

TEST(Simulation, RefusesUnknownSpheresAndBadEdits) {
  Simulation simulation(head_on_pair());
  EXPECT_THROW(simulation.position(2), Error);
  EXPECT_THROW(simulation.velocity(2), Error);
  EXPECT_THROW(simulation.remove(2), Error);
  EXPECT_THROW(simulation.change_velocity(2, {1, 0, 0}), Error);
  EXPECT_THROW(simulation.change_velocity(0, {kNan, 0, 0}), Error);
  EXPECT_THROW(simulation.change_velocity(0, {0, kInfinity, 0}), Error);
  EXPECT_THROW(simulation.add({{5, 5, 6}, {}, 1, 1}), Error) << "it overlaps";
  EXPECT_THROW(simulation.add({{19.5, 5, 5}, {}, 1, 1}), Error) << "it reaches through a wall";
  EXPECT_THROW(simulation.add({{10, 5, 5}, {}, -1, 1}), Error);
  EXPECT_THROW(simulation.add({{10, kNan, 5}, {}, 1, 1}), Error);
  EXPECT_EQ(simulation.size(), 2U);
  simulation.run_until(10);
  expect_undisturbed(simulation);
}

TEST(Simulation, RefusesOverlapsAndInvalidOptions) {
  World overlapping = head_on_pair();
  overlapping.add({{5, 6, 5}, {}, 1, 1});
  EXPECT_THROW(Simulation{overlapping}, Error);
  for (const EngineOptions& bad :
       {EngineOptions{EngineKind::cells, 0.0}, EngineOptions{EngineKind::cells, -1.0},
        EngineOptions{EngineKind::cells, kNan}, EngineOptions{EngineKind::cells, 1e-3},
        EngineOptions{EngineKind::paper, 1.9}, EngineOptions{EngineKind::cells, kInfinity},
        EngineOptions{EngineKind::all_pairs, 1e-70}, EngineOptions{.unit_costs = {.contact = kNan}},
        EngineOptions{.unit_costs = {.enter = 0, .cell = 0}}, EngineOptions{.unit_costs = {.cell = -1}},
        EngineOptions{.unit_costs = {.prediction = kInfinity}}}) {
    EXPECT_THROW(Simulation(head_on_pair(), bad), Error);
  }
}

TEST(Simulation, NamesTheEngineThatRuns) {
  EXPECT_NE(Simulation(head_on_pair()).engine(), EngineKind::automatic);
  EngineOptions options;
  options.engine = EngineKind::all_pairs;
  EXPECT_EQ(Simulation(head_on_pair(), options).cell_edge(), 0);
  options.engine = EngineKind::paper;
  options.cell_edge = 4;
  EXPECT_NEAR(Simulation(head_on_pair(), options).cell_edge(), (4 + 5 + 5) / 3.0, 1e-12)
      << "whole cells fill the box";
}

TEST(Simulation, CallsTheResponseOfTheUser) {
  for (const EngineKind engine : all_engines()) {
    Simulation simulation(head_on_pair(), {.engine = engine});
    simulation.respond_with([](const Contact& contact) {
      EXPECT_EQ(contact.after, contact.before);
      Velocities after = Restitution(1)(contact);
      after.first = 2 * after.first;  // a kick
      return after;
    });
    simulation.run_until(5);
    EXPECT_EQ(simulation.velocity(0), (Vec3{-2, 0, 0}));
    EXPECT_EQ(simulation.velocity(1), (Vec3{1, 0, 0}));
    simulation.respond_with([](const Contact& contact) { return contact.before; });
    EXPECT_THROW(simulation.run_until(10), Error) << "through the wall";
    // Nothing has changed, and with a better response the run continues.
    EXPECT_EQ(simulation.counters().contacts(), 1U);
    simulation.respond_with(nullptr);
    simulation.run_until(10);
    EXPECT_EQ(simulation.velocity(0), (Vec3{2, 0, 0}));
    simulation.validate();
  }
}

TEST(Simulation, ListenerThatThrowsEndsTheRunAfterThatContact) {
  Simulation simulation(head_on_pair());
  simulation.on_contact([](const Contact&) { throw std::runtime_error("enough"); });
  EXPECT_THROW(simulation.run_until(100), std::runtime_error);
  EXPECT_EQ(simulation.time(), 4);
  EXPECT_EQ(simulation.counters().contacts(), 1U);
  simulation.on_contact(nullptr);
  simulation.run_until(100);
  expect_undisturbed(simulation);
}

TEST(Simulation, ListenerMayNotRunItOrPredict) {
  for (const EngineKind engine : all_engines()) {
    Simulation simulation(head_on_pair(), {.engine = engine});
    int refused = 0;
    simulation.on_contact([&](const Contact&) {
      Measures measures;
      const auto is_refused = [&](const auto& call) {
        refused += support::problem_of(call) == "the simulation is running" ? 1 : 0;
      };
      is_refused([&] { simulation.run_until(100); });
      is_refused([&] { simulation.run_until(100, measures); });
      is_refused([&] { simulation.run_contacts(1); });
      is_refused([&] { simulation.run({}); });
      is_refused([&] { simulation.next_contact(); });
      is_refused([&] { simulation.positions_at(4); });
      EXPECT_EQ(simulation.position(0), (Vec3{9, 5, 5}));
      EXPECT_EQ(simulation.positions().size(), 2U);
      simulation.on_contact(nullptr);
    });
    simulation.run_until(100);
    EXPECT_EQ(refused, 6);
    expect_undisturbed(simulation);
  }
}

TEST(Simulation, ListenerMayExperimentOnACopy) {
  Simulation simulation(head_on_pair());
  std::optional<NextContact> next;
  simulation.on_contact([&](const Contact&) {
    Simulation copy = simulation;
    copy.on_contact(nullptr);
    next = copy.next_contact();
    copy.run_until(100);
    copy.add({{10, 5, 8}, {}, 1, 1});
  });
  simulation.run_until(5);
  ASSERT_TRUE(next);
  EXPECT_EQ(next->time, 12);
  EXPECT_EQ(simulation.size(), 2U);
}

TEST(Simulation, ListenerMayReplaceItselfAndTheResponse) {
  Simulation simulation(head_on_pair());
  std::string calls;
  simulation.on_contact([&, much = std::vector<int>(1000, 7)](const Contact&) {
    simulation.on_contact([&](const Contact&) { calls += "b"; });
    simulation.respond_with([](const Contact& contact) {
      return Velocities{-0.5 * contact.before.first, -0.5 * contact.before.second};
    });
    calls += much.back() == 7 ? "a" : "?";
  });
  simulation.run_until(13);
  EXPECT_EQ(calls, "abb");
  EXPECT_EQ(simulation.velocity(0), (Vec3{0.5, 0, 0}));
  // The replacements count even if the listener throws afterwards.
  simulation.on_contact([&](const Contact&) {
    simulation.on_contact([&](const Contact&) { calls += "c"; });
    throw std::runtime_error("enough");
  });
  EXPECT_THROW(simulation.run_until(100), std::runtime_error);
  simulation.run_until(100);
  EXPECT_EQ(calls.substr(0, 4), "abbc");
}

TEST(Simulation, IsCopiedWithTheListenerThatReplacesAnother) {
  Simulation simulation(head_on_pair());
  std::optional<Simulation> copy;
  int calls = 0;
  simulation.on_contact([&](const Contact&) {
    simulation.on_contact([&](const Contact&) { ++calls; });
    copy.emplace(simulation);
  });
  simulation.run_contacts(1);
  copy->run_contacts(3);
  EXPECT_EQ(calls, 3);
  // What has not taken its place yet goes with the simulation that is assigned to.
  simulation.on_contact([&](const Contact&) {
    simulation.on_contact([&](const Contact&) { ++calls; });
    throw std::runtime_error("enough");
  });
  EXPECT_THROW(simulation.run_contacts(1), std::runtime_error);
  simulation = Simulation(head_on_pair());
  simulation.run_contacts(3);
  EXPECT_EQ(calls, 3);
}

TEST(Simulation, CountsTheEnergyOfEditsWithoutSpins) {
  for (const Box& box : {Box::open(), Box::periodic({20, 20, 20})}) {
    World world(box);
    world.add({.position = {5, 5, 5}, .velocity = {1, 0, 0}, .spin = {0, 0, 3}});
    Simulation simulation(world);
    const SphereId id = simulation.add({.position = {5, 15, 5}, .velocity = {0, 2, 0}, .spin = {5, 0, 0}});
    const auto rate = [&] {
      const Tally& tally = simulation.tally();
      return tally.energy_integral(after(simulation.now(), 1)) - tally.energy_integral(simulation.now());
    };
    EXPECT_EQ(rate(), 2.5);
    simulation.change_velocity(0, {2, 0, 0});
    EXPECT_EQ(rate(), 4);
    simulation.remove(id);
    EXPECT_EQ(rate(), 2);
  }
}

TEST(Simulation, ResponseMayNotEditOrRunIt) {
  Simulation simulation(head_on_pair());
  for (const std::function<void()>& misuse : std::vector<std::function<void()>>{
           [&] { simulation.change_velocity(0, {}); }, [&] { simulation.remove(1); },
           [&] {
             simulation.add({{10, 5, 8}, {}, 1, 1});
           },
           [&] { simulation.respond_with(nullptr); }, [&] { simulation.run_until(100); },
           [&] { simulation.next_contact(); }}) {
    Simulation copy = simulation;
    simulation.respond_with([&](const Contact& contact) {
      misuse();
      return contact.before;
    });
    EXPECT_THROW(simulation.run_until(10), Error);
    EXPECT_EQ(simulation.counters().contacts(), 0U);
    simulation.respond_with(nullptr);
  }
  simulation.run_until(5);
  EXPECT_EQ(simulation.counters().contacts(), 1U) << "and it continues";
}

TEST(Simulation, IsNotEditedDuringARunWithMeasures) {
  Simulation simulation(head_on_pair());
  Measures measures;
  simulation.on_contact([&](const Contact&) { simulation.remove(1); });
  EXPECT_THROW(simulation.run_until(10, measures), Error);
  EXPECT_EQ(simulation.size(), 2U);
}

TEST(Simulation, RefusesMeasuresOfOtherSpheres) {
  Simulation simulation(head_on_pair());
  Measures measures;
  simulation.run_until(1, measures);
  const SphereId added = simulation.add({{10, 5, 8}, {}, 1, 1});
  EXPECT_THROW(simulation.run_until(2, measures), Error);
  simulation.remove(added);
  EXPECT_NO_THROW(simulation.run_until(2, measures)) << "the same spheres again";
  simulation.remove(1);
  EXPECT_THROW(simulation.run_until(3, measures), Error);
  simulation.add({{15, 5, 5}, {}, 1, 1});
  EXPECT_THROW(simulation.run_until(3, measures), Error) << "as many, but not the same";
  EXPECT_EQ(simulation.time(), 2);
}

TEST(Simulation, RefusesResponsesThatReturnInvalidVelocities) {
  for (const EngineKind engine : all_engines()) {
    for (const Box& box : {Box::open(), Box::walls({20, 10, 10}), Box::periodic({20, 10, 10})}) {
      for (const double bad : {kNan, kInfinity, 1e300}) {
        World world(box);
        world.add({{5, 5, 5}, {1, 0, 0}, 1, 1});
        world.add({{15, 5, 5}, {-1, 0, 0}, 1, 1});
        Simulation simulation(world, {.engine = engine});
        simulation.respond_with([&](const Contact&) { return Velocities{{-bad, 0, 0}, {bad, 0, 0}}; });
        EXPECT_THROW(simulation.run_until(10), Error);
        EXPECT_EQ(simulation.counters().contacts(), 0U);
        simulation.respond_with(nullptr);
        simulation.run_until(5);
        EXPECT_EQ(simulation.velocity(0), (Vec3{-1, 0, 0}));
      }
    }
  }
}

TEST(Simulation, StartsWhenTheLastSphereIsAdded) {
  World world(Box({Boundary::wall, Boundary::periodic, Boundary::periodic}, {20, 10, 10}));
  world.add({{5, 5, 5}, {1, 0, 0}, 1, 1}, Time(-3));
  world.add({{15, 5, 5}, {-1, 6, 0}, 1, 1}, Time(2));
  Simulation simulation(world);
  EXPECT_EQ(simulation.time(), 2);
  EXPECT_EQ(simulation.position(0), (Vec3{10, 5, 5}));
  World gone(world);
  gone.add({{12, 0, 5}, {}, 1, 1}, Time(12));
  const Error error = support::error_of([&] { Simulation late(gone); });
  EXPECT_EQ(error.problem(), "at time 12 sphere 0 reaches through a wall by 0.5 of its diameter");
}

// Spheres that flew through each other before the start must not collide in the past.
TEST(Simulation, IgnoresEncountersBeforeItsStart) {
  for (const EngineKind engine : all_engines()) {
    for (const Box& box : {Box::open(), Box::periodic({40, 10, 10})}) {
      World world(box);
      world.add({{10, 5, 5}, {1, 0, 0}, 1, 1}, Time(0));
      world.add({{14, 5, 5}, {-1, 0, 0}, 1, 1}, Time(1));
      world.add({{20, 5, 5}, {0, 0, 0}, 1, 1}, Time(7));
      Simulation simulation(world, {.engine = engine});
      EXPECT_EQ(simulation.position(0), (Vec3{17, 5, 5}));
      EXPECT_EQ(simulation.position(1), (Vec3{8, 5, 5}));
      simulation.run_until(9);
      EXPECT_EQ(simulation.counters().collision, 1U);
      EXPECT_EQ(simulation.velocity(2), (Vec3{1, 0, 0}));
      simulation.run_until(50);
      simulation.validate();
    }
  }
}

TEST(Simulation, ForgetsRemovedSpheresAndMeetsAddedOnes) {
  Simulation simulation(head_on_pair());
  simulation.run_until(1);
  const SphereId in_between = simulation.add({{10, 5, 5}, {0, 0, 0}, 1, 1});
  std::vector<std::pair<SphereId, std::uint32_t>> pairs;
  simulation.on_contact([&](const Contact& contact) { pairs.emplace_back(contact.first, contact.second); });
  simulation.run_until(3);
  EXPECT_EQ(pairs.size(), 3U) << "two at time 3, and then the middle sphere passes the impulse on";
  simulation.remove(in_between);
  pairs.clear();
  simulation.run_until(6.5);
  EXPECT_TRUE(pairs.empty());
  EXPECT_EQ(simulation.velocity(0), (Vec3{-1, 0, 0}));
  EXPECT_THROW(simulation.position(in_between), Error);
  EXPECT_EQ(simulation.positions(), (std::vector<Vec3>{{4.5, 5, 5}, {15.5, 5, 5}}));
}

TEST(Simulation, ReportsAnInvalidSphereBeforeAnOverlap) {
  Simulation simulation(head_on_pair());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Error error = support::error_of([&] { simulation.add({{nan, 5, 5}, {0, 0, 0}, 1, 1}); });
  EXPECT_EQ(error.problem(), "position along x is nan");
  EXPECT_THROW(simulation.add({simulation.position(0), {0, 0, 0}, 1, 1}), Error) << "on top of another";
  EXPECT_EQ(simulation.size(), 2U);
}

TEST(Simulation, CanBeMovedAndAssigned) {
  Simulation first(head_on_pair());
  Simulation second(std::move(first));
  second.run_until(5);
  EXPECT_EQ(second.counters().contacts(), 1U);
  first = second;
  first.run_until(50);
  EXPECT_EQ(second.time(), 5);
}

World gas_of(std::size_t spheres) {
  World world(Box::periodic({1000, 10, 10}));
  for (std::size_t i = 0; i < spheres; ++i) {
    world.add({{1000.0 * static_cast<double>(i) / static_cast<double>(spheres), 5, 5}, {1, 0, 0}, 0.01, 1});
  }
  return world;
}

TEST(Simulation, ReportsTheProgressOfItsSetUp) {
  for (const std::size_t spheres : {std::size_t{0}, std::size_t{1}, std::size_t{1000}, std::size_t{12000}}) {
    for (const EngineKind engine : {EngineKind::cells, EngineKind::neighbors}) {
      std::vector<double> reports;
      Simulation simulation(gas_of(spheres), {.engine = engine},
                            [&](double done) { reports.push_back(done); });
      ASSERT_GE(reports.size(), spheres >= 1000 ? 200U : 2U);
      EXPECT_LE(reports.size(), 400U) << spheres;
      EXPECT_EQ(reports.front(), 0);
      EXPECT_EQ(reports.back(), 1);
      EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end()));
      const std::size_t calls = reports.size();
      Simulation copy = simulation;
      copy.add({{500, 1, 1}, {1, 0, 0}, 0.01, 1});
      copy.run_until(0.01);
      simulation.remove(simulation.add({{500, 1, 1}, {1, 0, 0}, 0.01, 1}));
      simulation.run_until(0.01);
      EXPECT_EQ(reports.size(), calls) << "only the set-up is reported";
    }
  }
}

TEST(Simulation, IsNotMadeIfItsProgressListenerThrows) {
  for (const double end : {0.0, 0.3, 0.6, 1.0}) {
    const auto interrupt = [end](double done) {
      if (done >= end) throw RunFailure("enough");
    };
    EXPECT_THROW(Simulation(gas_of(1000), {}, interrupt), RunFailure) << end;
  }
}

// At such times there are events without end that have the same nearest double.
TEST(Simulation, FailsWhereTimesAreTooLargeToResolveMotion) {
  for (const EngineKind engine : all_engines()) {
    for (const double moment : {1e60, 1e100}) {
      World world(Box({Boundary::wall, Boundary::periodic, Boundary::periodic}, {20, 20, 20}));
      world.add({{2, 2, 2}, {1, 0, 0}, 1, 1}, Time(moment));
      world.add({{9, 9, 9}, {0, 1, 0}, 1, 1}, Time(moment));
      Simulation simulation(world, {.engine = engine});
      EXPECT_THROW(simulation.run_until(moment), RunFailure);
    }
  }
}

TEST(Simulation, CountsSamplesAmongTheSteps) {
  Simulation simulation(head_on_pair());
  Measures measures({.names = {"temperature"}, .every = 1e-6});
  EXPECT_EQ(simulation.run({.until = Time(3), .steps = 100}, measures), RunStatus::steps_reached);
  EXPECT_LT(simulation.time(), 1e-3);
}

TEST(Simulation, RefusesSamplesThatTimesCannotResolve) {
  Measures unresolved({.names = {"temperature"}, .every = 1e-40, .from = 0.5});
  Simulation simulation(head_on_pair());
  EXPECT_THROW(simulation.run_until(1, unresolved), Error);
  // Overdue samples are not counted one by one.
  Measures frequent({.names = {"temperature"}, .every = 1e-12});
  Simulation another(head_on_pair());
  another.run({.until = Time(3), .steps = 10}, frequent);
  another.run_until(3);
  EXPECT_EQ(another.run({.until = Time(3.5), .steps = 10}, frequent), RunStatus::steps_reached);
  EXPECT_LT(another.time(), 3.1);
}

}  // namespace
}  // namespace hardball::simulation_test
