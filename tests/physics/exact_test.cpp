// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Motions that are known in closed form or must reverse.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "hardball/simulation/simulation.hpp"
#include "support/gas.hpp"
#include "support/record.hpp"

namespace hardball::exact_test {
namespace {

using namespace support;

// Every engine, with cells far smaller than a sphere and cells larger than the box.
std::vector<EngineOptions> all_ways() {
  std::vector<EngineOptions> ways;
  for (const double edge : {0.3, 1.0, 1.1, 2.75, 11.0, 100.0})
    ways.push_back({.engine = EngineKind::cells, .cell_edge = edge});
  for (const EngineKind engine : {EngineKind::cells, EngineKind::neighbors, EngineKind::all_pairs})
    ways.push_back({.engine = engine});
  for (const double edge : {1.0, 1.1, 2.75, 11.0, 100.0}) {
    ways.push_back({.engine = EngineKind::paper, .cell_edge = edge});
  }
  ways.push_back({.engine = EngineKind::paper});
  return ways;
}

// What GoogleTest prints beside a failure.
std::string name_of(const EngineOptions& options) {
  const std::string engine = options.engine == EngineKind::cells       ? "cells"
                             : options.engine == EngineKind::neighbors ? "neighbors"
                             : options.engine == EngineKind::all_pairs ? "all pairs"
                                                                       : "paper";
  const std::string edge = options.cell_edge ? std::to_string(*options.cell_edge) : "chosen";
  return engine + ", edge " + edge;
}

// All these numbers are small dyadic fractions, so nothing is rounded and equality is exact.
TEST(HeadOnPair, MeetsWhenTheGapIsClosedAndExchangesVelocitiesToTheBit) {
  for (const EngineOptions& way : all_ways()) {
    SCOPED_TRACE(name_of(way));
    World world(Box::periodic({16, 16, 16}));
    world.add({.position = {4, 8, 8}, .velocity = {0.75, 0, 0}, .radius = 0.5});
    world.add({.position = {7.5, 8, 8}, .velocity = {-0.5, 0, 0}, .radius = 0.5});
    Simulation simulation(world, way);
    std::vector<Contact> contacts;
    simulation.on_contact([&](const Contact& contact) { contacts.push_back(contact); });
    simulation.run_until(4);
    ASSERT_EQ(contacts.size(), 1U);
    // A gap of 2.5 closes at a speed of 1.25.
    EXPECT_EQ(contacts[0].time, Time(2));
    EXPECT_EQ(contacts[0].position, (Vec3{5.5, 8, 8}));
    EXPECT_EQ(contacts[0].separation, (Vec3{1, 0, 0}));
    EXPECT_EQ(simulation.velocity(0), (Vec3{-0.5, 0, 0}));
    EXPECT_EQ(simulation.velocity(1), (Vec3{0.75, 0, 0}));
    EXPECT_EQ(simulation.position(0), (Vec3{4.5, 8, 8}));
    EXPECT_EQ(simulation.position(1), (Vec3{8, 8, 8}));
  }
}

TEST(HeadOnPair, OfUnequalMassesKeepsMomentumAndEnergyToTheBit) {
  World world;
  world.add({.position = {0, 0, 0}, .velocity = {1, 0, 0}, .radius = 0.5, .mass = 3});
  world.add({.position = {3, 0, 0}, .velocity = {-1, 0, 0}, .radius = 1.5, .mass = 1});
  Simulation simulation(world);
  simulation.run_until(1);
  // The center of mass moves at 1/2; relative to it both velocities are reversed.
  EXPECT_EQ(simulation.velocity(0), (Vec3{0, 0, 0}));
  EXPECT_EQ(simulation.velocity(1), (Vec3{2, 0, 0}));
}

// Six touching or evenly spaced spheres on a ring pass on one unit of velocity, each after one unit of time.
// A ring of eleven and six diameters leave five gaps of one, so that the motion never ends, and every number
// is an integer.
TEST(NewtonsCradle, PassesItsMotionOnAtEveryIntegerTimeWhateverTheEngineAndItsCells) {
  constexpr std::uint32_t kSpheres = 6;
  constexpr std::uint32_t kContacts = 600;
  for (const EngineOptions& way : all_ways()) {
    SCOPED_TRACE(name_of(way));
    World world(Box::periodic({11, 11, 11}));
    for (const double x : {0.0, 1.0, 3.0, 5.0, 7.0, 9.0}) {
      world.add({.position = {x, 5.5, 5.5}, .velocity = {x == 1 ? 1.0 : 0.0, 0, 0}, .radius = 0.5});
    }
    Simulation simulation(world, way);
    std::vector<Contact> contacts;
    simulation.on_contact([&](const Contact& contact) { contacts.push_back(contact); });
    simulation.run_until(kContacts);
    ASSERT_EQ(contacts.size(), kContacts);
    for (std::uint32_t k = 1; k <= kContacts; ++k) {
      const Contact& contact = contacts[k - 1];
      const auto [lower, higher] = std::minmax({k % kSpheres, (k + 1) % kSpheres});
      ASSERT_EQ(contact.time, Time(k));
      ASSERT_EQ(contact.first, lower);
      ASSERT_EQ(contact.second, higher);
      ASSERT_EQ(contact.overlap(), 0);
    }
    // Two of the six spheres collide per unit of time: the mean free time is three.
    EXPECT_EQ(simulation.time() * kSpheres / (2 * kContacts), 3);
  }
}

TEST(NewtonsCradle, StaysAtRestWhenNothingPushesIt) {
  World world(Box::periodic({11, 11, 11}));
  for (int i = 0; i < 11; ++i) world.add({.position = {0.5 + i, 5.5, 5.5}, .radius = 0.5});
  Simulation simulation(world);
  simulation.run_until(1e6);
  EXPECT_EQ(simulation.counters().contacts(), 0U);
}

// A single sphere hits the two walls of an axis alternately, each time after (D - 2r) / |v|.
TEST(OneSphereInABox, BouncesPeriodicallyAlongEachAxisToTheBit) {
  constexpr double kSize = 4;
  constexpr double kRadius = 0.5;
  const Vec3 start{1, 2, 0.5};
  const Vec3 velocity{0.5, -0.25, 0.125};
  for (const EngineOptions& way : all_ways()) {
    SCOPED_TRACE(name_of(way));
    World world(Box::walls({kSize, kSize, kSize}));
    world.add({.position = start, .velocity = velocity, .radius = kRadius});
    Simulation simulation(world, way);
    std::vector<Contact> contacts;
    simulation.on_contact([&](const Contact& contact) { contacts.push_back(contact); });
    // 512 round trips along z, the slowest axis.
    constexpr double kTime = 512 * 2 * (kSize - 2 * kRadius) / 0.125;
    simulation.run_until(kTime);
    std::array<std::uint64_t, kAxes> bounces{};
    for (const Contact& contact : contacts) {
      const std::size_t axis = axis_of(contact.second);
      const double speed = std::fabs(velocity[axis]);
      const double to_first =
          velocity[axis] > 0 ? (kSize - kRadius - start[axis]) / speed : (start[axis] - kRadius) / speed;
      const auto earlier = static_cast<double>(bounces[axis]++);
      ASSERT_EQ(contact.time, Time(to_first + earlier * (kSize - 2 * kRadius) / speed));
    }
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const double speed = std::fabs(velocity[axis]);
      EXPECT_EQ(static_cast<double>(bounces[axis]), kTime * speed / (kSize - 2 * kRadius));
      for (const bool upper : {false, true}) {
        // The force on a wall is v^2 / (D - 2r).
        EXPECT_EQ(simulation.tally().wall_impulse(face_of(axis, upper)) / kTime,
                  speed * speed / (kSize - 2 * kRadius));
      }
    }
    EXPECT_EQ(simulation.position(0), start);
    EXPECT_EQ(simulation.velocity(0), velocity);
  }
}

// The motion of hard spheres is reversible. Rounding errors grow in every collision, ten- to a hundredfold at
// this density and less in denser gases (the error grows by the ratio of free path to radius); after five
// collisions per sphere there and five back, 1e-16 was observed to become 1e-11 to 1e-8.
double expect_to_return(const Gas& gas) {
  constexpr double kCollisionsPerSphere = 5;
  const World world = make_gas(gas);
  Simulation simulation(world);
  const auto spheres = static_cast<double>(gas.count);
  simulation.run_contacts(static_cast<std::uint64_t>(kCollisionsPerSphere * spheres / 2));
  const double turn = simulation.time();
  for (SphereId id = 0; id < gas.count; ++id) simulation.change_velocity(id, -simulation.velocity(id));
  simulation.run_until(2 * turn);
  const Box& box = world.box();
  double farthest = 0;
  for (SphereId id = 0; id < gas.count; ++id) {
    Vec3 apart = simulation.position(id) - world.path(id).position;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (box.is_periodic(axis)) apart[axis] -= box.size()[axis] * std::round(apart[axis] / box.size()[axis]);
    }
    farthest = std::max(farthest, length(apart));
    EXPECT_LT(length(simulation.velocity(id) + world.path(id).velocity), 1e-6);
  }
  EXPECT_LT(farthest, 1e-6);
  return farthest;
}

