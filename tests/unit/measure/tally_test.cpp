// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "hardball/archive/archive.hpp"
#include "hardball/measure/energy_gain.hpp"
#include "hardball/measure/event_log_hash.hpp"
#include "hardball/measure/tally.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/world/totals.hpp"
#include "support/interacting.hpp"

namespace hardball::tally_test {
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
  for (const Contact& contact : log) hash.record(contact);
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
    tally.record(contact);
  }
  EXPECT_EQ(tally.max_overlap(), 0.125);
}

TEST(Tally, HasNoPressureBeforeTimeHasPassed) {
  Simulation simulation{World(Box::walls({1, 1, 1}))};
  EXPECT_TRUE(std::isnan(simulation.tally().compressibility(simulation.now())));
  EXPECT_TRUE(std::isnan(simulation.tally().wall_pressure(simulation.world().box(), simulation.now())));
}

// The contacts of a run, shuffled and divided among several hashes and tallies, which sum up to those of the
// run.

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kRunTime = 4;

struct Case {
  const char* name;
  Interactions interactions;
  bool has_kinematic = false;
};

ResponseTable motley() {
  ResponseTable table(Bounce({.restitution = ConstantRestitution{0.75}, .tangential_restitution = 0.5}),
                      Bounce({.restitution = ConstantRestitution{0.9}}));
  table.set(1, 1, Passing());
  table.set(2, 2, Merging());
  return table;
}

std::vector<Case> cases() {
  Interactions function;
  // Gives energy to some, and takes it from others.
  function.set_function([](const Contact& contact) {
    return Outcome(contact, velocities_after_impact(contact, contact.first % 2 == 0 ? 1.25 : 0.5));
  });
  return {{"elastic", {}},
          {"elastic beside a kinematic sphere", {}, true},
          {"inelastic", Restitution(0.9)},
          {"motley", motley()},
          {"by a function", function}};
}

// A mixture of three species between a thermal face, lossy faces and a moving plane.
World make_world(const Case& of) {
  constexpr int kAlongEdge = 6;
  constexpr int kMiddle = 3 + 3 * kAlongEdge * kAlongEdge;
  constexpr double kSize = 9;
  Box box({Boundary::wall, Boundary::periodic, Boundary::wall}, {kSize, kSize, kSize});
  box.set_face(face_of(0, false), {.material = {.temperature = 2, .seed = 5}, .velocity = {0, 0.5, 0}});
  box.set_face(face_of(2, true), {.material = {.restitution = 0.75}});
  const std::vector<Surface> surfaces{Surface(Plane({0.6, 0, 0.8}), {0.24, 0, 0.32}, {0.06, 0, 0.08})};
  World world(box, {}, surfaces);
  Random random(6);
  for (int k = 0; k < kAlongEdge * kAlongEdge * kAlongEdge; ++k) {
    const auto place = [&random](int step) { return 1.5 * step + 0.75 + 0.1 * random.uniform(); };
    const double x = place(k % kAlongEdge);
    const double y = place(k / kAlongEdge % kAlongEdge);
    const double z = place(k / (kAlongEdge * kAlongEdge));
    const double speed = 0.5 + random.uniform();
    const Vec3 velocity = speed * random.direction();
    const double radius = 0.4 + 0.2 * random.uniform();
    const bool is_kinematic = of.has_kinematic && k == kMiddle;
    world.add({.position = {x, y, z},
               .velocity = is_kinematic ? Vec3{0, 0.5, 0} : velocity,
               .radius = radius,
               .mass = is_kinematic ? kInfinity : 0.5 + random.uniform(),
               .species = static_cast<SpeciesId>(k % 3)});
  }
  world.set_interactions(of.interactions);
  return world;
}

struct Edit {
  double energy_change = 0;
  Time time;
};

struct RecordedRun {
  explicit RecordedRun(const Case& of) : start(make_world(of)), simulation(start) {
    simulation.on_contact([this](const Contact& contact) { contacts.push_back(contact); });
    simulation.run_until(kRunTime / 4);
    for (const SphereId id : {3U, 30U}) {
      const Slot slot = simulation.world().slot_of(id);
      const double before = kinetic_energy(simulation.world(), slot, simulation.now());
      simulation.change_velocity(id, {0.25, -1, id == 3 ? 5.0 : 0.0});
      edits.push_back(
          {kinetic_energy(simulation.world(), slot, simulation.now()) - before, simulation.now()});
    }
    simulation.run_until(kRunTime);
  }
  RecordedRun(const RecordedRun&) = delete;
  RecordedRun& operator=(const RecordedRun&) = delete;

  World start;
  Simulation simulation;
  std::vector<Contact> contacts;
  std::vector<Edit> edits;
};

template <class T>
void shuffle(std::vector<T>& items, Random& random) {
  for (std::size_t k = items.size(); k > 1; --k) {
    std::swap(items[k - 1], items[static_cast<std::size_t>(random.uniform() * static_cast<double>(k))]);
  }
}

