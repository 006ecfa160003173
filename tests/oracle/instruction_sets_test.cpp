// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// One gas with all instruction sets, and with engines that run side by side: one history, bit for bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "hardball/broadphase/all_pairs.hpp"
#include "hardball/broadphase/cell_grid.hpp"
#include "hardball/engine/engine.hpp"
#include "hardball/events/calendar_queue.hpp"
#include "hardball/measure/event_log_hash.hpp"
#include "support/effort.hpp"
#include "support/gas.hpp"
#include "support/ordered_queue.hpp"
#include "support/random_world.hpp"

namespace hardball::instruction_sets_test {
namespace {

constexpr std::array kAllSets = {InstructionSet::portable, InstructionSet::avx2, InstructionSet::avx512};

using Cells = Engine<CalendarQueue>;
using Pairs = Engine<support::OrderedQueue>;

// An engine and the hash of its history.
template <class Made>
struct Recorded {
  Made engine;
  EventLogHash hash;
  std::uint64_t contacts = 0;

  void go_on(const RunLimits& limits) {
    engine.run(limits, [this](const Contact& contact) {
      hash.record(contact);
      ++contacts;
    });
  }
};

Cells cells(const World& world, double edge, InstructionSet set) {
  return {world, {PhaseKind::cells, edge, set}, Time(0)};
}

// Dilute and dense, so that cells are large and small compared with the box; with 40 spheres images are not
// the nearest.
const std::vector<support::Gas>& gases() {
  static const std::vector<support::Gas> all = {
      {.count = 1000, .packing_fraction = 0.05, .seed = 1},
      {.count = 1000, .packing_fraction = 0.3, .seed = 2},
      {.count = 500, .packing_fraction = 0.3, .seed = 3, .boundary = Boundary::wall},
      {.count = 1372, .packing_fraction = 0.5, .seed = 4, .start = support::Start::fcc},
      {.count = 40, .packing_fraction = 0.2, .seed = 5},
      {.count = 300, .packing_fraction = 0.2, .seed = 6, .boundary = Boundary::open}};
  return all;
}

TEST(InstructionSets, GiveOneHistoryOfAGas) {
  for (const support::Gas& gas : gases()) {
    SCOPED_TRACE(testing::Message() << "gas " << gas.seed);
    const World world = support::make_gas(gas);
    std::optional<std::pair<EventLogHash, std::uint64_t>> expected;
    for (const InstructionSet set : kAllSets) {
      if (!is_available(set)) continue;
      for (const double edge : {1.1, 2.5}) {
        Recorded<Cells> run{cells(world, edge, set), {}};
        run.go_on({.until = Time(20), .contacts = support::cases(20000)});
        run.engine.validate();
        if (!expected) expected.emplace(run.hash, run.contacts);
        ASSERT_EQ(run.contacts, expected->second);
        ASSERT_EQ(run.hash.value(), expected->first.value());
      }
    }
    EXPECT_GT(expected->second, 100U);
  }
}

TEST(InstructionSets, GiveOneHistoryOfRandomWorlds) {
  for (std::uint64_t seed = 0; seed < support::cases(600); ++seed) {
    const support::RandomWorld made = support::make_random_world(seed);
    if (made.world.size() == 0) continue;
    SCOPED_TRACE(made.name);
    const RunLimits limits{.until = Time(made.until), .contacts = 200};
    std::optional<EventLogHash> expected;
    for (const InstructionSet set : kAllSets) {
      if (!is_available(set)) continue;
      Recorded<Cells> by_cells{cells(made.world, 2 * made.world.largest_radius(), set), {}};
      Recorded<Pairs> by_pairs{{made.world, {PhaseKind::all_pairs, 1, set}, Time(0)}, {}};
      by_cells.go_on(limits);
      by_pairs.go_on(limits);
      if (!expected) expected = by_pairs.hash;
      ASSERT_EQ(by_cells.hash, *expected);
      ASSERT_EQ(by_pairs.hash, *expected);
    }
  }
}

// Newly made, copied at the start and copied later, with different instruction sets and cells, and run in
// turns of different lengths: nothing may leak from one into another.
TEST(EnginesSideBySide, HaveTheHistoryOfASingleOne) {
  const World world = support::make_gas({.count = 400, .packing_fraction = 0.3, .seed = 7});
  const World other_world = support::make_gas({.count = 300, .packing_fraction = 0.1, .seed = 8});
  constexpr std::uint64_t kContacts = 12000;
  const auto alone = [](const World& gas) {
    Recorded<Cells> run{cells(gas, 1.3, InstructionSet::portable), {}};
    run.go_on({.contacts = kContacts});
    return run.hash.value();
  };
  const std::uint64_t expected = alone(world);
  const std::uint64_t other_expected = alone(other_world);
  ASSERT_NE(expected, other_expected);

  std::vector<Recorded<Cells>> runs;
  std::vector<std::uint64_t> hashes;
  for (const InstructionSet set : kAllSets) {
    if (!is_available(set)) continue;
    for (const double edge : {1.0, 1.6, 2.7}) {
      runs.push_back({cells(world, edge, set), {}});
      hashes.push_back(expected);
      runs.push_back({cells(other_world, edge, set), {}});
      hashes.push_back(other_expected);
      runs.push_back(runs.front());
      hashes.push_back(expected);
    }
  }
  Random random(9);
  std::size_t unfinished = runs.size();
  while (unfinished > 0) {
    const std::size_t chosen = random.bits() % runs.size();
    Recorded<Cells>& run = runs[chosen];
    if (run.contacts == kContacts) continue;
    run.go_on({.contacts = std::min<std::uint64_t>(1 + random.bits() % 700, kContacts - run.contacts)});
    if (run.contacts == kContacts) --unfinished;
    // A copy replaces another engine of the same gas.
    const std::size_t replaced = random.bits() % runs.size();
    const bool is_useful = random.uniform() < 0.1 && replaced != chosen && hashes[replaced] == hashes[chosen];
    if (!is_useful || runs[replaced].contacts == kContacts || run.contacts == kContacts) continue;
    Recorded<Cells> copy = run;
    runs[replaced] = std::move(copy);
  }
  for (std::size_t i = 0; i < runs.size(); ++i) {
    EXPECT_EQ(runs[i].hash.value(), hashes[i]) << "engine " << i;
    runs[i].engine.validate();
  }
}

}  // namespace
}  // namespace hardball::instruction_sets_test
