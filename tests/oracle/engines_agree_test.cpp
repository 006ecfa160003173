// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Many small worlds, each run by every engine and size of cells: one history, bit for bit.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

#include "hardball/broadphase/large_sphere_grid.hpp"
#include "hardball/broadphase/neighbor_list.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/placement/placement.hpp"
#include "support/effort.hpp"
#include "support/gas.hpp"
#include "support/history.hpp"
#include "support/instruction_sets.hpp"
#include "support/random_world.hpp"

namespace hardball::engines_agree_test {
namespace {

using namespace support;

constexpr std::uint64_t kWorlds = 4000;
constexpr std::uint64_t kParts = 8;

class EnginesAgree : public testing::TestWithParam<std::uint64_t> {
 protected:
  // Runs a part of so many worlds that `make` makes of seeds by every engine.
  void agree_on(RandomWorld (*make)(std::uint64_t seed), std::uint64_t worlds = kWorlds) {
    std::uint64_t contacts = 0;
    for (std::uint64_t seed = GetParam(); seed < cases(worlds); seed += kParts) {
      const RandomWorld made = make(seed);
      SCOPED_TRACE(made.name);
      // Contacts are limited too: in a granular world infinitely many may happen in a finite time.
      const RunLimits limits{.until = Time(made.until), .contacts = 60 + 60 * (seed % 5)};
      const std::optional<History> history =
          one_history(made.world, engine_variants(made.world), limits, true);
      if (!history) return;
      contacts += history->contacts;
    }
    // The worlds have some 50 contacts each on average.
    EXPECT_GT(contacts, 25 * cases(worlds) / kParts);
  }
};

TEST_P(EnginesAgree, OnRandomWorlds) {
  agree_on(make_random_world);
}

// With gravity, walls of all shapes, in motion or thermal, and obstacles.
TEST_P(EnginesAgree, OnFurnishedWorlds) {
  agree_on(make_furnished_world);
}

// Discs, with and without all that.
TEST_P(EnginesAgree, OnFlatWorlds) {
  const auto make = [](std::uint64_t seed) {
    return seed % 3 == 0 ? make_responsive_flat_world(seed) : make_flat_world(seed);
  };
  agree_on(make, kWorlds / 2);
}

// With species that bounce by different rules, rough or smooth, merge, or pass through each other, and
// kinematic spheres.
TEST_P(EnginesAgree, OnResponsiveWorlds) {
  agree_on(make_responsive_world);
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
    if (kIsSlowBuild && collapse.restitution == 0.05) continue;
    World world(Box({Boundary::wall, Boundary::periodic, Boundary::open}, {collapse.size, 3, 0}));
    for (std::size_t i = 0; i < 5; ++i) {
      const double x = 0.75 + 1.375 * static_cast<double>(i);
      world.add({{x, 1, 1}, {collapse.velocities[i], 0, 0}, 0.5, 1});
    }
    // Another one passes by, so that tuned cells are rebuilt during the collapse.
    world.add({{1, 1, 20}, {0, 0, 1e4}, 0.125, 1});
    world.set_interactions(Restitution(collapse.restitution));
    const RunLimits limits{.until = Time(20), .contacts = 200000};
    const std::optional<History> history = one_history(world, engine_variants(world), limits);
    ASSERT_TRUE(history);
    EXPECT_NE(history->failure.find("inelastic collapse"), std::string::npos);
    EXPECT_NE(history->failure.find("elastic_below"), std::string::npos) << "the message says what helps";
    EXPECT_NE(history->failure.find("contact_duration"), std::string::npos);
  }
}

// Two spheres become slower with each impact, for ever: no engine goes beyond the operating range.
TEST(InelasticCollapse, RunsWithoutEndEndWithTheOperatingRange) {
  World world(Box::walls({16, 4, 4}));
  world.add({.position = {8.625, 2, 2}, .velocity = {-1, 0, 0}, .radius = 0.5});
  world.add({.position = {7.375, 2, 2}, .velocity = {1, 0, 0}, .radius = 0.5});
  world.set_interactions(Restitution(0.05));
  std::vector<EngineVariant> variants = engine_variants(world);
  variants.push_back({{.division = Division{.domains = 2}}, "domains"});
  one_history(world, variants, [](Simulation& simulation, const EngineVariant&, bool) {
    const History history = run_on(simulation, {.contacts = 1000});
    EXPECT_GT(history.contacts, 100U);
    EXPECT_LT(history.contacts, 1000U);
    EXPECT_LE(simulation.time(), kLargestTime);
    EXPECT_GT(simulation.time(), 1e-3 * kLargestTime);
    EXPECT_FALSE(simulation.next_contact());
    return history;
  });
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
    const std::optional<History> history = one_history(world, engine_variants(world), {.until = Time(1000)});
    ASSERT_TRUE(history);
    EXPECT_EQ(history->failure, "");
    EXPECT_GT(history->contacts, by_duration ? 20U : 100U);
  }
}

