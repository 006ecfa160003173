// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/robots/obstacles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "hardball/numbers/random.hpp"
#include "hardball/surfaces/make_mesh.hpp"
#include "hardball/surfaces/surface.hpp"
#include "support/arm.hpp"
#include "support/refusal.hpp"

namespace hardball::obstacles_test {
namespace {

// The distance of a shape from a point, and the normal there, by hand.
struct Known {
  Vec3 point;
  double distance;
  Vec3 normal;
};

void expect(const Obstacles& obstacles, const std::vector<Known>& known) {
  for (const auto& [point, distance, normal] : known) {
    const NearestOfShape nearest = nearest_of(obstacles.item(0).shape, point, 0);
    EXPECT_NEAR(nearest.distance, distance, 1e-15);
    EXPECT_LT(length(nearest.normal - normal), 1e-15);
  }
}

TEST(Obstacles, KnowDistances) {
  Obstacles sphere;
  sphere.add_sphere({1, 0, 0}, 0.5, {2, 0, 0}, -1);
  expect(sphere, {{{3, 2, 0}, 1.5, {0, 1, 0}}, {{3, 0, 0}, -0.5, {}}});
  Obstacles box;
  box.add_box({1, 0, 0}, {2, 4, 6}, RotationMatrix{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}});
  expect(box, {{{1, 3, 0}, 2, {0, 1, 0}},
               {{5, 0, 0}, 2, {1, 0, 0}},
               {{1, 0.5, 1}, 0, {}},
               {{6, 5, 0}, 5, {0.6, 0.8, 0}}});
  Obstacles capsule;
  capsule.add_capsule({0, 0, 0}, {0, 0, 2}, 0.5);
  expect(capsule,
         {{{1, 0, 1}, 0.5, {1, 0, 0}}, {{0, 0, 3}, 0.5, {0, 0, 1}}, {{0, 3, -4}, 4.5, {0, 0.6, -0.8}}});
  Obstacles plane;
  plane.add_plane({0, 0, 1}, {0, 0, 2});
  expect(plane, {{{5, 5, 3}, 2, {0, 0, 1}}, {{5, 5, 0}, -1, {0, 0, 1}}});
  Obstacles triangle;
  const std::vector<Vec3> corners{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const std::vector<std::array<std::uint32_t, 3>> faces{{0, 1, 2}};
  triangle.add_mesh(corners, faces, 0.25);
  expect(triangle, {{{1, 1, 2}, 1.75, {0, 0, 1}},
                    {{1, 1, -2}, 1.75, {0, 0, -1}},
                    {{1, -3, 4}, 4.75, {0, -0.6, 0.8}},
                    {{-3, 0, 0}, 2.75, {-1, 0, 0}}});
}

// All items that the trees have, and whether each node holds all that it is an extent of.
void visit(const Obstacles& obstacles, std::uint32_t number, std::vector<std::uint32_t>& items) {
  const Obstacles::Node& node = obstacles.node(number);
  if (node.is_leaf) {
    items.push_back(node.right_or_item);
    return;
  }
  for (const std::uint32_t child : {number + 1, node.right_or_item}) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      EXPECT_LE(node.extent.low[axis], obstacles.node(child).extent.low[axis]);
      EXPECT_GE(node.extent.high[axis], obstacles.node(child).extent.high[axis]);
    }
    EXPECT_GE(node.speed, obstacles.node(child).speed);
    visit(obstacles, child, items);
  }
}

TEST(Obstacles, AreAllInTheTrees) {
  Random random(1);
  for (std::size_t count = 0; count < 70; ++count) {
    const Obstacles obstacles = support::random_obstacles(random, count, 0.3, 0, false);
    std::vector<std::uint32_t> items;
    for (const std::uint32_t root : obstacles.roots()) visit(obstacles, root, items);
    std::sort(items.begin(), items.end());
    ASSERT_EQ(items.size(), count);
    for (std::size_t k = 0; k < count; ++k) EXPECT_EQ(items[k], k);
    EXPECT_LE(obstacles.roots().size(), 7) << "a few trees, as each is larger than the next";
  }
}

