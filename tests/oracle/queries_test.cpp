// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Queries against slow twins that look at every image of every sphere, and against what the engine does next.
#include "hardball/queries/queries.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/world/images.hpp"
#include "hardball/world/pair_event.hpp"
#include "hardball/world/walls.hpp"
#include "support/effort.hpp"
#include "support/random_world.hpp"
#include "support/sheared.hpp"
#include "support/walls_one_by_one.hpp"

namespace hardball::queries_test {
namespace {

using support::for_each_image;
using support::RandomWorld;

constexpr std::uint64_t kWorlds = 600;
constexpr int kQueriesPerWorld = 6;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

RandomWorld any_world(std::uint64_t seed) {
  if (seed % 3 == 0) return support::make_responsive_world(seed);
  return seed % 3 == 1 ? support::make_random_world(seed) : support::make_furnished_world(seed);
}

// A simulation of the world some contacts later.
Simulation some_time_later(const RandomWorld& made, Random& random) {
  Simulation simulation(made.world);
  try {
    simulation.run({.until = Time(made.until * random.uniform()), .contacts = 50});
  } catch (const RunFailure&) {
    // It has collapsed, which is as good a state as any.
  }
  return simulation;
}

double shortest_period(const Box& box) {
  double shortest = kInfinity;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (box.is_periodic(axis)) shortest = std::min(shortest, box.size()[axis]);
  }
  return shortest;
}

double fastest(const World& world, const Time& now) {
  double speed = 0;
  for (Slot slot = 0; slot < world.size(); ++slot) speed = std::max(speed, length(world.velocity(slot, now)));
  return speed;
}

// A velocity as fast as the spheres, or one of theirs, or none.
Vec3 some_velocity(const World& world, const Time& now, Random& random) {
  const double kind = random.uniform();
  if (kind < 0.1) return {};
  const auto slot = static_cast<Slot>(random.uniform() * static_cast<double>(world.size()));
  if (kind < 0.3) return world.velocity(slot, now);
  return 2 * random.uniform() * fastest(world, now) * random.direction();
}

// Within which nothing moves farther than a few boxes, so that the twin can look at all images; infinite in
// some cases where there are none.
double some_duration(const World& world, const Time& now, const Vec3& velocity, double until,
                     Random& random) {
  constexpr double kBoxes = 2.5;
  const double period = shortest_period(world.box());
  if (period == kInfinity && random.uniform() < 0.5) return kInfinity;
  const double speed = fastest(world, now) + length(velocity);
  const double gravity = length(world.motion().gravity());
  return std::min(until, time_to_pass(kBoxes * period, speed, gravity)) * random.uniform();
}

// The first contact of a sphere by its stored path.
std::optional<NextContact> slow_first_contact(const World& world, Slot slot, const Time& now, double until) {
  constexpr std::int32_t kBoxes = 7;
  Event first = support::wall_event_one_by_one(world, slot, now, kBoxes);
  for (Slot other = 0; other < world.size(); ++other) {
    if (other == slot) continue;
    for_each_image(world.box(), kBoxes, [&](const Image& image) {
      // Paths may lead far out of the box.
      const Image nearest =
          world.box().nearest_image(world.unfolded_position(slot, now) - world.unfolded_position(other, now));
      const Image seen = nearest + image;
      if (pass(world, slot, other) && are_passing(world, slot, other, seen)) return;
      const Event contact =
          make_collision(contact_time(world, slot, other, seen), world.id(slot), world.id(other), seen);
      if (contact < first) first = contact;
    });
  }
  if (!first.happens() || first.time.high > until) return std::nullopt;
  const SphereId id = world.id(slot);
  return NextContact{first.time.value(), first.kind, id, first.first == id ? first.second : first.first};
}

// Looks at worlds of so many spheres at least, in the middle of a run.
template <class Look>
void in_random_worlds(std::size_t least, Look&& look) {
  for (std::uint64_t seed = 0; seed < support::cases(kWorlds); ++seed) {
    const RandomWorld made = any_world(seed);
    if (made.world.size() < least) continue;
    SCOPED_TRACE(made.name);
    Random random(seed + 1);
    Simulation simulation = some_time_later(made, random);
    look(simulation, made.until, random);
    if (testing::Test::HasFatalFailure()) return;
  }
}

TEST(Queries, FirstContactsAreThoseOfAllImages) {
  std::uint64_t found = 0;
  std::uint64_t predicted = 0;
  in_random_worlds(1, [&](const Simulation& simulation, double duration, Random& random) {
    const World& world = simulation.world();
    for (int i = 0; i < kQueriesPerWorld; ++i) {
      const auto slot = static_cast<Slot>(random.uniform() * static_cast<double>(world.size()));
      const SphereId id = world.id(slot);
      const Vec3 velocity = some_velocity(world, simulation.now(), random);
      const double until =
          simulation.time() + some_duration(world, simulation.now(), velocity, duration, random);
      const std::optional<NextContact> contact = simulation.first_contact(id, velocity, until);
      World changed = world;
      changed.change_velocity(slot, simulation.now(), velocity);
      ASSERT_EQ(contact, slow_first_contact(changed, slot, simulation.now(), until));
      found += contact ? 1U : 0U;

      // What the engine does next is this, or something earlier.
      Simulation copy = simulation;
      copy.change_velocity(id, velocity);
      const std::optional<NextContact> next =
          copy.next_contact(std::min(until, simulation.time() + duration));
      if (!next) continue;
      const bool is_about_it =
          next->first == id || (next->kind == EventKind::collision && next->second == id);
      if (!is_about_it) {
        ASSERT_TRUE(!contact || next->time <= contact->time);
        continue;
      }
      ASSERT_TRUE(contact);
      ASSERT_EQ(contact->time, next->time);
      ASSERT_EQ(contact->kind, next->kind);
      ASSERT_EQ(contact->second, next->first == id ? next->second : next->first);
      ++predicted;
    }
  });
  EXPECT_GT(found, support::cases(kWorlds));
  EXPECT_GT(predicted, support::cases(kWorlds) / 10);
}

TEST(Queries, ASphereNotInTheWorldMeetsWhatOneInItsPlaceWould) {
  std::uint64_t found = 0;
  in_random_worlds(2, [&](Simulation& simulation, double duration, Random& random) {
    const World& world = simulation.world();
    const auto slot = static_cast<Slot>(random.uniform() * static_cast<double>(world.size()));
    const SphereId id = world.id(slot);
    const Vec3 velocity = some_velocity(world, simulation.now(), random);
    const double until =
        simulation.time() + some_duration(world, simulation.now(), velocity, duration, random);
    const Sphere sphere{.position = simulation.position(id),
                        .velocity = velocity,
                        .radius = world.base_radius(slot),
                        .mass = world.mass(slot),
                        .species = world.species(slot)};
    std::optional<NextContact> expected = simulation.first_contact(id, velocity, until);
    simulation.remove(id);
    // It may reach through a face by rounding, where it cannot be added.
    try {
      world.check(sphere);
    } catch (const Error&) {
      return;
    }
    const std::optional<NextContact> contact = simulation.first_contact(sphere, until);
    if (expected) expected->first = kNoSphere;
    ASSERT_EQ(contact, expected);
    found += contact ? 1U : 0U;
  });
  EXPECT_GT(found, support::cases(kWorlds) / 5);
}

// A ray or a point sees spheres, obstacles, and walls with simple equations.
struct SlowHit {
  long double distance = kInfinity;
  EventKind kind = EventKind::collision;
  std::uint32_t body = 0;
};

// The lesser root t of |a + t b| = r, or the greater one; infinity if there is none ahead.
long double root_ahead(const Vec3& a, const Vec3& b, long double r, bool greater) {
  const auto product = [](const Vec3& p, const Vec3& q) {
    return static_cast<long double>(p.x) * q.x + static_cast<long double>(p.y) * q.y +
           static_cast<long double>(p.z) * q.z;
  };
  const long double half = product(a, b) / product(b, b);
  const long double rest = (product(a, a) - r * r) / product(b, b);
  const long double square = half * half - rest;
  if (!(square >= 0)) return kInfinity;
  const long double root = -half + (greater ? 1 : -1) * std::sqrt(square);
  return root >= 0 ? root : kInfinity;
}

// Where a ray from inside a cone around the origin leaves it; infinity if it never does.
long double root_in_cone(const Vec3& from, const Vec3& direction, const Cone& cone) {
  const auto product = [&](const Vec3& p, const Vec3& q) {
    const long double square = static_cast<long double>(cone.slope()) * cone.slope();
    return square * dot(p, cone.axis()) * dot(q, cone.axis()) -
           dot(cross(p, cone.axis()), cross(q, cone.axis()));
  };
  const long double half = product(from, direction) / product(direction, direction);
  const long double rest = product(from, from) / product(direction, direction);
  const long double square = half * half - rest;
  if (!(square >= 0)) return kInfinity;
  for (const int sign : {-1, 1}) {
    const long double root = -half + sign * std::sqrt(square);
    const long double height = dot(from, cone.axis()) + root * dot(direction, cone.axis());
    if (root >= 0 && height >= 0) return root;
  }
  return kInfinity;
}

// How far it is along a ray to a mesh, in steps that cannot pass it; infinite if it is not met soon.
long double way_to_mesh(const Box& box, const Surface& mesh, const Vec3& origin, const Vec3& direction,
                        const Time& now) {
  const double scale = mesh.mesh()->mesh().largest_coordinate();
  double way = 0;
  for (int step = 0; step < 100'000 && way < 100 * scale; ++step) {
    const double distance = distance_to_surface(box, mesh, origin + way * direction, now);
    if (std::fabs(distance) < 1e-12 * scale) return way;
    way += std::fabs(distance);
  }
  return kInfinity;
}

// Hits a little earlier or later than the first are returned as well.
std::vector<SlowHit> slow_hits(const World& world, const Time& now, const Vec3& origin,
                               const Vec3& direction) {
  constexpr std::int32_t kBoxes = 5;
  std::vector<SlowHit> hits;
  const auto note = [&](long double distance, EventKind kind, std::uint32_t body) {
    if (distance < kInfinity) hits.push_back({distance, kind, body});
  };
  for (Slot slot = 0; slot < world.size(); ++slot) {
    const Vec3 center = world.position(slot, now);
    for_each_image(world.box(), kBoxes, [&](const Image& image) {
      const Vec3 from = origin - (center + world.box().shift(image));
      note(root_ahead(from, direction, world.base_radius(slot), false), EventKind::collision, world.id(slot));
    });
  }
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!world.box().is_wall(axis)) continue;
    for (const bool upper : {false, true}) {
      const double way = upper ? world.box().size()[axis] - origin[axis] : -origin[axis];
      const long double distance = static_cast<long double>(way) / direction[axis];
      if (upper ? direction[axis] > 0 : direction[axis] < 0) {
        note(std::max(distance, 0.0L), EventKind::wall, face_of(axis, upper));
      }
    }
  }
  std::uint32_t number = kFaces;
  for (const Surface& surface : world.surfaces()) {
    const Vec3 from = origin - (surface.point() + now.value() * surface.velocity());
    if (surface.mesh()) {
      note(way_to_mesh(world.box(), surface, origin, direction, now), EventKind::wall, number);
    } else if (const auto* obstacle = std::get_if<Obstacle>(&surface.shape())) {
      for_each_image(world.box(), kBoxes, [&](const Image& image) {
        note(root_ahead(from - world.box().shift(image), direction, obstacle->radius(), false),
             EventKind::wall, number);
      });
    } else if (const auto* hollow = std::get_if<HollowSphere>(&surface.shape())) {
      note(root_ahead(from, direction, hollow->radius(), true), EventKind::wall, number);
    } else if (const auto* tube = std::get_if<Cylinder>(&surface.shape())) {
      note(root_ahead(cross(from, tube->axis()), cross(direction, tube->axis()), tube->radius(), true),
           EventKind::wall, number);
    } else if (const auto* cone = std::get_if<Cone>(&surface.shape())) {
      note(root_in_cone(from, direction, *cone), EventKind::wall, number);
    } else {
      const Vec3 normal = std::visit(
          [](const auto& shape) {
            if constexpr (requires { shape.normal(); }) return shape.normal();
            return Vec3{};
          },
          surface.shape());
      if (dot(direction, normal) < 0) {
        note(surface.distance(origin, now) / -static_cast<long double>(dot(direction, normal)),
             EventKind::wall, number);
      }
    }
    ++number;
  }
  return hits;
}

