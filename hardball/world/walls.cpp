// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/world/walls.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <type_traits>
#include <variant>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/contact_time.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/surfaces/polynomial.hpp"
#include "hardball/world/totals.hpp"

namespace hardball {
namespace {

bool is_periodic(const Box& box) {
  return box.is_periodic(0) || box.is_periodic(1) || box.is_periodic(2);
}

bool has_images(const Box& box, const Surface& surface) {
  return is_periodic(box) && std::holds_alternative<Obstacle>(surface.shape());
}

// Calls visit(image) for each image of what is within an extent that may reach into a part of space.
template <class Visit>
void for_each_image(const Box& box, const Extent& extent, const Extent& part, Visit&& visit) {
  Image low;
  Image high;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!box.is_periodic(axis)) continue;
    const double size = box.size()[axis];
    low[axis] = static_cast<std::int32_t>(std::ceil((part.low[axis] - extent.high[axis]) / size));
    high[axis] = static_cast<std::int32_t>(std::floor((part.high[axis] - extent.low[axis]) / size));
  }
  Image image;
  for (image[0] = low[0]; image[0] <= high[0]; ++image[0]) {
    for (image[1] = low[1]; image[1] <= high[1]; ++image[1]) {
      for (image[2] = low[2]; image[2] <= high[2]; ++image[2]) visit(image);
    }
  }
}

// Calls visit(image) for each image of what is within an extent that may have the point nearest to another:
// that is no farther than half a period along any axis.
template <class Visit>
void for_each_image_nearby(const Box& box, const Extent& extent, const Vec3& position, Visit&& visit) {
  const Vec3 half = 0.5 * box.size();
  for_each_image(box, extent, {position - half, position + half}, visit);
}

Extent around(const Vec3& position, double distance) {
  return Extent{position, position}.grown(distance);
}

// Where a mesh is at time zero, thickness included. In a periodic box it rests.
Extent extent_of(const Surface& mesh) {
  const Extent& extent = mesh.mesh()->mesh().extent();
  return Extent{mesh.point() + extent.low, mesh.point() + extent.high}.grown(mesh.mesh()->thickness());
}

// The distance from a point to a mesh or the nearest of its images, see Surface::distance.
double distance_to_mesh(const Box& box, const Surface& mesh, const Vec3& position, const Time& moment) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const bool is_inside = mesh.mesh()->spheres() == MeshSide::inside;
  double distance = is_inside ? -kInfinity : kInfinity;
  for_each_image_nearby(box, extent_of(mesh), position, [&](const Image& image) {
    const double to_image = mesh.distance(position - box.shift(image), moment);
    distance = is_inside ? std::max(distance, to_image) : std::min(distance, to_image);
  });
  return distance;
}

// The distance from a point to the nearest obstacle at rest or image of one; infinite if there are none.
double distance_to_obstacles(const Setting& setting, const Vec3& position) {
  double least = std::numeric_limits<double>::infinity();
  if (setting.obstacles().is_empty()) return least;
  const Box& box = setting.box();
  constexpr double kRoundedUp = 1 + 0x1p-40;
  double farthest = least;
  for_each_image_nearby(box, setting.obstacles().extent(), position, [&](const Image& image) {
    const Vec3 shift = box.shift(image);
    setting.obstacles().for_each_within(
        farthest, [&](const FourExtents& extents) { return distance_to(extents, position - shift); },
        [&](std::uint32_t number) {
          least = std::min(least, distance_to_surface(box, setting.surface(number), position, Time()));
          farthest = kRoundedUp * std::max(0.0, least);
        });
  });
  return least;
}

// Where a sphere may be from `now` until another time.
Extent reached(const Motion& motion, const Path& path, double radius, const Time& now, double until) {
  constexpr double kRounding = 0x1p-40;
  const State state = motion.state_at(path, now);
  const double largest_radius = radius * motion.largest_scale();
  const double elapsed = std::max(0.0, until - rounded_down(now)) * (1 + kRounding);
  Extent extent{state.position, state.position};
  for_each_axis([&](auto axis) {
    const double velocity = state.velocity[axis];
    const double gravity = motion.gravity()[axis];
    const double straight = velocity != 0 ? velocity * elapsed : 0;
    const double fall = gravity != 0 ? 0.5 * std::fabs(gravity) * elapsed * elapsed : 0;
    const double margin =
        largest_radius + fall + kRounding * (std::fabs(state.position[axis]) + largest_radius);
    extent.low[axis] += std::min(straight, 0.0) - margin;
    extent.high[axis] += std::max(straight, 0.0) + margin;
  });
  return extent;
}

// How far from a face a sphere is.
double gap_to_face(const Box& box, const Vec3& position, double radius, std::size_t axis, bool upper) {
  return upper ? (box.size()[axis] - radius) - position[axis] : position[axis] - radius;
}

// Where planes and faces of the box end a tube or a cone, along its axis from its point [L].
struct Ends {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
};

