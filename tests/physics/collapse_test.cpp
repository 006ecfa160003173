// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Spheres that lose energy end by the message of an inelastic collapse or continue by the rule against it,
// and no others are taken for them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/simulation/simulation.hpp"
#include "support/effort.hpp"
#include "support/interacting.hpp"

namespace hardball::collapse_test {
namespace {

struct End {
  std::string failure;
  std::uint64_t contacts = 0;
  std::uint64_t hash = 0;
  double time = 0;
};

End run(Simulation& simulation, double until, std::uint64_t most_contacts) {
  End end;
  try {
    simulation.run({.until = Time(until), .contacts = most_contacts});
  } catch (const RunFailure& failure) {
    end.failure = failure.what();
  }
  end.contacts = simulation.counters().contacts();
  end.hash = simulation.event_log_hash();
  end.time = simulation.time();
  return end;
}

End run(const World& world, const Interactions& interactions, double until, std::uint64_t most_contacts,
        EngineKind engine = EngineKind::automatic) {
  Simulation simulation(support::interacting(world, interactions), {.engine = engine});
  return run(simulation, until, most_contacts);
}

// Up to twenty spheres in a hollow sphere or a closed tube, near the origin or far from it.
World random_cavity(Random& random, int number) {
  const double radius = number % 2 == 0 ? 1.7 : 5.5;
  const Vec3 center = number % 3 == 0 ? Vec3{5, 5, 5} : number % 3 == 1 ? Vec3{} : Vec3{130, -70, 3};
  const Vec3 gravity = number % 5 < 3 ? Vec3{random.normal(), random.normal(), random.normal()} : Vec3{};
  std::vector<Surface> surfaces{Surface(HollowSphere(radius), center)};
  if (number % 4 < 2) {
    const Vec3 axis = random.direction();
    surfaces = {Surface(Cylinder(axis, radius), center), Surface(Plane(axis), center - 3 * axis),
                Surface(Plane(-axis), center + 3 * axis)};
  }
  World world(Box::open(), gravity, surfaces);
  const int spheres = 1 + static_cast<int>((number % 7 == 0 ? 20 : 6) * random.uniform());
  for (int tries = 0; tries < 10'000 && static_cast<int>(world.size()) < spheres; ++tries) {
    const double size = 0.05 + 0.15 * random.uniform();
    const auto offset = [&] { return radius * (2 * random.uniform() - 1); };
    const double x = offset();
    const double y = offset();
    const Vec3 place = center + Vec3{x, y, offset()};
    const auto is_free_of = [&](const Surface& surface) { return surface.distance(place, Time(0)) > size; };
    bool is_free = std::ranges::all_of(surfaces, is_free_of);
    for (Slot slot = 0; slot < world.size(); ++slot) {
      is_free = is_free && length(place - world.path(slot).position) > size + world.base_radius(slot);
    }
    if (is_free) world.add({place, random.direction(), size, 0.5 + random.uniform()});
  }
  return world;
}

TEST(InelasticSpheres, InCavitiesAndTubesEndByTheMessage) {
  Random random(2026);
  constexpr double kForever = 1e9;
  for (int i = 0; i < static_cast<int>(support::cases(64)); ++i) {
    const World world = random_cavity(random, i);
    const double restitution = 0.1 + 0.8 * random.uniform();
    const End end = run(world, Restitution(restitution), kForever, 100'000);
    EXPECT_EQ(end.failure.find("inelastic collapse: sphere "), 0U)
        << i << ": " << world.size() << " spheres, restitution " << restitution << ", " << end.contacts
        << " contacts, time " << end.time;
  }
}

World in_a_hollow_sphere(const Vec3& velocity) {
  World world(Box::open(), {}, {Surface(HollowSphere(5.5), {5, 5, 5})});
  world.add({{3, 4, 6}, velocity, 0.117, 1});
  return world;
}

World on_a_shaken_floor(const Vec3& velocity) {
  World world(Box::open(), {0, 0, -1}, {Surface(OscillatingPlane({0, 0, 1}, 0.01, 0.5), {})});
  world.add({{3, 4, 1.6}, velocity, 0.117, 1});
  return world;
}

TEST(InelasticSpheres, ThatSlideEndByTheMessageOrGoOnByTheRule) {
  Random random(4);
  for (int i = 0; i < 8; ++i) {
    for (const auto& make : {in_a_hollow_sphere, on_a_shaken_floor}) {
      const World world = make(random.direction());
      const End end = run(world, Restitution(0.53), 1e9, 100'000);
      EXPECT_NE(end.failure.find("inelastic collapse: sphere 0"), std::string::npos)
          << i << " " << end.contacts;
      const End by_rule = run(world, Restitution(0.53, 1e-2), 3 * end.time, 1'000'000);
      EXPECT_EQ(by_rule.failure, "");
      EXPECT_EQ(by_rule.time, 3 * end.time) << by_rule.contacts;
    }
  }
}

TEST(InelasticSpheres, EndAtTheSameContactInEveryEngineAndAfterALoad) {
  Random random(11);
  for (int i = 0; i < 6; ++i) {
    const World world = random_cavity(random, 7 * i);
    const Restitution restitution(0.5);
    const End expected = run(world, restitution, 1e9, 100'000);
    ASSERT_NE(expected.failure, "");
    for (const EngineKind engine : {EngineKind::all_pairs, EngineKind::cells}) {
      const End end = run(world, restitution, 1e9, 100'000, engine);
      EXPECT_EQ(end.failure, expected.failure);
      EXPECT_EQ(end.hash, expected.hash);
    }
    Simulation begun(support::interacting(world, restitution));
    begun.run_contacts(expected.contacts - 5'000);
    Simulation loaded = Simulation::load(begun.save());
    const End end = run(loaded, 1e9, 100'000);
    EXPECT_EQ(end.failure, expected.failure);
    EXPECT_EQ(end.hash, expected.hash);
  }
}

// Runs that the guard must let pass have more contacts of a sphere than it takes for the message.
void expect_no_alarm(const World& world, const Interactions& interactions, std::uint64_t contacts,
                     const std::string& what) {
  const End end = run(world, interactions, std::numeric_limits<double>::infinity(), contacts);
  EXPECT_EQ(end.failure, "") << what;
  EXPECT_EQ(end.contacts, contacts) << what;
}

// Gravity pulls it between two planes, where it turns back after many contacts in a row.
TEST(NoAlarm, ForAnElasticSphereInACorner) {
  for (const double angle : {0.3, 0.02, 1e-3}) {
    const Surface slope(Plane({-std::sin(angle), 0, -std::cos(angle)}), {});
    World world(Box::open(), {1, 0, 0}, {Surface(Plane({0, 0, 1}), {}), slope});
    world.add({{-3 / std::tan(angle), 0, 1.2}, {1, 0.1, -0.3}, 0.5, 1});
    expect_no_alarm(world, {}, 100'000, "a corner");
  }
}

TEST(NoAlarm, ForAnElasticSphereThatGrazesAWall) {
  for (const double angle : {1e-3, 1e-6, 1e-8}) {
    World world(Box::open(), {}, {Surface(HollowSphere(6), {5, 5, 5})});
    world.add({{5, 5, 0}, {std::cos(angle), 0, -std::sin(angle)}, 1, 1});
    expect_no_alarm(world, {}, 30'000, "grazing");
  }
}

TEST(NoAlarm, ForAGasAroundASphereOfGreatMassAtRest) {
  for (const double mass : {1e25, std::numeric_limits<double>::infinity()}) {
    World world(Box::walls({5, 5, 5}));
    world.add({{2.5, 2.5, 2.5}, {}, 1.75, mass});
    Random random(1);
    for (int i = 0; i < 8; ++i) world.add({{0.3 + 0.5 * i, 0.3, 0.3}, random.direction(), 0.1, 1});
    expect_no_alarm(world, {}, 100'000, "a gas");
  }
}

// Gaps of a few units in the last place, all contacts in a row within times that places do not resolve.
TEST(NoAlarm, ForCrystalsAndCradlesNearContact) {
  for (const double gap : {0.0, 1e-15, 1e-12, 1e-9}) {
    World cradle(Box({Boundary::wall, Boundary::open, Boundary::open}, {40, 0, 0}));
    for (int i = 0; i < 12; ++i) {
      cradle.add({{10.5 + i * (1 + gap), 0, 0}, {i == 0 ? 1.0 : 0.0, 0, 0}, 0.5, 1});
    }
    expect_no_alarm(cradle, {}, 100'000, "a cradle");
  }
  for (const double gap : {1e-12, 1e-6}) {
    const double spacing = 1 + gap;
    World crystal(Box::periodic({3 * spacing, 3 * spacing, 3 * spacing}));
    Random random(3);
    for (int i = 0; i < 27; ++i) {
      const Vec3 place{static_cast<double>(i % 3), static_cast<double>(i / 3 % 3),
                       static_cast<double>(i / 9)};
      crystal.add({spacing * place, random.direction(), 0.5, 1});
    }
    expect_no_alarm(crystal, {}, 150'000, "a crystal");
  }
}

TEST(NoAlarm, ForSpheresThatLoseEnergyAndAreKeptMoving) {
  for (const double restitution : {0.4, 0.99}) {
    World world(Box::walls({4, 4, 4}), {}, {Surface(OscillatingPlane({0, 0, 1}, 0.25, 3), {0, 0, 0.5})});
    Random random(8);
    for (int x = 0; x < 3; ++x) {
      for (int y = 0; y < 3; ++y) {
        world.add({{0.7 + 1.2 * x, 0.7 + 1.2 * y, 2}, random.direction(), 0.5, 1});
      }
    }
    expect_no_alarm(world, Restitution(restitution), 80'000, "a shaken gas");
  }
}

// Slow impacts are elastic by the rule, at rates of millions.
TEST(NoAlarm, ForTinyBouncesByTheRule) {
  World world(Box::walls({4, 4, 4}), {0, 0, -1});
  world.add({{1, 1, 1}, {0.1, 0, 0}, 0.5, 1});
  world.add({{1.2, 1.1, 2.2}, {0.1, 0, 0}, 0.5, 1});
  for (const double elastic_below : {1e-2, 1e-4, 1e-6}) {
    expect_no_alarm(world, Restitution(0.5, elastic_below), 100'000, "a heap");
  }
}

}  // namespace
}  // namespace hardball::collapse_test