double extent_of(const World& world, const Time& now) {
  double extent = 2 * world.largest_radius();
  for (Slot slot = 0; slot < world.size(); ++slot) {
    extent = std::max(extent, length(world.position(slot, now)));
  }
  return extent;
}

// A point among the spheres, but in none of them, nor beyond a wall.
std::optional<Vec3> some_free_point(const World& world, const Time& now, Random& random) {
  for (int attempt = 0; attempt < 20; ++attempt) {
    const auto slot = static_cast<Slot>(random.uniform() * static_cast<double>(world.size()));
    const double way = world.largest_radius() * (1 + 3 * random.uniform());
    const Vec3 point = world.position(slot, now) + way * random.direction();
    const std::optional<Clearance> room = clearance(world, now, point);
    if (room->distance > 1e-6 * way) return point;
  }
  return std::nullopt;
}

TEST(Queries, RaysHitWhatSimpleEquationsSay) {
  std::uint64_t spheres = 0;
  std::uint64_t walls = 0;
  in_random_worlds(1, [&](const Simulation& simulation, double, Random& random) {
    const World& world = simulation.world();
    const Time& now = simulation.now();
    const double extent = extent_of(world, now);
    for (int i = 0; i < kQueriesPerWorld; ++i) {
      const std::optional<Vec3> point = some_free_point(world, now, random);
      if (!point) break;
      const Vec3 direction = random.direction();
      const double most = std::min(3 * shortest_period(world.box()), 4 * extent);
      const std::vector<SlowHit> hits = slow_hits(world, now, *point, direction);
      // The lengths of directions differ by rounding; a grazing ray may differ more, but rarely.
      const double tolerance = 1e-9 * (extent + most);
      const std::optional<RayHit> hit = simulation.ray(*point, 3 * direction, most);
      long double nearest = kInfinity;
      for (const SlowHit& slow : hits) nearest = std::min(nearest, slow.distance);
      if (!hit) {
        ASSERT_GT(nearest, most - tolerance);
        continue;
      }
      ASSERT_LE(hit->distance, most);
      ASSERT_NEAR(hit->distance, static_cast<double>(nearest), tolerance);
      ASSERT_TRUE(std::ranges::any_of(hits, [&](const SlowHit& slow) {
        return slow.kind == hit->kind && slow.body == hit->body &&
               std::fabs(slow.distance - hit->distance) <= tolerance;
      }));
      ASSERT_NEAR(length(hit->normal), 1, 1e-12);
      ASSERT_LT(dot(hit->normal, direction), 1e-6);
      // The point lies on the body: a step out of it leads away from it.
      const Vec3 outside = hit->point + (1e-3 * world.largest_radius()) * hit->normal;
      const std::optional<Clearance> at = simulation.clearance(hit->point);
      const std::optional<Clearance> beyond = simulation.clearance(outside);
      ASSERT_NEAR(at->distance, 0, tolerance);
      if (beyond->kind == hit->kind && beyond->body == hit->body) {
        ASSERT_NEAR(beyond->distance, 1e-3 * world.largest_radius(), tolerance);
      }
      ++(hit->kind == EventKind::collision ? spheres : walls);
    }
  });
  EXPECT_GT(spheres, support::cases(kWorlds) / 2);
  EXPECT_GT(walls, support::cases(kWorlds) / 2);
}