// The volume of a tube between two ends, or of a cone from its apex [L^3], in a flat box of a cone [L^2]. A
// difference of powers would lose digits where the ends are close.
double volume_between(const Cylinder& tube, const Box& /*box*/, const Ends& ends) {
  return std::numbers::pi * tube.radius() * tube.radius() * (ends.high - ends.low);
}
double volume_between(const Pillar& pillar, const Box& box, const Ends& ends) {
  return volume_between(Cylinder(pillar.axis(), pillar.radius()), box, ends);
}
double volume_between(const Cone& cone, const Box& box, const Ends& ends) {
  const double near = std::max(0.0, ends.low);
  const double far = std::max(0.0, ends.high);
  const double slope = cone.slope();
  if (box.is_flat()) return slope * (far - near) * (far + near);
  return std::numbers::pi / 3 * slope * slope * (far - near) * (far * far + far * near + near * near);
}

// The volume of a tube, a pillar or a cone that planes across its axis cut off, or faces of the box [L^3];
// NaN if others do, or it goes on.
template <class S>
double volume_between_planes(const Setting& setting, const Surface& enclosing, const S& shape) {
  Ends ends;
  if (const std::size_t along = axis_along(shape.axis()); along < kAxes && setting.box().is_bounded(along)) {
    const double behind = shape.axis()[along] > 0 ? -enclosing.point()[along]
                                                  : enclosing.point()[along] - setting.box().size()[along];
    ends = {behind, behind + setting.box().size()[along]};
  }
  for (const Surface& surface : setting.surfaces()) {
    const Vec3* const normal = surface.normal();
    if (normal == nullptr) continue;
    const auto* const plane = std::get_if<Plane>(&surface.shape());
    const bool is_low = *normal == shape.axis();
    const bool is_across = plane && (is_low || *normal == -shape.axis());
    const bool stays = surface.velocity() == enclosing.velocity() && surface.since() == enclosing.since();
    if (!is_across || !stays) return std::numeric_limits<double>::quiet_NaN();
    const double along = dot(surface.point() - enclosing.point(), shape.axis());
    if (is_low) {
      ends.low = std::max(ends.low, along);
    } else {
      ends.high = std::min(ends.high, along);
    }
  }
  const double volume = volume_between(shape, setting.box(), ends);
  return std::isfinite(volume) ? volume : std::numeric_limits<double>::quiet_NaN();
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

bool has_images_of_solids(const Setting& setting) {
  return is_periodic(setting.box()) && setting.has_solids();
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

Event next_solid_event(const Setting& setting, SphereId id, const Path& path, double radius, const Time& now,
                       double until) {
  Event next;
  if (!setting.has_solids()) return next;
  double end = until;
  const auto note = [&](const Time& time, std::uint32_t number) {
    const Event event{time, EventKind::wall, id, number, {}};
    if (!(event < next)) return;
    next = event;
    end = std::min(until, next.time.high);
  };
  if (!setting.obstacles().is_empty()) {
    const Extent part = reached(setting.motion(), path, radius, now, until);
    for_each_image(setting.box(), setting.obstacles().extent(), part, [&](const Image& image) {
      const Vec3 shift = setting.box().shift(image);
      const Path passing{path.position - shift, path.velocity, path.time};
      setting.obstacles().for_each_in({part.low - shift, part.high - shift}, [&](std::uint32_t number) {
        const Surface& surface = setting.surface(number);
        if (surface.free_until(setting.motion(), passing, radius, now) > end) return;
        note(surface.contact_time(setting.motion(), passing, radius), number);
      });
    });
  }
  for (const std::uint32_t number : setting.meshes()) {
    const Surface& mesh = setting.surface(number);
    note(first_contact_with_mesh(setting.box(), setting.motion(), mesh, path, radius, now, end).contact.time,
         number);
  }
  return next;
}

ImageContact first_contact_with_mesh(const Box& box, const Motion& motion, const Surface& mesh,
                                     const Path& path, double radius, const Time& now, double until) {
  if (!is_periodic(box)) return {mesh.first_contact(motion, path, radius, now, until), {}};
  ImageContact first;
  double end = until;
  for_each_image(box, extent_of(mesh), reached(motion, path, radius, now, until), [&](const Image& image) {
    const Path passing{path.position - box.shift(image), path.velocity, path.time};
    const SurfaceContact found = mesh.first_contact(motion, passing, radius, now, end);
    if (!(found.time < first.contact.time)) return;
    first = {found, image};
    end = std::min(until, found.time.high);
  });
  return first;
}

MeshTouch touch_of_mesh(const Setting& setting, std::uint32_t number, const Path& path, double radius,
                        const Time& moment) {
  const Surface& mesh = setting.surface(number);
  const double until = std::nextafter(moment.high, std::numeric_limits<double>::infinity());
  // A search that begins before the contact has fewer features to look at than one that begins in touch.
  const double speed = length(setting.motion().state_at(path, moment).velocity);
  const Time arriving = later(path.time, Time(moment.high - 0.25 * radius / speed));
  const auto [contact, image] =
      first_contact_with_mesh(setting.box(), setting.motion(), mesh, path, radius, arriving, until);
  HARDBALL_CHECK(contact.time == moment);
  const Path passing{path.position - setting.box().shift(image), path.velocity, path.time};
  return {image, contact.feature,
          mesh.towards_feature(setting.motion(), passing, radius, moment, contact.feature)};
}

Event next_solid_event(const World& world, Slot slot, const Time& now, double until) {
  return next_solid_event(world, world.id(slot), world.path(slot), world.base_radius(slot), now, until);
}

std::size_t group_count_of(const Surface& surface) {
  return surface.mesh() ? surface.mesh()->mesh().group_count() : 1;
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

double distance_to_surface(const Box& box, const Surface& surface, const Vec3& position, const Time& moment) {
  if (surface.mesh()) return distance_to_mesh(box, surface, position, moment);
  return surface.distance(position - nearest_image_of(box, surface, position), moment);
}

double clearance_of_solids(const Setting& setting, const Vec3& position, double enough) {
  const Box& box = setting.box();
  double least = std::min(enough, distance_to_obstacles(setting, position));
  for (const std::uint32_t number : setting.meshes()) {
    const Surface& mesh = setting.surface(number);
    for_each_image_nearby(box, extent_of(mesh), position, [&](const Image& image) {
      const Vec3 relative = position - box.shift(image) - mesh.point();
      const double thickness = mesh.mesh()->thickness();
      least = std::min(least, mesh.mesh()->mesh().clearance(relative, least + thickness) - thickness);
    });
  }
  return least;
}

double rounding_near_solids(const Setting& setting) {
  Extent all;
  all.low = all.high = {};
  if (!setting.obstacles().is_empty()) all.enclose(setting.obstacles().extent());
  for (const std::uint32_t number : setting.meshes()) {
    all.enclose(extent_of(setting.surface(number)));
    all.enclose(setting.surface(number).mesh()->mesh().extent());
  }
  return 0x1p-40 * (length(all.low) + length(all.high) + length(setting.box().size()));
}

double distance_to_surfaces(const Setting& setting, const Vec3& position, const Time& moment) {
  double least = std::numeric_limits<double>::infinity();
  const auto note = [&](std::uint32_t number) {
    least = std::min(least, distance_to_surface(setting.box(), setting.surface(number), position, moment));
  };
  ranges::for_each(setting.other_surfaces(), note);
  ranges::for_each(setting.meshes(), note);
  return std::min(least, distance_to_obstacles(setting, position));
}

bool is_clear_of_surfaces(const Setting& setting, const Vec3& position, double radius, const Time& moment) {
  const auto is_clear = [&](std::uint32_t number) {
    return distance_to_surface(setting.box(), setting.surface(number), position, moment) >= radius;
  };
  if (!ranges::all_of(setting.other_surfaces(), is_clear)) return false;
  if (!ranges::all_of(setting.meshes(), is_clear)) return false;
  if (setting.obstacles().is_empty()) return true;
  const double reach = radius * (1 + 0x1p-40) + 0x1p-40 * length(position);
  bool clear = true;
  for_each_image(
      setting.box(), setting.obstacles().extent(), around(position, reach), [&](const Image& image) {
        const Vec3 shift = setting.box().shift(image);
        setting.obstacles().for_each_in(around(position - shift, reach),
                                        [&](std::uint32_t number) { clear = clear && is_clear(number); });
      });
  return clear;
}

double accessible_volume(const Setting& setting) {
  const Box& box = setting.box();
  double volume = box.volume();
  double obstacles = 0;
  bool is_enclosed = false;
  const bool has_planes =
      ranges::any_of(setting.surfaces(), [](const Surface& surface) { return surface.normal(); });
  // Planes end a tube or a cone, and enclose nothing by themselves.
  const bool has_tube = ranges::any_of(setting.surfaces(), [](const Surface& surface) {
    return std::holds_alternative<Cylinder>(surface.shape()) || std::holds_alternative<Cone>(surface.shape());
  });
  for (const Surface& surface : setting.surfaces()) {
    const Shape& shape = surface.shape();
    if (const auto* obstacle = std::get_if<Obstacle>(&shape)) {
      obstacles += box.sphere_volume(obstacle->radius());
      continue;
    }
    if (surface.mesh() && surface.mesh()->spheres() != MeshSide::inside) {
      obstacles += surface.mesh()->displaced_volume();
      continue;
    }
    if (const auto* pillar = std::get_if<Pillar>(&shape)) {
      obstacles += box.is_flat() ? box.sphere_volume(pillar->radius())
                                 : volume_between_planes(setting, surface, *pillar);
      continue;
    }
    if (surface.normal() && has_tube) continue;
    if (is_enclosed) return std::numeric_limits<double>::quiet_NaN();
    is_enclosed = true;
    volume = std::visit(
        [&]<class S>(const S& enclosing) {
          if constexpr (std::is_same_v<S, Cylinder> || std::is_same_v<S, Cone>)
            if (has_planes) return volume_between_planes(setting, surface, enclosing);
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

Vec3 nearest_image_of(const Box& box, const Surface& surface, const Vec3& position) {
  if (!has_images(box, surface)) return {};
  return box.shift(box.nearest_image(position - surface.point()));
}

}  // namespace hardball
