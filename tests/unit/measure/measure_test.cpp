// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "hardball/measure/event_log_hash.hpp"
#include "hardball/measure/tally.hpp"
#include "hardball/simulation/simulation.hpp"
#include "support/interacting.hpp"

namespace hardball::measure_test {
namespace {

Contact contact_of(double time, std::uint32_t first, std::uint32_t second) {
  Contact contact;
  contact.time = Time(time);
  contact.first = first;
  contact.second = second;
  return contact;
}

std::uint64_t hash_of(const std::vector<Contact>& log) {
  EventLogHash hash;
  for (const Contact& contact : log) hash.note(contact);
  return hash.value();
}

TEST(EventLogHash, DistinguishesTimesKindsIdsAndWhatWasBefore) {
  const Contact a = contact_of(1, 2, 3);
  const Contact b = contact_of(2, 4, 5);
  const std::uint64_t hash = hash_of({a, b});
  EXPECT_EQ(hash_of({b, a}), hash) << "their times order them";
  EXPECT_NE(hash_of({a}), hash);
  EXPECT_NE(hash_of({}), hash);
  EXPECT_NE(hash_of({a, b, b}), hash);
  EXPECT_NE(hash_of({contact_of(std::nextafter(1, 2), 2, 3), b}), hash);
  EXPECT_NE(hash_of({contact_of(1, 3, 2), b}), hash);
  EXPECT_NE(hash_of({contact_of(1, 2, 5), contact_of(2, 4, 3)}), hash);
  Contact finer = a;
  finer.time.low = 1e-30;
  EXPECT_NE(hash_of({finer, b}), hash);
  Contact wall = a;
  wall.kind = EventKind::wall;
  EXPECT_NE(hash_of({wall, b}), hash);
  for (const Time since : {Time(0.5), Time(0, 1e-30)}) {
    Contact later = a;
    later.first_since = since;
    EXPECT_NE(hash_of({later, b}), hash);
    Contact other = a;
    other.second_since = since;
    EXPECT_NE(hash_of({other, b}), hash);
    EXPECT_NE(hash_of({other, b}), hash_of({later, b}));
  }
}

// Of the balls 0, 1, 2 the middle one meets both others at time 1.
TEST(EventLogHash, DistinguishesWhichOfTwoContactsInOneMomentWasFirst) {
  Contact a = contact_of(1, 0, 1);
  Contact b = contact_of(1, 1, 2);
  b.first_since = Time(1);
  const std::uint64_t hash = hash_of({a, b});
  a.second_since = Time(1);
  b.first_since = Time(0);
  EXPECT_NE(hash_of({b, a}), hash);
}

// Whole numbers and their opposites, as exact worlds have them, differ in the upper bits of several words.
TEST(EventLogHash, DiffersForContactsWithFewBits) {
  const std::vector<double> times{-2, -1, 0, 0.5, 1, 2, 3, 4};
  std::vector<std::uint64_t> hashes;
  for (const double high : times) {
    for (const double low : times) {
      for (const double first : times) {
        for (const double second : times) {
          for (const double second_low : {-1.0, 0.0, 1.0}) {
            for (const std::uint32_t id : {1U, 2U, 3U}) {
              Contact contact = contact_of(high, 0, id);
              contact.time.low = low;
              contact.first_since = Time(first, -low);
              contact.second_since = Time(second, second_low);
              hashes.push_back(hash_of({contact}));
              contact.kind = EventKind::wall;
              hashes.push_back(hash_of({contact}));
            }
          }
        }
      }
    }
  }
  const std::size_t count = hashes.size();
  std::ranges::sort(hashes);
  const auto repeated = std::ranges::unique(hashes);
  EXPECT_EQ(hashes.size() - repeated.size(), count);
  // And each bit is set in half of them: of so many, by less than six standard deviations more or less.
  for (int bit = 0; bit < 64; ++bit) {
    const auto set =
        std::ranges::count_if(hashes, [bit](std::uint64_t hash) { return (hash >> bit & 1) != 0; });
    EXPECT_NEAR(static_cast<double>(set), static_cast<double>(count) / 2, 3 * std::sqrt(count));
  }
}

TEST(EventLogHash, HasOneZero) {
  Contact contact = contact_of(1, 2, 3);
  const std::uint64_t hash = hash_of({contact});
  contact.time.low = -0.0;
  contact.first_since = contact.second_since = Time(0, -0.0);
  EXPECT_EQ(hash_of({contact}), hash);
}

// Two spheres of radius 1/2 and mass 2 meet head-on at relative speed 4, every 2 units of time: round a box
// of 10 the gap between their surfaces is 9, then 8.
TEST(Tally, OfAHeadOnPairInAPeriodicBoxMatchesAHandCalculation) {
  World world(Box::periodic({10, 10, 10}));
  world.add({{1, 5, 5}, {3, 0, 0}, 0.5, 2});
  world.add({{6, 5, 5}, {-1, 0, 0}, 0.5, 2});
  Simulation simulation(world);
  // Gaps of 4 and then 8 close at speed 4: contacts at 1, 3.25 (a gap of 9), 5.5, ...
  simulation.run_until(6);
  const Tally& tally = simulation.tally();
  EXPECT_EQ(tally.collisions(), 3U);
  EXPECT_EQ(tally.wall_contacts(), 0U);
  EXPECT_EQ(tally.initial_energy(), 10);
  EXPECT_DOUBLE_EQ(tally.energy_integral(simulation.now()), 60);
  // Each gives the impulse 2 * 4 over the distance 1.
  EXPECT_DOUBLE_EQ(tally.virial(), 24);
  EXPECT_DOUBLE_EQ(tally.impact_speed_sum(), 12);
  EXPECT_DOUBLE_EQ(tally.impact_speed_square_sum(), 48);
  // 1 + virial / (2 integral of the energy).
  EXPECT_DOUBLE_EQ(tally.compressibility(simulation.now()), 1 + 24.0 / 120);
  EXPECT_LE(tally.max_overlap(), 1e-15);
  EXPECT_TRUE(std::isnan(tally.wall_pressure(world.box(), simulation.now())));
}

TEST(Tally, OfASphereBetweenWallsHasTheImpulseOnEachFace) {
  World world(Box::walls({12, 10, 8}));
  world.add({{6, 5, 4}, {5, 0, -1}, 1, 3});
  Simulation simulation(world);
  // Along x the free length is 10: hits at 1, 3, 5, ... in turn; along z 6: at 3, 9, ...
  simulation.run_until(10);
  const Tally& tally = simulation.tally();
  EXPECT_EQ(tally.wall_contacts(), 7U);
  EXPECT_EQ(tally.wall_impulse(face_of(0, true)), 3 * 30);
  EXPECT_EQ(tally.wall_impulse(face_of(0, false)), 2 * 30);
  EXPECT_EQ(tally.wall_impulse(face_of(1, true)), 0);
  EXPECT_EQ(tally.wall_impulse(face_of(2, false)), 6);
  EXPECT_EQ(tally.wall_impulse(face_of(2, true)), 6);
  const double area = 2 * (12 * 10 + 10 * 8 + 8 * 12);
  EXPECT_DOUBLE_EQ(tally.wall_pressure(world.box(), simulation.now()), (150 + 12) / (area * 10));
  EXPECT_EQ(tally.compressibility(simulation.now()), 1) << "nothing collided";
}

TEST(Tally, FollowsTheEnergyThroughLossesAndEdits) {
  World world(Box::walls({12, 12, 12}));
  world.add({{6, 6, 6}, {5, 0, 0}, 1, 2});
  Simulation simulation(support::interacting(world, Restitution(0.5)));
  simulation.run_until(2);  // after a bounce at 1 its speed is 2.5
  EXPECT_DOUBLE_EQ(simulation.tally().energy_integral(simulation.now()), 25 + 6.25);
  simulation.change_velocity(0, {0, 1, 0});
  simulation.run_until(3);
  EXPECT_DOUBLE_EQ(simulation.tally().energy_integral(simulation.now()), 25 + 6.25 + 1);
  const SphereId other = simulation.add({{2, 2, 2}, {0, 2, 0}, 1, 1});
  simulation.run_until(4);
  EXPECT_DOUBLE_EQ(simulation.tally().energy_integral(simulation.now()), 25 + 6.25 + 1 + 3);
  simulation.remove(other);
  simulation.run_until(5);
  EXPECT_DOUBLE_EQ(simulation.tally().energy_integral(simulation.now()), 25 + 6.25 + 1 + 3 + 1);
  EXPECT_EQ(simulation.tally().initial_energy(), 25);
}

TEST(Tally, RecordsTheDeepestOverlap) {
  Tally tally;
  World world;
  tally.begin(world, Time(0));
  Contact contact = contact_of(1, 0, 1);
  contact.reach = 2;
  contact.first_mass = contact.second_mass = 1;
  for (const double distance : {2.5, 1.75, 1.875}) {
    contact.separation = {distance, 0, 0};
    tally.note(contact);
  }
  EXPECT_EQ(tally.max_overlap(), 0.125);
}

TEST(Tally, HasNoPressureBeforeTimeHasPassed) {
  Simulation simulation{World(Box::walls({1, 1, 1}))};
  EXPECT_TRUE(std::isnan(simulation.tally().compressibility(simulation.now())));
  EXPECT_TRUE(std::isnan(simulation.tally().wall_pressure(simulation.world().box(), simulation.now())));
}

}  // namespace
}  // namespace hardball::measure_test
