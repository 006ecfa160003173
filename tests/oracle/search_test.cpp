// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Queries in the cells of engines against those that look at all spheres: the answers are the same bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "hardball/broadphase/neighbor_list.hpp"
#include "hardball/broadphase/sheared_cells.hpp"
#include "hardball/domains/domains_engine.hpp"
#include "hardball/engine/engine.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/queries/moving_spheres.hpp"
#include "hardball/queries/queries.hpp"
#include "hardball/simulation/simulation.hpp"
#include "support/effort.hpp"
#include "support/random_world.hpp"
#include "support/run_engine.hpp"
#include "support/sheared.hpp"

namespace hardball::search_test {
namespace {

using support::RandomWorld;

constexpr std::uint64_t kWorlds = 1000;
constexpr int kQueriesPerWorld = 100;

// Few large spheres among small ones, which touch nothing at the start.
RandomWorld make_mixture(std::uint64_t seed) {
  Random random(seed);
  RandomWorld made{.world = World(seed % 2 == 0 ? Box::periodic({20, 20, 20}) : Box::walls({20, 20, 20})),
                   .name = "mixture " + std::to_string(seed)};
  std::vector<Sphere> spheres;
  while (spheres.size() < 150) {
    const double radius = spheres.size() < 3 ? 2 + random.uniform() : 0.15;
    const auto coordinate = [&] { return radius + (20 - 2 * radius) * random.uniform(); };
    Sphere sphere{.position = {coordinate(), coordinate(), coordinate()},
                  .velocity = random.direction(),
                  .radius = radius,
                  .mass = radius * radius * radius};
    const bool is_free = std::ranges::all_of(spheres, [&](const Sphere& other) {
      return length(other.position - sphere.position) > other.radius + radius;
    });
    if (is_free) spheres.push_back(sphere);
  }
  for (const Sphere& sphere : spheres) made.world.add(sphere);
  return made;
}

RandomWorld make_gas(std::uint64_t seed) {
  constexpr std::array kBoundaries{Boundary::periodic, Boundary::wall, Boundary::open};
  Random random(seed);
  const auto any = [&] { return kBoundaries.at(static_cast<std::size_t>(3 * random.uniform())); };
  return support::make_random_gas(seed, {any(), any(), any()}, 200);
}

RandomWorld world_of(std::uint64_t seed) {
  switch (seed % 8) {
    case 0:
      return support::make_sheared_world(seed);
    case 1:
      return support::make_growing_world(seed);
    case 2:
      return make_mixture(seed);
    case 3:
      return make_gas(seed);
    default:
      return support::any_world(seed);
  }
}

// Settings for an engine with cells.
PhaseSettings settings_for(const World& world, Random& random) {
  // Sometimes large spheres are much larger than cells.
  double radius = world.largest_bounding_radius();
  if (random.uniform() < 0.5) radius = world.bounding_radius(static_cast<Slot>(world.size() - 1));
  if (random.uniform() < 0.4 && NeighborList::supports(world))
    return {PhaseKind::neighbors, radius * (0.02 + random.uniform())};
  if (world.box().is_sheared() && !ShearedCells::supports(world, radius)) return {PhaseKind::all_pairs, 1};
  return {PhaseKind::cells, radius * (0.5 + 4 * random.uniform())};
}

// What two searches answer, as text: numbers by their bits.
std::string text(double number) {
  return std::to_string(std::bit_cast<std::uint64_t>(number)) + " ";
}
std::string text(const Vec3& vector) {
  return text(vector.x) + text(vector.y) + text(vector.z);
}
std::string text(const RayHit& hit) {
  return text(hit.distance) + std::to_string(static_cast<int>(hit.kind)) + " " + std::to_string(hit.body) +
         " " + text(hit.point) + text(hit.normal);
}
std::string text(const Clearance& nearest) {
  return text(nearest.distance) + std::to_string(static_cast<int>(nearest.kind)) + " " +
         std::to_string(nearest.body);
}
std::string text(const NextContact& contact) {
  return text(contact.time) + std::to_string(static_cast<int>(contact.kind)) + " " +
         std::to_string(contact.first) + " " + std::to_string(contact.second);
}
std::string text(SphereId id) {
  return std::to_string(id) + " ";
}
template <class Value>
std::string text(const std::optional<Value>& value) {
  return value ? text(*value) : "none";
}
template <class Value>
std::string text(const std::vector<Value>& values) {
  std::string all = std::to_string(values.size()) + ": ";
  for (const Value& value : values) all += text(value) + ", ";
  return all;
}

// A question, drawn from `random`, and what a search answers to it.
std::string answer(const SphereSearch& search, const Time& now, double duration, Random random) {
  const World& world = search.world();
  const double length_unit = world.largest_bounding_radius();
  const auto any_slot = [&] {
    return static_cast<Slot>(random.uniform() * static_cast<double>(world.size()));
  };
  const Slot slot = any_slot();
  const Slot neighbor = random.uniform() < 0.3 ? 0 : slot;
  const Vec3 near = world.position(neighbor, now) + (4 * length_unit * random.uniform()) * random.direction();
  BodyFilter filter;
  if (random.uniform() < 0.2)
    filter.spheres = [](const World& its, Slot its_slot) { return its.id(its_slot) % 3 != 0; };
  filter.walls = random.uniform() < 0.8;
  const double most = length_unit * (random.uniform() < 0.5 ? 10 : 100) * random.uniform();
  const int kind = static_cast<int>(8 * random.uniform());
  try {
    switch (kind) {
      case 0:
        return "ray " + text(ray(search, now, near, random.direction(), most, filter));
      case 1:
        return "hits " + text(ray_hits(search, now, near, random.direction(), most, filter));
      case 2:
        return "clearance " + text(clearance(search, now, near, filter));
      case 3:
        return "clearance of " + text(clearance(search, now, world.id(slot), filter));
      case 4:
        return "ball " + text(overlap(search, now, near, 3 * length_unit * random.uniform(), filter));
      case 5: {
        const double half = 3 * length_unit;
        const Vec3 size = half * Vec3{random.uniform(), random.uniform(), random.uniform()};
        Extent extent{near - size, near + size};
        if (world.box().is_flat()) extent.low.z = extent.high.z = 0;
        return "box " + text(overlap(search, now, extent, filter));
      }
      default: {
        const Vec3 velocity =
            world.velocity(any_slot(), now) + (0.1 * random.uniform()) * world.velocity(slot, now);
        const Time until = after(now, duration * random.uniform());
        if (kind == 6) return "contact " + text(first_contact(search, now, world.id(slot), velocity, until));
        Sphere sphere{.position = near, .velocity = velocity, .radius = 0.5 * length_unit};
        if (world.box().is_flat()) sphere.position.z = 0;
        return "contact of another " + text(first_contact(search, now, sphere, until));
      }
    }
  } catch (const Error& error) {
    return "error " + error.problem();
  }
}

bool is_found(const std::string& answer) {
  return answer.find("none") == std::string::npos && answer.find("error") == std::string::npos &&
         answer.find(" 0: ") == std::string::npos;
}

TEST(Search, CellsAnswerAsAScanDoes) {
  std::uint64_t found = 0;
  std::uint64_t worlds = 0;
  LazyMovingSpheres moving;
  for (std::uint64_t seed = 0; seed < support::cases(kWorlds); ++seed) {
    const RandomWorld made = world_of(seed);
    if (made.world.size() == 0) continue;
    Random random(seed + 1);
    std::optional<Engine<CalendarQueue>> engine;
    try {
      engine.emplace(made.world, settings_for(made.world, random), Time(0));
    } catch (const Error&) {
      continue;  // such cells would be too small
    }
    SCOPED_TRACE(made.name + ", " + std::to_string(seed));
    try {
      const double until = made.until * random.uniform();
      support::run(*engine, {.until = Time(until), .contacts = 100}, [](const Contact&) {});
    } catch (const RunFailure&) {
      // It has collapsed, which is as good a state as any.
    }
    const World& world = engine->world();
    const Time now = engine->now();
    std::vector<SphereSearch::Part> parts = engine->search_parts(now);
    if (engine->needs_rebuild()) continue;
    ASSERT_EQ(parts.size(), 1U);
    if (!parts.front().phase->search_cells()) continue;
    if (seed % 4 != 0) parts.front().cell_cost = 0.02;
    moving.reset();
    const SphereSearch cells(world, parts, moving);
    const double duration = made.until * random.uniform();
    for (int i = 0; i < kQueriesPerWorld; ++i) {
      const Random question(1000 * seed + static_cast<std::uint64_t>(i));
      const std::string expected = answer(world, now, duration, question);
      ASSERT_EQ(answer(cells, now, duration, question), expected);
      found += is_found(expected) ? 1U : 0U;
    }
    ++worlds;
  }
  EXPECT_GT(worlds, support::cases(kWorlds) * 3 / 4);
  EXPECT_GT(found, worlds * kQueriesPerWorld / 2);
}

TEST(Search, DomainsAnswerAsAScanDoes) {
  std::uint64_t found = 0;
  for (std::uint64_t seed = 0; seed < support::cases(40); ++seed) {
    const Boundary boundary = seed % 2 == 0 ? Boundary::periodic : Boundary::wall;
    const RandomWorld made = support::make_random_gas(seed, {boundary, boundary, boundary}, 2000);
    SCOPED_TRACE(made.name);
    Random random(seed);
    DomainsEngine engine(made.world, settings_for(made.world, random), {.domains = 2 + seed % 3}, Time(0));
    support::run(engine, {.until = Time(made.until * random.uniform()), .contacts = 2000},
                 [](const Contact&) {});
    const Time now = engine.now();
    std::vector<SphereSearch::Part> parts = engine.search_parts(now);
    ASSERT_GT(parts.size(), 1U);
    const LazyMovingSpheres moving;
    const SphereSearch cells(engine.world(), parts, moving);
    for (int i = 0; i < kQueriesPerWorld; ++i) {
      const Random question(1000 * seed + static_cast<std::uint64_t>(i));
      const std::string expected = answer(engine.world(), now, made.until, question);
      ASSERT_EQ(answer(cells, now, made.until, question), expected);
      found += is_found(expected) ? 1U : 0U;
    }
  }
  EXPECT_GT(found, support::cases(40) * kQueriesPerWorld / 2);
}

// A body at rest, where a sphere that flies straight to it arrives at the last moment: none is at the very
// edge of what is looked at by chance.
TEST(Search, MovingSpheresIncludeWhatArrivesAtTheLastMoment) {
  constexpr double kEdge = 40;
  constexpr double kRadius = 0.1;
  for (const Boundary boundary : {Boundary::periodic, Boundary::wall}) {
    Random random(7);
    World world(Box({boundary, boundary, boundary}, {kEdge, kEdge, kEdge}));
    const auto coordinate = [&] { return 1 + (kEdge - 2) * random.uniform(); };
    for (int i = 0; i < 20000; ++i) {
      const double speed = 0.25 * (1 + i % 8);
      world.add({.position = {coordinate(), coordinate(), coordinate()},
                 .velocity = speed * random.direction(),
                 .radius = kRadius});
    }
    MovingSpheres moving;
    moving.sort(world, Time(0));
    for (int i = 0; i < 5000; ++i) {
      const auto slot = static_cast<Slot>(random.uniform() * static_cast<double>(world.size()));
      const double end = 10 * random.uniform();
      const double radius = 2 * random.uniform();
      const Vec3 velocity = world.velocity(slot, Time(0));
      const double way = 0.999 * end * length(velocity) + kRadius + radius;
      State body{world.position(slot, Time(0)) + (way / length(velocity)) * velocity, {}};
      world.box().fold(body.position);
      bool is_found = false;
      moving.for_each_near(body, radius, 0, end, [&](Slot near) { is_found = is_found || near == slot; });
      ASSERT_TRUE(is_found) << i;
    }
  }
}

}  // namespace
}  // namespace hardball::search_test
