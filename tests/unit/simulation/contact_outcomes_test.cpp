// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Spheres that pass through each other, merge, spin, or are kinematic.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/measure/measures.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/world/totals.hpp"
#include "support/interacting.hpp"

namespace hardball::contact_outcomes_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Simulation merging_by(EngineKind engine, const World& world) {
  return Simulation(support::interacting(world, ResponseTable(Merging())), {.engine = engine});
}

class ContactOutcomes : public testing::TestWithParam<EngineKind> {};

// Each meeting is one event, however rounding falls, and changes nothing.
TEST_P(ContactOutcomes, OfPassingSpheresIsOneEventForEachMeeting) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    World world(Box::open());
    const Vec3 way = random.direction();
    const Vec3 velocity = (0.5 + random.uniform()) * random.direction();
    const double speed = 1 + random.uniform();
    world.add({.position = {}, .velocity = velocity, .radius = 0.5 + random.uniform()});
    world.add({.position = 10 * way, .velocity = velocity - speed * way, .radius = 0.5, .species = 1});
    world.set_interactions(support::passing({{1, 0}}));
    Simulation simulation(world, {.engine = GetParam()});
    std::vector<Contact> contacts;
    simulation.on_contact([&](const Contact& contact) { contacts.push_back(contact); });
    simulation.run_until(100);
    ASSERT_EQ(contacts.size(), 1U);
    EXPECT_EQ(contacts[0].outcome, ContactOutcome::pass);
    EXPECT_NEAR(contacts[0].time.value(), (10 - contacts[0].reach) / speed, 1e-13);
    EXPECT_EQ(simulation.world().path(0).time, Time(0)) << "the path is as it was";
    EXPECT_EQ(simulation.velocity(0), velocity);
    simulation.validate();
  }
}

TEST_P(ContactOutcomes, OfPassingSpheresDoesNotHideOtherContacts) {
  // A third sphere sends a ghost back, once when it is still inside the other, once when it has left it.
  for (const bool has_left : {false, true}) {
    World world(Box::open());
    world.add({.position = {0, 0, 0}, .radius = 1});
    world.add({.position = {3, 0, 0}, .velocity = {-1, 0, 0}, .radius = 0.5, .species = 1});
    world.add(
        {.position = {has_left ? -8.0 : -6.0, 0, 0}, .velocity = {1, 0, 0}, .radius = 0.5, .species = 2});
    world.set_interactions(support::passing({{0, 1}, {0, 2}}));
    Simulation simulation(world, {.engine = GetParam()});
    std::vector<std::pair<SphereId, std::uint32_t>> met;
    simulation.on_contact([&](const Contact& contact) {
      met.emplace_back(contact.first, contact.second);
      EXPECT_EQ(contact.outcome, contact.first == 0 ? ContactOutcome::pass : ContactOutcome::bounce);
    });
    simulation.run_until(20);
    std::vector<std::pair<SphereId, std::uint32_t>> expected{{0, 1}, {1, 2}};
    if (has_left) expected.emplace_back(0, 1);
    EXPECT_EQ(met, expected);
  }
}

TEST_P(ContactOutcomes, OfSpheresThatOverlapFromTheStartMayBeToPass) {
  World world(Box::walls({10, 10, 10}));
  world.add({.position = {5, 5, 5}, .velocity = {1, 0, 0}, .radius = 1});
  world.add({.position = {5.5, 5, 5}, .velocity = {-1, 0, 0}, .radius = 1});
  EXPECT_THROW(Simulation{world}, Error);
  world.set_interactions(support::passing({{0, 0}}));
  Simulation simulation(world, {.engine = GetParam()});
  simulation.run_until(1);
  EXPECT_EQ(simulation.counters().collision, 0U);
  simulation.run_until(10);
  EXPECT_GT(simulation.counters().collision, 0U) << "having come back from the walls";
  EXPECT_EQ(simulation.tally().max_overlap() < 1e-12, true);
}