// Some thousand spheres, as dense and as different in size as chance has it, by all engines but the slowest:
// one history, bit for bit.

constexpr std::uint64_t kLargeWorlds = 24;
constexpr std::uint64_t kLargeParts = 4;

World make_large_world(std::uint64_t seed) {
  Random random(seed);
  const auto between = [&](double low, double high) { return low + (high - low) * random.uniform(); };
  const std::size_t least = kIsSlowBuild ? 500 : 2000;
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
  for (std::uint64_t seed = GetParam(); seed < cases(kLargeWorlds); seed += kLargeParts) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const World world = make_large_world(seed);
    const double diameter = 2 * world.largest_radius();
    // Spheres that burst into open space meet no more, and need not fly for ever.
    const RunLimits limits{.until = Time(500), .contacts = cases(20000)};
    std::vector<EngineVariant> ways{
        {{}, "automatic"},
        {{.engine = EngineKind::cells, .cell_edge = diameter}, "cells"},
        {{.engine = EngineKind::cells, .cell_edge = 2.5 * diameter}, "large cells"}};
    if (NeighborList::supports(world)) ways.push_back({{.engine = EngineKind::neighbors}, "neighbors"});
    if (!kIsSlowBuild) ways.push_back({{.engine = EngineKind::all_pairs}, "all pairs"});
    const std::optional<History> history = one_history(world, ways, limits);
    ASSERT_TRUE(history);
    EXPECT_EQ(history->failure, "");
    // Only a burst into open space ends before.
    EXPECT_GT(history->contacts, 20U);
  }
}

INSTANTIATE_TEST_SUITE_P(Part, LargeWorlds, testing::Range<std::uint64_t>(0, kLargeParts));

// Spheres of very different sizes, whose cells are those of the small ones: one history, bit for bit, that of
// all pairs.

// Spheres of radius one among others down to a hundredth of that.
World make_mixture(std::uint64_t seed) {
  Random random(seed);
  constexpr std::array kAll = {Boundary::periodic, Boundary::wall, Boundary::open};
  const bool is_uniform = random.uniform() < 0.5;
  const Boundary common = kAll[random.bits() % 3];
  const auto boundary = [&] { return is_uniform ? common : kAll[random.bits() % 3]; };
  const Box box({boundary(), boundary(), boundary()},
                {4.5 + 3 * random.uniform(), 5 + random.uniform(), 4.5 + 3 * random.uniform()});
  const std::size_t large = 1 + random.bits() % 3;
  const std::size_t small = 2 * large + random.bits() % 60;
  const bool is_of_two_sizes = random.uniform() < 0.3;
  std::vector<double> radii;
  for (std::size_t i = 0; i < large; ++i) radii.push_back(1 - 0.3 * random.uniform());
  for (std::size_t i = 0; i < small; ++i) {
    radii.push_back(is_of_two_sizes ? 0.1 : std::exp2(-6.6 * random.uniform()));
  }
  const Region region{{0, 0, 0},
                      {box.is_open(0) ? 5 : box.size().x, box.is_open(1) ? 5 : box.size().y,
                       box.is_open(2) ? 5 : box.size().z}};
  const std::vector<Vec3> centers = place_randomly(box, region, radii, random, "mixture");
  const bool are_masses_equal = random.uniform() < 0.5;
  const bool rest = random.uniform() < 0.3;
  World world(box);
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const Vec3 velocity{random.normal(), random.normal(), random.normal()};
    const double mass = are_masses_equal ? 1 : radii[i] * radii[i] * radii[i];
    world.add({centers[i], rest && i % 3 == 0 ? Vec3{} : velocity, radii[i], mass});
  }
  return world;
}