// The nearest of all images.
double slow_clearance(const World& world, const Time& now, const Vec3& center, double radius, Slot self) {
  constexpr std::int32_t kBoxes = 2;
  double least = kInfinity;
  Vec3 place = center;
  world.box().fold(place);
  for (Slot slot = 0; slot < world.size(); ++slot) {
    if (slot == self) continue;
    for_each_image(world.box(), kBoxes, [&](const Image& image) {
      const Vec3 apart = (world.position(slot, now) + world.box().shift(image)) - place;
      least = std::min(least, length(apart) - radius - world.base_radius(slot));
    });
  }
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!world.box().is_wall(axis)) continue;
    least = std::min({least, place[axis] - radius, world.box().size()[axis] - place[axis] - radius});
  }
  for (const Surface& surface : world.surfaces()) {
    const bool has_images = std::holds_alternative<Obstacle>(surface.shape()) || surface.mesh() != nullptr;
    for_each_image(world.box(), has_images ? kBoxes : 0, [&](const Image& image) {
      least = std::min(least, surface.distance(place + world.box().shift(image), now) - radius);
    });
  }
  return least;
}

double distance_to(const World& world, const Time& now, const Vec3& center, double radius,
                   const Clearance& nearest) {
  World only(world.box());
  if (nearest.kind != EventKind::collision) return nearest.distance;
  const Slot slot = world.slot_of(nearest.body);
  only.add({world.position(slot, now), {}, world.base_radius(slot), 1});
  double least = kInfinity;
  for_each_image(world.box(), 2, [&](const Image& image) {
    Vec3 place = center;
    world.box().fold(place);
    const Vec3 apart = (only.position(0, Time(0)) + world.box().shift(image)) - place;
    least = std::min(least, length(apart) - radius - world.base_radius(slot));
  });
  return least;
}

