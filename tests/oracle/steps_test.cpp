// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Potentials of steps: exit times against a hundred digits, and random worlds with wells, shoulders and
// chains, one history for all engines, however the run is split.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <optional>

#include "hardball/geometry/exit_time.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/world/step_levels.hpp"
#include "hardball/world/totals.hpp"
#include "support/effort.hpp"
#include "support/history.hpp"
#include "support/pieces.hpp"
#include "support/stepped.hpp"

namespace hardball::steps_test {
namespace {

using Long = boost::multiprecision::cpp_bin_float_100;
using namespace support;

Long dot(const Vec3& a, const Vec3& b) {
  return Long(a.x) * Long(b.x) + Long(a.y) * Long(b.y) + Long(a.z) * Long(b.z);
}

struct Passage {
  Vec3 separation;
  Vec3 velocity;
  double reach;
};

// The last time at which |r + v t| is the reach, of points that are not apart, or approach each other.
Long plain_time_to_exit(const Passage& passage) {
  const Long a = dot(passage.velocity, passage.velocity);
  const Long b = dot(passage.separation, passage.velocity);
  const Long c = dot(passage.separation, passage.separation) - Long(passage.reach) * Long(passage.reach);
  if (c >= 0 && b >= 0) return 0;
  const Long d = b * b - a * c;
  return (d > 0 ? Long(-b + sqrt(d)) : Long(-b)) / a;
}

// Deep inside, at the edge, beyond it by rounding; straight through, along the edge; fast and slow.
Passage make_passage(Random& random) {
  const auto exponent = [&](double least) { return std::pow(10, least * random.uniform()); };
  const Vec3 direction = random.direction();
  const double reach = 0.5 + random.uniform();
  const double kind = random.uniform();
  const double distance = kind < 0.3   ? reach * random.uniform()
                          : kind < 0.8 ? reach * (1 - exponent(-16))
                                       : reach * (1 + 1e-16 * random.uniform());
  Vec3 velocity = (random.uniform() < 0.5 ? 1 : exponent(-8)) * random.direction();
  if (random.uniform() < 0.4) {
    const double speed = length(velocity);
    velocity = velocity - hardball::dot(velocity, direction) * direction +
               ((random.uniform() - 0.5) * speed * exponent(-16)) * direction;
  }
  return {distance * direction, velocity, reach};
}

TEST(ExitTime, AgreesWithAHundredDigits) {
  Random random(1);
  int grazing = 0;
  for (std::size_t i = 0; i < cases(200000); ++i) {
    const Passage passage = make_passage(random);
    const double found = time_to_exit<double>(passage.separation, passage.velocity, passage.reach);
    const Long expected = plain_time_to_exit(passage);
    const double speed = length(passage.velocity);
    const double unit = 0x1p-53 * passage.reach / speed;
    ASSERT_LE(abs(Long(found) - expected), Long(64 * unit)) << i;
    if (found > 0 && expected > 0) {
      const Long a = dot(passage.velocity, passage.velocity) * Long(found) * Long(found);
      const Long b = dot(passage.separation, passage.velocity) * Long(found);
      const Long distance = sqrt(dot(passage.separation, passage.separation) + 2 * b + a);
      const double beyond = std::max(0.0, length(passage.separation) - passage.reach);
      ASSERT_LE(abs(distance - Long(passage.reach)), Long(8 * 0x1p-53 * passage.reach + beyond)) << i;
    }
    ASSERT_TRUE(
        same_bits(found, time_to_exit<double>(-passage.separation, -passage.velocity, passage.reach)));
    grazing += found > 0 && found < 1e-3 * passage.reach / speed ? 1 : 0;
  }
  EXPECT_GT(grazing, static_cast<int>(cases(20000)));
}

TEST(ExitTime, OfSpheresAtRestIsNever) {
  EXPECT_EQ(time_to_exit<double>({0.5, 0, 0}, {}, 1), std::numeric_limits<double>::infinity());
}

TEST(ExitTime, BeyondReachIsNowWhenReceding) {
  EXPECT_EQ(time_to_exit<double>({1.1, 0, 0}, {1, 0, 0}, 1), 0);
  EXPECT_EQ(time_to_exit<double>({1, 0, 0}, {0, 1, 0}, 1), 0);
  // Approaching, they leave on the other side, or where they are nearest.
  EXPECT_DOUBLE_EQ(time_to_exit<double>({1.1, 0, 0}, {-1, 0, 0}, 1), 2.1);
  EXPECT_DOUBLE_EQ(time_to_exit<double>({1, 1, 0}, {-1, 0, 0}, 1), 1);
}

constexpr std::uint64_t kWorlds = 3000;
constexpr std::uint64_t kParts = 6;

// With the energy and the number of pairs within steps.
History with_steps(const Simulation& simulation, History history) {
  history.more = {energy(simulation.world(), simulation.now()),
                  static_cast<double>(simulation.world().pair_levels().size())};
  return history;
}

// The levels of all pairs are what the distances say, but for rounding.
void expect_levels(const Simulation& simulation) {
  const World& world = simulation.world();
  for (Slot a = 0; a < world.size(); ++a) {
    for (Slot b = 0; b < a; ++b) {
      const PairLevel* const pair = world.pair_levels().find(a, b);
      const StepTable::Number number = pair ? pair->potential : potential_of(world, a, b);
      if (number == StepTable::kNone) continue;
      const StepPotential& potential = world.interactions().steps()[number];
      const int level = pair ? pair->level : 0;
      const Image image = nearest_image(world, a, b, simulation.now());
      const double distance = length(separation_at(world.motion(), world.path(a), world.path(b),
                                                   world.box().shift(image), simulation.now()));
      const double radii = world.base_radius(a) + world.base_radius(b);
      const double rounding = 1e-9 * radii + coordinate_error(world, a, simulation.now()) +
                              coordinate_error(world, b, simulation.now());
      if (level > 0) {
        ASSERT_LE(distance, potential.outer_ratio(static_cast<std::uint8_t>(level)) * radii + rounding);
      }
      ASSERT_GE(distance, potential.inner_ratio(static_cast<std::uint8_t>(level)) * radii - rounding);
    }
  }
}

class StepsAgree : public testing::TestWithParam<std::uint64_t> {};

TEST_P(StepsAgree, OnRandomWorlds) {
  std::uint64_t contacts = 0;
  std::uint64_t passed = 0;
  std::uint64_t refused = 0;
  for (std::uint64_t seed = GetParam(); seed < cases(kWorlds); seed += kParts) {
    const RandomWorld made = make_stepped_world(seed);
    SCOPED_TRACE(made.name);
    Random random(seed);
    const RunLimits limits{.until = Time(2 * made.until), .contacts = 100 + 100 * (seed % 5)};
    const std::vector<EngineVariant> variants = engine_variants(made.world);
    const auto run = [&](Simulation& simulation, const EngineVariant& variant, bool is_first) {
      const double before = energy(simulation.world(), simulation.now());
      if (is_first) {
        simulation.on_contact([&](const Contact& contact) {
          if (contact.step.happens()) ++(contact.step.passes ? passed : refused);
        });
      } else if (&variant == &variants[1 + seed % (variants.size() - 1)]) {
        return with_steps(simulation, run_in_pieces(simulation, limits, random));
      }
      const History history = with_steps(simulation, validated_run(simulation, limits));
      expect_levels(simulation);
      const std::optional<Restitution> response = made.world.interactions().table().one_for_all();
      if (response && response->coefficient() == 1 && made.world.surfaces().empty() &&
          made.world.box().has_plain_faces()) {
        const double scale = kinetic_energy(made.world, Time(0)) + std::fabs(before);
        EXPECT_NEAR(history.more.front(), before, 1e-12 * scale);
      }
      return history;
    };
    const std::optional<History> expected = one_history(made.world, variants, run, true);
    if (!expected) return;
    contacts += expected->contacts;
  }
  EXPECT_GT(contacts, 50 * cases(kWorlds) / kParts);
  EXPECT_GT(passed, 10 * cases(kWorlds) / kParts);
  EXPECT_GT(refused, 10 * cases(kWorlds) / kParts);
}

// A listener that removes and adds spheres, some of them within steps of others, and changes velocities.
TEST_P(StepsAgree, WhileSpheresComeAndGo) {
  std::uint64_t removed = 0;
  std::uint64_t added = 0;
  for (std::uint64_t seed = GetParam(); seed < cases(kWorlds / 4); seed += kParts) {
    const RandomWorld made = make_stepped_world(seed + 50000);
    SCOPED_TRACE(made.name);
    const auto run = [&](Simulation& simulation, const EngineVariant&, bool is_first) {
      std::uint64_t contacts = 0;
      simulation.on_contact([&](const Contact& contact) {
        ++contacts;
        if (contacts % 7 == 0) simulation.change_velocity(contact.first, -1.5 * contact.after.first);
        if (contacts % 11 == 0 && contact.is_collision() && simulation.size() > 3) {
          simulation.remove(contact.second);
          removed += is_first ? 1U : 0U;
        }
        if (contacts % 5 == 0) {
          const Vec3 apart = simulation.position(contact.first) - contact.position;
          const double radius = 0.3 * contact.first_radius;
          Vec3 beside = contact.position - 1.35 * contact.first_radius * contact.normal() + apart;
          if (made.world.box().is_flat()) beside.z = 0;
          try {
            simulation.add({.position = beside, .velocity = contact.before.first, .radius = radius});
            added += is_first ? 1U : 0U;
          } catch (const Error&) {
            // There is no room.
          }
        }
      });
      const RunLimits limits{.until = Time(made.until), .contacts = 150};
      const History history = with_steps(simulation, validated_run(simulation, limits));
      expect_levels(simulation);
      return history;
    };
    if (!one_history(made.world, engine_variants(made.world), run, true)) return;
  }
  EXPECT_GT(removed, cases(kWorlds / 4) / kParts);
  EXPECT_GT(added, cases(kWorlds / 4) / kParts);
}

INSTANTIATE_TEST_SUITE_P(Part, StepsAgree, testing::Range(std::uint64_t{0}, kParts));

}  // namespace
}  // namespace hardball::steps_test
