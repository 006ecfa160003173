// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Boxes of two dimensions: what leaves the plane is refused, and discs are placed in it.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "hardball/geometry/spacing.hpp"
#include "hardball/placement/placement.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/world/audit.hpp"
#include "hardball/world/totals.hpp"
#include "hardball/world/walls.hpp"
#include "support/refusal.hpp"

namespace hardball::flat_world_test {
namespace {

using support::refusal_of;

void expect_refused_out_of_plane(const std::function<void()>& attempt) {
  EXPECT_NE(refusal_of(attempt).find("two dimensions"), std::string::npos) << refusal_of(attempt);
}

TEST(FlatBox, HasTwoDimensions) {
  const Box box = Box::flat_periodic(3, 5);
  EXPECT_TRUE(box.is_flat());
  EXPECT_EQ(box.dimensions(), 2U);
  EXPECT_EQ(box.size(), (Vec3{3, 5, 0}));
  EXPECT_EQ(box.volume(), 15);
  EXPECT_EQ(box.face_area(0), 5);
  EXPECT_EQ(box.face_area(1), 3);
  EXPECT_DOUBLE_EQ(box.sphere_volume(2), 4 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(box.sphere_surface(2), 4 * std::numbers::pi);
  EXPECT_TRUE(box.is_all(Boundary::periodic));
  EXPECT_FALSE(box.is_any(Boundary::wall));
  EXPECT_TRUE(Box::flat_walls(3, 5).is_all(Boundary::wall));
  EXPECT_TRUE(std::isinf(Box::flat_open().volume()));
  EXPECT_EQ(Box::periodic({2, 3, 4}).dimensions(), 3U);
  EXPECT_EQ(Box::periodic({2, 3, 4}).face_area(1), 8);
  EXPECT_NE(refusal_of([] { Box({Boundary::flat, Boundary::wall, Boundary::wall}, {1, 1, 1}); }), "");
}

TEST(FlatWorld, RefusesSpheresOutOfThePlane) {
  World world(Box::flat_walls(10, 10));
  expect_refused_out_of_plane([&] { world.add({{5, 5, 0.1}, {}, 1, 1}); });
  expect_refused_out_of_plane([&] { world.add({{5, 5, 0}, {0, 0, 1}, 1, 1}); });
  EXPECT_EQ(world.size(), 0U);
  world.add({{5, 5, 0}, {1, 1, -0.0}, 1, 1});
  expect_refused_out_of_plane([&] { world.change_velocity(0, Time(0), {1, 0, 1e-30}); });
  EXPECT_NE(refusal_of([&] {
              world.add({{5, 0.5, 0}, {}, 1, 1});
            }).find("through a wall"),
            std::string::npos);
  EXPECT_DOUBLE_EQ(sphere_volume(world, Time(0)), std::numbers::pi);
}

TEST(FlatWorld, RefusesGravityAndSurfacesOutOfThePlane) {
  const Box box = Box::flat_open();
  const auto make = [&](const Surface& surface) { return World(box, {}, {surface}); };
  expect_refused_out_of_plane([&] { World(box, {0, 0, -1}); });
  expect_refused_out_of_plane([&] { make(Surface(Plane({0.6, 0, 0.8}), {})); });
  expect_refused_out_of_plane([&] { make(Surface(Plane({1, 0, 0}), {}, {0, 0, 1})); });
  expect_refused_out_of_plane([&] { make(Surface(OscillatingPlane({0, 0, 1}, 1, 1), {})); });
  expect_refused_out_of_plane([&] { make(Surface(Cylinder({1, 0, 0}, 1), {})); });
  expect_refused_out_of_plane([&] { make(Surface(Obstacle(1), {0, 0, 0.5})); });
  expect_refused_out_of_plane([&] { make(Surface(HollowSphere(1), {0, 0, 0.5})); });
  EXPECT_DOUBLE_EQ(accessible_volume(make(Surface(Cylinder({0, 0, 1}, 2), {}))), 4 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(accessible_volume(make(Surface(HollowSphere(2), {}))), 4 * std::numbers::pi);
}

TEST(FlatWorld, RefusesResponsesThatLeaveThePlane) {
  World world(Box::flat_walls(10, 10));
  world.add({{5, 5, 0}, {1, 0, 0}, 1, 1});
  Simulation simulation(world);
  simulation.respond_with([](const Contact& contact) {
    Velocities after = Restitution()(contact);
    after.first.z = 1;
    return after;
  });
  EXPECT_NE(refusal_of([&] { simulation.run_until(10); }).find("none along z"), std::string::npos);
}

// Two degrees of freedom: between thermal walls <v^2> becomes 2 kT / m. The standard error of the mean over
// so many contacts is about 2%, and four are allowed.
TEST(FlatWorld, HasThermalWallsThatReturnDiscsInThePlane) {
  const SurfaceMaterial warm{.temperature = 3, .seed = 5};
  World world(Box({Boundary::open, Boundary::periodic, Boundary::flat}, {0, 20, 0}), {},
              {Surface(Plane({1, 0, 0}), {}, {}, warm), Surface(Plane({-1, 0, 0}), {20, 0, 0}, {}, warm)});
  for (int i = 0; i < 8; ++i) world.add({{2.0 + 2 * i, 10, 0}, {1, 0.5 * i, 0}, 0.5, 1.5});
  Simulation simulation(world);
  double sum = 0;
  double count = 0;
  simulation.on_contact([&](const Contact& contact) {
    ASSERT_EQ(contact.after.first.z, 0);
    if (contact.is_collision()) return;
    sum += contact.after.first.y * contact.after.first.y;
    ++count;
  });
  simulation.run_contacts(20000);
  EXPECT_GT(count, 4000);
  EXPECT_NEAR(sum / count, 3 / 1.5, 0.16);
}

Audit audit_of(const Box& box, const std::vector<Vec3>& centers, const std::vector<double>& radii) {
  World world(box);
  for (std::size_t i = 0; i < centers.size(); ++i) world.add({centers[i], {}, radii[i], 1});
  return audit(world, Time(0));
}

TEST(PlaceDiscs, AtRandomNearlyToSaturation) {
  const Box box = Box::flat_periodic(100, 80);
  const double radius = std::sqrt(0.539 * box.volume() / (2000 * std::numbers::pi));
  const std::vector<double> radii(2000, radius);
  Random random(31);
  const std::vector<Vec3> centers = place_randomly(box, {{}, box.size()}, radii, random, "here");
  EXPECT_EQ(audit_of(box, centers, radii).max_overlap, 0);
  const std::vector<double> larger(2000, 1.01 * radius);
  EXPECT_NE(refusal_of([&] {
              place_randomly(box, {{}, box.size()}, larger, random, "here");
            }).find("hexagonal"),
            std::string::npos);
}

TEST(PlaceDiscs, OfManySizesBetweenWalls) {
  std::vector<double> radii;
  for (int i = 0; i < 3000; ++i) radii.push_back(i % 100 == 0 ? 3 : 0.1 + 0.3 * (i % 7) / 7);
  const Box box = Box::flat_walls(60, 50);
  Random random(32);
  EXPECT_EQ(audit_of(box, place_randomly(box, {{}, box.size()}, radii, random, "here"), radii).max_overlap,
            0);
}

// In boxes that suit it the lattice is perfect, either way up, up to close packing.
TEST(PlaceDiscs, OnAHexagonalLattice) {
  const double height = 12 * std::sqrt(3.0);
  for (const Box& box : {Box::flat_periodic(20, height), Box::flat_periodic(height, 20)}) {
    const double radius = 0.5 * (1 - 1e-12);
    const std::vector<Vec3> centers = place_on_lattice(box, {{}, box.size()}, 480, radius, "here");
    ASSERT_EQ(centers.size(), 480U);
    EXPECT_EQ(audit_of(box, centers, std::vector<double>(480, radius)).max_overlap, 0);
    EXPECT_NEAR(480 * box.sphere_volume(radius) / box.volume(), kClosePackingOfDiscs, 1e-9);
    EXPECT_NE(refusal_of([&] {
                place_on_lattice(box, {{}, box.size()}, 480, 0.51, "here");
              }).find("hexagonal"),
              std::string::npos);
  }
  const Box walls = Box::flat_walls(20, 17);
  const std::vector<Vec3> centers = place_on_lattice(walls, {{}, walls.size()}, 331, 0.45, "here");
  EXPECT_EQ(centers.size(), 331U);
  EXPECT_TRUE(audit_of(walls, centers, std::vector<double>(331, 0.45)).is_sound());
}

// The mean of n directions has components of standard deviation sqrt(1 / 2n), the mean square 1/2 one of
// sqrt(1 / 8n); four of each.
TEST(DirectionInPlane, IsUniformOnTheCircle) {
  Random random(33);
  constexpr int kCount = 20000;
  Vec3 sum;
  double square = 0;
  for (int i = 0; i < kCount; ++i) {
    const Vec3 direction = random.direction_in_plane();
    ASSERT_NEAR(length(direction), 1, 1e-15);
    ASSERT_EQ(direction.z, 0);
    sum += direction;
    square += direction.x * direction.x;
  }
  EXPECT_NEAR(sum.x / kCount, 0, 4 * std::sqrt(0.5 / kCount));
  EXPECT_NEAR(sum.y / kCount, 0, 4 * std::sqrt(0.5 / kCount));
  EXPECT_NEAR(square / kCount, 0.5, 4 * std::sqrt(0.125 / kCount));
}

TEST(Spacing, OfDiscsIsThatOfSquares) {
  EXPECT_DOUBLE_EQ(spacing({12, 3, 0}, 4), 3);
  EXPECT_DOUBLE_EQ(spacing({12, 3, 0}, 36), 1);
  EXPECT_DOUBLE_EQ(spacing({12, 3, 0}, 2), 6);
}

}  // namespace
}  // namespace hardball::flat_world_test