TEST(Queries, ClearancesAreThoseOfTheNearestImage) {
  in_random_worlds(1, [&](const Simulation& simulation, double, Random& random) {
    const World& world = simulation.world();
    const Time& now = simulation.now();
    const double tolerance = 1e-9 * extent_of(world, now);
    for (int i = 0; i < kQueriesPerWorld; ++i) {
      const auto slot = static_cast<Slot>(random.uniform() * static_cast<double>(world.size()));
      const double way = 4 * world.largest_radius() * random.uniform();
      const Vec3 point = simulation.position(world.id(slot)) + way * random.direction();
      const std::optional<Clearance> room = simulation.clearance(point);
      ASSERT_TRUE(room);
      const auto none = static_cast<Slot>(world.size());
      ASSERT_NEAR(room->distance, slow_clearance(world, now, point, 0, none), tolerance);
      ASSERT_NEAR(room->distance, distance_to(world, now, point, 0, *room), tolerance);

      const std::optional<Clearance> gap = simulation.clearance(world.id(slot));
      const Vec3 center = world.position(slot, now);
      const double expected = slow_clearance(world, now, center, world.base_radius(slot), slot);
      ASSERT_EQ(gap.has_value(), expected < kInfinity);
      if (!gap) continue;
      ASSERT_NEAR(gap->distance, expected, tolerance);
      ASSERT_NEAR(gap->distance, distance_to(world, now, center, world.base_radius(slot), *gap), tolerance);
    }
  });
}

// The distance from the surface of the nearest image of a sphere, by trial of all images nearby.
double slow_clearance_in_flow(const World& world, const Time& now, const Vec3& center, double radius,
                              Slot self) {
  constexpr int kRows = 12;
  const Box& box = world.box();
  double least = kInfinity;
  for (Slot slot = 0; slot < world.size(); ++slot) {
    if (slot == self) continue;
    for (int row = -kRows; row <= kRows; ++row) {
      const Vec3 apart = world.position(slot, now) + box.shift({{0, row, 0}}, now) - center;
      const double x = std::remainder(apart.x, box.period().x);
      const double z = box.is_periodic(2) ? std::remainder(apart.z, box.period().z) : apart.z;
      least = std::min(least, std::hypot(x, apart.y, z) - radius - world.base_radius(slot));
    }
  }
  if (box.is_wall(2)) least = std::min({least, center.z - radius, box.size().z - center.z - radius});
  return least;
}

