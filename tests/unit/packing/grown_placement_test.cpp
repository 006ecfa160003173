// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/packing/grown_placement.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/world/audit.hpp"
#include "hardball/world/walls.hpp"
#include "support/refusal.hpp"

namespace hardball::grown_placement_test {
namespace {

// Radii of so many spheres, every third one of `other`, that fill this fraction of a region.
std::vector<double> filling(const Box& box, const Vec3& size, std::size_t count, double other,
                            double fraction) {
  std::vector<double> radii(count, 1.0);
  for (std::size_t i = 0; i < count; i += 3) radii[i] = other;
  double volume = 0;
  for (const double radius : radii) volume += box.sphere_volume(radius);
  const double excess = volume / (fraction * box.volume_of(size));
  const double factor = box.is_flat() ? std::sqrt(1 / excess) : std::cbrt(1 / excess);
  for (double& radius : radii) radius *= factor;
  return radii;
}

// World::add refuses what reaches beyond a face.
void expect_no_overlap(World world, const std::vector<Vec3>& centers, const std::vector<double>& radii,
                       const std::vector<PlacedSphere>& placed = {}) {
  ASSERT_EQ(centers.size(), radii.size());
  for (std::size_t i = 0; i < centers.size(); ++i) {
    EXPECT_GE(distance_to_surfaces(world, centers[i], Time(0)), radii[i]);
    world.add({.position = centers[i], .radius = radii[i]});
  }
  for (const PlacedSphere& sphere : placed) world.add({.position = sphere.center, .radius = sphere.radius});
  EXPECT_EQ(audit(world, Time(0)).max_overlap, 0);
}

TEST(PlaceByGrowth, ReachesDensitiesOfFluidsInAnyBox) {
  const Vec3 size{10, 11, 12};
  const Vec3 plane{30, 31, 0};
  for (const auto& [box, fraction] :
       {std::pair(Box::periodic(size), 0.494), std::pair(Box::walls(size), 0.45),
        std::pair(Box::flat_periodic(30, 31), 0.7), std::pair(Box::flat_walls(30, 31), 0.68)}) {
    const Vec3& extent = box.is_flat() ? plane : size;
    for (const double other : {1.0, 0.6}) {
      const std::vector<double> radii = filling(box, extent, 500, other, fraction);
      const World empty(box);
      Random random(7);
      const std::vector<Vec3> centers = place_by_growth(empty, {{}, extent}, radii, {}, random, "here");
      expect_no_overlap(empty, centers, radii);
      Random again(7);
      EXPECT_EQ(place_by_growth(empty, {{}, extent}, radii, {}, again, "here"), centers);
    }
  }
}

TEST(PlaceByGrowth, KeepsClearOfSpheresThatAreThere) {
  const Vec3 size{10, 10, 10};
  const World empty(Box::periodic(size));
  const std::vector<PlacedSphere> placed{{{0.5, 5, 5}, 2}, {{5, 5, 9.9}, 1}};
  const std::vector<double> radii = filling(empty.box(), size, 600, 1, 0.44);
  Random random(8);
  const std::vector<Vec3> centers = place_by_growth(empty, {{}, size}, radii, placed, random, "here");
  expect_no_overlap(empty, centers, radii, placed);
}

// Where the box is open, the ends of the region bound the spheres; walls are where they are at time zero.
TEST(PlaceByGrowth, StaysBetweenSurfaces) {
  const Vec3 up{0, 0, 1};
  const std::vector<Surface> surfaces{
      {Cylinder(up, 4), {4, 4, 0}},
      {OscillatingPlane(up, 0.5, 2), {0, 0, 1}, {}, SurfaceMaterial{.temperature = 2.0}}};
  const World empty(Box::open(), {0, 0, -1}, surfaces);
  const std::vector<double> radii(560, 0.5);  // 0.53 of the cylinder between 1 and 12
  Random random(9);
  const Region region{{0, 0, 0.5}, {8, 8, 12}};
  const std::vector<Vec3> centers = place_by_growth(empty, region, radii, {}, random, "here");
  expect_no_overlap(empty, centers, radii);
  for (const Vec3& center : centers) EXPECT_LE(center.z, 11.5);
}

TEST(PlaceByGrowth, AlsoWhereTheBoxWillBeSheared) {
  const Vec3 size{9, 9, 9};
  Box box = Box::periodic(size);
  box.set_shear({.rate = 0.3});
  const World empty(box);
  const std::vector<double> radii = filling(box, size, 400, 0.8, 0.48);
  Random random(10);
  expect_no_overlap(empty, place_by_growth(empty, {{}, size}, radii, {}, random, "here"), radii);
  box.set_shear({.rate = 0.3, .offset = 2});
  EXPECT_THROW(place_by_growth(World(box), {{}, size}, radii, {}, random, "here"), Error);
}

std::string error_of(const Box& box, const std::vector<double>& radii) {
  return support::refusal_of([&] {
    Random random(1);
    place_by_growth(World(box), {{}, box.size()}, radii, {}, random, "gas.toml:3:1");
  });
}

TEST(PlaceByGrowth, RefusesWhatWouldJam) {
  const Box box = Box::periodic({10, 10, 10});
  const std::string equal = error_of(box, filling(box, box.size(), 500, 1, 0.63));
  EXPECT_NE(equal.find("gas.toml:3:1"), std::string::npos) << equal;
  EXPECT_NE(equal.find("jam at about 0.64"), std::string::npos) << equal;
  EXPECT_NE(equal.find("placement = \"fcc\""), std::string::npos) << equal;
  EXPECT_NE(equal.find("hardball pack"), std::string::npos) << equal;
  const std::string unequal = error_of(box, filling(box, box.size(), 500, 0.5, 0.68));
  EXPECT_EQ(unequal.find("fcc"), std::string::npos) << unequal;
  EXPECT_NE(unequal.find("hardball pack"), std::string::npos) << unequal;
  // Six hundred spheres, as dense as .6 in bulk, lock between walls so close that few fit beside each other.
  const Box narrow = Box::walls({3, 3, 30});
  const std::string locked = error_of(narrow, filling(narrow, narrow.size(), 160, 1, 0.6));
  EXPECT_NE(locked.find("lock before"), std::string::npos) << locked;
}

}  // namespace
}  // namespace hardball::grown_placement_test