TEST_P(ContactOutcomes, OfMergingSpheresKeepsMassMomentumVolumeAndAngularMomentum) {
  Random random(2);
  for (int i = 0; i < 50; ++i) {
    World world(Box::open());
    const Vec3 way = random.direction();
    const Sphere first{.position = random.direction(),
                       .velocity = random.direction(),
                       .radius = 0.5 + random.uniform(),
                       .mass = 1 + random.uniform(),
                       .spin = random.direction()};
    const Sphere second{.position = first.position + 5 * way,
                        .velocity = first.velocity - 2 * way + 0.1 * random.direction(),
                        .radius = 0.5 + random.uniform(),
                        .mass = 1 + random.uniform(),
                        .spin = 2 * random.direction(),
                        .inertia_factor = 0.6};
    world.add(first);
    world.add(second);
    Simulation simulation = merging_by(GetParam(), world);
    simulation.run_until(5);
    ASSERT_EQ(simulation.size(), 1U);
    const World& merged = simulation.world();
    const double mass = first.mass + second.mass;
    EXPECT_EQ(merged.mass(0), mass);
    EXPECT_NEAR(std::pow(merged.base_radius(0), 3), std::pow(first.radius, 3) + std::pow(second.radius, 3),
                1e-14 * 8);
    const Vec3 whole_momentum = first.mass * first.velocity + second.mass * second.velocity;
    EXPECT_LE(length(momentum(merged, simulation.now()) - whole_momentum), 1e-14);
    const Vec3 moments = first.mass * first.position + second.mass * second.position;
    const Vec3 center = (1 / mass) * (moments + simulation.time() * whole_momentum);
    EXPECT_LE(length(simulation.position(0) - center), 1e-13);
    const auto own = [](const Sphere& sphere) {
      return (sphere.inertia_factor * sphere.mass * sphere.radius * sphere.radius) * sphere.spin;
    };
    const Vec3 angular_momentum = first.mass * cross(first.position, first.velocity) +
                                  second.mass * cross(second.position, second.velocity) + own(first) +
                                  own(second);
    const Vec3 orbital = mass * cross(center, (1 / mass) * whole_momentum);
    const double inertia = merged.inertia_factor(0) * mass * merged.base_radius(0) * merged.base_radius(0);
    EXPECT_LE(length(orbital + inertia * merged.spin(0) - angular_momentum), 1e-12);
  }
}

// A drop in a row that grows into its neighbors merges with them at once.
TEST_P(ContactOutcomes, OfMergingSpheresIsToMergeWithAllThatTheMergedOneOverlaps) {
  World world(Box::open());
  world.add({.position = {0, 0, 0}, .velocity = {1, 0, 0}, .radius = 1});
  world.add({.position = {3, 0, 0}, .radius = 1});
  world.add({.position = {5.5, 0, 0}, .velocity = {0.5, 0, 0}, .radius = 1, .species = 1});
  world.add({.position = {2.5, 2.05, 0}, .radius = 1});
  Simulation simulation = merging_by(GetParam(), world);
  std::vector<std::uint32_t> partners;
  std::vector<double> times;
  simulation.on_contact([&](const Contact& contact) {
    EXPECT_EQ(contact.outcome, ContactOutcome::merge);
    EXPECT_EQ(contact.first, 0U);
    partners.push_back(contact.second);
    times.push_back(contact.time.value());
  });
  EXPECT_EQ(simulation.run_contacts(1), 1U);
  ASSERT_TRUE(simulation.next_contact());
  EXPECT_EQ(simulation.next_contact()->time, 1);
  EXPECT_EQ(simulation.next_contact()->second, 3U);
  Simulation copy(simulation);
  simulation.run_until(1);
  EXPECT_EQ(partners, (std::vector<std::uint32_t>{1, 3}));
  EXPECT_EQ(times, (std::vector<double>{1, 1}));
  EXPECT_EQ(simulation.size(), 2U);
  copy.on_contact(nullptr);
  copy.run_until(1);
  EXPECT_EQ(copy.event_log_hash(), simulation.event_log_hash());
}

