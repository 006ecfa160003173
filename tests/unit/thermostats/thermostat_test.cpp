// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/thermostats/thermostat.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/numbers/event_random.hpp"
#include "hardball/theory/thermal_motion.hpp"
#include "hardball/world/images.hpp"
#include "hardball/world/totals.hpp"
#include "support/gas.hpp"

namespace hardball::thermostat_test {
namespace {

// Three spheres of unequal mass in a periodic box, one of them stored out of order.
World make_three() {
  World world(Box::periodic({10, 10, 10}));
  world.add({{1, 1, 1}, {1, 0, 0.5}, 0.5, 1});
  world.add({{4, 4, 4}, {0, -2, 0.5}, 0.5, 2});
  world.add({{7, 7, 7}, {0, 1, -1}, 0.5, 4});
  return world;
}

World reordered(World world) {
  const std::vector<Slot> order{2, 0, 1};
  world.reorder(order);
  return world;
}

TEST(EventRandom, DependsOnEachOfItsKeys) {
  std::set<std::uint64_t> seen;
  for (const std::uint64_t seed : {0U, 1U, 2U}) {
    for (const SphereId sphere : {0U, 1U, 2U}) {
      for (const std::uint64_t count : {0U, 1U, 2U}) seen.insert(event_random(seed, sphere, count).bits());
    }
  }
  EXPECT_EQ(seen.size(), 27U);
  EXPECT_EQ(event_random(1, 2, 3).bits(), event_random(1, 2, 3).bits());
}

// Numbers of successive events, and of neighboring spheres, are not correlated.
TEST(EventRandom, GivesIndependentNormalNumbers) {
  constexpr int kEvents = 20000;
  double squares = 0;
  double with_next_event = 0;
  double with_next_sphere = 0;
  for (std::uint64_t k = 0; k < kEvents; ++k) {
    const auto draw = [](SphereId sphere, std::uint64_t count) {
      Random random = event_random(5, sphere, count);
      return random.normal_vector(3);
    };
    const Vec3 own = draw(7, k);
    squares += dot(own, own);
    with_next_event += dot(own, draw(7, k + 1));
    with_next_sphere += dot(own, draw(8, k));
  }
  // Sums of 3 k products of variance one, and of squares of variance two.
  const double deviation = std::sqrt(3.0 * kEvents);
  EXPECT_NEAR(squares, 3 * kEvents, 4 * std::sqrt(2.0) * deviation);
  EXPECT_NEAR(with_next_event, 0, 4 * deviation);
  EXPECT_NEAR(with_next_sphere, 0, 4 * deviation);
}

TEST(Andersen, HasAPoissonProcessForEachSphere) {
  constexpr double kRate = 3;
  const World world = support::make_gas({.count = 20, .packing_fraction = 0.1});
  Thermostat thermostat(Andersen(1, kRate), 9);
  thermostat.begin(world, Time(2));
  std::vector<double> last(20, 2);
  double sum = 0;
  double squares = 0;
  constexpr int kEvents = 20000;
  double previous = 2;
  for (int k = 0; k < kEvents; ++k) {
    const double time = thermostat.next();
    EXPECT_GE(time, previous);
    previous = time;
    const auto changes = thermostat.act(world, Time(time));
    ASSERT_EQ(changes.size(), 1U);
    double& its_last = last[world.id(changes[0].slot)];
    const double wait = time - its_last;
    its_last = time;
    sum += wait;
    squares += wait * wait;
  }
  // Waits are exponential: their deviation is their mean, and that of their squares sqrt(20) / rate^2.
  EXPECT_NEAR(sum / kEvents * kRate, 1, 4 / std::sqrt(kEvents));
  EXPECT_NEAR(squares / kEvents * kRate * kRate, 2, 4 * std::sqrt(20.0 / kEvents));
  EXPECT_EQ(thermostat.events(), static_cast<std::uint64_t>(kEvents));
}

TEST(Andersen, GivesMaxwellVelocitiesByMass) {
  constexpr double kTemperature = 0.5;
  const World world = make_three();
  Thermostat thermostat(Andersen(kTemperature, 1), 10);
  thermostat.begin(world, Time(0));
  std::vector<double> squares(3);
  std::vector<double> counts(3);
  for (int k = 0; k < 30000; ++k) {
    const NewVelocity change = thermostat.act(world, Time(thermostat.next()))[0];
    squares[change.slot] += world.mass(change.slot) * dot(change.after, change.after);
    ++counts[change.slot];
  }
  for (std::size_t i = 0; i < 3; ++i) {
    // m v^2 / 3 kT of so many velocities has the deviation sqrt(2 / 3 count).
    EXPECT_NEAR(squares[i] / counts[i] / 3 / kTemperature, 1, 4 * std::sqrt(2 / (3 * counts[i])));
  }
}

// The processes of the other spheres continue as they would have.
TEST(Andersen, FollowsSpheresThatComeAndGo) {
  World world = make_three();
  const auto times_of = [&](SphereId sphere, bool is_removed) {
    Thermostat thermostat(Andersen(1, 1), 11);
    thermostat.begin(world, Time(0));
    thermostat.note_added(3, Time(0));
    if (is_removed) thermostat.note_removed(1);
    World with(world);
    with.add({{9, 9, 9}});
    if (is_removed) with.remove(1);
    std::vector<double> times;
    while (thermostat.next() < 20) {
      const double time = thermostat.next();
      if (with.id(thermostat.act(with, Time(time))[0].slot) == sphere) times.push_back(time);
    }
    return times;
  };
  EXPECT_TRUE(times_of(1, true).empty());
  for (const SphereId sphere : {0U, 2U, 3U}) {
    EXPECT_FALSE(times_of(sphere, false).empty());
    EXPECT_EQ(times_of(sphere, false), times_of(sphere, true));
  }
}

TEST(Rescale, SetsTheTemperatureAboutTheDrift) {
  const World world = make_three();
  Thermostat thermostat(Rescale(2, 0.25));
  thermostat.begin(world, Time(1));
  EXPECT_EQ(thermostat.next(), 1.25);
  Vec3 before;
  Vec3 after;
  double mass = 0;
  for (const NewVelocity& change : thermostat.act(world, Time(1.25))) {
    before += world.mass(change.slot) * change.before;
    after += world.mass(change.slot) * change.after;
    mass += world.mass(change.slot);
  }
  EXPECT_LT(length(after - before), 1e-14);
  const Vec3 drift = (1 / mass) * after;
  double twice_energy = 0;
  Thermostat again(Rescale(2, 0.25));
  again.begin(world, Time(1));
  for (const NewVelocity& change : again.act(world, Time(1.25))) {
    const Vec3 relative = change.after - drift;
    twice_energy += world.mass(change.slot) * dot(relative, relative);
  }
  EXPECT_NEAR(twice_energy / 6, 2, 1e-14) << "six degrees of freedom: nine less three of the drift";
  EXPECT_EQ(thermostat.next(), 1.5);
}

TEST(Rescale, CountsAllMotionBetweenWalls) {
  World world(Box::walls({10, 10, 10}));
  world.add({{3, 3, 3}, {1, 2, 3}, 0.5, 2});
  Thermostat thermostat(Rescale(7, 1));
  thermostat.begin(world, Time(0));
  const Vec3 after = thermostat.act(world, Time(1))[0].after;
  EXPECT_NEAR(2 * dot(after, after) / 3, 7, 1e-14);
  EXPECT_NEAR(thermostat.energy(), 1.5 * 7 - 14, 1e-13);
}

TEST(Rescale, LeavesSpheresAtRest) {
  World world(Box::periodic({10, 10, 10}));
  world.add({{3, 3, 3}});
  world.add({{6, 6, 6}});
  Thermostat thermostat(Rescale(7, 1));
  thermostat.begin(world, Time(0));
  EXPECT_TRUE(thermostat.act(world, Time(1)).empty());
  EXPECT_EQ(thermostat.next(), 2);
}

World make_sheared(std::size_t spheres) {
  Box box = Box::periodic({10, 10, 10});
  box.set_shear({.rate = 0.7});
  World world(box);
  Random random(5);
  for (std::size_t k = 0; k < spheres; ++k) {
    const Vec3 position{10 * random.uniform(), 10 * random.uniform(), 10 * random.uniform()};
    // A flow that is not the linear one, and thermal motion.
    const double flow = 3 * (position.y > 5 ? 1 : -1) + 0.3 * random.normal();
    world.add({.position = position, .velocity = {flow, random.normal(), random.normal()}, .radius = 0.01});
  }
  return world;
}

TEST(Rescale, InAShearedBoxIsRelativeToTheFlow) {
  World world = make_sheared(500);
  Thermostat thermostat(Rescale(2, 1));
  thermostat.begin(world, Time(0));
  const double before = kinetic_energy(world, Time(1));
  for (const NewVelocity& change : thermostat.act(world, Time(1)))
    world.change_velocity(change.slot, Time(1), change.after);
  EXPECT_NEAR(thermal_motion(world, Time(1)).temperature(), 2, 1e-13);
  EXPECT_NEAR(thermostat.energy(), kinetic_energy(world, Time(1)) - before, 1e-10);
}

// The mean velocity of each slab stays, and the temperature relative to it is the one wanted.
TEST(Rescale, InSlabsKeepsTheProfileOfTheFlow) {
  World world = make_sheared(500);
  constexpr std::size_t kSlabs = 4;
  Thermostat thermostat(Rescale(2, 1, kSlabs));
  thermostat.begin(world, Time(0));
  const auto means = [&] {
    std::array<Vec3, kSlabs> sums{};
    std::array<double, kSlabs> counts{};
    for (Slot slot = 0; slot < world.size(); ++slot) {
      const auto slab = static_cast<std::size_t>(world.position(slot, Time(1)).y / 10 * kSlabs);
      sums[slab] += peculiar_velocity(world, slot, Time(1));
      ++counts[slab];
    }
    for (std::size_t slab = 0; slab < kSlabs; ++slab) sums[slab] = (1 / counts[slab]) * sums[slab];
    return sums;
  };
  const std::array<Vec3, kSlabs> before = means();
  for (const NewVelocity& change : thermostat.act(world, Time(1)))
    world.change_velocity(change.slot, Time(1), change.after);
  const std::array<Vec3, kSlabs> after = means();
  for (std::size_t slab = 0; slab < kSlabs; ++slab) EXPECT_LT(length(after[slab] - before[slab]), 1e-12);
  EXPECT_GT(length(before[0] - before[3]), 1);
  double twice_energy = 0;
  for (Slot slot = 0; slot < world.size(); ++slot) {
    const auto slab = static_cast<std::size_t>(world.position(slot, Time(1)).y / 10 * kSlabs);
    const Vec3 thermal = peculiar_velocity(world, slot, Time(1)) - after[slab];
    twice_energy += dot(thermal, thermal);
  }
  EXPECT_NEAR(twice_energy / (3.0 * (500 - kSlabs)), 2, 1e-12);
  EXPECT_THROW(Thermostat(Rescale(1, 1, 2)).begin(World(Box::open()), Time(0)), Error);
}

TEST(Andersen, GivesVelocitiesRelativeToTheFlow) {
  const World world = make_sheared(2000);
  Thermostat thermostat(Andersen(0.25, 1e-3));
  thermostat.begin(world, Time(0));
  double correlation = 0;
  double square = 0;
  for (int k = 0; k < 1000; ++k) {
    const Time now(thermostat.next());
    for (const NewVelocity& change : thermostat.act(world, now)) {
      const double flow = flow_velocity(world, change.slot, now).x;
      correlation += flow * change.after.x;
      square += flow * flow;
    }
  }
  // The slope of the new velocities over the flow: one, with an error of 0.5 / sqrt(sum of squares).
  EXPECT_NEAR(correlation / square, 1, 4 * 0.5 / std::sqrt(square));
}

TEST(Heating, KicksAllSpheresAndKeepsTheMomentum) {
  constexpr std::size_t kSpheres = 4000;
  const World world = support::make_gas({.count = kSpheres, .packing_fraction = 0.1});
  Thermostat thermostat(Heating(0.5, 0.25), 12);
  thermostat.begin(world, Time(0));
  Vec3 momentum;
  Vec3 squares;
  double energy = 0;
  for (const NewVelocity& change : thermostat.act(world, Time(0.25))) {
    const Vec3 kick = change.after - change.before;
    momentum += kick;
    squares += Vec3{kick.x * kick.x, kick.y * kick.y, kick.z * kick.z};
    energy += (dot(change.after, change.after) - dot(change.before, change.before)) / 2;
  }
  EXPECT_LT(length(momentum), 1e-11);
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    EXPECT_NEAR(squares[axis] / kSpheres / 0.125, 1, 4 * std::sqrt(2.0 / kSpheres));
  }
  EXPECT_NEAR(thermostat.energy(), energy, 1e-9);
  EXPECT_EQ(thermostat.events(), 1U);
}

TEST(Thermostat, DoesNotDependOnHowSpheresAreStored) {
  const World world = make_three();
  const World other = reordered(make_three());
  for (const ThermostatKind& kind :
       {ThermostatKind(Andersen(1, 1)), ThermostatKind(Rescale(1, 1)), ThermostatKind(Heating(1, 1))}) {
    Thermostat one(kind, 13);
    Thermostat two(kind, 13);
    one.begin(world, Time(0));
    two.begin(other, Time(0));
    for (int k = 0; k < 20; ++k) {
      ASSERT_EQ(one.next(), two.next());
      const Time moment(one.next());
      const auto changes = one.act(world, moment);
      const auto others = two.act(other, moment);
      ASSERT_EQ(changes.size(), others.size());
      for (std::size_t i = 0; i < changes.size(); ++i) {
        EXPECT_EQ(world.id(changes[i].slot), other.id(others[i].slot)) << "in the order of ids";
        EXPECT_EQ(changes[i].after, others[i].after);
      }
      EXPECT_EQ(one.energy(), two.energy());
    }
  }
}

TEST(Thermostat, LeavesKinematicSpheres) {
  World world(Box::periodic({10, 10, 10}));
  world.add({{1, 1, 1}, {1, 0, 0}, 0.5, std::numeric_limits<double>::infinity()});
  world.add({{4, 4, 4}, {0, 2, 0}, 0.5, 2});
  for (const ThermostatKind& kind :
       {ThermostatKind(Andersen(1, 1)), ThermostatKind(Rescale(1, 1)), ThermostatKind(Heating(1, 1))}) {
    Thermostat thermostat(kind);
    thermostat.begin(world, Time(0));
    std::size_t changed = 0;
    for (int k = 0; k < 20; ++k) {
      for (const NewVelocity& change : thermostat.act(world, Time(thermostat.next()))) {
        EXPECT_EQ(world.id(change.slot), 1U);
        EXPECT_TRUE(std::isfinite(length(change.after)));
        ++changed;
      }
    }
    EXPECT_GT(changed, 3U);
    EXPECT_TRUE(std::isfinite(thermostat.energy()));
  }
}

TEST(Thermostat, RefusesParametersThatAreNotPositive) {
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), 1e61}) {
    EXPECT_THROW(Andersen(bad, 1), Error);
    EXPECT_THROW(Andersen(1, bad), Error);
    EXPECT_THROW(Rescale(bad, 1), Error);
    EXPECT_THROW(Rescale(1, bad), Error);
    EXPECT_THROW(Heating(bad, 1), Error);
    EXPECT_THROW(Heating(1, bad), Error);
  }
}

}  // namespace
}  // namespace hardball::thermostat_test