TEST(ReversedVelocities, BringAPeriodicGasBack) {
  record("farthest_11", expect_to_return({.count = 500, .packing_fraction = 0.1, .seed = 11}));
  record("farthest_12", expect_to_return({.count = 500, .packing_fraction = 0.3, .seed = 12}));
}

TEST(ReversedVelocities, BringAGasBetweenWallsBack) {
  record("farthest_13",
         expect_to_return({.count = 500, .packing_fraction = 0.1, .seed = 13, .boundary = Boundary::wall}));
  record("farthest_14",
         expect_to_return({.count = 500, .packing_fraction = 0.3, .seed = 14, .boundary = Boundary::wall}));
}

TEST(ReversedVelocities, BringACrystalBack) {
  record("farthest_15",
         expect_to_return({.count = 500, .packing_fraction = 0.6, .seed = 15, .start = Start::fcc}));
}

// A row of two species, where like meets like with a restitution of one half, and unlike elastically.
TEST(NewtonsCradle, WithATableOfPairsIsExact) {
  ResponseTable table;
  table.set(0, 0, Bounce({.restitution = ConstantRestitution{0.5}}));
  World world(Box::open());
  for (const SpeciesId i : std::initializer_list<SpeciesId>{0, 1, 2, 3}) {
    world.add({.position = {3.0 * i, 0, 0},
               .velocity = {i == 0 ? 1.0 : 0.0, 0, 0},
               .radius = 0.5,
               .species = static_cast<SpeciesId>(i == 1 ? 1 : 0)});
  }
  world.set_interactions(table);
  Simulation simulation(world);
  std::vector<double> times;
  simulation.on_contact([&](const Contact& contact) { times.push_back(contact.time.value()); });
  simulation.run_until(100);
  EXPECT_EQ(times, (std::vector<double>{2, 4, 6}));
  for (const auto& [id, speed] : {std::pair{0, 0.0}, {1, 0.0}, {2, 0.25}, {3, 0.75}}) {
    EXPECT_EQ(simulation.velocity(static_cast<SphereId>(id)), (Vec3{speed, 0, 0}));
  }
}

}  // namespace
}  // namespace hardball::exact_test
