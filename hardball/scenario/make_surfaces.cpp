// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/make_surfaces.hpp"

#include <algorithm>
#include <cmath>

namespace hardball {
namespace {

Vec3 normalized(const Vec3& vector) {
  // Components along an axis stay exact, and no square overflows.
  const double largest = std::max({std::fabs(vector.x), std::fabs(vector.y), std::fabs(vector.z)});
  const Vec3 scaled{vector.x / largest, vector.y / largest, vector.z / largest};
  const double norm = length(scaled);
  return {scaled.x / norm, scaled.y / norm, scaled.z / norm};
}

Shape make_shape(const WallDescription& wall) {
  switch (wall.shape) {
    case WallDescription::Shape::cylinder:
      return Cylinder(normalized(wall.direction), wall.radius);
    case WallDescription::Shape::sphere:
      return HollowSphere(wall.radius);
    case WallDescription::Shape::plane:
      break;
  }
  const Vec3 normal = normalized(wall.direction);
  if (wall.amplitude > 0) return OscillatingPlane(normal, wall.amplitude, wall.frequency);
  return Plane(normal);
}

}  // namespace

std::vector<Surface> make_surfaces(const Scenario& scenario) {
  std::vector<Surface> surfaces;
  const auto material = [&](const auto& description) {
    return SurfaceMaterial{description.restitution, description.temperature, scenario.seed};
  };
  for (const WallDescription& wall : scenario.walls) {
    surfaces.emplace_back(make_shape(wall), wall.point, wall.velocity, material(wall));
  }
  for (const ObstacleDescription& obstacle : scenario.obstacles) {
    surfaces.emplace_back(Obstacle(obstacle.radius), obstacle.position, Vec3{}, material(obstacle));
  }
  return surfaces;
}

}  // namespace hardball