TEST(Mixtures, HaveTheHistoryOfAllPairs) {
  std::uint64_t suited = 0;
  std::uint64_t contacts = 0;
  for (std::uint64_t seed = 0; seed < cases(200); ++seed) {
    World world = make_mixture(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    world.set_interactions(Restitution(seed % 3 == 0 ? 1 : 0.3 + 0.1 * static_cast<double>(seed % 7)));
    const RunLimits limits{.until = Time(10), .contacts = 100 + seed % 200};
    std::vector<EngineVariant> ways{{{.engine = EngineKind::all_pairs}, "all pairs"}, {{}, "automatic"}};
    for (const double edge : {0.2, 0.35, 0.6}) {
      if (LargeSphereGrid::supports(world, edge)) ++suited;
      ways.push_back({{.engine = EngineKind::cells, .cell_edge = edge}, "cells of edge " + to_text(edge)});
    }
    const std::optional<History> history = one_history(world, ways, limits);
    ASSERT_TRUE(history);
    contacts += history->contacts;
  }
  EXPECT_GT(suited, cases(200));
  EXPECT_GT(contacts, 30 * cases(200));
}

// A ball that lists those that can reach it soon: now and then a sphere near it becomes far faster than the
// list assumes, and the ball itself is pushed.
TEST(Mixtures, AreFollowedThroughChangesOfVelocity) {
  for (std::uint64_t seed = 0; seed < (kIsSlowBuild ? 1U : 4U); ++seed) {
    Random random(seed);
    constexpr double kSize = 44;
    std::vector<double> radii(seed % 2 == 0 ? 4000 : 3000, 0.2);
    radii[0] = 10;
    if (seed % 2 == 1) radii[1] = 1.5;
    const Box box = seed < 2 ? Box::periodic({kSize, kSize, kSize}) : Box::walls({kSize, kSize, kSize});
    const std::vector<Vec3> centers =
        place_randomly(box, {{0, 0, 0}, {kSize, kSize, kSize}}, radii, random, "mixture");
    World world(box);
    for (std::size_t i = 0; i < radii.size(); ++i) {
      const Vec3 velocity{random.normal(), random.normal(), random.normal()};
      world.add({centers[i], velocity, radii[i], i == 0 && seed < 3 ? 1000.0 : 1.0});
    }
    constexpr double kEdge = 3.3;
    ASSERT_TRUE(LargeSphereGrid::supports(world, kEdge));
    std::optional<std::uint64_t> expected;
    for (const EngineKind engine : {EngineKind::all_pairs, EngineKind::cells}) {
      // Where it would take minutes, the checks of the cells must do.
      if (kIsSlowBuild && engine == EngineKind::all_pairs) continue;
      Simulation simulation(world, {.engine = engine, .cell_edge = kEdge});
      Random changes(seed);
      for (int piece = 0; piece < 20; ++piece) {
        simulation.run_contacts(40);
        const auto id = static_cast<SphereId>(1 + changes.uniform() * 2990);
        const Vec3 direction = changes.direction();
        simulation.change_velocity(id, (piece % 2 == 0 ? 300.0 : 3.0) * direction);
        if (piece % 4 == 0) simulation.change_velocity(0, changes.uniform() * changes.direction());
        if (piece % 10 == 0) simulation.validate();
      }
      EXPECT_GT(simulation.counters().contacts(), 700U);
      if (!expected) expected = simulation.event_log_hash();
      EXPECT_EQ(simulation.event_log_hash(), *expected) << "seed " << seed;
    }
  }
}

// Speeds that differ by many orders of magnitude, or change by as much, and places far away: the copies of
// paths from which contacts are bounded are good up to some speed, age and distance. One history by every
// engine.

// Runs the world in every way: `run` takes a simulation and returns its history.
template <class Run>
std::uint64_t contacts_in_one_history(const World& world, Run&& run) {
  const std::optional<History> history =
      one_history(world, engine_variants(world), [&](Simulation& simulation, const EngineVariant&, bool) {
        History found = run(simulation);
        simulation.validate();
        return found;
      });
  return history ? history->contacts : 0;
}

// So light that it hardly moves the others.
World gas_with_bullet(std::uint64_t seed, double speed) {
  World gas = make_gas({.count = 50, .packing_fraction = 0.05, .seed = seed});
  World world(gas.box());
  for (Slot slot = 0; slot < gas.size(); ++slot) {
    const bool is_bullet = slot == seed % gas.size();
    world.add({.position = gas.path(slot).position,
               .velocity = (is_bullet ? speed : 1) * gas.path(slot).velocity,
               .radius = is_bullet ? 0.05 : 0.5,
               .mass = is_bullet ? 1 / (speed * speed) : 1});
  }
  return world;
}

TEST(Speeds, OfABulletAmongSlowSpheres) {
  for (std::uint64_t seed = 0; seed < cases(12); ++seed) {
    for (const double speed : {10.0, 30.0, 1e4, 1e6}) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", speed " << speed);
      const World world = gas_with_bullet(seed, speed);
      const auto run = [](Simulation& simulation) { return run_on(simulation, {.contacts = 1000}); };
      EXPECT_EQ(contacts_in_one_history(world, run), 1000U);
      if (HasFailure()) return;
    }
  }
}