// Two spheres merge beside a third, which recedes and is overlapped by a fourteenth of the reach.
World world_of_a_drop_beside_another(SpeciesId species) {
  World world(Box::open());
  world.add({.position = {0, 0, 0}, .velocity = {1, 0, 0}});
  world.add({.position = {3, 0, 0}});
  world.add({.position = {1.5, 1.9, 0}, .velocity = {0.5, 0.2, 0}, .species = species});
  return world;
}

TEST_P(ContactOutcomes, OfMergingSpheresAreAlikeWhetherATableOrAFunctionMergesThem) {
  Simulation by_table = merging_by(GetParam(), world_of_a_drop_beside_another(0));
  by_table.run_until(2);
  EXPECT_EQ(by_table.size(), 1U);
  Simulation by_function(world_of_a_drop_beside_another(0), {.engine = GetParam()});
  std::vector<std::uint32_t> asked;
  by_function.respond_with([&](const Contact& contact) {
    asked.push_back(contact.second);
    return Merging()(contact);
  });
  EXPECT_EQ(by_function.run_contacts(1), 1U);
  ASSERT_TRUE(by_function.next_contact(2));
  EXPECT_EQ(*by_function.next_contact(2), (NextContact{1, EventKind::collision, 0, 2}));
  asked.clear();
  by_function.run_until(2);
  EXPECT_EQ(asked, (std::vector<std::uint32_t>{2})) << "a response that counts is asked once";
  EXPECT_EQ(by_function.size(), 1U);
  EXPECT_EQ(by_function.event_log_hash(), by_table.event_log_hash());
  EXPECT_EQ(by_function.counters().collision, 2U);
  EXPECT_EQ(by_function.velocity(0), by_table.velocity(0));
}

// Of the pairs that a function does not merge, only those that approach meet.
TEST_P(ContactOutcomes, OfSpheresThatAMergedOneOverlapsAreToPartUnlessAFunctionMergesThem) {
  for (const double approach : {0.0, 0.4}) {
    Simulation simulation(world_of_a_drop_beside_another(1), {.engine = GetParam()});
    simulation.respond_with([](const Contact& contact) {
      if (contact.second_species == 0) return Merging()(contact);
      return Bounce()(contact);
    });
    simulation.run_contacts(1);
    if (approach > 0) simulation.change_velocity(2, {0.5, -approach, 0});
    simulation.run_until(2);
    EXPECT_EQ(simulation.size(), 2U);
    EXPECT_EQ(simulation.counters().collision, approach > 0 ? 2U : 1U);
    EXPECT_GT(simulation.velocity(2).y, 0);
  }
}

TEST_P(ContactOutcomes, OfATableThatReplacesTheResponseAreThoseOfOneFromTheStart) {
  World world(Box::walls({20, 20, 20}));
  Random random(3);
  for (int i = 0; i < 27; ++i) {
    world.add({.position = {3.0 + 6 * (i % 3), 3.0 + 6 * (i / 3 % 3), 3.0 + 6 * (i / 9)},
               .velocity = random.direction(),
               .radius = 1 + random.uniform()});
  }
  Simulation from_start = merging_by(GetParam(), world);
  Simulation later(world, {.engine = GetParam()});
  later.respond_with([](const Contact& contact) { return contact.before; });
  later.respond_with(ResponseTable(Merging()));
  EXPECT_FALSE(later.has_custom_response());
  const auto expect_same = [](const Simulation& a, const Simulation& b) {
    EXPECT_EQ(a.event_log_hash(), b.event_log_hash());
    EXPECT_EQ(a.tally().mergers(), b.tally().mergers());
    EXPECT_EQ(a.size(), b.size());
  };
  for (Simulation* simulation : {&from_start, &later}) simulation->run_until(5);
  expect_same(from_start, later);
  Simulation loaded = Simulation::load(later.save());
  Simulation copied = later;
  // A function comes before the table, which stays for afterwards.
  later.respond_with([](const Contact& contact) { return contact.before; });
  later.respond_with(nullptr);
  for (Simulation* simulation : {&from_start, &later, &loaded, &copied}) simulation->run_until(30);
  EXPECT_GT(from_start.tally().mergers(), 5U);
  for (const Simulation* simulation : {&later, &loaded, &copied}) expect_same(from_start, *simulation);
}