TEST(Queries, ClearancesKnowImagesThatSlide) {
  std::uint64_t asked = 0;
  for (std::uint64_t seed = 0; seed < support::cases(200); ++seed) {
    const RandomWorld made = support::make_sheared_world(seed);
    if (made.world.size() == 0) continue;
    SCOPED_TRACE(made.name);
    Simulation simulation(made.world);
    simulation.run({.until = Time(made.until), .contacts = 40});
    const World& world = simulation.world();
    const Time& now = simulation.now();
    const Box& box = world.box();
    const double radius = world.largest_radius();
    const double tolerance = 1e-9 * (box.size().x + box.size().y + radius);
    const auto none = static_cast<Slot>(world.size());
    for (Slot slot = 0; slot < std::min<Slot>(none, 10); ++slot, ++asked) {
      const Vec3 center = world.position(slot, now);
      const std::optional<Clearance> gap = simulation.clearance(world.id(slot));
      const double expected = slow_clearance_in_flow(world, now, center, world.base_radius(slot), slot);
      ASSERT_EQ(gap.has_value(), expected < kInfinity);
      if (gap) {
        ASSERT_NEAR(gap->distance, expected, tolerance);
      }
      const Vec3 beside = center + Vec3{0.7 * radius, 0.9 * radius, 0};
      const double room = slow_clearance_in_flow(world, now, beside, 0, none);
      // The same in another box.
      ASSERT_NEAR(simulation.clearance(beside + box.shift({{3, 2, 0}}, now))->distance, room, tolerance);
    }
  }
  EXPECT_GT(asked, 5 * support::cases(200));
}

// Two spheres in boxes so much longer than high that the nearest image may lie several rows away.
TEST(Queries, ClearancesKnowImagesInRowsFartherAway) {
  Random random(5);
  bool is_any_far = false;
  for (int i = 0; i < 300; ++i) {
    Box box = Box::periodic({12, 1.5, 6});
    box.set_shear({.rate = random.uniform(), .offset = 12 * random.uniform()});
    World world(box);
    world.add({.position = {12 * random.uniform(), 1.5 * random.uniform(), 1}, .radius = 0.1});
    world.add({.position = {12 * random.uniform(), 1.5 * random.uniform(), 2}, .radius = 0.2});
    const Time now(20 * random.uniform());
    const double gap = clearance(world, now, SphereId{0})->distance;
    ASSERT_NEAR(gap, slow_clearance_in_flow(world, now, world.position(0, now), 0.1, 0), 1e-9);
    is_any_far = is_any_far || gap > 1.5;
  }
  EXPECT_TRUE(is_any_far);
}

// All spheres are at rest, and as large as they are now.
TEST(Queries, RaysHitSpheresThatGrowWhereTheyAreNow) {
  World world(Box::open());
  world.add({.position = {4, 0, 0}, .radius = 1});
  world.set_growth({.begin = Time(0), .end = Time(10), .scale = 1, .rate = 0.1});
  EXPECT_DOUBLE_EQ(ray(world, Time(0), {}, {1, 0, 0}, 10)->distance, 3);
  EXPECT_DOUBLE_EQ(ray(world, Time(5), {}, {1, 0, 0}, 10)->distance, 2.5);
  EXPECT_FALSE(ray(world, Time(0), {0, 1.2, 0}, {1, 0, 0}, 10));
  EXPECT_TRUE(ray(world, Time(5), {0, 1.2, 0}, {1, 0, 0}, 10));
}

TEST(Queries, AllHitsOfARayAreThoseOfSimpleEquations) {
  std::uint64_t found = 0;
  in_random_worlds(1, [&](const Simulation& simulation, double, Random& random) {
    const World& world = simulation.world();
    const Time& now = simulation.now();
    const double extent = extent_of(world, now);
    const std::optional<Vec3> point = some_free_point(world, now, random);
    if (!point) return;
    const Vec3 direction = random.direction();
    const double most = std::min(3 * shortest_period(world.box()), 4 * extent);
    const std::vector<RayHit> hits = simulation.ray_hits(*point, direction, most);
    const std::optional<RayHit> first = simulation.ray(*point, direction, most);
    ASSERT_EQ(first.has_value(), !hits.empty());
    if (!first) return;
    ASSERT_EQ(first->distance, hits.front().distance);
    ASSERT_EQ(first->body, hits.front().body);
    ASSERT_TRUE(std::ranges::is_sorted(hits, {}, &RayHit::distance));
    const double tolerance = 1e-9 * (extent + most);
    const auto is_end = [&](EventKind kind, std::uint32_t body) {
      return kind == EventKind::wall &&
             (body < kFaces || !std::holds_alternative<Obstacle>(world.surface(body).shape()));
    };
    const std::vector<SlowHit> slow_ones = slow_hits(world, now, *point, direction);
    long double end = most;
    for (const SlowHit& slow : slow_ones)
      if (is_end(slow.kind, slow.body)) end = std::min(end, slow.distance);
    const auto are_same = [&](const SlowHit& slow, const RayHit& hit) {
      return slow.kind == hit.kind && slow.body == hit.body &&
             std::fabs(slow.distance - hit.distance) <= tolerance;
    };
    for (const RayHit& hit : hits) {
      ASSERT_LE(hit.distance, end + tolerance);
      ASSERT_TRUE(std::ranges::any_of(slow_ones, [&](const SlowHit& slow) { return are_same(slow, hit); }));
    }
    for (const SlowHit& slow : slow_ones) {
      if (slow.distance > end - tolerance) continue;
      ASSERT_TRUE(std::ranges::any_of(hits, [&](const RayHit& hit) { return are_same(slow, hit); }));
      ++found;
    }
  });
  EXPECT_GT(found, support::cases(kWorlds) / 8);
}

