// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/surfaces/surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

// The caller checks the numbers of a surface; here, that the shape can be computed with.
void check_value(std::string_view name, const Vec3& direction) {
  constexpr double kRounding = 1e-12;
  if (std::fabs(dot(direction, direction) - 1) <= kRounding) return;
  throw Error("the " + std::string(name) + " of a surface has the length " +
                  to_text(std::hypot(direction.x, direction.y, direction.z)),
              "surface", "give a unit vector");
}
void check_value(std::string_view name, double number) {
  if (number > 0 && std::isfinite(number * number)) return;
  throw Error("the " + std::string(name) + " of a surface is " + to_text(number), "surface",
              "give a positive number");
}

DoubleDouble<> opening_speed(const auto& shape, const Passage& passage, std::uint32_t feature) {
  if constexpr (requires { shape.opening_speed(passage, feature); }) {
    return shape.opening_speed(passage, feature);
  } else if constexpr (requires { shape.opening_speed(passage); }) {
    return shape.opening_speed(passage);
  } else {
    return shape.gap(passage).coefficients[1];
  }
}

}  // namespace

Surface::Surface(const Shape& shape, const Vec3& point, const Vec3& velocity, const SurfaceMaterial& material)
    : shape_(shape), point_(point), velocity_(velocity), material_(material) {
  std::visit(
      [](const auto& given) {
        for_each_value(given, [](const auto& field, const auto& value) { check_value(field.name, value); });
      },
      shape);
  if (!std::isfinite(dot(point, point)) || !std::isfinite(dot(velocity, velocity))) {
    throw Error("a point or a velocity of a surface is not finite", "surface", "give finite numbers");
  }
  check_material(material, "surface");
}

Surface Surface::moved(const Time& moment, const Vec3& point, const Vec3& velocity) const {
  if (!std::isfinite(moment.high))
    throw Error("a moment of a surface is not finite", "surface", "give a time");
  Surface moved(shape_, point, velocity, material_);
  moved.since_ = moment;
  return moved;
}

std::string_view Surface::name() const {
  return std::visit(
      [](const auto& shape) -> std::string_view {
        if constexpr (requires { shape.name(); }) return shape.name();
        return shape.kName;
      },
      shape_);
}

const SurfaceMaterial& Surface::material_of(std::uint32_t feature) const {
  const SurfaceMaterial* const own = mesh() ? mesh()->material_of(feature) : nullptr;
  return own ? *own : material_;
}

Shape oscillating(const Shape& plane, double amplitude, double frequency) {
  if (amplitude == 0 && frequency == 0) return plane;
  const Plane* const at_rest = std::get_if<Plane>(&plane);
  if (at_rest) return OscillatingPlane(at_rest->normal(), amplitude, frequency);
  throw Error("a surface oscillates that is not a plane", "surface", "let it rest, or move evenly");
}

Shape Surface::shape_at_rest() const {
  return std::visit(
      [](const auto& shape) -> Shape {
        if constexpr (requires { shape.rest(); }) return shape.rest();
        return shape;
      },
      shape_);
}

const Vec3* Surface::normal() const {
  return std::visit(
      [](const auto& shape) -> const Vec3* {
        if constexpr (requires { shape.normal(); }) return &shape.normal();
        return nullptr;
      },
      shape_);
}

Extent Surface::room() const {
  const Extent room = std::visit([](const auto& shape) { return shape.room(); }, shape_);
  return {point_ + room.low, point_ + room.high};
}

double Surface::largest_sphere() const {
  return std::visit(
      [](const auto& shape) {
        if constexpr (requires { shape.largest_sphere(); }) return shape.largest_sphere();
        return std::numeric_limits<double>::infinity();
      },
      shape_);
}

Surface Surface::at_rest(const Time& moment) const {
  Vec3 point = point_ + path_until(moment);
  std::visit(
      [&](const auto& shape) {
        if constexpr (requires { shape.displacement_at(moment); }) point += shape.displacement_at(moment);
      },
      shape_);
  return {shape_at_rest(), point};
}

Passage Surface::passage_of(const Motion& motion, const Path& path, double radius) const {
  Time start = path.time;
  Vec3 position = path.position;
  Vec3 velocity = path.velocity;
  double growth = 0;
  if (motion.has_growth()) {
    start = later(start, motion.growth().begin);
    position = motion.position_at(path, start);
    growth = radius * motion.growth().rate;
  }
  if (start < since_) {
    start = since_;
    const State state = motion.state_at(path, start);
    position = state.position;
    velocity = state.velocity;
  }
  Passage passage{precise_difference(position, point_),
                  precise_difference(velocity, velocity_),
                  precise(motion.gravity()),
                  radius * motion.scale_at(start),
                  growth,
                  start};
  if (velocity_ == Vec3{}) return passage;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double v = velocity_[axis];
    passage.position[axis] = passage.position[axis] - (product(v, start.high) + product(v, start.low));
    if (since_ == Time()) continue;
    passage.position[axis] = passage.position[axis] + (product(v, since_.high) + product(v, since_.low));
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

SurfaceContact Surface::first_contact(const Motion& motion, const Path& path, double radius, const Time& now,
                                      double until) const {
  const Passage passage = passage_of(motion, path, radius);
  // Differences of times are rounded.
  constexpr double kRounding = 0x1p-50;
  const double begin = std::max(0.0, (1 - kRounding) * duration(passage.start, now));
  const double end = (1 + kRounding) * (until - rounded_down(passage.start));
  const MeshContact found = mesh()->first_contact(passage, begin, std::max(begin, end));
  return {after(passage.start, found.wait), found.feature};
}

Vec3 Surface::towards_feature(const Motion& motion, const Path& path, double radius, const Time& moment,
                              std::uint32_t feature) const {
  const Passage passage = passage_of(motion, path, radius);
  return mesh()->towards(passage, duration(passage.start, moment), feature);
}

bool Surface::is_approached(const Motion& motion, const Path& path, double radius,
                            std::uint32_t feature) const {
  const Passage passage = passage_of(motion, path, radius);
  const DoubleDouble<> speed =
      std::visit([&](const auto& shape) { return opening_speed(shape, passage, feature); }, shape_);
  return speed.high < 0 || (speed.high == 0 && speed.low < 0);
}

double Surface::free_until(const Motion& motion, const Path& path, double radius, const Time& now) const {
  const double size = radius * motion.scale_at(now);
  const double growth = std::max(0.0, radius * motion.growth().rate);
  // More than distance, speed and wait are rounded by.
  constexpr double kRounding = 0x1p-40;
  const Vec3 position = motion.position_at(path, now);
  const double age = now.high - since_.high;
  const double scale = length(position) + length(point_) + length(velocity_) * std::fabs(age) + size;
  const Vec3 relative = (position - age * velocity_) - point_;
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

// What an even motion covers.
Vec3 Surface::path_until(const Time& moment) const {
  if (since_ == Time()) return moment.high * velocity_ + moment.low * velocity_;
  return duration(since_, moment) * velocity_;
}

Vec3 Surface::relative_position(const Vec3& position, const Time& moment) const {
  Vec3 relative = (position - point_) - path_until(moment);
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
