// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/world/walls.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <variant>

#include "hardball/geometry/contact_time.hpp"
#include "hardball/surfaces/polynomial.hpp"
#include "hardball/world/totals.hpp"

namespace hardball {
namespace {

bool is_periodic(const Box& box) {
  return box.is_periodic(0) || box.is_periodic(1) || box.is_periodic(2);
}

bool has_images(const Setting& setting, const Surface& surface) {
  return is_periodic(setting.box()) && std::holds_alternative<Obstacle>(surface.shape());
}

// Calls visit(shift) with the displacement of each image of the obstacles at rest that may reach into a part
// of space.
template <class Visit>
void for_each_image_of_obstacles(const Setting& setting, const Bounds& part, Visit&& visit) {
  const Bounds& bounds = setting.obstacles().bounds();
  const Box& box = setting.box();
  Image low;
  Image high;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!box.is_periodic(axis)) continue;
    const double size = box.size()[axis];
    low[axis] = static_cast<std::int32_t>(std::ceil((part.low[axis] - bounds.high[axis]) / size));
    high[axis] = static_cast<std::int32_t>(std::floor((part.high[axis] - bounds.low[axis]) / size));
  }
  Image image;
  for (image[0] = low[0]; image[0] <= high[0]; ++image[0]) {
    for (image[1] = low[1]; image[1] <= high[1]; ++image[1]) {
      for (image[2] = low[2]; image[2] <= high[2]; ++image[2]) visit(box.shift(image));
    }
  }
}

// Where a sphere may be from `now` until another time.
Bounds reached(const Motion& motion, const Path& path, double radius, const Time& now, double until) {
  constexpr double kRounding = 0x1p-40;
  const State state = motion.state_at(path, now);
  const double largest_radius = radius * motion.largest_scale();
  const double elapsed = std::max(0.0, until - rounded_down(now)) * (1 + kRounding);
  Bounds bounds{state.position, state.position};
  for_each_axis([&](auto axis) {
    const double velocity = state.velocity[axis];
    const double gravity = motion.gravity()[axis];
    const double straight = velocity != 0 ? velocity * elapsed : 0;
    const double fall = gravity != 0 ? 0.5 * std::fabs(gravity) * elapsed * elapsed : 0;
    const double margin =
        largest_radius + fall + kRounding * (std::fabs(state.position[axis]) + largest_radius);
    bounds.low[axis] += std::min(straight, 0.0) - margin;
    bounds.high[axis] += std::max(straight, 0.0) + margin;
  });
  return bounds;
}

// How far from a face a sphere is.
double gap_to_face(const Box& box, const Vec3& position, double radius, std::size_t axis, bool upper) {
  return upper ? (box.size()[axis] - radius) - position[axis] : position[axis] - radius;
}

// When a sphere touches a face; kNever if never.
Time time_of_face(const Setting& setting, const Path& path, double radius, std::size_t axis, bool upper) {
  const Motion& motion = setting.motion();
  const double approach = upper ? path.velocity[axis] : -path.velocity[axis];
  if (motion.has_growth()) {
    const Time start = later(path.time, motion.growth().begin);
    const double gap = gap_to_face(setting.box(), motion.position_at(path, start),
                                   radius * motion.growth().scale_at(start), axis, upper);
    return after(start, time_to_plane(gap, approach + radius * motion.growth().rate));
  }
  const double gap = gap_to_face(setting.box(), path.position, radius, axis, upper);
  const double pull = upper ? motion.gravity()[axis] : -motion.gravity()[axis];
  if (pull == 0) return after(path.time, time_to_plane(gap, approach));
  return after(path.time, earliest_descent({{{{gap, 0}, {-approach, 0}, {-0.5 * pull, 0}}}}));
}

}  // namespace

bool has_walls(const Setting& setting) {
  const Box& box = setting.box();
  return box.is_wall(0) || box.is_wall(1) || box.is_wall(2) || !setting.surfaces().empty();
}

bool is_uniform(const Setting& setting) {
  return setting.motion().is_straight() && setting.surfaces().empty() && setting.box().has_plain_faces();
}

bool has_images_of_obstacles(const Setting& setting) {
  return is_periodic(setting.box()) && !setting.obstacles().is_empty();
}

Event next_wall_event(const Setting& setting, SphereId id, const Path& path, double radius, const Time& now) {
  Event next;
  const auto note = [&](const Time& time, std::uint32_t wall) {
    const Event event{time, EventKind::wall, id, wall, {}};
    if (event < next) next = event;
  };
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!setting.box().is_wall(axis)) continue;
    for (const bool upper : {false, true}) {
      note(time_of_face(setting, path, radius, axis, upper), face_of(axis, upper));
    }
  }
  for (const std::uint32_t number : setting.other_surfaces()) {
    const Surface& surface = setting.surface(number);
    if (surface.free_until(setting.motion(), path, radius, now) > next.time.high) continue;
    note(surface.contact_time(setting.motion(), path, radius), number);
  }
  return next;
}

Event next_wall_event(const World& world, Slot slot, const Time& now) {
  return next_wall_event(world, world.id(slot), world.path(slot), world.base_radius(slot), now);
}