TEST(DividedSums, AreThoseOfTheRun) {
  for (const Case& of : cases()) {
    SCOPED_TRACE(of.name);
    RecordedRun run(of);
    ASSERT_GT(run.contacts.size(), 500U);
    const Tally& whole = run.simulation.tally();
    EXPECT_GT(whole.wall(kFaces).contacts, 0U);
    EXPECT_GT(whole.collisions(), 300U);
    Random random(7);
    for (const std::size_t parts : {1U, 2U, 5U}) {
      shuffle(run.contacts, random);
      std::vector<Tally> tallies(parts);
      std::vector<EventLogHash> hashes(parts);
      for (Tally& tally : tallies) tally.begin(run.start, Time(0));
      const auto any = [&] {
        return static_cast<std::size_t>(random.uniform() * static_cast<double>(parts));
      };
      for (const Contact& contact : run.contacts) {
        const std::size_t part = any();
        tallies[part].record(contact);
        hashes[part].record(contact);
      }
      for (const Edit& edit : run.edits) tallies[any()].note_edit(edit.energy_change, edit.time);
      for (std::size_t part = 1; part < parts; ++part) {
        tallies[0].add(tallies[part]);
        hashes[0].add(hashes[part]);
      }
      EXPECT_EQ(hashes[0].value(), run.simulation.event_log_hash());
      EXPECT_TRUE(archived(tallies[0]) == archived(whole)) << "in every bit";
      const Time now = run.simulation.now();
      EXPECT_EQ(tallies[0].energy_integral(now), whole.energy_integral(now));
      EXPECT_EQ(tallies[0].compressibility(now), whole.compressibility(now));
      EXPECT_EQ(tallies[0].last_change(), whole.last_change());
    }
  }
}

// The kinetic energy that a contact adds, but for that of spins.
double gain_of(const Contact& contact) {
  if (contact.outcome == ContactOutcome::pass) return 0;
  if (contact.outcome == ContactOutcome::merge) {
    return energy_gain(contact.first_mass + contact.second_mass, {}, contact.after.first) -
           energy_gain(contact.first_mass, {}, contact.before.first) -
           energy_gain(contact.second_mass, {}, contact.before.second);
  }
  const double of_first = energy_gain(contact.first_mass, contact.before.first, contact.after.first);
  if (!contact.is_collision()) return of_first;
  return of_first + energy_gain(contact.second_mass, contact.before.second, contact.after.second);
}

TEST(DividedSums, AreThoseOfASequenceButForItsRounding) {
  for (const Case& of : cases()) {
    SCOPED_TRACE(of.name);
    const RecordedRun run(of);
    long double energy = kinetic_energy(run.start, Time(0));
    long double integral = 0;
    long double turned_over = energy;
    long double virial = 0;
    long double heat = 0;
    double last = 0;
    std::size_t edit = 0;
    const auto advance = [&](double gain, double time) {
      integral += energy * static_cast<long double>(time - last);
      energy += gain;
      turned_over += std::fabs(gain);
      last = time;
    };
    for (const Contact& contact : run.contacts) {
      for (; edit < run.edits.size() && run.edits[edit].time < contact.time; ++edit) {
        advance(run.edits[edit].energy_change, run.edits[edit].time.value());
      }
      advance(gain_of(contact), contact.time.value());
      if (contact.is_collision() && contact.outcome == ContactOutcome::bounce)
        virial -= dot(contact.impulse(), contact.separation);
      if (!contact.is_collision() && contact.second == face_of(0, false))
        heat += energy_gain_of_first(contact) - dot(contact.impulse(), contact.before.second);
    }
    advance(0, kRunTime);
    const Tally& tally = run.simulation.tally();
    const double rounding = 1e-14 * static_cast<double>(turned_over) * kRunTime;
    EXPECT_NEAR(tally.energy_integral(run.simulation.now()), static_cast<double>(integral), rounding);
    EXPECT_NEAR(tally.virial(), static_cast<double>(virial), 1e-14 * static_cast<double>(virial));
    EXPECT_NEAR(tally.wall(face_of(0, false)).heat, static_cast<double>(heat), rounding);
    // Up to a later time, and from a saved tally.
    Tally restored;
    restore(archived(tally), "the test", restored);
    EXPECT_NEAR(restored.energy_integral(Time(2 * kRunTime)),
                static_cast<double>(integral + energy * kRunTime), 2 * rounding);
  }
}

// Otherwise rounding noise would add up.
TEST(DividedSums, LeaveTheEnergyOfAnElasticGasAsItIs) {
  World world(Box::periodic({3, 3, 3}));
  Random random(8);
  for (int k = 0; k < 8; ++k) {
    world.add({.position = {0.75 + 1.5 * (k % 2), 0.75 + 1.5 * (k / 2 % 2), 0.75 + 1.5 * (k / 4)},
               .velocity = random.direction(),
               .radius = 0.6,
               .mass = 0.5 + random.uniform()});
  }
  Simulation simulation(world);
  simulation.run_contacts(5000);
  const double energy = kinetic_energy(world, Time(0));
  EXPECT_NE(kinetic_energy(simulation.world(), simulation.now()), energy) << "rounding";
  EXPECT_EQ(simulation.tally().energy_integral(simulation.now()), energy * simulation.time());
  // Until a response is given that takes energy.
  simulation.respond_with(ResponseTable(Bounce(Restitution(0.5))));
  const Time start = simulation.now();
  simulation.run_until(start.value() + 1);
  const double left = kinetic_energy(simulation.world(), simulation.now());
  EXPECT_LT(left, 0.9 * energy);
  const Tally& tally = simulation.tally();
  const double later = start.value() + 2;
  EXPECT_NEAR(tally.energy_integral(Time(later)) - tally.energy_integral(Time(later - 1)), left,
              1e-9 * energy);
  // Saved and loaded, it knows the response.
  Simulation again = Simulation::load(simulation.save());
  simulation.run_until(later);
  again.run_until(later);
  EXPECT_EQ(again.tally().energy_integral(Time(later)), tally.energy_integral(Time(later)));
}

}  // namespace
}  // namespace hardball::tally_test
