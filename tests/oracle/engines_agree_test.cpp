// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Many small worlds, each run by every engine, queue and size of cells: one history, bit for bit.
#include <gtest/gtest.h>

#include "support/effort.hpp"
#include "support/history.hpp"
#include "support/random_world.hpp"

namespace hardball::engines_agree_test {
namespace {

using support::History;
using support::RandomWorld;

constexpr std::uint64_t kWorlds = 4000;
constexpr std::uint64_t kParts = 8;

// The history by one engine, whose structures are checked; nothing if the cells are refused as too small.
std::optional<History> history_by(const support::EngineVariant& variant, const RandomWorld& made,
                                  const RunLimits& limits) {
  try {
    Simulation simulation(made.world, variant.options);
    History history = support::run_on(simulation, limits);
    if (history.failure.empty()) simulation.validate();
    return history;
  } catch (const Error& error) {
    if (error.where() == "cell edge") return std::nullopt;
    throw;
  }
}

class EnginesAgree : public testing::TestWithParam<std::uint64_t> {
 protected:
  // Runs a part of so many worlds that `make` makes of seeds by every engine.
  void agree_on(RandomWorld (*make)(std::uint64_t seed), std::uint64_t worlds = kWorlds) {
    std::uint64_t contacts = 0;
    for (std::uint64_t seed = GetParam(); seed < support::cases(worlds); seed += kParts) {
      const RandomWorld made = make(seed);
      SCOPED_TRACE(made.name);
      // Contacts are limited too: in a granular world infinitely many may happen in a finite time.
      const RunLimits limits{.until = Time(made.until), .contacts = 60 + 60 * (seed % 5)};
      std::optional<History> expected;
      for (const support::EngineVariant& variant : support::engine_variants(made.world)) {
        SCOPED_TRACE(variant.name);
        std::optional<History> history;
        ASSERT_NO_THROW(history = history_by(variant, made, limits));
        if (!history) continue;
        if (!expected) expected = history;
        ASSERT_EQ(support::difference(*expected, *history), "");
      }
      contacts += expected->contacts;
    }
    // The worlds have some 50 contacts each on average.
    EXPECT_GT(contacts, 30 * support::cases(worlds) / kParts);
  }
};

TEST_P(EnginesAgree, OnRandomWorlds) {
  agree_on(support::make_random_world);
}

// With gravity, walls of all shapes, in motion or thermal, and obstacles.
TEST_P(EnginesAgree, OnFurnishedWorlds) {
  agree_on(support::make_furnished_world);
}

// Discs, with and without all that.
TEST_P(EnginesAgree, OnFlatWorlds) {
  const auto make = [](std::uint64_t seed) {
    return seed % 3 == 0 ? support::make_responsive_flat_world(seed) : support::make_flat_world(seed);
  };
  agree_on(make, kWorlds / 2);
}

// With species that bounce by different rules, rough or smooth, merge, or pass through each other, and
// kinematic spheres.
TEST_P(EnginesAgree, OnResponsiveWorlds) {
  agree_on(support::make_responsive_world);
}

INSTANTIATE_TEST_SUITE_P(Part, EnginesAgree, testing::Range<std::uint64_t>(0, kParts));

// Spheres in a row that collapse into one cluster: all engines stop at the same contact with the same
// message.
struct Collapse {
  double restitution;
  double size;                       // of the box along the row
  std::array<double, 5> velocities;  // along the row
};

TEST(InelasticCollapse, IsNoticedByAllEnginesAtTheSameContact) {
  const std::array<Collapse, 4> collapses = {{// So symmetric that velocities vanish completely.
                                              {0.02, 40, {1, 0, 0, 0, -1}},
                                              // Against a wall.
                                              {0.1, 8, {1, 0, 0, 0, 0}},
                                              {0.05, 40, {1, 0.5, 0, -0.5, -1}},
                                              {0.05, 40, {1, 0, 0, 0, -1}}}};
  for (const Collapse& collapse : collapses) {
    if (support::kIsSlowBuild && collapse.restitution == 0.05) continue;
    World world(Box({Boundary::wall, Boundary::periodic, Boundary::open}, {collapse.size, 3, 0}));
    for (std::size_t i = 0; i < 5; ++i) {
      const double x = 0.75 + 1.375 * static_cast<double>(i);
      world.add({{x, 1, 1}, {collapse.velocities[i], 0, 0}, 0.5, 1});
    }
    // Another one passes by, so that tuned cells are rebuilt during the collapse.
    world.add({{1, 1, 20}, {0, 0, 1e4}, 0.125, 1});
    world.set_interactions(Restitution(collapse.restitution));
    std::optional<History> expected;
    for (const support::EngineVariant& variant : support::engine_variants(world)) {
      SCOPED_TRACE(variant.name);
      Simulation simulation(world, variant.options);
      const History history = support::run_on(simulation, {.until = Time(20), .contacts = 200000});
      EXPECT_NE(history.failure.find("inelastic collapse"), std::string::npos);
      EXPECT_NE(history.failure.find("elastic_below"), std::string::npos) << "the message says what helps";
      EXPECT_NE(history.failure.find("contact_duration"), std::string::npos);
      if (!expected) expected = history;
      ASSERT_EQ(support::difference(*expected, history), "");
    }
  }
}

// Two spheres become slower with each impact, for ever: no engine goes beyond the operating range.
TEST(InelasticCollapse, RunsWithoutEndEndWithTheOperatingRange) {
  World world(Box::walls({16, 4, 4}));
  world.add({.position = {8.625, 2, 2}, .velocity = {-1, 0, 0}, .radius = 0.5});
  world.add({.position = {7.375, 2, 2}, .velocity = {1, 0, 0}, .radius = 0.5});
  world.set_interactions(Restitution(0.05));
  std::vector<support::EngineVariant> variants = support::engine_variants(world);
  variants.push_back({{.division = Division{.domains = 2}}, "domains"});
  std::optional<History> expected;
  for (const support::EngineVariant& variant : variants) {
    SCOPED_TRACE(variant.name);
    Simulation simulation(world, variant.options);
    const History history = support::run_on(simulation, {.contacts = 1000});
    EXPECT_GT(history.contacts, 100U);
    EXPECT_LT(history.contacts, 1000U);
    EXPECT_LE(simulation.time(), kLargestTime);
    EXPECT_GT(simulation.time(), 1e-3 * kLargestTime);
    EXPECT_FALSE(simulation.next_contact());
    if (!expected) expected = history;
    ASSERT_EQ(support::difference(*expected, history), "");
  }
}

// What the message of a collapse recommends.
TEST(InelasticCollapse, IsAvoidedIfSlowOrRapidImpactsAreElastic) {
  World world(Box({Boundary::wall, Boundary::periodic, Boundary::open}, {8, 3, 0}));
  for (std::size_t i = 0; i < 5; ++i) {
    world.add({{0.75 + 1.375 * static_cast<double>(i), 1, 1}, {i == 0 ? 1.0 : 0.0, 0, 0}, 0.5, 1});
  }
  for (const bool by_duration : {false, true}) {
    BounceRules rules{.restitution = ConstantRestitution{0.1}};
    (by_duration ? rules.contact_duration : rules.elastic_below) = by_duration ? 0.01 : 1e-3;
    world.set_interactions(ResponseTable(Bounce(rules), Bounce(rules)));
    std::optional<History> expected;
    for (const support::EngineVariant& variant : support::engine_variants(world)) {
      SCOPED_TRACE(variant.name);
      Simulation simulation(world, variant.options);
      const History history = support::run_on(simulation, {.until = Time(1000)});
      EXPECT_EQ(history.failure, "");
      EXPECT_GT(history.contacts, by_duration ? 20U : 100U);
      if (!expected) expected = history;
      ASSERT_EQ(support::difference(*expected, history), "");
    }
  }
}

}  // namespace
}  // namespace hardball::engines_agree_test
