// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Spheres that grow, in cases that are known exactly.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/world/audit.hpp"
#include "hardball/world/totals.hpp"
#include "hardball/world/walls.hpp"
#include "support/crystal.hpp"
#include "support/gas.hpp"
#include "support/refusal.hpp"

namespace hardball::growth_test {
namespace {

using support::refusal_of;

// Two spheres approach each other with u = -1 while the sum of their radii grows with 1/2: they part with
// u' = 2 * 1/2 + 1 = 2.
TEST(GrowingSpheres, PartByTwiceTheGrowth) {
  World world(Box::open());
  world.add({.position = {0, 0, 0}, .velocity = {0.5, 0, 0}, .radius = 0.5});
  world.add({.position = {4, 0, 0}, .velocity = {-0.5, 0, 0}, .radius = 0.5});
  world.set_growth({Time(0), Time(10), 1, 0.5});
  Simulation simulation(world);
  // 4 - t = 1 + t / 2
  EXPECT_EQ(simulation.next_contact(10)->time, 2);
  simulation.run_until(2);
  EXPECT_EQ(simulation.velocity(1) - simulation.velocity(0), (Vec3{2, 0, 0}));
  EXPECT_EQ(simulation.tally().growth_work(), 0.75);
  EXPECT_EQ(simulation.sphere(0).radius(), 1);
}

// The law of restitution is that of the surfaces: they close in with 1.5 and part with half of it, as in a
// function that halves what it sees.
TEST(GrowingSpheres, PartByTheRestitutionOfTheirSurfaces) {
  World world(Box::open());
  world.add({.position = {0, 0, 0}, .velocity = {0.5, 0, 0}, .radius = 0.5});
  world.add({.position = {4, 0, 0}, .velocity = {-0.5, 0, 0}, .radius = 0.5, .mass = 3});
  world.set_interactions(Restitution(0.5));
  world.set_growth({Time(0), Time(10), 1, 0.5});
  Simulation by_table(world);
  by_table.run_until(2);
  EXPECT_DOUBLE_EQ(by_table.velocity(1).x - by_table.velocity(0).x, 0.5 + 0.75);
  EXPECT_DOUBLE_EQ(momentum(by_table.world(), by_table.now()).x, -1);
  Simulation by_function(world);
  by_function.respond_with([](const Contact& contact) {
    const Vec3 closing = contact.before.second - contact.before.first;
    EXPECT_DOUBLE_EQ(closing.x, -1.5);
    return Velocities{contact.before.first + (1.5 * 0.75) * closing,
                      contact.before.second - (1.5 * 0.25) * closing};
  });
  by_function.run_until(2);
  EXPECT_DOUBLE_EQ(by_function.velocity(1).x - by_function.velocity(0).x, 0.5 + 0.75);
}

// A sphere at rest between walls meets both at once, and then moves as fast as they close in.
TEST(GrowingSpheres, MeetWalls) {
  World world(Box::walls({10, 10, 10}));
  world.add({.position = {2, 5, 5}, .velocity = {-0.5, 0, 0}, .radius = 0.5});
  world.set_growth({Time(0), Time(4), 1, 0.5});
  Simulation simulation(world);
  // 2 - t / 2 = 1/2 + t / 4
  EXPECT_EQ(simulation.next_contact(4)->time, 2);
  simulation.run_until(2);
  EXPECT_EQ(simulation.velocity(0), (Vec3{1, 0, 0}));
}

// At rest all neighbors of a crystal touch at one moment, with no speed but that of growth, and could grow no
// further. What each contact gives is the work of growth.
TEST(GrowingSpheres, OfACrystalAtRestTouchAtOnce) {
  World world = support::make_crystal(support::face_centered_cubic(), 3, 1.25);
  world.set_growth({Time(0), Time(1.2), 1, 0.25});
  Simulation simulation(world);
  std::vector<double> times;
  simulation.on_contact([&](const Contact& contact) { times.push_back(contact.time.value()); });
  ASSERT_EQ(simulation.run_contacts(6 * world.size()), 6 * world.size());
  for (const double time : times) EXPECT_NEAR(time, 1, 1e-12);
  EXPECT_NEAR(kinetic_energy(simulation.world(), simulation.now()), simulation.tally().growth_work(),
              1e-12 * simulation.tally().growth_work());
  EXPECT_LT(audit(simulation.world(), simulation.now()).max_overlap, 1e-12);
}

// When growth has been stopped, spheres are as if they had always had their sizes.
TEST(GrowingSpheres, KeepTheirSizesAfterwards) {
  Simulation simulation(support::make_gas({.count = 200, .packing_fraction = 0.2}));
  simulation.grow({.rate = 0.1, .until_packing_fraction = 0.4});
  simulation.run_until(1);
  const double radius = simulation.sphere(7).radius();
  simulation.stop_growing();
  EXPECT_FALSE(simulation.world().motion().has_growth());
  EXPECT_FALSE(simulation.growth());
  EXPECT_EQ(simulation.sphere(7).radius(), radius);
  EXPECT_EQ(simulation.world().base_radius(7), radius);
  const double energy = kinetic_energy(simulation.world(), simulation.now());
  simulation.run_contacts(2000);
  EXPECT_NEAR(kinetic_energy(simulation.world(), simulation.now()), energy, 1e-12 * energy);
  EXPECT_LT(audit(simulation.world(), simulation.now()).max_overlap, 1e-12);
  simulation.validate();
}

// d ln T / dC = sqrt(pi) / 3 times the rate, for each collision of a sphere, at constant rate: T is a square.
TEST(GrowingSpheres, AreHeatedByEveryCollision) {
  World world = support::make_gas({.count = 2000, .packing_fraction = 0.1, .seed = 3});
  constexpr double kRate = 0.01;
  world.set_growth({Time(0), Time(40), 1, kRate});
  Simulation simulation(world);
  const double before = kinetic_energy(simulation.world(), simulation.now());
  simulation.run_contacts(10 * world.size());
  const double after = kinetic_energy(simulation.world(), simulation.now());
  const double of_a_sphere = 2.0 * 10;
  const double expected = std::pow(1 + std::sqrt(std::numbers::pi) / 6 * kRate * of_a_sphere, 2);
  EXPECT_NEAR((after / before - 1) / (expected - 1), 1, 0.03);
}

// Growth ends with exactly what was wanted, and constant sizes.
TEST(GrowingSpheres, ReachThePackingFractionWanted) {
  for (const double rate : {0.3, 0.03, -0.1}) {
    const double from = rate > 0 ? 0.2 : 0.3;
    Simulation simulation(support::make_gas({.count = 300, .packing_fraction = from}));
    const double to = rate > 0 ? 0.5 : 0.1;
    simulation.grow({.rate = rate, .until_packing_fraction = to});
    while (!simulation.growth()->is_over()) simulation.run_until(simulation.growth()->next());
    EXPECT_EQ(simulation.growth()->state(), GrowthSchedule::State::reached);
    EXPECT_NEAR(packing_fraction(simulation.world(), simulation.now()), to, 1e-13 * to);
    const double hash_time = simulation.time();
    simulation.run_until(hash_time + 1);
    EXPECT_NEAR(packing_fraction(simulation.world(), simulation.now()), to, 1e-13 * to);
    EXPECT_LT(audit(simulation.world(), simulation.now()).max_overlap, 1e-12);
  }
}

// Spheres that cannot go on growing are not compressed without end.
TEST(GrowingSpheres, EndWhereOnlyOneFits) {
  World world(Box::periodic({3, 3, 3}));
  world.add({.position = {1, 1, 1}, .velocity = {1, 0.3, 0.2}, .radius = 0.5});
  Simulation simulation(world);
  simulation.grow({.rate = 0.5});
  simulation.run_until(100);
  EXPECT_EQ(simulation.growth()->state(), GrowthSchedule::State::no_room);
  EXPECT_NEAR(simulation.sphere(0).radius(), 1.5, 1e-6);
}

TEST(GrowingSpheres, AreRefusedWhereTheyCannotBe) {
  const World gas = support::make_gas({.count = 50, .packing_fraction = 0.2});
  const auto refusal = [&](World world) {
    return refusal_of([&] { world.set_growth({Time(0), Time(1), 1, 0.1}); });
  };
  World falling(Box::open(), {0, 0, -1});
  EXPECT_NE(refusal(falling).find("gravity"), std::string::npos);
  Simulation simulation(gas);
  EXPECT_NE(refusal_of([&] { simulation.grow({.rate = 0}); }).find("rate"), std::string::npos);
  EXPECT_NE(refusal_of([&] { simulation.grow({.until_packing_fraction = 0.1}); }).find("0.1"),
            std::string::npos);
  EXPECT_NE(refusal_of([&] { simulation.grow({.rate = -0.1}); }).find("packing_fraction"), std::string::npos);
  World at_rest(Box::periodic({5, 5, 5}));
  at_rest.add({.position = {1, 1, 1}, .radius = 0.5});
  Simulation resting(at_rest);
  EXPECT_NE(refusal_of([&] { resting.grow({}); }).find("rest"), std::string::npos);
  World mixed(Box::periodic({5, 5, 5}));
  mixed.add({.position = {1, 1, 1}, .radius = 0.5, .mass = std::numeric_limits<double>::infinity()});
  EXPECT_NE(refusal(mixed).find("kinematic"), std::string::npos);
  simulation.grow({.rate = 0.1, .until_packing_fraction = 0.3});
  EXPECT_NE(refusal_of([&] {
              simulation.add({.position = {1, 1, 1}, .radius = 0.01});
            }).find("grow"),
            std::string::npos);
  EXPECT_NE(refusal_of([&] { simulation.remove(3); }).find("grow"), std::string::npos);
  EXPECT_NE(refusal_of([&] { static_cast<void>(simulation.positions_at(1e6)); }).find("epoch"),
            std::string::npos);
  for (const bool merges : {true, false}) {
    simulation.respond_with([merges](const Contact& contact) {
      Outcome outcome(contact, {contact.before.second, contact.before.first});
      outcome.merges = merges;
      if (!merges) outcome.spins.first = {0, 0, 1};
      return outcome;
    });
    EXPECT_NE(refusal_of([&] { simulation.run_contacts(1); }).find(merges ? "merge" : "spin"),
              std::string::npos);
  }
  EXPECT_NE(refusal_of([&] {
              static_cast<void>(simulation.first_contact(0, {1, 0, 0}, simulation.time() + 1));
            }).find("grow"),
            std::string::npos);
}

// Few spheres between walls lock so suddenly that no epoch before tells. Growth ends nevertheless, where
// gaps are no longer resolved, and does so in the same way for every engine.
// Whichever candidates an engine looks at, a sphere never meets its own image.
TEST(Growth, EndsAtOnceWhereASphereFillsTheBox) {
  for (const EngineOptions& options : {EngineOptions{.engine = EngineKind::all_pairs},
                                       EngineOptions{.engine = EngineKind::cells, .cell_edge = 3.0}}) {
    World world(Box::periodic({1, 1, 4}));
    world.add({.position = {0.5, 0.5, 1}, .velocity = {0.1, 0.2, 0.3}, .radius = 0.5});
    world.add({.position = {0.5, 0.5, 3}, .velocity = {0.2, -0.2, -0.1}, .radius = 0.5});
    Simulation simulation(std::move(world), options);
    simulation.grow({.rate = 0.01});
    simulation.run_contacts(50, 100);
    EXPECT_EQ(simulation.growth()->state(), GrowthSchedule::State::no_room);
    EXPECT_GT(simulation.time(), 1);
  }
}

TEST(Growth, EndsWhereFewSpheresLock) {
  std::uint64_t hash = 0;
  for (const EngineOptions& options :
       {EngineOptions{.engine = EngineKind::all_pairs}, EngineOptions{.engine = EngineKind::cells},
        EngineOptions{.engine = EngineKind::neighbors}, EngineOptions{.threads = 2}}) {
    World world(Box(), {}, {Surface(HollowSphere(2), {0, 0, 0})});
    world.add({.position = {1, 0, 0}, .velocity = {0.3, 1, 0.1}, .radius = 0.3});
    world.add({.position = {-1, 0, 0}, .velocity = {1, 0.2, -0.5}, .radius = 0.4});
    world.add({.position = {0, 1.2, 0}, .velocity = {-0.4, 0.5, 1}, .radius = 0.2});
    Simulation simulation(std::move(world), options);
    simulation.grow({.rate = 0.1, .until_packing_fraction = 0.7});
    // Not until a time: locked spheres meet without end.
    for (int turn = 0; turn < 100 && !simulation.growth()->is_over(); ++turn) simulation.run_contacts(100);
    EXPECT_EQ(simulation.growth()->state(), GrowthSchedule::State::over_pressure);
    const double fraction = packing_fraction(simulation.world(), simulation.now());
    EXPECT_GT(fraction, 0.2);
    EXPECT_LT(fraction, 0.4) << "of three that touch each other and the wall";
    if (hash == 0) hash = simulation.event_log_hash();
    EXPECT_EQ(simulation.event_log_hash(), hash);
  }
}

}  // namespace
}  // namespace hardball::growth_test
