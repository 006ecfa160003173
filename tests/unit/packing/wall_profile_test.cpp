// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/packing/wall_profile.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "hardball/numbers/random.hpp"

namespace hardball::wall_profile_test {
namespace {

const double kPi = std::numbers::pi;

// The area, in two dimensions the length, of what is so far from the curved wall.
double area_at(const Container& container, double distance) {
  const double radius = container.size.x / 2;
  const double inner = radius - distance;
  if (container.dimensions == 2) return 2 * kPi * inner;
  if (container.shape == Container::Shape::sphere || container.shape == Container::Shape::shell)
    return 4 * kPi * inner * inner;
  if (container.shape == Container::Shape::truncated_cone) {
    const double slope = (radius - container.inner / 2) / container.size.z;
    const double secant = std::hypot(1, slope);
    // The radii of the surface at its ends, of which the lower may be an apex of its own.
    const double top = radius - distance * secant;
    const double bottom = std::max(0.0, container.inner / 2 - distance * secant);
    return kPi * (top * top - bottom * bottom) * secant / slope;
  }
  if (container.shape == Container::Shape::cylinder || container.shape == Container::Shape::annulus)
    return 2 * kPi * inner * container.size.z;
  const double share = 1 - distance * std::hypot(radius, container.size.z) / (radius * container.size.z);
  return kPi * radius * std::hypot(radius, container.size.z) * share * share;
}

double volume_in(const WallProfile& profile, const Container& container) {
  double volume = 0;
  for (std::size_t k = 0; k < profile.packing_fraction.size(); ++k)
    volume += profile.packing_fraction[k] * area_at(container, profile.distance(k)) * profile.width;
  return volume;
}

// Spheres well within each kind of container, one of which encloses its axis.
std::vector<PackedSpheres> some() {
  using Shape = Container::Shape;
  return {
      {{.shape = Shape::cylinder, .size = {6, 6, 8}},
       {{3.3, 3, 2}, {1.5, 3, 5}, {4.5, 4.5, 6}},
       {1.1, 1, 0.6}},
      {{.shape = Shape::sphere, .size = {6, 6, 6}}, {{3.3, 3, 2.6}, {1.2, 3, 4}}, {1, 0.8}},
      {{.shape = Shape::cone, .size = {6, 6, 6}}, {{3.2, 3, 3}, {4.5, 3, 5}}, {0.9, 0.7}},
      {{.shape = Shape::truncated_cone, .size = {6, 6, 6}, .inner = 4},
       {{3.2, 3, 3}, {4.5, 3, 5}, {2.5, 3, 1}},
       {0.9, 0.7, 0.8}},
      {{.shape = Shape::shell, .size = {6, 6, 6}, .inner = 2}, {{3.3, 3, 5}, {1, 3, 3.5}}, {0.9, 0.8}},
      {{.shape = Shape::annulus, .size = {6, 6, 5}, .inner = 2}, {{3.3, 5, 3}, {1, 3, 1.5}}, {0.9, 0.8}},
      {{.shape = Shape::sphere, .dimensions = 2, .size = {6, 6, 0}}, {{3.3, 3, 0}, {1.2, 3, 0}}, {1, 0.8}},
  };
}

TEST(WallProfile, HasTheVolumeOfTheSpheres) {
  for (const PackedSpheres& spheres : some()) {
    const double volume = spheres.packing_fraction() * spheres.container.volume();
    EXPECT_NEAR(volume_in(wall_profile(spheres), spheres.container), volume, 0.003 * volume)
        << static_cast<int>(spheres.container.shape);
  }
}

// Counts random points in steps of the distance.
TEST(WallProfile, IsTheShareOfPointsWithinSpheres) {
  Random random(7);
  for (const PackedSpheres& spheres : some()) {
    const WallProfile profile = wall_profile(spheres);
    const Container& container = spheres.container;
    const double radius = container.size.x / 2;
    const double slant = std::hypot(radius, container.size.z);
    std::vector<double> all(profile.packing_fraction.size());
    std::vector<double> within(all.size());
    for (int turn = 0; turn < 400'000; ++turn) {
      const Vec3 point{container.size.x * random.uniform(), container.size.y * random.uniform(),
                       container.size.z * random.uniform()};
      const double from_axis = std::hypot(point.x - radius, point.y - radius);
      double distance = radius - from_axis;
      const bool is_shell = container.shape == Container::Shape::shell;
      if (container.shape == Container::Shape::truncated_cone) {
        const double narrow = container.inner / 2;
        distance = (point.z * (radius - narrow) + container.size.z * (narrow - from_axis)) /
                   std::hypot(radius - narrow, container.size.z);
      }
      if (is_shell || (container.shape == Container::Shape::sphere && container.dimensions == 3))
        distance = radius - std::hypot(from_axis, point.z - radius);
      if (container.shape == Container::Shape::cone)
        distance = (point.z * radius - from_axis * container.size.z) / slant;
      const bool is_around = is_shell || container.shape == Container::Shape::annulus;
      if (!(distance > 0) || (is_around && distance > radius - container.inner / 2)) continue;
      const auto step = static_cast<std::size_t>(distance / profile.width);
      if (step >= all.size()) continue;
      ++all[step];
      for (std::size_t i = 0; i < spheres.size(); ++i)
        if (length(point - spheres.positions[i]) < spheres.radii[i]) ++within[step];
    }
    for (std::size_t k = 0; k < all.size(); ++k) {
      const double expected = profile.packing_fraction[k];
      if (all[k] < 500) continue;
      EXPECT_NEAR(within[k] / all[k], expected, 0.01 + 5 * std::sqrt(expected / all[k]))
          << static_cast<int>(container.shape) << " at " << profile.distance(k);
    }
  }
}

TEST(WallProfile, IsEmptyInABox) {
  const PackedSpheres spheres{Container::periodic({5, 5, 5}), {{1, 1, 1}}, {1}};
  EXPECT_TRUE(wall_profile(spheres).packing_fraction.empty());
}

}  // namespace
}  // namespace hardball::wall_profile_test