// How far the surface of a sphere is from a box, by trial of all images nearby.
double slow_distance_to_extent(const World& world, const Time& now, Slot slot, const Extent& extent) {
  double least = kInfinity;
  Vec3 place = world.position(slot, now);
  world.box().fold(place);
  for_each_image(world.box(), 3, [&](const Image& image) {
    Vec3 beyond = place + world.box().shift(image);
    for (std::size_t axis = 0; axis < kAxes; ++axis)
      beyond[axis] -= std::clamp(beyond[axis], extent.low[axis], extent.high[axis]);
    least = std::min(least, length(beyond) - world.base_radius(slot));
  });
  return least;
}

TEST(Queries, OverlapsAreThoseOfAllImages) {
  std::uint64_t found = 0;
  std::uint64_t missed = 0;
  in_random_worlds(1, [&](const Simulation& simulation, double, Random& random) {
    const World& world = simulation.world();
    const Time& now = simulation.now();
    const double tolerance = 1e-9 * extent_of(world, now);
    for (int i = 0; i < kQueriesPerWorld; ++i) {
      const auto middle = static_cast<Slot>(random.uniform() * static_cast<double>(world.size()));
      Vec3 center =
          world.position(middle, now) + (3 * world.largest_radius() * random.uniform()) * random.direction();
      world.box().fold(center);
      const double radius = 2 * world.largest_radius() * random.uniform();
      Vec3 half = world.largest_radius() * Vec3{random.uniform(), random.uniform(), random.uniform()};
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        if (world.box().is_periodic(axis)) half[axis] = std::min(half[axis], world.box().size()[axis] / 2);
      }
      const Extent extent{center - half, center + half};
      const std::vector<SphereId> in_ball = simulation.overlap(center, radius);
      const std::vector<SphereId> in_box = simulation.overlap(extent);
      ASSERT_TRUE(std::ranges::is_sorted(in_ball));
      for (Slot slot = 0; slot < world.size(); ++slot) {
        const double to_ball = slow_distance_to_extent(world, now, slot, {center, center}) - radius;
        const double to_box = slow_distance_to_extent(world, now, slot, extent);
        const auto has = [&](const std::vector<SphereId>& ids) {
          return std::ranges::binary_search(ids, world.id(slot));
        };
        if (std::fabs(to_ball) > tolerance) {
          ASSERT_EQ(has(in_ball), to_ball < 0);
        }
        if (std::fabs(to_box) > tolerance) {
          ASSERT_EQ(has(in_box), to_box < 0);
        }
        ++(to_box < 0 ? found : missed);
      }
    }
  });
  EXPECT_GT(found, support::cases(kWorlds));
  EXPECT_GT(missed, support::cases(kWorlds));
}

// Each kind of change that may outdate what queries know, and then queries.
TEST(Queries, FollowEveryChange) {
  for (std::uint64_t seed = 0; seed < support::cases(60); ++seed) {
    RandomWorld made = support::make_random_gas(
        seed,
        seed % 2 == 0 ? std::array{Boundary::periodic, Boundary::periodic, Boundary::periodic}
                      : std::array{Boundary::wall, Boundary::wall, Boundary::open},
        300);
    if (made.restitution < 1 || made.world.size() == 0) continue;  // so that nothing collapses
    Random random(seed);
    SCOPED_TRACE(made.name);
    EngineOptions options;
    options.engine = seed % 3 == 0 ? EngineKind::neighbors : EngineKind::cells;
    options.threads = seed % 5 == 0 ? 2 : 1;
    Simulation simulation(made.world, options);
    const double radius = made.world.largest_radius();
    const double speed = fastest(made.world, Time(0));
    for (int change = 0; change < 12; ++change) {
      const auto any_id = [&] {
        return simulation.world().id(
            static_cast<Slot>(random.uniform() * static_cast<double>(simulation.size())));
      };
      switch (static_cast<int>(6 * random.uniform())) {
        case 0:
          simulation.run_until(simulation.time() + 0.02 * made.until * random.uniform());
          break;
        case 1:
          simulation.change_velocity(any_id(), (3 * speed) * random.direction());
          break;
        case 2:
          if (simulation.size() > 2) simulation.remove(any_id());
          break;
        case 3:
          static_cast<void>(simulation.next_contact(simulation.time() + made.until));
          break;
        case 4:
          static_cast<void>(simulation.contacts_within(0.01 * made.until));
          break;
        default:
          simulation.run_contacts(3, simulation.time() + made.until);
      }
      for (int i = 0; i < 5; ++i) {
        const World& now_in = simulation.world();
        const SphereId id = any_id();
        const Vec3 velocity = speed * random.direction();
        const double until = simulation.time() + 0.1 * made.until;
        ASSERT_EQ(simulation.first_contact(id, velocity, until),
                  first_contact(now_in, simulation.now(), id, velocity, Time(until)));
        const Vec3 point = simulation.position(id) + (3 * radius) * random.direction();
        const double most = 20 * radius;
        const std::optional<RayHit> hit = simulation.ray(point, velocity, most);
        const std::optional<RayHit> expected = ray(now_in, simulation.now(), point, velocity, most);
        ASSERT_EQ(hit.has_value(), expected.has_value());
        if (hit) {
          ASSERT_EQ(hit->distance, expected->distance);
          ASSERT_EQ(hit->body, expected->body);
        }
        ASSERT_EQ(simulation.clearance(id)->distance, clearance(now_in, simulation.now(), id)->distance);
      }
    }
  }
}

