// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Some thousand spheres, as dense and as different in size as chance has it, by all engines but the slowest:
// one history, bit for bit.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "hardball/broadphase/neighbor_list.hpp"
#include "hardball/placement/placement.hpp"
#include "support/effort.hpp"
#include "support/history.hpp"

namespace hardball::large_worlds_test {
namespace {

using support::History;

constexpr std::uint64_t kWorlds = 24;
constexpr std::uint64_t kParts = 4;

World make_large_world(std::uint64_t seed) {
  Random random(seed);
  const auto between = [&](double low, double high) { return low + (high - low) * random.uniform(); };
  const std::size_t least = support::kIsSlowBuild ? 500 : 2000;
  const std::size_t count = least + random.bits() % least;
  const double ratio = std::array{1.0, 1.5, 4.0, 20.0}[random.bits() % 4];
  std::vector<double> radii;
  double volume = 0;
  for (std::size_t i = 0; i < count; ++i) {
    // Few large ones: the volume is shared evenly among sizes.
    radii.push_back(0.5 * std::pow(between(std::pow(ratio, -3.0), 1), -1 / 3.0) / ratio);
    volume += 4.1887902047863905 * radii.back() * radii.back() * radii.back();
  }
  const double packing_fraction = std::array{0.002, 0.05, 0.2, 0.33}[random.bits() % 4];
  constexpr std::array kAll = {Boundary::periodic, Boundary::wall, Boundary::open};
  const auto boundary = [&] { return kAll[random.bits() % 3]; };
  const double edge = std::cbrt(volume / packing_fraction);
  const Vec3 size{edge, edge, edge};
  const Box box({boundary(), boundary(), boundary()}, size);
  const std::vector<Vec3> centers = place_randomly(box, {{}, size}, radii, random, "large world");
  World world(box);
  for (std::size_t i = 0; i < count; ++i) {
    world.add({centers[i],
               {random.normal(), random.normal(), random.normal()},
               radii[i],
               radii[i] * radii[i] * radii[i]});
  }
  world.set_interactions(Restitution(random.uniform() < 0.6 ? 1 : between(0.7, 1)));
  return world;
}

class LargeWorlds : public testing::TestWithParam<std::uint64_t> {};

TEST_P(LargeWorlds, HaveOneHistory) {
  for (std::uint64_t seed = GetParam(); seed < support::cases(kWorlds); seed += kParts) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const World world = make_large_world(seed);
    const double diameter = 2 * world.largest_radius();
    // Spheres that burst into open space meet no more, and need not fly for ever.
    const RunLimits limits{.until = Time(500), .contacts = support::cases(20000)};
    std::vector<EngineOptions> ways;
    const auto add = [&](EngineKind engine, std::optional<double> edge) {
      ways.push_back({.engine = engine, .cell_edge = edge});
    };
    add(EngineKind::automatic, std::nullopt);
    add(EngineKind::cells, diameter);
    add(EngineKind::cells, 2.5 * diameter);
    if (NeighborList::supports(world)) add(EngineKind::neighbors, std::nullopt);
    if (!support::kIsSlowBuild) add(EngineKind::all_pairs, std::nullopt);
    std::optional<History> expected;
    for (const EngineOptions& way : ways) {
      SCOPED_TRACE(static_cast<int>(way.engine));
      Simulation simulation(world, way);
      const History history = support::run_on(simulation, limits);
      simulation.validate();
      if (!expected) expected = history;
      ASSERT_EQ(support::difference(*expected, history), "");
    }
    // Only a burst into open space ends before.
    EXPECT_GT(expected->contacts, 20U);
  }
}

INSTANTIATE_TEST_SUITE_P(Part, LargeWorlds, testing::Range<std::uint64_t>(0, kParts));

}  // namespace
}  // namespace hardball::large_worlds_test
