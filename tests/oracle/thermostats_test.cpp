// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Worlds with thermostats: one history for all engines, however the run is split and whatever is asked
// meanwhile.
#include <gtest/gtest.h>

#include <optional>

#include "hardball/numbers/random.hpp"
#include "hardball/world/totals.hpp"
#include "support/effort.hpp"
#include "support/history.hpp"
#include "support/pieces.hpp"
#include "support/random_world.hpp"

namespace hardball::thermostats_test {
namespace {

using namespace support;

constexpr std::uint64_t kWorlds = 300;
constexpr std::uint64_t kParts = 4;

// One of the three kinds, which acts a few times to a few hundred times in the run.
Thermostat make_thermostat(const RandomWorld& made, std::uint64_t seed) {
  Random random(seed);
  double mass = 1;
  double temperature = 0;
  for (Slot slot = 0; slot < made.world.size(); ++slot) {
    if (made.world.is_kinematic(slot)) continue;
    mass = made.world.mass(slot);
    temperature = std::max(temperature, 2 * kinetic_energy(made.world, slot, Time(0)));
  }
  if (temperature == 0) {
    const double speed = 10 * made.world.largest_radius() / made.until;
    temperature = speed > 0 ? mass * speed * speed : 1;
  }
  const double actions = std::ldexp(1 + random.uniform(), static_cast<int>(seed / 3 % 6));
  switch (seed % 3) {
    case 0:
      return Thermostat(Andersen(temperature, actions / made.until), seed);
    case 1:
      return Thermostat(Rescale(temperature, made.until / actions), seed);
    default:
      return Thermostat(Heating(temperature / mass / made.until, made.until / actions), seed);
  }
}

// With what the thermostat has done.
History with_thermostat(const Simulation& simulation, History history) {
  history.more = {static_cast<double>(simulation.thermostat()->events()), simulation.thermostat()->energy()};
  return history;
}

class Thermostats : public testing::TestWithParam<std::uint64_t> {
 protected:
  void agree_on(RandomWorld (*make)(std::uint64_t seed)) {
    std::uint64_t events = 0;
    std::uint64_t contacts = 0;
    for (std::uint64_t seed = GetParam(); seed < cases(kWorlds); seed += kParts) {
      const RandomWorld made = make(seed);
      const Thermostat thermostat = make_thermostat(made, seed);
      SCOPED_TRACE(made.name + ", " + std::string(name_of(thermostat.kind())));
      const RunLimits limits{.until = Time(made.until), .contacts = 60 + 60 * (seed % 5)};
      const auto run = [&](Simulation& simulation, const EngineVariant&, bool) {
        simulation.set_thermostat(thermostat);
        Simulation split(simulation);
        const History history = with_thermostat(simulation, validated_run(simulation, limits));
        if (history.failure.empty()) {
          Random random(seed);
          const auto next = [](const Simulation& driven) { return driven.thermostat()->next(); };
          const History pieces = with_thermostat(split, run_in_pieces(split, limits, random, next));
          EXPECT_EQ(difference(history, pieces), "") << "in pieces";
        }
        return history;
      };
      const std::optional<History> history = one_history(made.world, engine_variants(made.world), run, true);
      if (!history) return;
      events += static_cast<std::uint64_t>(history->more.front());
      contacts += history->contacts;
    }
    EXPECT_GT(events, 3 * cases(kWorlds) / kParts);
    EXPECT_GT(contacts, 10 * cases(kWorlds) / kParts);
  }
};

TEST_P(Thermostats, GiveOneHistory) {
  agree_on(make_random_world);
}

TEST_P(Thermostats, GiveOneHistoryWithGravityAndSurfaces) {
  agree_on(make_furnished_world);
}

// With spins, merging, spheres that pass through each other, and kinematic spheres.
TEST_P(Thermostats, GiveOneHistoryWithResponses) {
  agree_on(make_responsive_world);
}

TEST_P(Thermostats, GiveOneHistoryInTwoDimensions) {
  agree_on(make_flat_world);
}

INSTANTIATE_TEST_SUITE_P(Part, Thermostats, testing::Range<std::uint64_t>(0, kParts));

}  // namespace
}  // namespace hardball::thermostats_test
