// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Spheres that grow or shrink: contact times against a hundred digits, and random worlds, one history for all
// engines, however the run is split.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <optional>

#include "hardball/geometry/contact_time.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/world/totals.hpp"
#include "hardball/world/walls.hpp"
#include "support/effort.hpp"
#include "support/history.hpp"
#include "support/pieces.hpp"
#include "support/random_world.hpp"

namespace hardball::growth_test {
namespace {

using Long = boost::multiprecision::cpp_bin_float_100;
using namespace support;

double infinity() {
  return std::numeric_limits<double>::infinity();
}

Long dot(const Vec3& a, const Vec3& b) {
  return Long(a.x) * Long(b.x) + Long(a.y) * Long(b.y) + Long(a.z) * Long(b.z);
}

// The first time t >= 0 at which |r + v t| falls below R + G t, from the signs of the quadratic and of its
// derivative alone; infinity if there is none.
Long plain_time_to_touch(const GrowingPair<double>& pair) {
  const Long a = dot(pair.velocity, pair.velocity) - Long(pair.growth) * Long(pair.growth);
  const Long b = dot(pair.separation, pair.velocity) - Long(pair.reach) * Long(pair.growth);
  const Long c = dot(pair.separation, pair.separation) - Long(pair.reach) * Long(pair.reach);
  const Long forever = std::numeric_limits<Long>::infinity();
  if (c <= 0 && b < 0) return 0;
  const Long d = b * b - a * c;
  const auto with_radii = [&](const Long& root) {
    return root >= 0 && Long(pair.reach) + Long(pair.growth) * root > 0 ? root : forever;
  };
  if (a == 0) return b < 0 ? with_radii(-c / (2 * b)) : forever;
  if (d <= 0) return a < 0 ? with_radii(-b / a) : forever;
  // Of a parabola that opens upward the lower root, of one that opens downward the upper root is a descent.
  return with_radii((-b - sqrt(d)) / a);
}

// Touching, grazing, nearly at relative rest, growing faster than they part, with gaps down to rounding.
GrowingPair<double> make_pair(Random& random) {
  const auto exponent = [&](double least) { return std::pow(10, least * random.uniform()); };
  const Vec3 direction = random.direction();
  const double reach = 0.5 + random.uniform();
  const double gap = random.uniform() < 0.2 ? 3 * random.uniform() : reach * exponent(-15);
  Vec3 velocity = random.uniform() < 0.8 ? 1.0 * random.direction() : exponent(-6) * random.direction();
  const double growth = (random.uniform() < 0.3 ? -1 : 1) * exponent(-6) * (random.uniform() < 0.3 ? 3 : 1);
  if (random.uniform() < 0.2) velocity = velocity - hardball::dot(velocity, direction) * direction;
  if (random.uniform() < 0.2) velocity = (random.uniform() * std::fabs(growth)) * random.direction();
  return {(reach + gap) * direction, velocity, reach, growth};
}

TEST(GrowingContact, AgreesWithAHundredDigits) {
  Random random(1);
  int contacts = 0;
  int overtaken = 0;
  for (std::size_t i = 0; i < cases(200000); ++i) {
    const GrowingPair<double> pair = make_pair(random);
    const double found = time_to_touch(pair);
    const Long expected = plain_time_to_touch(pair);
    if (found == infinity() || expected == std::numeric_limits<Long>::infinity()) {
      ASSERT_TRUE(found == infinity() && expected == std::numeric_limits<Long>::infinity()) << i;
      continue;
    }
    ++contacts;
    overtaken += approach(pair) >= 0 ? 1 : 0;
    // Six units in the last place, for a double that is the square root of a sum.
    ASSERT_LE(abs(Long(found) - expected), Long(6 * 0x1p-53) * expected) << i;
    const GrowingPair<double> exchanged{-pair.separation, -pair.velocity, pair.reach, pair.growth};
    ASSERT_TRUE(same_bits(found, time_to_touch(exchanged)));
  }
  EXPECT_GT(contacts, static_cast<int>(cases(50000)));
  EXPECT_GT(overtaken, static_cast<int>(cases(500)));
}

constexpr std::uint64_t kWorlds = 1200;
constexpr std::uint64_t kParts = 6;

// Rates of both signs, slow and fast, to a packing fraction or a pressure, or on and on.
std::optional<GrowthRules> make_rules(const World& world, Random& random) {
  if (world.size() == 0 || !(kinetic_energy(world, Time(0)) > 0)) return std::nullopt;
  GrowthRules rules;
  rules.rate = (random.uniform() < 0.25 ? -1 : 1) * std::pow(10, -3 * random.uniform());
  const double present = packing_fraction(world, Time(0));
  // In open space nothing ends it.
  if (!(present > 0)) rules.rate = 0.1 * std::fabs(rules.rate);
  if (present > 0 && (rules.rate < 0 || random.uniform() < 0.5))
    rules.until_packing_fraction =
        present * (rules.rate > 0 ? 1 + random.uniform() : 0.2 + 0.8 * random.uniform());
  if (random.uniform() < 0.3) rules.until_compressibility = std::pow(10, 1 + 5 * random.uniform());
  return rules;
}

// With what the growth has come to.
History with_growth(const Simulation& simulation, History history) {
  const Growth& growth = simulation.world().motion().growth();
  history.more = {static_cast<double>(simulation.growth()->epochs()),
                  simulation.tally().growth_work(),
                  growth.begin.high,
                  growth.begin.low,
                  growth.end.high,
                  growth.end.low,
                  growth.scale,
                  growth.rate};
  return history;
}

// All pairs, and a fifth of the other ways: each is compared in many worlds.
std::vector<EngineVariant> variants_for(const World& world, std::uint64_t seed) {
  std::vector<EngineVariant> all = engine_variants(world);
  // In open space nothing ends the growth: in the end, spheres would be in millions of cells of their first
  // size.
  if (!(packing_fraction(world, Time(0)) > 0)) {
    const double extent = 20 * world.largest_bounding_radius();
    std::erase_if(all, [&](const EngineVariant& variant) {
      return variant.options.engine == EngineKind::cells && variant.options.cell_edge < extent;
    });
  }
  if (world.size() > 1) {
    for (const EngineVariant& variant : divided_variants()) all.push_back(variant);
  }
  std::vector<EngineVariant> chosen{all.front()};
  for (std::size_t i = 1; i < all.size(); ++i) {
    if ((i + seed / kParts) % 5 == 0) chosen.push_back(all[i]);
  }
  return chosen;
}

class GrowthAgrees : public testing::TestWithParam<std::uint64_t> {};

TEST_P(GrowthAgrees, OnRandomWorlds) {
  std::uint64_t contacts = 0;
  std::uint64_t epochs = 0;
  for (std::uint64_t seed = GetParam(); seed < cases(kWorlds); seed += kParts) {
    const RandomWorld made = make_growing_world(seed);
    SCOPED_TRACE(made.name);
    Random random(seed);
    const std::optional<GrowthRules> rules = make_rules(made.world, random);
    if (!rules) continue;
    SCOPED_TRACE("rate " + to_text(rules->rate) + " to " + to_text(rules->until_packing_fraction));
    const RunLimits limits{.until = Time(3 * made.until), .contacts = 100 + 100 * (seed % 5)};
    const std::vector<EngineVariant> variants = variants_for(made.world, seed);
    const auto run = [&](Simulation& simulation, const EngineVariant& variant, bool is_first) {
      double edits = 0;
      simulation.observe({.change = [&](const VelocityChange& change) {
        edits += change.mass *
                 (hardball::dot(change.after, change.after) - hardball::dot(change.before, change.before)) /
                 2;
      }});
      simulation.grow(*rules);
      if (!is_first && variant.name == variants.back().name) {
        const auto next_epoch = [](const Simulation& growing) { return growing.growth()->next(); };
        return with_growth(simulation, run_in_pieces(simulation, limits, random, next_epoch));
      }
      const History history = with_growth(simulation, run_on(simulation, limits));
      // What is locked among walls comes to rest where impacts are inelastic.
      const bool is_collapse =
          made.restitution < 1 && history.failure.find("inelastic collapse") != std::string::npos;
      EXPECT_TRUE(history.failure.empty() || is_collapse) << history.failure;
      simulation.validate();
      const double energy = hardball::energy(simulation.world(), simulation.now());
      const double before = simulation.tally().initial_energy();
      const double work = simulation.tally().growth_work();
      if (made.restitution == 1 && made.world.surfaces().empty() && made.world.box().has_plain_faces()) {
        EXPECT_NEAR(energy, before + work + edits,
                    1e-12 * (energy + before + std::fabs(work) + std::fabs(edits)));
      }
      return history;
    };
    const std::optional<History> expected = one_history(made.world, variants, run, true);
    if (!expected) return;
    contacts += expected->contacts;
    epochs += static_cast<std::uint64_t>(expected->more.front());
  }
  EXPECT_GT(contacts, 30 * cases(kWorlds) / kParts);
  EXPECT_GT(epochs, 5 * cases(kWorlds) / kParts);
}

INSTANTIATE_TEST_SUITE_P(Part, GrowthAgrees, testing::Range(std::uint64_t{0}, kParts));

// Negating the velocities and the rate leads back to the start.
TEST(Growth, IsReversible) {
  std::uint64_t contacts = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    RandomWorld made = make_random_gas(seed, {Boundary::periodic, Boundary::wall, Boundary::periodic}, 30);
    if (made.world.size() < 5 || made.restitution < 1) continue;
    World start = made.world;
    const double end = 0.05 * made.until;
    const double rate = 0.2 / end * (seed % 3 == 0 ? -1 : 1);
    double scale = 1;
    if (rate > 0) {
      // So that there is room.
      scale = 0.6;
    }
    start.set_growth({Time(0), Time(end), scale, rate});
    Simulation there(start);
    there.run_until(end);
    // Rounding errors grow with every contact.
    if (there.counters().contacts() > 4 * start.size()) continue;
    contacts += there.counters().contacts();
    World turn(start.box());
    turn.set_interactions(start.interactions());
    there.world().for_each_by_id([&](Slot slot) {
      turn.add({.position = there.world().position(slot, there.now()),
                .velocity = -there.world().velocity(slot, there.now()),
                .radius = there.world().base_radius(slot) * 0.5,
                .mass = there.world().mass(slot)});
    });
    turn.set_growth({Time(0), Time(end), 2 * (scale + rate * end), -2 * rate});
    Simulation back(turn);
    back.run_until(end);
    EXPECT_EQ(back.counters().contacts(), there.counters().contacts()) << seed;
    const double size = made.world.largest_radius();
    for (SphereId id = 0; id < start.size(); ++id) {
      Vec3 apart = back.position(id) - start.position(start.slot_of(id), Time(0));
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        if (start.box().is_periodic(axis))
          apart[axis] -= start.box().size()[axis] * std::round(apart[axis] / start.box().size()[axis]);
      }
      EXPECT_LT(length(apart), 1e-5 * size) << seed;
    }
  }
  EXPECT_GT(contacts, 300U);
}

}  // namespace
}  // namespace hardball::growth_test
