// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Worlds that are hard to divide among domains, each for a reason of its own: the history of one engine, to
// the last bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hardball/broadphase/cell_grid.hpp"
#include "hardball/domains/domains_engine.hpp"
#include "hardball/events/calendar_queue.hpp"
#include "hardball/measure/contact_sums.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/placement/placement.hpp"
#include "hardball/world/audit.hpp"
#include "support/crystal.hpp"
#include "support/discs.hpp"
#include "support/effort.hpp"
#include "support/gas.hpp"
#include "support/history.hpp"
#include "support/interacting.hpp"

namespace hardball::hard_cases_for_domains_test {
namespace {

using namespace support;

std::string name_of(const Division& division) {
  return to_text(division.domains) + " domains, " + to_text(division.threads) + " threads, halo " +
         to_text(division.halo) + ", window " + to_text(division.window);
}

// From one domain to sixteen, with halos from the least to far more than is needed, and windows from a few
// contacts to far too many.
std::vector<Division> divisions() {
  return {{.domains = 1},
          {.domains = 2, .halo = 1.05, .window = 1},
          {.domains = 3, .threads = 2, .halo = 1.5, .window = 0.1},
          {.domains = 5, .halo = 1.2, .window = 0.01},
          {.domains = 8, .threads = 3, .halo = 1.75, .window = 0.3, .first_window = 10},
          {.domains = 13, .halo = 4},
          {.domains = 16, .halo = 1.05, .window = 2}};
}

struct Outcome {
  History history;
  std::vector<Contact> log;
  double virial = 0;
};

Outcome run_through(const World& world, const EngineOptions& options, const RunLimits& limits,
                    const std::optional<Thermostat>& thermostat, bool is_heard) {
  Simulation simulation(world, options);
  simulation.set_thermostat(thermostat);
  Outcome outcome;
  if (is_heard) simulation.on_contact([&](const Contact& contact) { outcome.log.push_back(contact); });
  outcome.history = run_on(simulation, limits);
  outcome.virial = simulation.tally().virial();
  if (outcome.history.failure.empty()) simulation.validate();
  return outcome;
}

// A world has the same history in all divisions, in every other one with a listener. Returns that of one
// engine.
History expect_one_history(const World& world, const RunLimits& limits,
                           const std::optional<Thermostat>& thermostat = {},
                           const std::vector<Division>& all = divisions()) {
  const Outcome expected = run_through(world, {}, limits, thermostat, true);
  bool is_heard = true;
  for (const Division& division : all) {
    SCOPED_TRACE(name_of(division));
    is_heard = !is_heard;
    const Outcome divided = run_through(world, {.division = division}, limits, thermostat, is_heard);
    EXPECT_EQ(difference(divided.history, expected.history), "");
    EXPECT_EQ(divided.virial, expected.virial);
    if (!is_heard) continue;
    const auto are_same = [](const Contact& a, const Contact& b) {
      return a.time == b.time && a.kind == b.kind && a.first == b.first && a.second == b.second &&
             a.after == b.after;
    };
    EXPECT_TRUE(std::ranges::equal(divided.log, expected.log, are_same)) << "the order of contacts";
  }
  return expected.history;
}

// About so many contacts for each sphere, fewer in a slow build.
RunLimits contacts_each(const World& world, double contacts) {
  const double share = kIsSlowBuild ? 0.25 : 1;
  const auto all = static_cast<std::uint64_t>(share * contacts * static_cast<double>(world.size()));
  return {.until = Time(1000), .contacts = all + 1};
}

// Adds spheres of these radii with thermal velocities, each at the first of many random places where there is
// room.
void fill(World& world, const Region& region, const std::vector<double>& radii, std::uint64_t seed) {
  Random random(seed);
  for (const double radius : radii) {
    constexpr int kAttempts = 1000;
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
      Sphere sphere{.position = {}, .velocity = random.normal_vector(3), .radius = radius};
      for (std::size_t axis = 0; axis < world.box().dimensions(); ++axis) {
        const double room = region.high[axis] - region.low[axis] - 2 * radius;
        sphere.position[axis] = region.low[axis] + radius + random.uniform() * room;
      }
      if (world.box().is_flat()) sphere.velocity.z = 0;
      if (distance_to_surfaces(world, sphere.position, Time(0)) < radius) continue;
      const auto slot = static_cast<Slot>(world.size());
      world.add(sphere);
      try {
        require_room(world, slot, all_slots(world), Time(0));
        break;
      } catch (const Error&) {
        world.undo_add();
      }
    }
  }
}

World filled(const Box& box, std::size_t count, std::uint64_t seed) {
  World world(box);
  fill(world, {{}, box.size()}, std::vector<double>(count, 0.5), seed);
  return world;
}

// Rows of touching spheres. All that the first of a row does goes through all domains in one moment, and
// happens in several rows at once.
TEST(HardCasesForDomains, NewtonsCradles) {
  World world(Box::walls({64, 8, 8}));
  for (int row = 0; row < 4; ++row) {
    const double y = 1.5 + 2 * (row % 2);
    const double z = 1.5 + 2 * static_cast<double>(row / 2);
    world.add({.position = {4, y, z}, .velocity = {1, 0, 0}, .radius = 0.5});
    for (int k = 0; k < 24; ++k) world.add({.position = {16.0 + k, y, z}, .radius = 0.5});
    if (row > 1) world.add({.position = {50, y, z}, .velocity = {-1, 0, 0}, .radius = 0.5});
  }
  const History history = expect_one_history(world, {.until = Time(60)});
  EXPECT_GT(history.contacts, 4U * 24);
}

TEST(HardCasesForDomains, CrystalsOfWhichOneSphereIsKicked) {
  for (const double spacing : {1.0, 1.0625}) {
    const std::uint64_t most = spacing == 1 ? 20 : 200;
    World world(make_crystal(simple_cubic(), 4, spacing));
    Simulation kicked(std::move(world));
    kicked.change_velocity(0, {1, 0, 0});
    kicked.change_velocity(50, {0.5, 0.25, -1});
    EXPECT_EQ(expect_one_history(kicked.world(), {.until = Time(20), .contacts = most}).contacts, most);
  }
}

TEST(HardCasesForDomains, SpheresThatAllStartInOneBlock) {
  for (const Boundary boundary : {Boundary::wall, Boundary::periodic, Boundary::open}) {
    World world(Box({boundary, boundary, boundary}, {40, 40, 40}));
    fill(world, {{5, 5, 5}, {11, 11, 11}}, std::vector<double>(60, 0.5), 2);
    EXPECT_GT(expect_one_history(world, {.until = Time(100), .contacts = 150}).contacts, 30U);
  }
}

TEST(HardCasesForDomains, FewerSpheresThanDomains) {
  for (std::size_t count = 0; count <= 4; ++count) {
    expect_one_history(filled(Box::walls({8, 8, 8}), count, count), {.until = Time(40), .contacts = 30});
    expect_one_history(filled(Box::periodic({3, 3, 3}), count, count), {.until = Time(40), .contacts = 30});
    expect_one_history(filled(Box::flat_walls(6, 3), count, count), {.until = Time(40), .contacts = 30});
  }
}

// They cross several domains in a window that suits the others.
TEST(HardCasesForDomains, Bullets) {
  for (const double speed : {30.0, 3000.0}) {
    World world(Box::periodic({60, 6, 6}));
    fill(world, {{0, 0, 0}, {3, 6, 6}}, {0.5, 0.5}, 1);
    Simulation shot(world);
    shot.change_velocity(0, {speed, 0.1 * speed, 0});
    shot.change_velocity(1, {-0.7 * speed, 0.01 * speed, 0.3 * speed});
    world = shot.world();
    fill(world, {{3, 0, 0}, {60, 6, 6}}, std::vector<double>(200, 0.5), 7);
    expect_one_history(world, contacts_each(world, 4));
  }
}

// Each domain is the neighbor of the other on both sides, and a halo may reach around the box.
TEST(HardCasesForDomains, SmallPeriodicBoxes) {
  for (const double edge : {1.25, 2.1, 3.0}) {
    const World world = filled(Box::periodic({edge, edge, edge}), static_cast<std::size_t>(4 * edge), 5);
    SCOPED_TRACE(testing::Message() << world.size() << " spheres in a box of " << edge);
    expect_one_history(world, contacts_each(world, 6));
    const World flat = filled(Box::flat_periodic(edge, 2 * edge), static_cast<std::size_t>(2 * edge), 5);
    expect_one_history(flat, contacts_each(flat, 6));
  }
}

// A ghost flies around the box along an axis that is not divided, into a row of spheres whose last hits a
// ghost of the other domain in the same window.
TEST(HardCasesForDomains, WaysAroundTheBox) {
  for (int step = 0; step < 11; ++step) {
    const double wait = 26.5 + 0.2 * step;
    SCOPED_TRACE(wait);
    World world(Box::periodic({80, 12, 12}));
    const double speed = 0.225;
    const Vec3 toward{0.8, 0.6, 0};
    const Vec3 met{19.3, 8, 5};
    const Vec3 end_of_row{21.6, 2, 5};
    const Vec3 along{-0.2, 0.9797958971132712, 0};
    constexpr int kRow = 12;
    constexpr double kSpacing = 1.015625;
    world.add({.position = met - (1 + speed * wait) * toward,
               .velocity = speed * toward,
               .radius = 0.5,
               .mass = 0.2});
    world.add({.position = met, .radius = 0.5});
    world.add({.position = {20, 1, 10}, .radius = 0.5});
    for (int k = 0; k <= kRow; ++k)
      world.add({.position = end_of_row - (kSpacing * k) * along, .radius = 0.5});
    world.add(
        {.position = end_of_row - (kSpacing * kRow + 1 + wait) * along, .velocity = along, .radius = 0.5});
    for (int k = 0; k < kRow; ++k) world.add({.position = {3 + 1.2 * k, 1, 10}, .radius = 0.5});
    expect_one_history(world, {.until = Time(wait + 20)}, {}, {{.domains = 2}, {.domains = 3, .halo = 1.5}});
  }
}

// Gaps between blocks, across the box and its period, are as wide as neighborhoods to the last bit.
TEST(HardCasesForDomains, LatticesWithTheSpacingOfHalos) {
  for (const double diameter : {0.2, 0.3, 0.6, 0.7, 1.2, 2.0}) {
    for (const double ratio : {1.75, 3.5, 7.0 / 6}) {
      for (const int along : {8, 9, 12, 16}) {
        const double spacing = diameter * ratio;
        World world(Box::periodic({along * spacing, 2 * spacing, 2 * spacing}));
        for (int k = 0; k < 4 * along; ++k) {
          const int x = k / 4;
          const int y = k / 2 % 2;
          const int z = k % 2;
          world.add({.position = {(x + 0.5) * spacing, (y + 0.5) * spacing, (z + 0.5) * spacing},
                     .velocity = {x % 2 == 1 ? 1.0 : -0.5, 0.3 * y, 0.1 * z},
                     .radius = diameter / 2});
        }
        expect_one_history(world, {.until = Time(1000), .contacts = 20}, {},
                           {{.domains = 8}, {.domains = 12}});
      }
    }
  }
}

TEST(HardCasesForDomains, Discs) {
  for (const Boundary boundary : {Boundary::wall, Boundary::periodic, Boundary::open}) {
    const World world = make_discs(200, 0.4, 4, boundary);
    expect_one_history(world, contacts_each(world, boundary == Boundary::open ? 1 : 4));
  }
}

// All blocks are slices of a tube.
TEST(HardCasesForDomains, Slabs) {
  for (const Boundary boundary : {Boundary::wall, Boundary::periodic}) {
    const World world = filled(Box({boundary, boundary, boundary}, {80, 2.5, 2.5}), 150, 6);
    expect_one_history(world, contacts_each(world, 5));
  }
}

TEST(HardCasesForDomains, MovingWallsObstaclesAndGravity) {
  const std::vector<Surface> surfaces{
      Surface(OscillatingPlane({0, 0, 1}, 0.25, 3), {0, 0, 0.75}),
      Surface(Plane({-1, 0, 0}), {19, 0, 0}, {-0.05, 0, 0}),
      Surface(Obstacle(1.5), {9, 4, 4}),
      Surface(Obstacle(0.5), {14, 1, 5}, {}, {.restitution = 0.5}),
  };
  for (const double restitution : {1.0, 0.9}) {
    World world(Box::walls({20, 8, 8}), {0.1, 0, -0.5}, surfaces);
    fill(world, {{0, 0, 1.5}, {18, 8, 8}}, std::vector<double>(120, 0.5), 8);
    world.set_interactions(Restitution(restitution, 0.01));
    expect_one_history(world, contacts_each(world, 5));
  }
  // Along a periodic axis spheres fall ever faster, through more and more domains.
  World falling(Box::periodic({8, 8, 24}), {0, 0, -1});
  fill(falling, {{}, {8, 8, 24}}, std::vector<double>(80, 0.5), 9);
  expect_one_history(falling, contacts_each(falling, 2));
}

// Large spheres, which need cells of their own, are in some domains only.
TEST(HardCasesForDomains, MixturesOfSizes) {
  World world(Box::periodic({24, 6, 6}));
  fill(world, {{}, {6, 6, 6}}, {2, 1.5}, 10);
  fill(world, {{}, {24, 6, 6}}, std::vector<double>(400, 0.125), 11);
  fill(world, {{}, {24, 6, 6}}, std::vector<double>(50, 0.25), 12);
  expect_one_history(world, contacts_each(world, 3));

  World pair(Box::walls({30, 8, 8}));
  fill(pair, {{12, 0, 0}, {18, 8, 8}}, {2}, 13);
  fill(pair, {{}, {30, 8, 8}}, std::vector<double>(40, 0.1), 14);
  expect_one_history(pair, contacts_each(pair, 8));
}

// What of a contact between spheres that pass through each other matters is who owns them.
TEST(HardCasesForDomains, SpeciesThatPassThroughEachOther) {
  for (const bool with_ties : {false, true}) {
    World world(Box::periodic({24, 6, 6}));
    Random random(15);
    for (int x = 0; x < 12; ++x) {
      for (int y = 0; y < 3; ++y) {
        for (int z = 0; z < 3; ++z) {
          const Vec3 velocity =
              with_ties ? Vec3{x % 2 == 0 ? 1.0 : -1.0, 0, 0} : Vec3(random.normal_vector(3));
          const auto species = static_cast<SpeciesId>((x + y + z) % 3);
          world.add({.position = {2.0 * x, 2.0 * y, 2.0 * z},
                     .velocity = velocity,
                     .radius = 0.5,
                     .species = species});
        }
      }
    }
    const World passing = interacting(world, support::passing({{0, 1}, {2, 2}}));
    expect_one_history(passing, contacts_each(passing, 8));
  }
}

TEST(HardCasesForDomains, RoughSpheres) {
  World world(Box::walls({20, 6, 6}));
  fill(world, {{}, {20, 6, 6}}, std::vector<double>(150, 0.5), 16);
  BounceRules rules;
  rules.restitution = ConstantRestitution{0.95};
  rules.tangential_restitution = 0.5;
  const History history = expect_one_history(interacting(world, ResponseTable(Bounce(rules), Bounce(rules))),
                                             contacts_each(world, 5));
  EXPECT_TRUE(std::ranges::any_of(history.spins, [](const Vec3& spin) { return !(spin == Vec3{}); }));
}

TEST(HardCasesForDomains, Thermostats) {
  const World world = filled(Box::periodic({20, 6, 6}), 150, 17);
  for (const Thermostat& thermostat :
       {Thermostat(Andersen(1, 0.5), 1), Thermostat(Rescale(2, 0.25), 2), Thermostat(Heating(1, 0.25), 3)}) {
    expect_one_history(world, contacts_each(world, 4), thermostat);
  }
}

// A cluster on the border of two domains that collapses, and others that come near it: who was without time
// between contacts is known to the next owner, too.
TEST(HardCasesForDomains, InelasticCollapses) {
  World world(Box::walls({16, 4, 4}));
  for (int k = 0; k < 6; ++k) {
    world.add({.position = {3 + 2.0 * k + 0.03125 * (k % 3), 2, 2},
               .velocity = {k < 3 ? 1.0 : -1.0, 0, 0},
               .radius = 0.5});
  }
  world.set_interactions(Restitution(0.05));
  const History history =
      expect_one_history(world, {.until = Time(100), .contacts = 100000}, {}, {{.domains = 3, .halo = 1.05}});
  EXPECT_NE(history.failure, "");
}

// Spheres of different owners collapse at the same contact: that with the lower id is named, although its
// domain has the higher number.
TEST(HardCasesForDomains, CollapsesOfBothSpheresOfAContact) {
  World world(Box::walls({16, 4, 4}));
  world.add({.position = {8.5, 2, 2}, .velocity = {-1, 0, 0}, .radius = 0.5});
  world.add({.position = {7.5, 2, 2}, .velocity = {1, 0, 0}, .radius = 0.5});
  world.set_interactions(Restitution(0.5));
  PostContactState before;
  for (const SphereId sphere : {0U, 1U}) before.collapse.set_idle_contacts(sphere, 9999);
  DomainsEngine engine(world, PhaseSettings(1.5), {.domains = 2, .halo = 1.05}, Time(0));
  ASSERT_LE(engine.blocks()[1].distance({8.5, 2, 2}), 0);
  ASSERT_LE(engine.blocks()[0].distance({7.5, 2, 2}), 0);
  engine.take_over(before);
  ContactSums sums;
  try {
    engine.run({.until = Time(1)}, sums, {});
    FAIL() << "no collapse";
  } catch (const RunFailure& failure) {
    EXPECT_EQ(std::string(failure.what()).find("inelastic collapse: sphere 0 was hit"), 0U) << failure.what();
  }
}

// A contact of which no sphere can come with a speed in the operating range: all before it has happened, and
// the simulation can be used as before.
TEST(HardCasesForDomains, ContactsThatThrow) {
  World world(Box::walls({64, 8, 8}));
  for (int k = 0; k < 6; ++k) {
    world.add({.position = {4 + 10.0 * k, 4, 4},
               .velocity = {k == 0 ? 9e59 : 0.0, 0, 0},
               .radius = 0.5,
               .mass = k < 5 ? 1000.0 : 1.0});
  }
  const auto run_to_error = [&](const EngineOptions& options) {
    Simulation simulation(world, options);
    std::string message;
    try {
      simulation.run_until(1);
    } catch (const Error& error) {
      message = error.what();
    }
    EXPECT_NE(message, "");
    EXPECT_EQ(simulation.counters().collision, 4U);
    simulation.remove(5);
    History history = run_on(simulation, {.until = Time(simulation.time()), .contacts = 10});
    history.failure = message;
    return history;
  };
  const History expected = run_to_error({});
  for (const Division& division : divisions()) {
    SCOPED_TRACE(name_of(division));
    EXPECT_EQ(difference(run_to_error({.division = division}), expected), "");
  }
}

// Windows of many contacts for each sphere fail again and again, until single steps lead on.
TEST(HardCasesForDomains, WindowsThatAreFarTooLong) {
  for (const double packing_fraction : {0.005, 0.3}) {
    for (std::uint64_t seed = 0; seed < cases(5); ++seed) {
      const World world = make_gas({.count = 150, .packing_fraction = packing_fraction, .seed = seed});
      Simulation reference(world);
      const History expected = run_on(reference, {.contacts = 300});
      DomainsEngine divided(world, PhaseSettings(1.5),
                            {.domains = 6, .halo = 1.05, .window = 3, .first_window = 100}, Time(0));
      ContactSums sums;
      divided.run({.contacts = 300}, sums, {});
      EXPECT_EQ(sums.hash.value(), expected.hash);
      EXPECT_GT(divided.windows().failed, 10U);
      EXPECT_GT(divided.windows().steps, 0U);
    }
  }
}

}  // namespace
}  // namespace hardball::hard_cases_for_domains_test