TEST(Queries, OverlapsKnowImagesThatSlide) {
  std::uint64_t found = 0;
  for (std::uint64_t seed = 0; seed < support::cases(200); ++seed) {
    const RandomWorld made = support::make_sheared_world(seed);
    if (made.world.size() == 0) continue;
    SCOPED_TRACE(made.name);
    Simulation simulation(made.world);
    simulation.run({.until = Time(made.until), .contacts = 40});
    const World& world = simulation.world();
    const Time& now = simulation.now();
    const Box& box = world.box();
    Random random(seed);
    const double tolerance = 1e-9 * (box.size().x + box.size().y);
    const auto along = [&](std::size_t axis) { return box.is_flat() && axis == 2 ? 0 : random.uniform(); };
    const Slot any = static_cast<Slot>(random.uniform() * static_cast<double>(world.size()));
    const Vec3 center =
        world.position(any, now) + world.largest_radius() * Vec3{along(0), along(1), along(2)};
    Vec3 half = world.largest_radius() * Vec3{along(0), 2 * along(1), along(2)};
    for (std::size_t axis = 0; axis < kAxes; ++axis)
      half[axis] = std::min(half[axis], 0.5 * box.size()[axis]);
    const std::vector<SphereId> ids = simulation.overlap(Extent{center - half, center + half});
    for (Slot slot = 0; slot < world.size(); ++slot) {
      double least = kInfinity;
      for (int row = -12; row <= 12; ++row) {
        const Vec3 apart = world.position(slot, now) + box.shift({{0, row, 0}}, now) - center;
        const double x = std::remainder(apart.x, box.period().x);
        const double z = box.is_periodic(2) ? std::remainder(apart.z, box.period().z) : apart.z;
        const auto beyond = [](double distance, double end) {
          return std::max(0.0, std::fabs(distance) - end);
        };
        least = std::min(least, std::hypot(beyond(x, half.x), beyond(apart.y, half.y), beyond(z, half.z)));
      }
      const double gap = least - world.base_radius(slot);
      if (std::fabs(gap) < tolerance) continue;
      ASSERT_EQ(std::ranges::binary_search(ids, world.id(slot)), gap < 0);
      found += gap < 0 ? 1U : 0U;
    }
  }
  EXPECT_GT(found, support::cases(200) / 4);
}

// A thousand spheres at rest, and one more that is not, by its id.
struct Still {
  Simulation simulation;
  SphereId moving;
};
Still still_spheres(const Vec3& position, const Vec3& velocity) {
  World world(Box::walls({100, 100, 100}));
  for (int k = 0; k < 1000; ++k) {
    const auto place = [](int number) { return 10.0 * number + 5; };
    world.add({.position = {place(k % 10), place(k / 10 % 10), place(k / 100)}, .radius = 1});
  }
  const SphereId moving = world.add({.position = position, .velocity = velocity, .radius = 1});
  return {Simulation(std::move(world), {.engine = EngineKind::cells, .cell_edge = 5}), moving};
}

TEST(Queries, AFastSphereIsSeenFromAfar) {
  Still still = still_spheres({10, 10, 10}, {0, 0, 1000});
  // It flies between the others, and would hit this one from below, far from where it is.
  const Sphere sphere{.position = {10, 10, 90}, .radius = 1};
  // The first question of a moment is answered by a scan.
  static_cast<void>(still.simulation.first_contact(sphere, 1));
  const std::optional<NextContact> hit = still.simulation.first_contact(sphere, 1);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->second, still.moving);
  EXPECT_DOUBLE_EQ(hit->time, 78.0 / 1000);
}

TEST(Queries, AChangeOfVelocityIsSeenAtOnce) {
  Still still = still_spheres({10, 10, 10}, {});
  const Sphere sphere{.position = {10, 10, 90}, .radius = 1};
  for (int i = 0; i < 2; ++i) EXPECT_FALSE(still.simulation.first_contact(sphere, 1));
  still.simulation.change_velocity(still.moving, {0, 0, 1000});
  // The first question of a moment is answered by a scan.
  static_cast<void>(still.simulation.first_contact(sphere, 1));
  const std::optional<NextContact> hit = still.simulation.first_contact(sphere, 1);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->second, still.moving);
}

TEST(Queries, AreAboutNowWhenTheEngineHasLookedAhead) {
  Still still = still_spheres({10, 10, 10}, {0, 0, 10});
  ASSERT_EQ(still.simulation.next_contact(100)->kind, EventKind::wall);
  const std::optional<RayHit> hit = still.simulation.ray({10, 10, 2}, {0, 0, 1}, 100);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->kind, EventKind::collision);
  EXPECT_EQ(hit->body, still.moving);
  EXPECT_EQ(still.simulation.overlap({10, 10, 10}, 0.5), std::vector<SphereId>{still.moving});
}