// Half of the spheres of a gas get other speeds by and by, or all at once.
TEST(Speeds, ThatChangeByOrdersOfMagnitude) {
  for (std::uint64_t seed = 0; seed < cases(6); ++seed) {
    for (const std::vector<double>& factors :
         {std::vector<double>{1e4}, std::vector<double>{1e-4}, std::vector<double>{1e2, 1e4, 1e-3}}) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", first factor " << factors[0]);
      const World world = make_gas({.count = 100, .packing_fraction = 0.02, .seed = seed});
      const auto run = [&](Simulation& simulation) {
        Random random(seed);
        double speed = 1;
        for (const double factor : factors) {
          simulation.run_until(simulation.time() + 1 / speed);
          speed *= factor;
          for (SphereId id = 0; id < simulation.size(); id += 2) {
            simulation.change_velocity(id, speed * random.direction());
          }
          run_on(simulation, {.contacts = 3000 / factors.size()});
        }
        return run_on(simulation, {.contacts = 1});
      };
      EXPECT_GT(contacts_in_one_history(world, run), 3000U);
      if (HasFailure()) return;
    }
  }
}

// A slow sphere and one at rest, which it meets when the others have had thousands of contacts: much later
// than copies of paths are good for.
TEST(Speeds, OfSpheresAtRestForVeryLong) {
  for (std::uint64_t seed = 0; seed < cases(6); ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    World world(Box::periodic({16, 16, 16}));
    world.add({{2, 2, 2}, {}, 0.5, 1});
    world.add({{2, 2, 3.25 + 0.25 * random.uniform()}, {0, 0, -1e-3}, 0.5, 1});
    // Others go to and fro between two at rest.
    for (const double y : {7.0, 9.0, 11.0}) {
      for (const double x : {2.0, 10.0}) world.add({{x, y, 9}, {}, 0.5, 1e9});
      world.add({{5 + random.uniform(), y, 9}, {10 + random.uniform(), 0, 0}, 0.5, 1});
    }
    const auto run = [](Simulation& simulation) { return run_on(simulation, {.until = Time(600)}); };
    EXPECT_GT(contacts_in_one_history(world, run), 2000U);
    if (HasFailure()) return;
  }
}

