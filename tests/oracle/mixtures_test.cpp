// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Spheres of very different sizes, whose cells are those of the small ones: one history, bit for bit, that of
// all pairs.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "hardball/broadphase/large_sphere_grid.hpp"
#include "hardball/placement/placement.hpp"
#include "support/effort.hpp"
#include "support/history.hpp"

namespace hardball::mixtures_test {
namespace {

using support::History;

// Spheres of radius one among others down to a hundredth of that.
World make_mixture(std::uint64_t seed) {
  Random random(seed);
  constexpr std::array kAll = {Boundary::periodic, Boundary::wall, Boundary::open};
  const bool is_uniform = random.uniform() < 0.5;
  const Boundary common = kAll[random.bits() % 3];
  const auto boundary = [&] { return is_uniform ? common : kAll[random.bits() % 3]; };
  const Box box({boundary(), boundary(), boundary()},
                {4.5 + 3 * random.uniform(), 5 + random.uniform(), 4.5 + 3 * random.uniform()});
  const std::size_t large = 1 + random.bits() % 3;
  const std::size_t small = 2 * large + random.bits() % 60;
  const bool is_of_two_sizes = random.uniform() < 0.3;
  std::vector<double> radii;
  for (std::size_t i = 0; i < large; ++i) radii.push_back(1 - 0.3 * random.uniform());
  for (std::size_t i = 0; i < small; ++i) {
    radii.push_back(is_of_two_sizes ? 0.1 : std::exp2(-6.6 * random.uniform()));
  }
  const Region region{{0, 0, 0},
                      {box.is_open(0) ? 5 : box.size().x, box.is_open(1) ? 5 : box.size().y,
                       box.is_open(2) ? 5 : box.size().z}};
  const std::vector<Vec3> centers = place_randomly(box, region, radii, random, "mixture");
  const bool are_masses_equal = random.uniform() < 0.5;
  const bool rest = random.uniform() < 0.3;
  World world(box);
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const Vec3 velocity{random.normal(), random.normal(), random.normal()};
    const double mass = are_masses_equal ? 1 : radii[i] * radii[i] * radii[i];
    world.add({centers[i], rest && i % 3 == 0 ? Vec3{} : velocity, radii[i], mass});
  }
  return world;
}

TEST(Mixtures, HaveTheHistoryOfAllPairs) {
  std::uint64_t suited = 0;
  std::uint64_t contacts = 0;
  for (std::uint64_t seed = 0; seed < support::cases(200); ++seed) {
    World world = make_mixture(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    const double restitution = seed % 3 == 0 ? 1 : 0.3 + 0.1 * static_cast<double>(seed % 7);
    world.set_interactions(Restitution(restitution));
    const RunLimits limits{.until = Time(10), .contacts = 100 + seed % 200};
    std::vector<EngineOptions> ways{{.engine = EngineKind::all_pairs}, {.engine = EngineKind::automatic}};
    for (const double edge : {0.2, 0.35, 0.6}) {
      if (LargeSphereGrid::supports(world, edge)) ++suited;
      ways.push_back({.engine = EngineKind::cells, .cell_edge = edge});
    }
    std::optional<History> expected;
    for (const EngineOptions& way : ways) {
      SCOPED_TRACE(way.cell_edge.value_or(0));
      Simulation simulation(world, way);
      const History history = support::run_on(simulation, limits);
      if (history.failure.empty()) simulation.validate();
      if (!expected) expected = history;
      ASSERT_EQ(support::difference(*expected, history), "");
    }
    contacts += expected->contacts;
  }
  EXPECT_GT(suited, support::cases(200));
  EXPECT_GT(contacts, 30 * support::cases(200));
}

// A ball that lists those that can reach it soon: now and then a sphere near it becomes far faster than the
// list assumes, and the ball itself is pushed.
TEST(Mixtures, AreFollowedThroughChangesOfVelocity) {
  for (std::uint64_t seed = 0; seed < (support::kIsSlowBuild ? 1U : 4U); ++seed) {
    Random random(seed);
    constexpr double kSize = 44;
    std::vector<double> radii(seed % 2 == 0 ? 4000 : 3000, 0.2);
    radii[0] = 10;
    if (seed % 2 == 1) radii[1] = 1.5;
    const Box box = seed < 2 ? Box::periodic({kSize, kSize, kSize}) : Box::walls({kSize, kSize, kSize});
    const std::vector<Vec3> centers =
        place_randomly(box, {{0, 0, 0}, {kSize, kSize, kSize}}, radii, random, "mixture");
    World world(box);
    for (std::size_t i = 0; i < radii.size(); ++i) {
      const Vec3 velocity{random.normal(), random.normal(), random.normal()};
      world.add({centers[i], velocity, radii[i], i == 0 && seed < 3 ? 1000.0 : 1.0});
    }
    constexpr double kEdge = 3.3;
    ASSERT_TRUE(LargeSphereGrid::supports(world, kEdge));
    std::optional<std::uint64_t> expected;
    for (const EngineKind engine : {EngineKind::all_pairs, EngineKind::cells}) {
      // Where it would take minutes, the checks of the cells must do.
      if (support::kIsSlowBuild && engine == EngineKind::all_pairs) continue;
      Simulation simulation(world, {.engine = engine, .cell_edge = kEdge});
      Random changes(seed);
      for (int piece = 0; piece < 20; ++piece) {
        simulation.run_contacts(40);
        const auto id = static_cast<SphereId>(1 + changes.uniform() * 2990);
        const Vec3 direction = changes.direction();
        simulation.change_velocity(id, (piece % 2 == 0 ? 300.0 : 3.0) * direction);
        if (piece % 4 == 0) simulation.change_velocity(0, changes.uniform() * changes.direction());
        if (piece % 10 == 0) simulation.validate();
      }
      EXPECT_GT(simulation.counters().contacts(), 700U);
      if (!expected) expected = simulation.event_log_hash();
      EXPECT_EQ(simulation.event_log_hash(), *expected) << "seed " << seed;
    }
  }
}

}  // namespace
}  // namespace hardball::mixtures_test
