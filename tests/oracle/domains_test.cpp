// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Worlds divided among domains, with shallow halos and long windows that often fail: the history of one
// engine that compares all pairs, to the last bit.
#include <gtest/gtest.h>

#include <vector>

#include "hardball/numbers/random.hpp"
#include "support/effort.hpp"
#include "support/gas.hpp"
#include "support/history.hpp"
#include "support/random_world.hpp"

namespace hardball::domains_test {
namespace {

using namespace support;

constexpr std::uint64_t kWorlds = 240;
constexpr std::uint64_t kParts = 4;

class Domains : public testing::TestWithParam<std::uint64_t> {};

TEST_P(Domains, HaveTheHistoryOfAllPairs) {
  std::uint64_t contacts = 0;
  for (std::uint64_t seed = GetParam(); seed < cases(kWorlds); seed += kParts) {
    const RandomWorld made = any_world(seed);
    SCOPED_TRACE(made.name);
    const RunLimits limits{.until = Time(made.until), .contacts = 60 + 60 * (seed % 3)};
    Simulation reference(made.world, {.engine = EngineKind::all_pairs});
    const History expected = run_on(reference, limits);
    for (const EngineVariant& variant : divided_variants()) {
      SCOPED_TRACE(variant.name);
      Simulation simulation(made.world, variant.options);
      const History history = run_on(simulation, limits);
      ASSERT_EQ(difference(history, expected), "");
      if (history.failure.empty()) simulation.validate();
      // A listener hears the contacts in their order.
      Simulation heard(made.world, variant.options);
      Simulation heard_reference(made.world, {.engine = EngineKind::all_pairs});
      const std::vector<Contact> log = record(heard, limits);
      const std::vector<Contact> log_of_reference = record(heard_reference, limits);
      ASSERT_EQ(log.size(), log_of_reference.size());
      for (std::size_t i = 0; i < log.size(); ++i) {
        ASSERT_EQ(log[i].time, log_of_reference[i].time) << "contact " << i;
        ASSERT_EQ(log[i].first, log_of_reference[i].first) << "contact " << i;
        ASSERT_EQ(log[i].second, log_of_reference[i].second) << "contact " << i;
        ASSERT_EQ(log[i].after, log_of_reference[i].after) << "contact " << i;
      }
      ASSERT_EQ(heard.event_log_hash(), simulation.event_log_hash());
    }
    contacts += expected.contacts;
  }
  EXPECT_GT(contacts, 5 * cases(kWorlds) / kParts);
}

INSTANTIATE_TEST_SUITE_P(Part, Domains, testing::Range<std::uint64_t>(0, kParts));

// Gases in blocks so small, with halos so shallow and windows so long, that most windows fail.
TEST(GasInDomains, HasOneHistoryWhereWindowsFail) {
  for (const double packing_fraction : {0.02, 0.25}) {
    for (std::uint64_t seed = 0; seed < cases(30); ++seed) {
      SCOPED_TRACE(testing::Message() << "packing fraction " << packing_fraction << ", seed " << seed);
      const World world = make_gas({.count = 500, .packing_fraction = packing_fraction, .seed = seed});
      const RunLimits limits{.contacts = 1500};
      Simulation reference(world);
      const History expected = run_on(reference, limits);
      for (const Division& division : {Division{.domains = 2, .halo = 1.05, .window = 1},
                                       Division{.domains = 4, .halo = 1.05, .window = 0.3},
                                       Division{.domains = 8, .halo = 1.5, .window = 0.3}}) {
        Simulation simulation(world, {.division = division});
        ASSERT_EQ(difference(run_on(simulation, limits), expected), "") << division.domains << " domains";
      }
    }
  }
}

// A thin gas in which spheres come and go between domains all the time, for some flights: who owns and holds
// them is checked on the way.
TEST(GasInDomains, KnowsWhoHoldsSpheresThatComeAndGo) {
  for (std::uint64_t seed = 0; seed < cases(8); ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const World world = make_gas({.count = 4000, .packing_fraction = 0.02, .seed = seed});
    const RunLimits limits{.contacts = 8000};
    Simulation reference(world);
    reference.run(limits);
    for (const std::size_t domains : {std::size_t{4}, std::size_t{7}}) {
      Simulation simulation(world, {.division = Division{.domains = domains}});
      simulation.run(limits);
      EXPECT_EQ(simulation.event_log_hash(), reference.event_log_hash()) << domains << " domains";
    }
  }
}

// Listeners that give spheres new velocities, remove them and add others cut windows short.
TEST(EditedDomains, HaveTheHistoryOfAllPairs) {
  constexpr std::uint64_t kEdited = 60;
  for (std::uint64_t seed = 0; seed < cases(kEdited); ++seed) {
    const RandomWorld made = make_random_world(seed);
    if (made.world.size() < 2) continue;
    SCOPED_TRACE(made.name);
    const auto history_of = [&](const EngineOptions& options) {
      Simulation simulation(made.world, options);
      Random random(seed);
      simulation.on_contact([&](const Contact& contact) {
        const double kind = random.uniform();
        const Vec3 velocity = random.normal_vector(3);
        if (kind < 0.3) {
          simulation.change_velocity(contact.first, length(contact.before.first) * velocity);
        } else if (kind < 0.35 && simulation.size() > 2) {
          simulation.remove(contact.first);
        } else if (kind < 0.5) {
          try {
            const double radius = 0.5 * contact.first_radius;
            simulation.add({contact.position + 4 * radius * random.direction(), contact.after.first, radius});
          } catch (const Error&) {
            // No room, whatever the engine.
          }
        }
      });
      return run_on(simulation, {.until = Time(made.until), .contacts = 60});
    };
    const History expected = history_of({.engine = EngineKind::all_pairs});
    for (const EngineVariant& variant : divided_variants()) {
      SCOPED_TRACE(variant.name);
      ASSERT_EQ(difference(history_of(variant.options), expected), "");
    }
  }
}

// A gas large enough for windows that do not fail, in pieces, looked ahead of, saved and loaded between.
TEST(GasInDomains, HasOneHistoryThroughLookAheadsAndSaving) {
  const World world = make_gas({.count = 1000, .packing_fraction = 0.25, .seed = 3});
  Simulation expected(world);
  Simulation divided(world, {.division = Division{.domains = 4, .threads = 2}});
  for (int piece = 1; piece <= 5; ++piece) {
    const double until = 0.1 * piece;
    const std::vector<Contact> ahead = divided.contacts_within(0.02, 20);
    const std::vector<Contact> ahead_of_one = expected.contacts_within(0.02, 20);
    ASSERT_EQ(ahead.size(), ahead_of_one.size());
    for (std::size_t i = 0; i < ahead.size(); ++i) ASSERT_EQ(ahead[i].time, ahead_of_one[i].time);
    divided.run_until(until);
    expected.run_until(until);
    ASSERT_EQ(divided.event_log_hash(), expected.event_log_hash());
    ASSERT_EQ(divided.positions(), expected.positions());
    ASSERT_EQ(divided.tally().virial(), expected.tally().virial());
    ASSERT_EQ(divided.tally().energy_integral(divided.now()),
              expected.tally().energy_integral(expected.now()));
    Simulation loaded = Simulation::load(divided.save());
    loaded.run_until(until + 0.05);
    Simulation copy = expected;
    copy.run_until(until + 0.05);
    ASSERT_EQ(loaded.event_log_hash(), copy.event_log_hash());
  }
}

}  // namespace
}  // namespace hardball::domains_test