// In open space, so far from the origin that places are coarse on the scale of the spheres, by more or less.
TEST(Places, FarFromTheOrigin) {
  for (std::uint64_t seed = 0; seed < cases(4); ++seed) {
    for (const double distance : {1e6, 2e7, 5e7, 1e8, 1e9, 1e11}) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", distance " << distance);
      const World gas =
          make_gas({.count = 60, .packing_fraction = 0.2, .seed = seed, .boundary = Boundary::open});
      World world;
      for (const Path& path : gas.paths()) {
        // Spaced a little wider: places are rounded.
        world.add({1.001 * path.position + Vec3{distance, -distance, 0}, path.velocity, 0.5, 1});
      }
      const auto run = [](Simulation& simulation) { return run_on(simulation, {.until = Time(30)}); };
      EXPECT_GT(contacts_in_one_history(world, run), 30U);
      if (HasFailure()) return;
    }
  }
}

// Worlds full of contacts at one moment, in numbers so simple that the moments are equal to the last bit: one
// history by every engine, queue and instruction set, whatever the ids and slots of the spheres.

constexpr double kEdge = 16;

std::size_t below(Random& random, std::size_t count) {
  return random.bits() % count;
}

// The spheres of diameter one that a test makes, added in any order and stored in another.
class Scene {
 public:
  explicit Scene(std::uint64_t seed) : random_(seed) {}

  Random& random() { return random_; }
  void add(const Vec3& place, const Vec3& velocity) { spheres_.push_back({place, velocity, 0.5, 1}); }

  World world(Boundary boundary) {
    World world(Box({boundary, boundary, boundary}, {kEdge, kEdge, kEdge}));
    for (const std::size_t i : any_order<std::size_t>()) world.add(spheres_[i]);
    world.reorder(any_order<Slot>());
    return world;
  }

 private:
  template <class Index>
  std::vector<Index> any_order() {
    std::vector<Index> order(spheres_.size());
    std::iota(order.begin(), order.end(), Index{0});
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[below(random_, i)]);
    return order;
  }

  Random random_;
  std::vector<Sphere> spheres_;
};

// Runs a world in every way, and returns how many contacts happened at the moment of the one before.
std::uint64_t ties_in_one_history(const World& world, const RunLimits& limits) {
  std::vector<EngineVariant> ways;
  for (const EngineVariant& variant : engine_variants(world)) {
    const bool has_kernels = variant.options.engine != EngineKind::paper;
    for (const InstructionSet set : available_instruction_sets()) {
      if (!has_kernels && set != InstructionSet::portable) continue;
      ways.push_back(variant);
      ways.back().options.instructions = set;
      ways.back().name += ", instruction set " + std::to_string(static_cast<int>(set));
    }
  }
  if (!one_history(world, ways, limits)) return 0;
  Simulation simulation(world);
  const std::vector<Contact> log = record(simulation, limits);
  std::uint64_t ties = 0;
  for (std::size_t i = 1; i < log.size(); ++i) ties += log[i].time == log[i - 1].time ? 1U : 0U;
  return ties;
}

// A row of spheres along an axis, at integer places, some of which move.
void add_row(Scene& scene, std::size_t axis, double second, double third, bool is_closed) {
  Random& random = scene.random();
  const std::size_t moving = 1 + below(random, 2);
  const std::size_t places = static_cast<std::size_t>(kEdge) - (is_closed ? 1 : 0);
  std::vector<double> taken;
  for (std::size_t place = is_closed ? 1 : 0; place < places; ++place) {
    if (random.uniform() < 0.4) taken.push_back(static_cast<double>(place));
  }
  for (std::size_t i = 0; i < taken.size(); ++i) {
    Vec3 place;
    place[axis] = taken[i];
    place[(axis + 1) % kAxes] = second;
    place[(axis + 2) % kAxes] = third;
    Vec3 velocity;
    if (i < moving) velocity[axis] = random.uniform() < 0.5 ? -1 : 1;
    scene.add(place, velocity);
  }
}

