// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Many obstacles at rest, which a tree finds, against each by itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <set>
#include <vector>

#include "hardball/geometry/extent_tree.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/world/walls.hpp"
#include "support/effort.hpp"
#include "support/walls_one_by_one.hpp"

namespace hardball::obstacles_test {
namespace {

Vec3 random_point(Random& random, const Vec3& size) {
  return {size.x * random.uniform(), size.y * random.uniform(), size.z * random.uniform()};
}

// Obstacles of very different sizes, some at one point, others in a plane.
struct Ball {
  Vec3 center;
  double radius;
};

std::vector<Ball> random_balls(Random& random, std::size_t count) {
  std::vector<Ball> balls;
  const bool are_flat = random.uniform() < 0.2;
  for (std::uint32_t i = 0; i < count; ++i) {
    Vec3 center = random_point(random, {10, 10, are_flat ? 0.0 : 10.0});
    if (i > 0 && random.uniform() < 0.1) center = balls[i - 1].center;
    balls.push_back({center, std::exp2(-6 * random.uniform())});
  }
  return balls;
}

ExtentTree tree_of(const std::vector<Ball>& balls) {
  std::vector<ExtentTree::Item> items;
  for (std::uint32_t i = 0; i < balls.size(); ++i)
    items.push_back({Extent{balls[i].center, balls[i].center}.grown(balls[i].radius), i});
  return ExtentTree(items);
}

TEST(ExtentTree, FindsAllThatReachIntoAPartOfSpace) {
  std::uint64_t found = 0;
  for (std::uint64_t seed = 0; seed < support::cases(500); ++seed) {
    Random random(seed);
    const auto balls = random_balls(random, random.bits() % 60);
    const ExtentTree tree = tree_of(balls);
    EXPECT_EQ(tree.is_empty(), balls.empty());
    const Vec3 corner = random_point(random, {12, 12, 12});
    const Extent part{corner, corner + random_point(random, {3, 3, 3})};
    std::multiset<std::uint32_t> visited;
    tree.for_each_in(part, [&](std::uint32_t number) { visited.insert(number); });
    for (std::uint32_t number = 0; number < balls.size(); ++number) {
      const auto& [center, radius] = balls[number];
      const bool reaches = distance_to(part, center) <= radius;
      EXPECT_LE(visited.count(number), 1U);
      EXPECT_TRUE(!reaches || visited.count(number) == 1) << "seed " << seed << ", ball " << number;
      found += reaches ? 1U : 0U;
    }
  }
  EXPECT_GT(found, support::cases(500) / 20);
}

TEST(ExtentTree, FindsTheNearestAndFewOthers) {
  std::uint64_t visits = 0;
  for (std::uint64_t seed = 0; seed < support::cases(200); ++seed) {
    Random random(seed);
    const auto balls = random_balls(random, 500);
    const ExtentTree tree = tree_of(balls);
    const Vec3 point = random_point(random, {10, 10, 10});
    const auto distance_of = [&](const Ball& ball) {
      return std::max(0.0, length(ball.center - point) - ball.radius);
    };
    double nearest = std::numeric_limits<double>::infinity();
    tree.for_each_within(
        nearest, [&](const Extent& extent) { return distance_to(extent, point); },
        [&](std::uint32_t number) {
          nearest = std::min(nearest, distance_of(balls[number]));
          ++visits;
        });
    for (const Ball& ball : balls) EXPECT_LE(nearest, distance_of(ball)) << "seed " << seed;
  }
  EXPECT_LT(visits, support::cases(200) * 50);
}

// A sphere among obstacles, in a box with all kinds of boundaries, which falls, grows or moves uniformly.
World world_among_obstacles(Random& random) {
  constexpr std::array kBoundaries = {Boundary::periodic, Boundary::wall, Boundary::open};
  std::array<Boundary, kAxes> boundary{};
  for (Boundary& each : boundary) each = kBoundaries[random.bits() % 3];
  const Vec3 size{10, 10 + 10 * random.uniform(), 30};
  const double kind = random.uniform();
  std::vector<Surface> surfaces;
  const std::uint64_t count = 1 + random.bits() % 80;
  for (std::uint64_t i = 0; i < count; ++i) {
    const double radius = 0.05 + 2 * random.uniform() * random.uniform();
    const bool moves =
        kind <= 0.8 && boundary == std::array{Boundary::open, Boundary::open, Boundary::open} && i % 3 == 0;
    surfaces.emplace_back(Obstacle(radius), random_point(random, size), moves ? random.direction() : Vec3{});
  }
  if (random.uniform() < 0.5) {
    MeshParts parts;
    for (int corner = 0; corner < 4; ++corner) parts.vertices.push_back(4 * random.direction());
    parts.triangles = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
    surfaces.emplace_back(MeshShape(std::make_shared<const Mesh>(parts)), random_point(random, size));
  }
  World world(Box(boundary, size), kind < 0.4 ? random.uniform() * random.direction() : Vec3{}, surfaces);
  const Vec3 velocity =
      random.uniform() < 0.1 ? Vec3{} : std::exp2(2 + 2 * random.normal()) * random.direction();
  world.add({Vec3{1, 1, 1} + random_point(random, size - Vec3{2, 2, 2}), velocity, 0.3, 1},
            Time(random.uniform()));
  if (kind > 0.8) world.set_growth({.begin = Time(0), .end = Time(1000), .scale = 1, .rate = 0.01});
  return world;
}

TEST(NextSolidEvent, IsThatOfTheFirstInReachOneByOne) {
  std::uint64_t met = 0;
  std::uint64_t beyond = 0;
  const std::uint64_t cases = support::cases(4000);
  for (std::uint64_t seed = 0; seed < cases; ++seed) {
    Random random(seed);
    const World world = world_among_obstacles(random);
    const Time now(1 + random.uniform());
    // The sphere covers no more than a box and a half, of which two are looked at.
    const double fastest = length(world.velocity(0, now)) + 1e-9;
    const double until = now.high + std::min(15 / fastest, 5.0) * random.uniform();
    if (world.path(0).time > now) continue;
    const Event wall = next_wall_event(world, 0, now);
    const Event expected = support::wall_event_one_by_one(world, 0, now, 2);
    // A contact before now would have happened.
    if (expected.time < now || wall.time < now) continue;
    const Event found = std::min(wall, next_solid_event(world, 0, now, until));
    if (expected.time.high <= until) {
      EXPECT_EQ(found, expected) << "seed " << seed;
      EXPECT_EQ(std::min(wall, next_solid_event(world, 0, now, expected.time.high)), expected)
          << "seed " << seed << ", which is at the end of the time";
      met += expected.second >= kFaces ? 1U : 0U;
    } else {
      EXPECT_GT(found.time.high, until) << "seed " << seed;
      ++beyond;
    }
  }
  EXPECT_GT(met, cases / 40);
  EXPECT_GT(beyond, cases / 10);
}

TEST(DistanceToSurfaces, IsThatOfTheNearestImageOneByOne) {
  for (std::uint64_t seed = 0; seed < support::cases(1000); ++seed) {
    Random random(seed);
    const World world = world_among_obstacles(random);
    const Vec3 point = 3 * random_point(random, {10, 10, 10}) - Vec3{10, 10, 10};
    double least = std::numeric_limits<double>::infinity();
    for (const Surface& surface : world.surfaces()) {
      const Image nearest = world.box().nearest_image(point - surface.point());
      support::for_each_image(world.box(), 2, [&](const Image& image) {
        const Vec3 shift = world.box().shift(nearest + image);
        least = std::min(least, surface.distance(point - shift, Time(2)));
      });
    }
    EXPECT_EQ(distance_to_surfaces(world, point, Time(2)), least) << "seed " << seed;
    if (!(least > 0)) continue;
    EXPECT_TRUE(is_clear_of_surfaces(world, point, least, Time(2))) << "seed " << seed;
    EXPECT_FALSE(is_clear_of_surfaces(world, point, std::nextafter(least, 100), Time(2))) << "seed " << seed;
  }
}

}  // namespace
}  // namespace hardball::obstacles_test
