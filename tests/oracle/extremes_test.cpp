// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Speeds that differ by many orders of magnitude, or change by as much, and places far away: the copies of
// paths from which contacts are bounded are good up to some speed, age and distance. One history by every
// engine.
#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "hardball/numbers/random.hpp"
#include "support/effort.hpp"
#include "support/gas.hpp"
#include "support/history.hpp"

namespace hardball::extremes_test {
namespace {

using support::History;

// Runs the world in every way: `run` takes a simulation and returns its history.
template <class Run>
std::uint64_t contacts_in_one_history(const World& world, Run&& run) {
  std::optional<History> expected;
  for (const support::EngineVariant& variant : support::engine_variants(world)) {
    SCOPED_TRACE(variant.name);
    Simulation simulation(world, variant.options);
    std::optional<History> history;
    EXPECT_NO_THROW(history = run(simulation));
    EXPECT_NO_THROW(simulation.validate());
    if (!history) return 0;
    if (!expected) expected = history;
    EXPECT_EQ(support::difference(*expected, *history), "");
    if (testing::Test::HasFailure()) return 0;
  }
  return expected->contacts;
}

// So light that it hardly moves the others.
World gas_with_bullet(std::uint64_t seed, double speed) {
  World gas = support::make_gas({.count = 50, .packing_fraction = 0.05, .seed = seed});
  World world(gas.box());
  for (Slot slot = 0; slot < gas.size(); ++slot) {
    const bool is_bullet = slot == seed % gas.size();
    world.add({.position = gas.path(slot).position,
               .velocity = (is_bullet ? speed : 1) * gas.path(slot).velocity,
               .radius = is_bullet ? 0.05 : 0.5,
               .mass = is_bullet ? 1 / (speed * speed) : 1});
  }
  return world;
}

TEST(Speeds, OfABulletAmongSlowSpheres) {
  for (std::uint64_t seed = 0; seed < support::cases(12); ++seed) {
    for (const double speed : {10.0, 30.0, 1e4, 1e6}) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", speed " << speed);
      const World world = gas_with_bullet(seed, speed);
      const auto run = [](Simulation& simulation) { return support::run_on(simulation, {.contacts = 1000}); };
      EXPECT_EQ(contacts_in_one_history(world, run), 1000U);
      if (HasFailure()) return;
    }
  }
}

// Half of the spheres of a gas get other speeds by and by, or all at once.
TEST(Speeds, ThatChangeByOrdersOfMagnitude) {
  for (std::uint64_t seed = 0; seed < support::cases(6); ++seed) {
    for (const std::vector<double>& factors :
         {std::vector<double>{1e4}, std::vector<double>{1e-4}, std::vector<double>{1e2, 1e4, 1e-3}}) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", first factor " << factors[0]);
      const World world = support::make_gas({.count = 100, .packing_fraction = 0.02, .seed = seed});
      const auto run = [&](Simulation& simulation) {
        Random random(seed);
        double speed = 1;
        for (const double factor : factors) {
          simulation.run_until(simulation.time() + 1 / speed);
          speed *= factor;
          for (SphereId id = 0; id < simulation.size(); id += 2) {
            simulation.change_velocity(id, speed * random.direction());
          }
          support::run_on(simulation, {.contacts = 3000 / factors.size()});
        }
        return support::run_on(simulation, {.contacts = 1});
      };
      EXPECT_GT(contacts_in_one_history(world, run), 3000U);
      if (HasFailure()) return;
    }
  }
}

// A slow sphere and one at rest, which it meets when the others have had thousands of contacts: much later
// than copies of paths are good for.
TEST(Speeds, OfSpheresAtRestForVeryLong) {
  for (std::uint64_t seed = 0; seed < support::cases(6); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    World world(Box::periodic({16, 16, 16}));
    world.add({{2, 2, 2}, {}, 0.5, 1});
    world.add({{2, 2, 3.25 + 0.25 * random.uniform()}, {0, 0, -1e-3}, 0.5, 1});
    // Others go to and fro between two at rest.
    for (const double y : {7.0, 9.0, 11.0}) {
      for (const double x : {2.0, 10.0}) world.add({{x, y, 9}, {}, 0.5, 1e9});
      world.add({{5 + random.uniform(), y, 9}, {10 + random.uniform(), 0, 0}, 0.5, 1});
    }
    const auto run = [](Simulation& simulation) { return support::run_on(simulation, {.until = Time(600)}); };
    EXPECT_GT(contacts_in_one_history(world, run), 2000U);
    if (HasFailure()) return;
  }
}

// In open space, so far from the origin that places are coarse on the scale of the spheres, by more or less.
TEST(Places, FarFromTheOrigin) {
  for (std::uint64_t seed = 0; seed < support::cases(4); ++seed) {
    for (const double distance : {1e6, 2e7, 5e7, 1e8, 1e9, 1e11}) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", distance " << distance);
      const World gas =
          support::make_gas({.count = 60, .packing_fraction = 0.2, .seed = seed, .boundary = Boundary::open});
      World world;
      for (const Path& path : gas.paths()) {
        // Spaced a little wider: places are rounded.
        world.add({1.001 * path.position + Vec3{distance, -distance, 0}, path.velocity, 0.5, 1});
      }
      const auto run = [](Simulation& simulation) {
        return support::run_on(simulation, {.until = Time(30)});
      };
      EXPECT_GT(contacts_in_one_history(world, run), 30U);
      if (HasFailure()) return;
    }
  }
}

}  // namespace
}  // namespace hardball::extremes_test
