// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// What must not change a history, to the last bit: the ids of the spheres, queries in between, how a run is
// divided, copying, scaling of units by powers of two; and the same with edits between runs.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <type_traits>
#include <variant>

#include "support/effort.hpp"
#include "support/history.hpp"
#include "support/random_world.hpp"

namespace hardball::metamorphic_test {
namespace {

using namespace support;

constexpr std::uint64_t kWorlds = 1500;
constexpr std::uint64_t kContacts = 150;

EngineOptions some_options(std::uint64_t seed, const RandomWorld& made) {
  constexpr std::array<EngineKind, 5> kEngines = {EngineKind::cells, EngineKind::neighbors,
                                                  EngineKind::all_pairs, EngineKind::neighbors,
                                                  EngineKind::paper};
  EngineOptions options;
  options.engine = kEngines[seed % kEngines.size()];
  if (options.engine == EngineKind::neighbors &&
      (made.world.size() == 0 || !NeighborList::supports(made.world))) {
    options.engine = EngineKind::cells;
  }
  if (options.engine == EngineKind::paper && !goes_with(Feature::paper, made.world.features())) {
    options.engine = EngineKind::all_pairs;
  }
  return options;
}

// Of three worlds one has gravity, walls and obstacles, and one has spheres that respond in various ways.
// Some are flat.
RandomWorld some_world(std::uint64_t seed) {
  switch (seed / 5 % 3) {
    case 0:
      return seed % 2 == 0 ? make_flat_world(seed) : make_random_world(seed);
    case 1:
      return make_furnished_world(seed);
    default:
      return seed % 4 == 0 ? make_responsive_flat_world(seed) : make_responsive_world(seed);
  }
}

bool has_merging(const RandomWorld& made) {
  return made.world.interactions().table().has_merging();
}

Rule scaled(const Rule& rule, double length, double speed) {
  if (!std::holds_alternative<Bounce>(rule)) return rule;
  BounceRules rules = std::get<Bounce>(rule).rules();
  rules.elastic_below *= speed;
  rules.contact_duration *= length / speed;
  if (const auto* law = std::get_if<ViscoelasticRestitution>(&rules.restitution)) {
    rules.restitution = law->scaled(speed);
  } else if (const auto* table = std::get_if<TabulatedRestitution>(&rules.restitution)) {
    rules.restitution = table->scaled(speed);
  }
  return Bounce(rules);
}

ResponseTable scaled(const ResponseTable& responses, double length, double speed) {
  ResponseTable table;
  for (SpeciesId a = 0; a < kMaxRandomSpecies; ++a) {
    table.set_wall(a, std::get<Bounce>(scaled(Rule(responses.wall(a)), length, speed)));
    for (SpeciesId b = a; b < kMaxRandomSpecies; ++b) {
      table.set(a, b, scaled(responses.rule(a, b), length, speed));
    }
  }
  return table;
}

// The random numbers of thermal walls depend on ids and on the bits of times.
bool has_thermal_walls(const World& world) {
  for (Face face = 0; face < kFaces; ++face) {
    if (world.box().face(face).material.temperature) return true;
  }
  return std::ranges::any_of(
      world.surfaces(), [](const Surface& surface) { return surface.material().temperature.has_value(); });
}

Box scaled(const Box& box, double length, double speed) {
  Box made({box.boundary(0), box.boundary(1), box.boundary(2)}, length * box.size());
  for (Face face = 0; face < kFaces; ++face) {
    if (!box.has_own_properties(face)) continue;
    made.set_face(face, {box.face(face).material, speed * box.face(face).velocity});
  }
  return made;
}

Surface scaled(const Surface& surface, double length, double speed) {
  const Shape shape = std::visit(
      [&](const auto& old) -> Shape {
        using Old = std::remove_cvref_t<decltype(old)>;
        if constexpr (std::is_same_v<Old, OscillatingPlane>) {
          return OscillatingPlane(old.normal(), length * old.amplitude(), speed / length * old.frequency());
        }
        if constexpr (std::is_same_v<Old, Cylinder>) return Cylinder(old.axis(), length * old.radius());
        if constexpr (std::is_same_v<Old, Pillar>) return Pillar(old.axis(), length * old.radius());
        if constexpr (std::is_same_v<Old, HollowSphere>) return HollowSphere(length * old.radius());
        if constexpr (std::is_same_v<Old, MeshShape>) {
          MeshParts parts{{}, {old.mesh().triangles().begin(), old.mesh().triangles().end()}, {}, {}};
          for (const Vec3& vertex : old.mesh().vertices()) parts.vertices.push_back(length * vertex);
          return MeshShape(std::make_shared<const Mesh>(std::move(parts)), old.spheres(),
                           length * old.thickness());
        }
        if constexpr (std::is_same_v<Old, Obstacle>) return Obstacle(length * old.radius());
        return surface.shape();
      },
      surface.shape());
  return {shape, length * surface.point(), speed * surface.velocity(), surface.material()};
}

std::size_t below(Random& random, std::size_t count) {
  return static_cast<std::size_t>(random.uniform() * static_cast<double>(count));
}

Sphere sphere_of(const World& world, Slot slot) {
  return {.position = world.path(slot).position,
          .velocity = world.path(slot).velocity,
          .radius = world.base_radius(slot),
          .mass = world.mass(slot),
          .spin = world.spin(slot),
          .species = world.species(slot),
          .inertia_factor = world.inertia_factor(slot)};
}

bool has_simultaneous_contacts(const std::vector<Contact>& log) {
  for (std::size_t i = 1; i < log.size(); ++i) {
    if (log[i].time == log[i - 1].time) return true;
  }
  return false;
}

TEST(Renaming, ChangesNothingButNames) {
  std::uint64_t compared = 0;
  for (std::uint64_t seed = 0; seed < cases(kWorlds); ++seed) {
    const RandomWorld made = some_world(seed);
    SCOPED_TRACE(made.name);
    Random random(seed + 1);
    const std::size_t size = made.world.size();
    std::vector<Slot> old_name(size);  // by new name
    std::iota(old_name.begin(), old_name.end(), Slot{0});
    for (std::size_t i = size; i > 1; --i) std::swap(old_name[i - 1], old_name[below(random, i)]);
    // Spheres that merge keep the lower id.
    if (has_thermal_walls(made.world) || has_merging(made)) continue;
    World renamed(made.world.box(), made.world.motion().gravity(),
                  {made.world.surfaces().begin(), made.world.surfaces().end()});
    for (const Slot slot : old_name) renamed.add(sphere_of(made.world, slot));
    renamed.set_interactions(made.world.interactions());

    const RunLimits limits{.until = Time(made.until), .contacts = kContacts};
    Simulation original(made.world, some_options(seed, made));
    Simulation other(renamed, some_options(seed, made));
    const std::vector<Contact> log = record(original, limits);
    const std::vector<Contact> other_log = record(other, limits);
    // Ids decide the order of simultaneous contacts.
    if (has_simultaneous_contacts(log) || has_simultaneous_contacts(other_log)) continue;
    ++compared;
    ASSERT_EQ(log.size(), other_log.size());
    for (std::size_t i = 0; i < log.size(); ++i) {
      ASSERT_EQ(log[i].time, other_log[i].time) << "contact " << i;
      ASSERT_EQ(log[i].kind, other_log[i].kind) << "contact " << i;
      const Slot first = old_name[other_log[i].first];
      const std::uint32_t second =
          log[i].is_collision() ? old_name[other_log[i].second] : other_log[i].second;
      const bool swapped = log[i].is_collision() && first > second;
      ASSERT_EQ(log[i].first, swapped ? second : first) << "contact " << i;
      ASSERT_EQ(log[i].second, swapped ? first : second) << "contact " << i;
      const Velocities& after = other_log[i].after;
      ASSERT_EQ(log[i].after.first, swapped ? after.second : after.first) << "contact " << i;
    }
  }
  EXPECT_GT(compared, cases(kWorlds) / 2);
}

// Runs to the limits by detours: in pieces of time, contacts and steps, with queries and copies in between.
History run_by_detours(Simulation simulation, double until, std::uint64_t contacts, Random& random) {
  History history;
  for (;;) {
    const std::uint64_t left = contacts - simulation.counters().contacts();
    const double time = simulation.time();
    RunLimits piece{.until = Time(until), .contacts = left};
    switch (below(random, 6)) {
      case 0:
        piece.until = Time(std::min(until, time + random.uniform() * 0.1 * until));
        break;
      case 1:
        piece.contacts = std::min<std::uint64_t>(left, 1 + below(random, 20));
        break;
      case 2:
        piece.steps = below(random, 30);
        break;
      case 3:
        simulation.next_contact(time + random.uniform() * (until - time));
        break;
      case 4: {
        Simulation copy(simulation);
        run_on(copy, {.until = Time(until), .contacts = std::min<std::uint64_t>(left, 5)});
        Simulation another(simulation);
        simulation = std::move(another);
        break;
      }
      default: {
        const std::optional<NextContact> next = simulation.next_contact(until);
        const double soon = next ? std::max(time, next->time) : until;
        EXPECT_EQ(simulation.positions_at(time + 0.5 * (soon - time)).size(), simulation.size());
        simulation.positions();
        break;
      }
    }
    history = run_on(simulation, piece);
    if (!history.failure.empty() || history.contacts == contacts || history.time >= until) return history;
  }
}

TEST(Detours, ChangeNothing) {
  for (std::uint64_t seed = 0; seed < cases(kWorlds); ++seed) {
    const RandomWorld made = some_world(seed);
    SCOPED_TRACE(made.name);
    const Simulation start(made.world, some_options(seed, made));
    Simulation straight(start);
    const History expected = run_on(straight, {.until = Time(made.until), .contacts = kContacts});
    Random random(seed);
    const History history = run_by_detours(start, made.until, kContacts, random);
    ASSERT_EQ(difference(expected, history), "");
  }
}

TEST(Copies, ContinueAlikeAndIndependently) {
  for (std::uint64_t seed = 0; seed < cases(kWorlds) / 3; ++seed) {
    const RandomWorld made = some_world(seed);
    SCOPED_TRACE(made.name);
    Simulation original(made.world, some_options(seed, made));
    if (!run_on(original, {.until = Time(made.until), .contacts = 40}).failure.empty()) continue;
    Simulation copy(original);
    Simulation assigned{World()};
    assigned = original;
    const RunLimits rest{.until = Time(2 * made.until), .contacts = 80};
    const History expected = run_on(original, rest);
    ASSERT_EQ(difference(expected, run_on(copy, rest)), "");
    ASSERT_EQ(difference(expected, run_on(assigned, rest)), "");
  }
}

// Scaling length, time and mass by powers of two changes only exponents.
TEST(Units, ThatArePowersOfTwoChangeOnlyExponents) {
  for (std::uint64_t seed = 0; seed < cases(kWorlds) / 3; ++seed) {
    const RandomWorld made = some_world(seed);
    SCOPED_TRACE(made.name);
    const double length = 0x1p9;
    const double speed = 0x1p-14;
    const double mass = 0x1p5;
    if (has_thermal_walls(made.world)) continue;
    std::vector<Surface> surfaces;
    for (const Surface& surface : made.world.surfaces()) surfaces.push_back(scaled(surface, length, speed));
    World changed(scaled(made.world.box(), length, speed),
                  speed * speed / length * made.world.motion().gravity(), surfaces);
    for (Slot slot = 0; slot < made.world.size(); ++slot) {
      Sphere sphere = sphere_of(made.world, slot);
      sphere.position = length * sphere.position;
      sphere.velocity = speed * sphere.velocity;
      sphere.radius *= length;
      sphere.mass *= mass;
      sphere.spin = (speed / length) * sphere.spin;
      changed.add(sphere);
    }
    changed.set_interactions(scaled(made.world.interactions().table(), length, speed));
    Simulation original(made.world, some_options(seed, made));
    Simulation other(changed, some_options(seed, made));
    const std::vector<Contact> log = record(original, {.until = Time(made.until), .contacts = kContacts});
    const std::vector<Contact> other_log =
        record(other, {.until = Time(made.until * (length / speed)), .contacts = kContacts});
    ASSERT_EQ(log.size(), other_log.size());
    for (std::size_t i = 0; i < log.size(); ++i) {
      ASSERT_EQ(log[i].first, other_log[i].first) << "contact " << i;
      ASSERT_EQ(log[i].second, other_log[i].second) << "contact " << i;
      ASSERT_EQ(log[i].time.high * (length / speed), other_log[i].time.high) << "contact " << i;
      ASSERT_EQ(log[i].time.low * (length / speed), other_log[i].time.low) << "contact " << i;
      ASSERT_EQ(speed * log[i].after.first, other_log[i].after.first) << "contact " << i;
      ASSERT_EQ((speed / length) * log[i].spins_after.first, other_log[i].spins_after.first)
          << "contact " << i;
    }
  }
}

Vec3 random_velocity(const World& world, double until, Random& random) {
  double energy = 0;
  for (const Path& path : world.paths()) energy += dot(path.velocity, path.velocity);
  const double speed = energy > 0 ? std::sqrt(energy / static_cast<double>(world.size()))
                                  : 50 * world.largest_radius() / until;
  return speed * (world.box().is_flat() ? random.direction_in_plane() : random.direction());
}

// Runs in pieces, with an edit after each; `ask` interleaves queries, which advance the engine beyond the
// current time.
History run_with_edits(Simulation& simulation, const RandomWorld& made, std::uint64_t seed, bool ask) {
  Random random(seed);
  Random questions(seed + 1);
  History history;
  constexpr int kPieces = 8;
  for (int piece = 0; piece < kPieces; ++piece) {
    const double until = made.until * (piece + 1) / kPieces;
    if (ask) simulation.next_contact(simulation.time() + questions.uniform() * made.until);
    // Pieces end with a contact or between contacts.
    history = run_on(simulation, {.until = Time(until), .contacts = 20});
    if (!history.failure.empty()) return history;
    if (ask) simulation.next_contact(simulation.time() + questions.uniform() * made.until);
    const int edits = 1 + static_cast<int>(below(random, 2));
    for (int edit = 0; edit < edits; ++edit) {
      const double kind = random.uniform();
      const Vec3 velocity = random_velocity(simulation.world(), made.until, random);
      const std::size_t chosen = below(random, simulation.size());
      if (kind < 0.6 && simulation.size() > 0) {
        simulation.change_velocity(simulation.world().id(static_cast<Slot>(chosen)), velocity);
      } else if (kind < 0.75 && simulation.size() > 0) {
        simulation.remove(simulation.world().id(static_cast<Slot>(chosen)));
      } else if (simulation.size() > 0) {
        // A sphere a fifth as large, if it fits there.
        const double radius = simulation.world().largest_radius() / 5;
        Vec3 place;
        for (std::size_t axis = 0; axis < kAxes; ++axis) {
          const Box& box = simulation.world().box();
          place[axis] = random.uniform() * (box.is_open(axis) ? 20 * radius : box.size()[axis]);
        }
        try {
          simulation.add({place, velocity, radius, 1});
        } catch (const Error&) {  // it does not fit
        }
      }
    }
  }
  return history;
}

TEST(Edits, AreTheSameForAllEnginesWithAndWithoutQueries) {
  for (std::uint64_t seed = 0; seed < cases(kWorlds) / 5; ++seed) {
    const RandomWorld made = some_world(seed);
    SCOPED_TRACE(made.name);
    std::optional<History> expected;
    for (const bool ask : {false, true}) {
      for (std::uint64_t engine = 0; engine < 10; ++engine) {
        SCOPED_TRACE("engine " + to_text(engine) + (ask ? ", asked" : ""));
        Simulation simulation(made.world, some_options(engine, made));
        const History history = run_with_edits(simulation, made, seed, ask);
        if (!expected) expected = history;
        ASSERT_EQ(difference(*expected, history), "");
        if (history.failure.empty()) {
          simulation.run({.until = simulation.now(), .steps = 0});
          simulation.validate();
        }
      }
    }
  }
}

// The engine's cells are rebuilt while a burst expands in open space.
TEST(Retuning, OfABurstKeepsTheHistory) {
  const std::uint64_t spheres = kIsSlowBuild ? 60 : 200;
  const double side = std::cbrt(static_cast<double>(spheres));
  World world;
  Random random(11);
  for (std::uint64_t i = 0; world.size() < spheres; ++i) {
    const auto along = static_cast<std::uint64_t>(side) + 1;
    const Vec3 place{static_cast<double>(i % along), static_cast<double>(i / along % along),
                     static_cast<double>(i / along / along)};
    world.add({place, {random.normal(), random.normal(), random.normal()}, 0.45, 1});
  }
  EngineOptions plain;
  plain.engine = EngineKind::all_pairs;
  Simulation oracle(world, plain);
  const History expected = run_on(oracle, {.until = Time(100)});
  Simulation tuned(world);
  const double edge_at_first = tuned.cell_edge();
  const History history = run_on(tuned, {.until = Time(100)});
  EXPECT_GT(tuned.cell_edge(), 2 * edge_at_first);
  EXPECT_GT(history.contacts, spheres);
  EXPECT_EQ(difference(expected, history), "");
}

}  // namespace
}  // namespace hardball::metamorphic_test