TEST_P(ContactOutcomes, OfMergingSpheresEndsARunWithMeasures) {
  World world(Box::open());
  world.add({.position = {0, 0, 0}, .velocity = {1, 0, 0}, .radius = 1});
  world.add({.position = {3, 0, 0}, .radius = 1});
  Simulation simulation = merging_by(GetParam(), world);
  Measures measures({.names = {"temperature"}});
  EXPECT_THROW(simulation.run_until(5, measures), Error);
  EXPECT_EQ(simulation.size(), 1U);
}

TEST_P(ContactOutcomes, OfMergingThatFillsTheBoxIsTheEndOfTheRun) {
  World world(Box::walls({2.2, 2.2, 10}));
  world.add({.position = {1.1, 1.1, 2}, .velocity = {0, 0, 1}, .radius = 1});
  world.add({.position = {1.1, 1.1, 8}, .radius = 1});
  Simulation simulation = merging_by(GetParam(), world);
  EXPECT_THROW(simulation.run_until(10), RunFailure);
  EXPECT_EQ(simulation.size(), 2U) << "nothing has changed";
}

TEST_P(ContactOutcomes, OfKinematicSpheresIsNeverToBeDeflected) {
  World world(Box::periodic({10, 10, 10}));
  world.add({.position = {2, 5, 5}, .velocity = {1, 0, 0}, .radius = 1, .mass = kInfinity});
  world.add({.position = {8, 5, 5}, .velocity = {-1, 0, 0}, .radius = 1, .mass = kInfinity});
  world.add({.position = {5, 5, 5}, .velocity = {0, 0.1, 0}, .radius = 0.5});
  Simulation simulation(world, {.engine = GetParam()});
  simulation.run_until(50);
  EXPECT_EQ(simulation.velocity(0), (Vec3{1, 0, 0}));
  EXPECT_EQ(simulation.velocity(1), (Vec3{-1, 0, 0}));
  EXPECT_GT(simulation.counters().collision, 10U);
  EXPECT_TRUE(std::isfinite(energy(simulation.world(), simulation.now())));
  EXPECT_TRUE(std::isfinite(simulation.tally().energy_integral(simulation.now())));
}

// Hit by a wall of infinite mass moving at 2, a sphere at rest leaves at 4.
TEST_P(ContactOutcomes, OfASphereHitByAKinematicOneIsExact) {
  World world(Box::open());
  world.add({.position = {0, 0, 0}, .velocity = {2, 0, 0}, .radius = 1, .mass = kInfinity});
  world.add({.position = {4, 0, 0}, .radius = 1});
  Simulation simulation(world, {.engine = GetParam()});
  simulation.run_until(2);
  EXPECT_EQ(simulation.velocity(1), (Vec3{4, 0, 0}));
}

// All spheres are shells: what all have in common counts, too.
TEST_P(ContactOutcomes, OfRoughSpheresDependsOnTheirMoments) {
  for (const double moment : {0.4, 2.0 / 3}) {
    World world(Box::open());
    world.add({.position = {0, 0, 0}, .velocity = {1, 0, 0}, .radius = 0.5, .inertia_factor = moment});
    world.add({.position = {3, 0.5, 0}, .radius = 0.5, .inertia_factor = moment});
    world.set_interactions(ResponseTable(Bounce({.tangential_restitution = 1})));
    Simulation simulation(world, {.engine = GetParam()});
    const double before = energy(simulation.world(), simulation.now());
    simulation.run_until(10);
    EXPECT_EQ(simulation.counters().collision, 1U);
    EXPECT_GT(length(simulation.world().spin(0)), 0.1);
    EXPECT_NEAR(energy(simulation.world(), simulation.now()), before, 1e-15);
  }
}

