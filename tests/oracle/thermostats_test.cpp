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
#include "support/random_world.hpp"

namespace hardball::thermostats_test {
namespace {

using support::History;
using support::RandomWorld;

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

// Splits and queries, none of which may affect the history.
class Splitter {
 public:
  explicit Splitter(std::uint64_t seed) : random_(seed) {}

  RunLimits piece(const Simulation& simulation, const RunLimits& left) {
    RunLimits piece = left;
    const double now = simulation.time();
    const double kind = random_.uniform();
    const double action = simulation.thermostat()->next();
    if (kind < 0.3) {
      piece.until = Time(now + random_.uniform() * random_.uniform() * (left.until.high - now));
    } else if (kind < 0.5 && action >= now && action <= left.until.high) {
      piece.until = Time(action);
    } else if (kind < 0.7) {
      piece.contacts = std::min<std::uint64_t>(left.contacts, below(5));
    } else if (kind < 0.9) {
      piece.steps = 1 + below(20);
    }
    return piece;
  }

  void query(Simulation& simulation, const RunLimits& left) {
    const double kind = random_.uniform();
    if (kind < 0.1) simulation = Simulation(simulation);
    if (kind > 0.1 && kind < 0.2) simulation = Simulation::load(simulation.save());
    if (kind < 0.4) simulation.next_contact(left.until.high);
    if (kind > 0.7) {
      const double action = std::min(simulation.thermostat()->next(), left.until.high);
      const std::optional<NextContact> contact = simulation.next_contact(action);
      if (!contact && action >= simulation.time()) simulation.positions_at(action);
    }
  }

 private:
  std::uint64_t below(std::uint64_t count) {
    return static_cast<std::uint64_t>(random_.uniform() * static_cast<double>(count));
  }

  Random random_;
};

History run_in_pieces(Simulation& simulation, const RunLimits& limits, std::uint64_t seed) {
  Splitter splitter(seed);
  for (;;) {
    RunLimits left = limits;
    left.contacts -= simulation.counters().contacts();
    splitter.query(simulation, left);
    const RunLimits piece = splitter.piece(simulation, left);
    RunStatus status{};
    try {
      status = simulation.run(piece);
    } catch (const RunFailure&) {
      return with_thermostat(simulation, support::run_on(simulation, left));
    }
    left.contacts = limits.contacts - simulation.counters().contacts();
    const bool is_end = status == RunStatus::time_reached && piece.until == limits.until;
    if (is_end || left.contacts == 0) {
      return with_thermostat(simulation, support::run_on(simulation, {.until = limits.until, .contacts = 0}));
    }
  }
}

class Thermostats : public testing::TestWithParam<std::uint64_t> {
 protected:
  void agree_on(RandomWorld (*make)(std::uint64_t seed)) {
    std::uint64_t events = 0;
    std::uint64_t contacts = 0;
    for (std::uint64_t seed = GetParam(); seed < support::cases(kWorlds); seed += kParts) {
      const RandomWorld made = make(seed);
      const Thermostat thermostat = make_thermostat(made, seed);
      SCOPED_TRACE(made.name + ", " + std::string(name_of(thermostat.kind())));
      const RunLimits limits{.until = Time(made.until), .contacts = 60 + 60 * (seed % 5)};
      const auto run = [&](Simulation& simulation, const support::EngineVariant&, bool) {
        simulation.set_thermostat(thermostat);
        Simulation split(simulation);
        const History history = with_thermostat(simulation, support::validated_run(simulation, limits));
        if (history.failure.empty()) {
          EXPECT_EQ(support::difference(history, run_in_pieces(split, limits, seed)), "") << "in pieces";
        }
        return history;
      };
      const std::optional<History> history =
          support::one_history(made.world, support::engine_variants(made.world), run, true);
      if (!history) return;
      events += static_cast<std::uint64_t>(history->more.front());
      contacts += history->contacts;
    }
    EXPECT_GT(events, 3 * support::cases(kWorlds) / kParts);
    EXPECT_GT(contacts, 10 * support::cases(kWorlds) / kParts);
  }
};

TEST_P(Thermostats, GiveOneHistory) {
  agree_on(support::make_random_world);
}

TEST_P(Thermostats, GiveOneHistoryWithGravityAndSurfaces) {
  agree_on(support::make_furnished_world);
}

// With spins, merging, spheres that pass through each other, and kinematic spheres.
TEST_P(Thermostats, GiveOneHistoryWithResponses) {
  agree_on(support::make_responsive_world);
}

TEST_P(Thermostats, GiveOneHistoryInTwoDimensions) {
  agree_on(support::make_flat_world);
}

INSTANTIATE_TEST_SUITE_P(Part, Thermostats, testing::Range<std::uint64_t>(0, kParts));

}  // namespace
}  // namespace hardball::thermostats_test