// Two spheres that come from either side, at the same time: the lower id is hit, whichever cell is first.
TEST(Queries, OfSimultaneousContactsTheLowerIdIsFirst) {
  for (const bool is_upper_first : {false, true}) {
    // As fast as this one, they are found in cells.
    Still still = still_spheres({10, 10, 10}, {0, 0, 100});
    const double side = is_upper_first ? 1 : -1;
    const SphereId low =
        still.simulation.add({.position = {50, 50 + 3 * side, 50}, .velocity = {0, -side, 0}});
    still.simulation.add({.position = {50, 50 - 3 * side, 50}, .velocity = {0, side, 0}});
    const Sphere sphere{.position = {50, 50, 50}, .radius = 1};
    for (int i = 0; i < 2; ++i) {
      EXPECT_EQ(still.simulation.first_contact(sphere, 100)->second, low);
    }
  }
}

// A row of spheres along x, of alternating species; spheres 0 to 3 are in groups 1, 2, 3 and none.
Simulation row_of_spheres() {
  World world(Box::walls({10, 2, 2}));
  for (SpeciesId k = 0; k < 4; ++k)
    world.add({.position = {2.0 * k + 2, 1, 1}, .radius = 0.5, .species = static_cast<SpeciesId>(k % 2)});
  Simulation simulation(world);
  simulation.set_user_data(0, 0b01);
  simulation.set_user_data(1, 0b10);
  simulation.set_user_data(2, 0b11);
  return simulation;
}

TEST(Queries, MasksChooseWhatIsFound) {
  const Simulation simulation = row_of_spheres();
  const auto hit = [&](const BodyMask& mask) {
    const std::optional<RayHit> found = simulation.ray({0.5, 1, 1}, {1, 0, 0}, 20, mask);
    return found ? static_cast<int>(found->body) : -1;
  };
  EXPECT_EQ(hit({}), 0);
  EXPECT_EQ(hit({.species = {1}}), 1);
  EXPECT_EQ(hit({.groups = 0b10}), 1);
  EXPECT_EQ(hit({.species = {0}, .groups = 0b10}), 2);
  EXPECT_EQ(hit({.species = {2}}), static_cast<int>(face_of(0, true)));
  EXPECT_EQ(hit({.species = {2}, .walls = false}), -1);
  EXPECT_EQ(simulation.overlap({5, 1, 1}, 5, {.groups = 0b01}), (std::vector<SphereId>{0, 2}));
  EXPECT_EQ(simulation.overlap(Extent{{0, 0, 0}, {5, 2, 2}}, {.species = {1}}), (std::vector<SphereId>{1}));
  EXPECT_EQ(simulation.clearance(Vec3{2, 1, 1}, {.species = {1}, .walls = false})->body, 1U);
  EXPECT_EQ(simulation.clearance(SphereId{0}, {.groups = 0b11, .walls = false})->body, 1U);
  std::vector<std::uint32_t> bodies;
  for (const RayHit& each : simulation.ray_hits({0.5, 1, 1}, {1, 0, 0}, 20, {.species = {1}}))
    bodies.push_back(each.body);
  EXPECT_EQ(bodies, (std::vector<std::uint32_t>{1, 3, face_of(0, true)}));
}

TEST(Queries, ManyRaysAreAsManySingleOnes) {
  const RandomWorld made =
      support::make_random_gas(3, {Boundary::wall, Boundary::periodic, Boundary::wall}, 500);
  const Simulation simulation(made.world);
  const World& world = simulation.world();
  Random random(4);
  std::vector<Vec3> origins;
  std::vector<Vec3> directions;
  for (int i = 0; i < 1000; ++i) {
    origins.push_back(
        world.position(static_cast<Slot>(random.uniform() * static_cast<double>(world.size())), Time(0)));
    directions.push_back(random.direction());
  }
  const double most = 30 * world.largest_radius();
  for (const std::size_t threads : {1U, 3U}) {
    const std::vector<std::optional<RayHit>> hits = simulation.rays(origins, directions, most, {}, threads);
    ASSERT_EQ(hits.size(), origins.size());
    for (std::size_t i = 0; i < hits.size(); ++i) {
      const std::optional<RayHit> single = simulation.ray(origins[i], directions[i], most);
      ASSERT_EQ(hits[i].has_value(), single.has_value());
      if (single) {
        ASSERT_EQ(hits[i]->distance, single->distance);
      }
    }
  }
  EXPECT_TRUE(simulation.rays({}, {}, most).empty());
  EXPECT_THROW(static_cast<void>(simulation.rays(origins, {}, most)), Error);
  EXPECT_THROW(static_cast<void>(simulation.rays(origins, directions, most, {}, 0)), Error);
  directions.back() = {};
  EXPECT_THROW(static_cast<void>(simulation.rays(origins, directions, most, {}, 2)), Error);
}

}  // namespace
}  // namespace hardball::queries_test
