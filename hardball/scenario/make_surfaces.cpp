// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/make_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <variant>

#include "hardball/errors/error.hpp"
#include "hardball/world/world.hpp"

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
    case WallDescription::Shape::cone:
      return Cone(normalized(wall.direction), wall.slope);
    case WallDescription::Shape::sphere:
      return HollowSphere(wall.radius);
    case WallDescription::Shape::plane:
      break;
  }
  const Vec3 normal = normalized(wall.direction);
  if (wall.amplitude > 0) return OscillatingPlane(normal, wall.amplitude, wall.frequency);
  return Plane(normal);
}

// A surface that this box may have. Error, with the place of its description: it may not.
Surface checked(const Box& box, const Shape& shape, const Vec3& point, const Vec3& velocity,
                const SurfaceMaterial& material, const std::string& where) {
  try {
    const Surface surface(shape, point, velocity, material);
    static_cast<void>(World(box, {}, {surface}));
    return surface;
  } catch (const Error& error) {
    throw Error(error.problem(), where, error.remedy());
  }
}

}  // namespace

std::vector<Surface> make_surfaces(const Scenario& scenario, const Box& box) {
  std::vector<Surface> surfaces;
  const auto material = [&](const auto& description) {
    return SurfaceMaterial{description.restitution, description.temperature, scenario.seed};
  };
  for (const WallDescription& wall : scenario.walls) {
    surfaces.push_back(checked(box, make_shape(wall), wall.point, wall.velocity, material(wall), wall.where));
  }
  for (const ObstacleDescription& obstacle : scenario.obstacles) {
    surfaces.push_back(
        checked(box, Obstacle(obstacle.radius), obstacle.position, {}, material(obstacle), obstacle.where));
  }
  return surfaces;
}

Interval interval_between(std::span<const Surface> surfaces, std::size_t axis) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Interval interval{-kInfinity, kInfinity};
  const auto enclose = [&](double center, double radius) {
    interval.low = std::max(interval.low, center - radius);
    interval.high = std::min(interval.high, center + radius);
  };
  const auto bound = [&](const Vec3& normal, double coordinate, double amplitude) {
    if (normal[axis] == 1) interval.low = std::max(interval.low, coordinate - amplitude);
    if (normal[axis] == -1) interval.high = std::min(interval.high, coordinate + amplitude);
  };
  for (const Surface& surface : surfaces) {
    const double coordinate = surface.point()[axis];
    const Shape& shape = surface.shape();
    if (const auto* sphere = std::get_if<HollowSphere>(&shape)) {
      enclose(coordinate, sphere->radius());
    } else if (const auto* cylinder = std::get_if<Cylinder>(&shape)) {
      if (cylinder->axis()[axis] == 0) enclose(coordinate, cylinder->radius());
    } else if (const auto* cone = std::get_if<Cone>(&shape)) {
      if (cone->axis()[axis] == 1) interval.low = std::max(interval.low, coordinate);
      if (cone->axis()[axis] == -1) interval.high = std::min(interval.high, coordinate);
    } else if (const auto* plane = std::get_if<Plane>(&shape)) {
      bound(plane->normal(), coordinate, 0);
    } else if (const auto* moving = std::get_if<OscillatingPlane>(&shape)) {
      bound(moving->normal(), coordinate, moving->amplitude());
    }
  }
  return interval;
}

}  // namespace hardball