TEST(Obstacles, ExtentsHoldTheirShapes) {
  Random random(2);
  const Obstacles obstacles = support::random_obstacles(random, 40, 0.3, 0, false);
  for (std::uint32_t k = 0; k < 200; ++k) {
    const std::uint32_t leaf = [&] {
      std::uint32_t at = obstacles.roots()[0];
      while (!obstacles.node(at).is_leaf)
        at = random.bits() % 2 == 0 ? at + 1 : obstacles.node(at).right_or_item;
      return at;
    }();
    const Extent& extent = obstacles.node(leaf).extent;
    const Vec3 outside = (extent.high + Vec3{1e-9, 1e-9, 1e-9}) + random.uniform() * Vec3{1, 1, 1};
    EXPECT_GT(nearest_of(obstacles.item(obstacles.node(leaf).right_or_item).shape, outside, 0).distance, 0);
  }
}

TEST(Obstacles, TakeWorlds) {
  World world(
      Box::walls({10, 10, 10}), {},
      {Surface(Plane({0, 0.6, 0.8}), {5, 1, 1}), Surface(hardball::Obstacle(0.5), {2, 8, 8}),
       Surface(MeshShape(std::make_shared<const Mesh>(plate_mesh({2, 0, 0}, {0, 2, 0}))), {3, 3, 3})});
  world.add({.position = {5, 5, 5}, .velocity = {1, 0, 0}, .radius = 0.25}, Time(2));
  Obstacles obstacles;
  obstacles.add_sphere({0, 0, 0}, 1);
  EXPECT_EQ(obstacles.add_world(world, Time(4)), 1);
  EXPECT_EQ(obstacles.size(), 11);
  const auto distance = [&](std::size_t item, const Vec3& point, double time) {
    return nearest_of(obstacles.item(item).shape, point, time).distance;
  };
  EXPECT_EQ(distance(1, {9, 5, 5}, 5), 0.75) << "it moves on";
  EXPECT_EQ(distance(2, {1, 5, 5}, 0), 1) << "x_min";
  EXPECT_EQ(distance(3, {1, 5, 5}, 0), 9) << "x_max";
  EXPECT_DOUBLE_EQ(distance(8, {5, 1, 2}, 0), 0.8);
  EXPECT_EQ(distance(9, {2, 8, 6}, 0), 1.5);
  EXPECT_EQ(distance(10, {4.5, 3.5, 5}, 0), 2);
}

TEST(Obstacles, RefuseWhatTheyCannotBe) {
  Obstacles obstacles;
  const auto problem = [](auto&& act) { return support::problem_of(act); };
  EXPECT_EQ(problem([&] { obstacles.add_sphere({}, 0); }), "the radius is 0");
  EXPECT_EQ(problem([&] { obstacles.add_box({}, {1, 0, 1}); }), "an edge is 0");
  EXPECT_EQ(problem([&] {
              obstacles.add_box({}, {1, 1, 1}, {{1, 0, 0}, {0, 1, 0}, {0, 0, -1}});
            }),
            "the rotation is none");
  EXPECT_EQ(problem([&] { obstacles.add_plane({}, {}); }), "the normal is a vector of length zero");
  EXPECT_EQ(problem([&] {
              obstacles.add_capsule({}, {0, 0, std::numeric_limits<double>::infinity()}, 1);
            }),
            "an end is inf");
  const std::vector<Vec3> corners{{}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<std::array<std::uint32_t, 3>> faces{{0, 1, 3}};
  EXPECT_EQ(problem([&] { obstacles.add_mesh(corners, faces); }), "a triangle has the vertex 3");
  EXPECT_EQ(problem([&] { obstacles.add_mesh(corners, {}); }), "there are no triangles");
  EXPECT_EQ(problem([&] {
              obstacles.add_world(World(Box::periodic({1, 1, 1})), Time(0));
            }),
            "the box is periodic");
  EXPECT_EQ(problem([&] {
              obstacles.add_world(World(Box::open(), {0, 0, -1}), Time(0));
            }),
            "spheres fall or grow");
  EXPECT_EQ(
      problem([&] { obstacles.add_world(World(Box::open(), {}, {Surface(HollowSphere(3), {})}), Time(0)); }),
      "there is a surface of the shape sphere");
  EXPECT_EQ(obstacles.size(), 0) << "nothing has been added";
}

}  // namespace
}  // namespace hardball::obstacles_test
