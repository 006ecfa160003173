// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Runs that are saved and loaded at any moment, and continue with another engine: the history and all
// measures are those of the undisturbed run, to the bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <optional>
#include <string>
#include <vector>

#include "hardball/archive/archive.hpp"
#include "hardball/measure/measures.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/simulation/simulation.hpp"
#include "support/effort.hpp"
#include "support/history.hpp"
#include "support/random_world.hpp"

namespace hardball::saved_test {
namespace {

using namespace support;

constexpr std::uint64_t kWorlds = 1000;
constexpr std::uint64_t kParts = 4;
constexpr std::uint64_t kMaxContacts = 300;
constexpr std::uint64_t kMaxSteps = 20000;

std::optional<Thermostat> any_thermostat(const RandomWorld& made, std::uint64_t seed) {
  const double speed = 10 * made.world.largest_radius() / made.until;
  if (seed / 5 % 2 == 0 || !(speed > 0)) return std::nullopt;
  if (seed / 10 % 3 == 0) return Thermostat(Andersen(speed * speed, 5 / made.until), seed);
  if (seed / 10 % 3 == 1) return Thermostat(Rescale(speed * speed, made.until / 5), seed);
  return Thermostat(Heating(speed * speed / made.until, made.until / 5), seed);
}

bool merges(const RandomWorld& made) {
  return made.world.interactions().table().has_merging();
}

void expect_same_bits(double a, double b, const std::string& name) {
  ASSERT_EQ(std::bit_cast<std::uint64_t>(a), std::bit_cast<std::uint64_t>(b))
      << name << ": " << a << " and " << b;
}

void expect_same(const std::vector<Measurement>& a, const std::vector<Measurement>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].name, b[i].name);
    ASSERT_EQ(a[i].quantities.size(), b[i].quantities.size());
    for (std::size_t k = 0; k < a[i].quantities.size(); ++k) {
      const Quantity& one = a[i].quantities[k];
      const Quantity& other = b[i].quantities[k];
      expect_same_bits(one.value, other.value, a[i].name + " " + one.name);
      expect_same_bits(one.error, other.error, a[i].name + " error of " + one.name);
      expect_same_bits(one.theory, other.theory, a[i].name + " theory of " + one.name);
    }
    ASSERT_EQ(a[i].columns.size(), b[i].columns.size());
    for (std::size_t k = 0; k < a[i].columns.size(); ++k) {
      const Column& one = a[i].columns[k];
      ASSERT_EQ(one.values.size(), b[i].columns[k].values.size());
      for (std::size_t row = 0; row < one.values.size(); ++row) {
        expect_same_bits(one.values[row], b[i].columns[k].values[row], a[i].name + " " + one.name);
      }
    }
    expect_same_bits(a[i].duration, b[i].duration, a[i].name + " duration");
    expect_same_bits(a[i].transient, b[i].transient, a[i].name + " transient");
  }
}

struct MeasuredRun {
  Simulation simulation;
  Measures measures;
  std::string failure = {};

  RunStatus go_on(const RunLimits& limits) {
    try {
      return simulation.run(limits, measures);
    } catch (const RunFailure& reason) {
      failure = reason.what();
      return RunStatus::time_reached;
    }
  }
};

// All measures where they are possible.
Measures make_measures(const RandomWorld& made, std::uint64_t seed) {
  MeasureSettings settings;
  if (merges(made)) settings.names = {};
  if (seed % 2 == 0) settings.every = made.until / 20;
  return Measures(settings);
}

class Saved : public testing::TestWithParam<std::uint64_t> {};

TEST_P(Saved, GoesOnToTheSameHistoryAndMeasures) {
  std::uint64_t saves = 0;
  std::uint64_t contacts = 0;
  for (std::uint64_t seed = GetParam(); seed < cases(kWorlds); seed += kParts) {
    const RandomWorld made = any_world(seed);
    if (made.world.size() == 0) continue;
    SCOPED_TRACE(made.name);
    const RunLimits limits{.until = Time(made.until), .contacts = kMaxContacts, .steps = kMaxSteps};
    const std::vector<EngineVariant> variants = engine_variants(made.world);
    const EngineVariant& variant = variants[seed / kParts % variants.size()];
    SCOPED_TRACE(variant.name);
    try {
      MeasuredRun undisturbed{Simulation(made.world, variant.options), make_measures(made, seed)};
      undisturbed.simulation.set_thermostat(any_thermostat(made, seed));
      MeasuredRun saved = undisturbed;
      if (undisturbed.go_on(limits) == RunStatus::steps_reached) continue;
      Random random(seed);
      for (;;) {
        RunLimits piece = limits;
        piece.contacts -= saved.simulation.counters().contacts();
        if (piece.contacts == 0) break;
        const bool is_cut = random.uniform() < 0.9;
        if (is_cut) {
          const auto few = static_cast<std::uint64_t>(random.uniform() * 12);
          piece.contacts = std::min(piece.contacts, few);
        }
        const RunStatus status = saved.go_on(piece);
        if (status == RunStatus::time_reached || !saved.failure.empty()) break;
        if (random.uniform() < 0.3) saved.simulation.next_contact(made.until);
        saved.simulation = Simulation::load(saved.simulation.save());
        const std::string bytes = archived(saved.measures);
        restore(bytes, "measures", saved.measures);
        ASSERT_EQ(archived(saved.measures), bytes);
        ++saves;
      }
      ASSERT_EQ(saved.failure, undisturbed.failure);
      const RunLimits none{.until = undisturbed.simulation.now(), .contacts = 0};
      const History history = run_on(saved.simulation, none);
      ASSERT_EQ(difference(history, run_on(undisturbed.simulation, none)), "");
      contacts += history.contacts;
      const Tally& tally = saved.simulation.tally();
      expect_same_bits(tally.compressibility(saved.simulation.now()),
                       undisturbed.simulation.tally().compressibility(saved.simulation.now()), "Z");
      expect_same_bits(tally.initial_energy(), undisturbed.simulation.tally().initial_energy(), "energy");
      expect_same(saved.measures.results(saved.simulation.world(), saved.simulation.now()),
                  undisturbed.measures.results(undisturbed.simulation.world(), undisturbed.simulation.now()));
    } catch (const Error& error) {
      if (error.where() != "cell edge") throw;
    }
  }
  EXPECT_GT(saves, 2 * cases(kWorlds) / kParts);
  EXPECT_GT(contacts, 20 * cases(kWorlds) / kParts);
}

INSTANTIATE_TEST_SUITE_P(Part, Saved, testing::Range<std::uint64_t>(0, kParts));

}  // namespace
}  // namespace hardball::saved_test