// What a kinematic sphere absorbs is no part of the energy any more.
TEST_P(ContactOutcomes, OfMergingSpheresIsFollowedByTheEnergy) {
  for (const double mass : {1.0, kInfinity}) {
    World world(Box::open());
    world.add({.position = {0, 0, 0}, .velocity = {2, 0, 0}, .radius = 1, .mass = mass});
    world.add({.position = {4, 0, 0}, .velocity = {0, 1, 0}, .radius = 1});
    world.add({.position = {0, 9, 0}, .velocity = {0, 3, 0}, .radius = 1});
    Simulation simulation = merging_by(GetParam(), world);
    simulation.run_until(3);
    ASSERT_EQ(simulation.size(), 2U);
    const double energy = kinetic_energy(simulation.world(), simulation.now());
    const Tally& tally = simulation.tally();
    EXPECT_NEAR(tally.energy_integral(Time(4)) - tally.energy_integral(Time(3)), energy, 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Engine, ContactOutcomes,
                         testing::Values(EngineKind::cells, EngineKind::neighbors, EngineKind::all_pairs,
                                         EngineKind::paper));

TEST(KinematicSpheres, AreRefusedWhereSpheresFall) {
  World world(Box::open(), {0, 0, -1});
  world.add({.position = {}, .mass = kInfinity});
  Simulation simulation(world);
  EXPECT_THROW(simulation.run_until(1), Error) << "no motion drives it";
}

TEST(CustomResponse, MaySpinAndMergeSpheres) {
  World world(Box::open());
  for (int i = 0; i < 3; ++i) {
    world.add({.position = {3.0 * i, 0, 0}, .velocity = {i == 0 ? 1.0 : 0.0, 0, 0}, .radius = 1});
  }
  Simulation simulation(world);
  simulation.respond_with([](const Contact& contact) {
    Outcome outcome(contact, {contact.before.second, contact.before.first});
    outcome.spins.second = {0, 0, 7};
    outcome.merges = contact.second == 2;
    return outcome;
  });
  simulation.run_until(1.5);
  EXPECT_EQ(simulation.world().spin(1), (Vec3{0, 0, 7}));
  EXPECT_EQ(simulation.size(), 3U);
  simulation.run_until(5);
  EXPECT_EQ(simulation.size(), 2U);
  EXPECT_LT(length(simulation.world().spin(1)), 7);
  simulation.respond_with([](const Contact& contact) {
    Outcome outcome(contact, {contact.before.second, contact.before.first});
    outcome.spins.first.x = kInfinity;
    return outcome;
  });
  simulation.change_velocity(0, {2, 0, 0});
  EXPECT_THROW(simulation.run_until(50), Error);
}

TEST(CustomResponse, DoesNotMergeASphereWithAWall) {
  World world(Box::walls({10, 10, 10}));
  world.add({.position = {5, 5, 5}, .velocity = {1, 0, 0}, .radius = 1});
  Simulation simulation(world);
  simulation.respond_with([](const Contact& contact) {
    Outcome outcome(contact, {-contact.before.first, {}});
    outcome.merges = true;
    return outcome;
  });
  simulation.run_until(6);
  EXPECT_EQ(simulation.velocity(0), (Vec3{-1, 0, 0}));
}

TEST(CustomResponse, ThatReturnsBadSpinsChangesNothing) {
  World world(Box::open());
  world.add({.position = {0, 0, 0}, .velocity = {1, 0, 0}, .radius = 1});
  world.add({.position = {4, 0, 0}, .radius = 1});
  Simulation simulation(world);
  simulation.respond_with([](const Contact& contact) {
    Outcome outcome(contact, {contact.before.second, contact.before.first});
    outcome.spins = {{0, 0, 1}, {0, 0, 1e300}};
    return outcome;
  });
  EXPECT_THROW(simulation.run_until(5), Error);
  EXPECT_EQ(simulation.world().path(0).time, Time(0));
  EXPECT_EQ(simulation.world().spin(0), Vec3{});
  simulation.respond_with(nullptr);
  Spins spins_after{{1, 1, 1}, {}};
  simulation.on_contact([&](const Contact& contact) { spins_after = contact.spins_after; });
  simulation.run_until(5);
  EXPECT_EQ(simulation.counters().collision, 1U);
  EXPECT_EQ(simulation.velocity(1), (Vec3{1, 0, 0}));
  EXPECT_EQ(spins_after, Spins{});
}

}  // namespace
}  // namespace hardball::contact_outcomes_test