Event next_obstacle_event(const Setting& setting, SphereId id, const Path& path, double radius,
                          const Time& now, double until) {
  Event next;
  if (setting.obstacles().is_empty()) return next;
  const Bounds part = reached(setting.motion(), path, radius, now, until);
  for_each_image_of_obstacles(setting, part, [&](const Vec3& shift) {
    const Path image{path.position - shift, path.velocity, path.time};
    setting.obstacles().for_each_in({part.low - shift, part.high - shift}, [&](std::uint32_t number) {
      const Surface& surface = setting.surface(number);
      if (surface.free_until(setting.motion(), image, radius, now) > std::min(until, next.time.high)) return;
      const Event event{
          surface.contact_time(setting.motion(), image, radius), EventKind::wall, id, number, {}};
      if (event < next) next = event;
    });
  });
  return next;
}

Event next_obstacle_event(const World& world, Slot slot, const Time& now, double until) {
  return next_obstacle_event(world, world.id(slot), world.path(slot), world.base_radius(slot), now, until);
}

bool may_meet_wall_of_any_kind(const World& world, Slot slot, double time, const Time& now) {
  if (!(time < kNever.high)) return true;
  const Path& path = world.path(slot);
  const double radius = world.base_radius(slot);
  const double largest_radius = radius * world.motion().largest_scale();
  constexpr double kRounding = 1 + 0x1p-48;
  const double elapsed = (time - rounded_down(path.time)) * kRounding;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!world.box().is_wall(axis)) continue;
    const double gravity = world.motion().gravity()[axis];
    const double way =
        elapsed * (std::fabs(path.velocity[axis]) + 0.5 * elapsed * std::fabs(gravity)) * kRounding;
    const double below = gap_to_face(world.box(), path.position, largest_radius, axis, false);
    const double above = gap_to_face(world.box(), path.position, largest_radius, axis, true);
    if (std::min(below, above) <= way) return true;
  }
  for (const std::uint32_t number : world.other_surfaces()) {
    if (world.surface(number).free_until(world.motion(), path, radius, now) < time) return true;
  }
  return false;
}

double distance_to_surfaces(const Setting& setting, const Vec3& position, const Time& moment) {
  double least = std::numeric_limits<double>::infinity();
  const auto note = [&](const Surface& surface) {
    const Vec3 image = nearest_image_of(setting, surface, position);
    least = std::min(least, surface.distance(position - image, moment));
  };
  for (const std::uint32_t number : setting.other_surfaces()) note(setting.surface(number));
  if (setting.obstacles().is_empty()) return least;
  constexpr double kRoundedUp = 1 + 0x1p-40;
  const Vec3 half = 0.5 * setting.box().size();
  double farthest = least;
  for_each_image_of_obstacles(setting, {position - half, position + half}, [&](const Vec3& shift) {
    setting.obstacles().for_each_within(
        farthest, [&](const Bounds& bounds) { return distance_to(bounds, position - shift); },
        [&](std::uint32_t number) {
          note(setting.surface(number));
          farthest = kRoundedUp * std::max(0.0, least);
        });
  });
  return least;
}

bool is_clear_of_surfaces(const Setting& setting, const Vec3& position, double radius, const Time& moment) {
  const auto is_clear = [&](const Surface& surface) {
    const Vec3 image = nearest_image_of(setting, surface, position);
    return surface.distance(position - image, moment) >= radius;
  };
  for (const std::uint32_t number : setting.other_surfaces()) {
    if (!is_clear(setting.surface(number))) return false;
  }
  if (setting.obstacles().is_empty()) return true;
  const double reach = radius * (1 + 0x1p-40) + 0x1p-40 * length(position);
  const Vec3 extent{reach, reach, reach};
  bool clear = true;
  for_each_image_of_obstacles(setting, {position - extent, position + extent}, [&](const Vec3& shift) {
    setting.obstacles().for_each_in(
        {position - extent - shift, position + extent - shift},
        [&](std::uint32_t number) { clear = clear && is_clear(setting.surface(number)); });
  });
  return clear;
}

double accessible_volume(const Setting& setting) {
  const Box& box = setting.box();
  double volume = box.volume();
  double obstacles = 0;
  bool is_enclosed = false;
  for (const Surface& surface : setting.surfaces()) {
    const Shape& shape = surface.shape();
    if (const auto* obstacle = std::get_if<Obstacle>(&shape)) {
      obstacles += box.sphere_volume(obstacle->radius());
      continue;
    }
    if (is_enclosed) return std::numeric_limits<double>::quiet_NaN();
    is_enclosed = true;
    volume = std::visit(
        [&](const auto& enclosing) {
          if constexpr (requires { enclosing.volume(box, surface.point()); })
            return enclosing.volume(box, surface.point());
          return std::numeric_limits<double>::quiet_NaN();
        },
        shape);
  }
  return volume - obstacles;
}

double packing_fraction(const World& world, const Time& moment) {
  return packing_fraction(world, sphere_volume(world, moment));
}

double packing_fraction(const Setting& setting, double sphere_volume) {
  const double fraction = sphere_volume / accessible_volume(setting);
  return fraction > 0 ? fraction : std::numeric_limits<double>::quiet_NaN();
}

Vec3 nearest_image_of(const Setting& setting, const Surface& surface, const Vec3& position) {
  if (!has_images(setting, surface)) return {};
  return setting.box().shift(setting.box().nearest_image(position - surface.point()));
}

}  // namespace hardball