Boundary closed_if(bool is_closed) {
  return is_closed ? Boundary::wall : Boundary::periodic;
}

World newtons_cradles_side_by_side(std::uint64_t seed) {
  Scene scene(seed);
  const bool is_closed = seed % 2 == 0;
  for (const double second : {2.0, 4.0, 6.0, 9.0}) {
    add_row(scene, seed % kAxes, second, seed % 4 < 2 ? 5 : second + 1, is_closed);
  }
  return scene.world(closed_if(is_closed));
}

// They cross in the middle of the box, where one sphere is; the rows begin two places from it on.
World rows_that_cross(std::uint64_t seed) {
  Scene scene(seed);
  scene.add({8, 8, 8}, {});
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      for (double distance = 2; distance < 7; distance += 1) {
        if (scene.random().uniform() < 0.5) continue;
        Vec3 place{8, 8, 8};
        place[axis] += side * distance;
        Vec3 velocity;
        velocity[axis] = -side;
        scene.add(place, velocity);
      }
    }
  }
  return scene.world(closed_if(seed % 2 == 0));
}

// Pairs that meet on a plane in the middle, return to the walls, and reach both at one moment.
World mirrored_pairs_and_walls(std::uint64_t seed) {
  Scene scene(seed);
  for (const double y : {2.0, 5.0, 8.0, 11.0}) {
    for (const double z : {3.0, 6.0}) {
      const double distance = 1 + static_cast<double>(below(scene.random(), 4));
      const double speed = static_cast<double>(1 + below(scene.random(), 2));
      scene.add({8 - distance, y, z}, {speed, 0, 0});
      scene.add({8 + distance, y, z}, {-speed, 0, 0});
    }
  }
  // One that meets nothing but walls, when the pairs do.
  scene.add({8, 8, 12}, {1, 0, 0});
  return scene.world(Boundary::wall);
}

// Spheres that touch from the start, three and more at once, up to whole layers.
World three_spheres_and_more(std::uint64_t seed) {
  Scene scene(seed);
  Random& random = scene.random();
  for (double x = 4; x < 8; x += 1) {
    for (double y = 4; y < 8; y += 1) {
      for (double z = 4; z < 6; z += 1) {
        if (random.uniform() < 0.3) continue;
        Vec3 velocity;
        if (random.uniform() < 0.7) velocity[below(random, kAxes)] = random.uniform() < 0.5 ? -1 : 1;
        scene.add({x, y, z}, velocity);
      }
    }
  }
  return scene.world(closed_if(seed % 2 == 0));
}

struct TieCase {
  World (*make)(std::uint64_t seed);
  std::uint64_t worlds;
  RunLimits limits;
  std::uint64_t ties;  // at least, in each world on average
};

class Ties : public testing::TestWithParam<TieCase> {};

TEST_P(Ties, AreBrokenInOneWay) {
  const auto& [make, worlds, limits, least] = GetParam();
  std::uint64_t ties = 0;
  for (std::uint64_t seed = 0; seed < cases(worlds); ++seed) {
    SCOPED_TRACE(seed);
    ties += ties_in_one_history(make(seed), limits);
    if (HasFailure()) return;
  }
  EXPECT_GT(ties, least * cases(worlds));
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, Ties,
    testing::Values(TieCase{newtons_cradles_side_by_side, 60, {.until = Time(40), .contacts = 400}, 50},
                    TieCase{rows_that_cross, 60, {.until = Time(20), .contacts = 200}, 5},
                    TieCase{mirrored_pairs_and_walls, 60, {.until = Time(64), .contacts = 400}, 50},
                    TieCase{three_spheres_and_more, 100, {.until = Time(30), .contacts = 300}, 20}));

}  // namespace
}  // namespace hardball::engines_agree_test
