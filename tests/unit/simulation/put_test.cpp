// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Spheres that are put elsewhere between runs.
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "hardball/simulation/simulation.hpp"
#include "hardball/world/totals.hpp"
#include "support/history.hpp"
#include "support/refusal.hpp"

namespace hardball::put_test {
namespace {

using namespace support;

World lattice() {
  World world(Box::periodic({10, 10, 10}));
  for (int k = 0; k < 64; ++k) {
    const Vec3 place{1.0 + 2.5 * (k % 4), 1.0 + 2.5 * (k / 4 % 4), 1.0 + 2.5 * (k / 16)};
    world.add({.position = place, .velocity = {0.1 * (k % 5), -0.2 * (k % 3), 0.1 * (k % 7)}, .radius = 0.5});
  }
  return world;
}

TEST(Put, GivesSpheresANewPathNow) {
  World world(Box::open());
  world.add({.position = {0, 0, 0}, .radius = 1});
  world.add({.position = {9, 0, 0}, .velocity = {0, 1, 0}, .radius = 1});
  Simulation simulation(world);
  simulation.run_until(3);
  const std::vector<PlaceEdit> edits{{1, {5, 0, 0}, {-2, 0, 0}}};
  simulation.put(edits);
  EXPECT_EQ(simulation.position(1), (Vec3{5, 0, 0}));
  EXPECT_EQ(simulation.world().path(1).time, Time(3));
  EXPECT_EQ(simulation.next_contact(9)->time, 4.5);
  simulation.run_until(5);
  EXPECT_EQ(simulation.velocity(0), (Vec3{-2, 0, 0}));
  EXPECT_EQ(simulation.tally().energy_integral(simulation.now()), 3 * 0.5 + 2 * 2);
}

TEST(Put, ChangesNothingIfItIsRefused) {
  Simulation simulation(lattice());
  simulation.run_until(2);
  Simulation expected(simulation);
  const auto refusal = [&](const std::vector<PlaceEdit>& edits) {
    return refusal_of([&] { simulation.put(edits); });
  };
  const Vec3 there = simulation.position(7);
  EXPECT_NE(refusal({{3, there + Vec3{0.5, 0, 0}, {}}}).find("overlap"), std::string::npos);
  EXPECT_NE(refusal({{3, {}, {}}, {3, {}, {}}}).find("two places"), std::string::npos);
  EXPECT_NE(refusal({{99, {}, {}}}).find("there is no sphere 99"), std::string::npos);
  EXPECT_NE(refusal({{3, {}, {std::numeric_limits<double>::quiet_NaN(), 0, 0}}}), "");
  EXPECT_EQ(difference(run_on(expected, {.until = Time(20)}), run_on(simulation, {.until = Time(20)})), "");
}

TEST(Put, GivesOneHistoryWithAllEngines) {
  const World world = lattice();
  std::vector<EngineVariant> variants = engine_variants(world);
  const std::vector<EngineVariant> divided = divided_variants();
  variants.insert(variants.end(), divided.begin(), divided.end());
  const auto run = [&](Simulation& simulation, const EngineVariant&, bool) {
    simulation.run_until(2);
    // They exchange their places, one of them by way of an image.
    const Vec3 a = simulation.position(5);
    const Vec3 b = simulation.position(44);
    const std::vector<PlaceEdit> edits{{44, a, {1, 0, 0}}, {5, b + Vec3{10, -20, 0}, {0, 0, 1}}};
    simulation.put(edits);
    EXPECT_LT(length(simulation.position(5) - b), 1e-14);
    return validated_run(simulation, {.until = Time(30)});
  };
  const auto history = one_history(world, variants, run, true);
  ASSERT_TRUE(history);
  EXPECT_GT(history->contacts, 50U);
}

}  // namespace
}  // namespace hardball::put_test
