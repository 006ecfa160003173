// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/surfaces/surface.hpp"

#include <algorithm>
#include <cmath>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

// The caller checks the numbers of a surface; here, that the shape can be computed with.
void check_direction(const Vec3& direction, const char* name) {
  constexpr double kRounding = 1e-12;
  if (std::fabs(dot(direction, direction) - 1) <= kRounding) return;
  throw Error(std::string("the ") + name + " of a surface has the length " +
                  to_text(std::hypot(direction.x, direction.y, direction.z)),
              "surface", "give a unit vector");
}

void check_radius(double radius) {
  if (radius > 0 && std::isfinite(radius)) return;
  throw Error("the radius of a surface is " + to_text(radius), "surface", "give a positive number");
}

void check(const Plane& plane) {
  check_direction(plane.normal(), "normal");
}
void check(const OscillatingPlane& plane) {
  check_direction(plane.normal(), "normal");
  if (plane.amplitude() > 0 && plane.frequency() > 0 && std::isfinite(plane.amplitude() * plane.frequency()))
    return;
  throw Error("a surface oscillates with amplitude " + to_text(plane.amplitude()) + " and frequency " +
                  to_text(plane.frequency()),
              "surface", "give positive numbers");
}
void check(const Cylinder& cylinder) {
  check_direction(cylinder.axis(), "axis");
  check_radius(cylinder.radius());
}
void check(const HollowSphere& sphere) {
  check_radius(sphere.radius());
}
void check(const Obstacle& obstacle) {
  check_radius(obstacle.radius());
}
void check(const Cone& cone) {
  check_direction(cone.axis(), "axis");
  if (cone.slope() > 0 && std::isfinite(cone.slope() * cone.slope())) return;
  throw Error("the slope of a cone is " + to_text(cone.slope()), "surface", "give a positive number");
}

DoubleDouble<> opening_speed(const auto& shape, const Passage& passage) {
  if constexpr (requires { shape.opening_speed(passage); }) {
    return shape.opening_speed(passage);
  } else {
    return shape.gap(passage).coefficients[1];
  }
}

}  // namespace

Surface::Surface(const Shape& shape, const Vec3& point, const Vec3& velocity, const SurfaceMaterial& material)
    : shape_(shape), point_(point), velocity_(velocity), material_(material) {
  std::visit([](const auto& given) { check(given); }, shape);
  if (!std::isfinite(dot(point, point)) || !std::isfinite(dot(velocity, velocity))) {
    throw Error("a point or a velocity of a surface is not finite", "surface", "give finite numbers");
  }
  check_material(material, "surface");
}

std::string_view Surface::name() const {
  return std::visit([](const auto& shape) { return std::string_view(shape.kName); }, shape_);
}

Passage Surface::passage_of(const Motion& motion, const Path& path, double radius) const {
  Time start = path.time;
  Vec3 position = path.position;
  double growth = 0;
  if (motion.has_growth()) {
    start = later(start, motion.growth().begin);
    position = motion.position_at(path, start);
    growth = radius * motion.growth().rate;
  }
  Passage passage{precise_difference(position, point_),
                  precise_difference(path.velocity, velocity_),
                  precise(motion.gravity()),
                  radius * motion.scale_at(start),
                  growth,
                  start};
  if (velocity_ == Vec3{}) return passage;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    passage.position[axis] =
        passage.position[axis] - (product(velocity_[axis], start.high) + product(velocity_[axis], start.low));
  }
  return passage;
}

Time Surface::contact_time(const Motion& motion, const Path& path, double radius) const {
  const Passage passage = passage_of(motion, path, radius);
  return std::visit(
      [&](const auto& shape) {
        if constexpr (requires { shape.contact_time(passage); }) {
          return shape.contact_time(passage);
        } else {
          if constexpr (requires { shape.is_missed(passage); }) {
            if (shape.is_missed(passage)) return kNever;
          }
          return after(passage.start, earliest_descent(shape.gap(passage)));
        }
      },
      shape_);
}

bool Surface::is_approached(const Motion& motion, const Path& path, double radius) const {
  const Passage passage = passage_of(motion, path, radius);
  const DoubleDouble<> speed =
      std::visit([&](const auto& shape) { return opening_speed(shape, passage); }, shape_);
  return speed.high < 0 || (speed.high == 0 && speed.low < 0);
}

double Surface::free_until(const Motion& motion, const Path& path, double radius, const Time& now) const {
  const double size = radius * motion.scale_at(now);
  const double growth = std::max(0.0, radius * motion.growth().rate);
  // More than distance, speed and wait are rounded by.
  constexpr double kRounding = 0x1p-40;
  const Vec3 position = motion.position_at(path, now);
  const double scale = length(position) + length(point_) + length(velocity_) * std::fabs(now.high) + size;
  const Vec3 relative = (position - now.high * velocity_) - point_;
  const double gap = std::visit(
      [&](const auto& shape) {
        const double distance = shape.distance(relative) - size - kRounding * scale;
        if constexpr (requires { shape.amplitude(); }) return distance - shape.amplitude();
        return distance;
      },
      shape_);
  if (!(gap > 0)) return rounded_down(now);
  const double speed = length(motion.velocity_at(path, now) - velocity_) + growth;
  const double acceleration = length(motion.gravity());
  const double wait = 2 * gap / (speed + std::sqrt(speed * speed + 2 * acceleration * gap));
  return rounded_down(now) + (1 - kRounding) * wait;
}

Vec3 Surface::relative_position(const Vec3& position, const Time& moment) const {
  Vec3 relative = (position - point_) - (moment.high * velocity_ + moment.low * velocity_);
  std::visit(
      [&](const auto& shape) {
        if constexpr (requires { shape.displacement_at(moment); }) relative -= shape.displacement_at(moment);
      },
      shape_);
  return relative;
}

double Surface::distance(const Vec3& position, const Time& moment) const {
  const Vec3 relative = relative_position(position, moment);
  return std::visit([&](const auto& shape) { return shape.distance(relative); }, shape_);
}

Vec3 Surface::direction(const Vec3& position, const Time& moment) const {
  const Vec3 relative = relative_position(position, moment);
  const Vec3 towards = std::visit([&](const auto& shape) { return shape.towards(relative); }, shape_);
  const double distance = length(towards);
  if (!(distance > 0)) return {1, 0, 0};  // from the very middle every direction leads there
  if (distance == 1) return towards;
  return (1 / distance) * towards;
}

Vec3 Surface::velocity_at(const Time& moment) const {
  Vec3 velocity = velocity_;
  std::visit(
      [&](const auto& shape) {
        if constexpr (requires { shape.velocity_at(moment); }) velocity += shape.velocity_at(moment);
      },
      shape_);
  return velocity;
}

}  // namespace hardball
