// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/queries/queries.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <type_traits>
#include <variant>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/queries/image_search.hpp"
#include "hardball/surfaces/surface.hpp"
#include "hardball/world/pair_event.hpp"
#include "hardball/world/walls.hpp"

namespace hardball {
namespace {

using namespace image_search;

void check_exclusions_of(Feature question, const World& world) {
  if (!goes_with(question, world.features())) check_exclusions(world.features() | question);
}

// Spheres that pass through each other, and have begun to, do not touch; see are_passing (world.hpp).
double time_to_begin(const World& world, const Time& now, SphereId id, SphereId other_id,
                     const Relative& other) {
  if (are_inside(other.separation, other.reach)) return kInfinity;
  const double wait = time_to_touch(other);
  const Event contact = make_collision(after(now, wait), id, other_id, {});
  return is_recorded(contact, world.last_passage()) ? kInfinity : wait;
}

// The first body that a sphere touches on a path that starts now; `pass(slot)` says through which others it
// passes.
template <class Pass>
std::optional<NextContact> first_contact_on(const World& world, SphereId id, Slot self, const Path& path,
                                            double radius, const Pass& pass, const Time& until) {
  check_exclusions_of(Feature::first_contact, world);
  const Time& now = path.time;
  const Box& box = world.box();
  const double last = until.high < kNever.high ? duration(now, until) : until.high;
  check_end(box, last, "time", "first_contact");
  // Contacts whose time rounds to that of the end count.
  const double end = last + 0x1p-52 * std::fabs(until.high);
  const State from{path.position, path.velocity};
  const Motion& motion = world.motion();
  const auto state_of = [&](Slot slot) { return motion.state_at(world.path(slot), now); };
  const bool some_pass = has_passing_pairs(world) || id == kNoSphere;
  const auto wait_of = [&](Slot slot, const Relative& other) {
    if (some_pass && pass(slot)) return time_to_begin(world, now, id, world.id(slot), other);
    return time_to_touch(other);
  };

  const double half = 0.5 * box.shortest_period();
  double fastest = 0;
  for (Slot slot = 0; is_periodic(box) && slot < world.size(); ++slot) {
    const Vec3 velocity = motion.velocity_at(world.path(slot), now) - path.velocity;
    if (slot != self) fastest = std::max(fastest, dot(velocity, velocity));
  }
  const double stride_to_spheres = half / std::sqrt(fastest);
  const bool has_obstacles = has_images_of_obstacles(world);
  const auto stride = [&](double begin) {
    if (!has_obstacles) return stride_to_spheres;
    const double gravity = length(motion.gravity());
    return std::min(stride_to_spheres, time_to_pass(half, length(path.velocity) + gravity * begin, gravity));
  };

  First first;
  search_in_intervals(stride, end, [&](const Interval& during) {
    first = {};
    note_spheres(world, now, 1, from, radius, self, state_of, wait_of, during, first);
    const Time from_then = after(now, during.begin);
    const Time latest = after(now, during.end);
    for (const Event& wall : {next_wall_event(world, id, path, radius, from_then),
                              next_obstacle_event(world, id, path, radius, from_then, latest.high)}) {
      if (wall.time <= latest) first.record({wall.time, wall.kind, wall.second, {}});
    }
    return first.time < kNever;
  });
  if (!(first.time < kNever) || first.time.high > until.high) return std::nullopt;
  return NextContact{first.time.value(), first.kind, id, first.body};
}

// A ray leaves what it starts in.
double time_to_enter(const Relative& other) {
  const bool is_inside = dot(other.separation, other.separation) < other.reach * other.reach;
  return is_inside ? kInfinity : time_to_touch(other);
}

Vec3 axis_vector(std::size_t axis, double length) {
  Vec3 vector;
  vector[axis] = length;
  return vector;
}

// Calls visit(number, surface) for all surfaces, at rest as they are now.
template <class Visit>
void for_each_surface(const World& world, const Time& now, Visit&& visit) {
  std::uint32_t number = kFaces;
  for (const Surface& surface : world.surfaces()) visit(number++, surface.at_rest(now));
}

template <class Visit>
void for_each_face(const Box& box, Visit&& visit) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!box.is_wall(axis)) continue;
    for (const bool upper : {false, true}) visit(axis, upper);
  }
}

double distance_to_face(const Box& box, const Vec3& point, std::size_t axis, bool upper) {
  return upper ? box.size()[axis] - point[axis] : point[axis];
}

// Records the walls that a ray hits in an interval.
void note_walls(const World& world, const Time& now, const Path& path, const Interval& during, First& first) {
  const Box& box = world.box();
  const auto note = [&](double distance, std::uint32_t number, const Vec3& separation) {
    if (distance <= during.end) first.record({Time(distance), EventKind::wall, number, separation});
  };
  for_each_face(box, [&](std::size_t axis, bool upper) {
    const double approach = upper ? path.velocity[axis] : -path.velocity[axis];
    note(time_to_plane(distance_to_face(box, path.position, axis, upper), approach), face_of(axis, upper),
         {});
  });
  for_each_surface(world, now, [&](std::uint32_t number, const Surface& surface) {
    const auto* obstacle = std::get_if<Obstacle>(&surface.shape());
    if (obstacle == nullptr) return note(surface.contact_time(Motion(), path, 0).high, number, {});
    const Relative other{surface.point() - path.position, -path.velocity, obstacle->radius()};
    for_each_image(box, other, during, [&](const Vec3& separation) {
      note(time_to_enter(Relative{separation, other.velocity, other.reach}), number, separation);
    });
  });
}

void check_vector(const Vec3& vector, const char* name, const char* where) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) check_finite(vector[axis], name, where);
}

// A point folded into the box as it is at `now`.
Vec3 folded(const Box& box, Vec3 point, const Time& now, const char* where) {
  check_vector(point, "a coordinate", where);
  Vec3 no_velocity;
  box.fold(point, no_velocity, now);
  return point;
}

// The unit vector out of what a ray hits.
Vec3 normal_of(const World& world, const Time& now, const First& hit, const Vec3& point, const Vec3& way) {
  const bool is_face = hit.kind == EventKind::wall && hit.body < kFaces;
  if (is_face) return axis_vector(axis_of(hit.body), is_upper(hit.body) ? -1 : 1);
  if (hit.separation != Vec3{}) {
    const Vec3 outwards = way - hit.separation;
    return (1 / length(outwards)) * outwards;
  }
  return -world.surface(hit.body).direction(point, now);
}

// What is nearest: of several bodies, by the order of events.
void note_nearer(const Clearance& other, std::optional<Clearance>& nearest) {
  const auto order = [](const Clearance& body) { return std::tie(body.distance, body.kind, body.body); };
  if (!nearest || order(other) < order(*nearest)) nearest = other;
}

// The image of `apart` that is shortest.
HARDBALL_ALWAYS_INLINE Vec3 shortest_image(const Box& box, const Vec3& apart, const Time& now) {
  const auto shorten = [&box](Vec3& vector, std::size_t axis) {
    vector[axis] -= round_to_integer(vector[axis] * box.inverse_period()[axis]) * box.period()[axis];
  };
  Vec3 shortest = apart;
  for_each_axis([&](auto axis) { shorten(shortest, axis); });
  if (!box.is_sheared()) [[likely]]
    return shortest;
  const auto row = static_cast<std::int32_t>(round_to_integer(apart.y * box.inverse_period().y));
  double least = kInfinity;
  // A row that is farther away may have slid so that its image is nearer.
  for (std::int32_t k = 0; (k - 0.5) * box.period().y < least; ++k) {
    for (const std::int32_t number : {row - k, row + k}) {
      Vec3 image = apart - box.shift({{0, number, 0}}, now);
      shorten(image, 0);
      shorten(image, 2);
      if (length(image) >= least) continue;
      least = length(image);
      shortest = image;
    }
  }
  return shortest;
}

std::optional<Clearance> clearance_of(const World& world, const Time& now, const Vec3& center, double radius,
                                      Slot self) {
  const Box& box = world.box();
  std::optional<Clearance> nearest;
  double least = kInfinity;
  for (Slot slot = 0; slot < world.size(); ++slot) {
    if (slot == self) continue;
    const Vec3 apart = shortest_image(box, world.unfolded_position(slot, now) - center, now);
    const double reach = radius + world.radius(slot, now);
    const double square = dot(apart, apart);
    // Most are certainly farther, and need no square root.
    const double within = least + reach;
    if (within < 0 || square * (1 - kRounding) > within * within) continue;
    const double distance = std::sqrt(square) - reach;
    note_nearer({distance, EventKind::collision, world.id(slot)}, nearest);
    least = nearest->distance;
  }
  for_each_face(box, [&](std::size_t axis, bool upper) {
    const double distance = distance_to_face(box, center, axis, upper) - radius;
    note_nearer({distance, EventKind::wall, face_of(axis, upper)}, nearest);
  });
  for_each_surface(world, now, [&](std::uint32_t number, const Surface& surface) {
    const Vec3 image = nearest_image_of(world, surface, center);
    note_nearer({surface.distance(center - image, now) - radius, EventKind::wall, number}, nearest);
  });
  return nearest;
}

}  // namespace

std::optional<NextContact> first_contact(const World& world, const Time& now, SphereId id,
                                         const Vec3& velocity, const Time& until) {
  const Slot slot = world.slot_of(id);
  world.check_velocity(id, velocity);
  const Path path{world.position(slot, now), velocity, now};
  const auto passes = [&](Slot other) { return pass(world, slot, other); };
  return first_contact_on(world, id, slot, path, world.base_radius(slot), passes, until);
}

std::optional<NextContact> first_contact(const World& world, const Time& now, const Sphere& sphere,
                                         const Time& until) {
  world.check(sphere);
  Path path{sphere.position, sphere.velocity, now};
  world.box().fold(path.position);
  const auto pass = [&](Slot other) {
    return world.interactions().pass(sphere.species, world.species(other)) ||
           (std::isinf(sphere.mass) && world.is_kinematic(other));
  };
  return first_contact_on(world, kNoSphere, kNoSlot, path, sphere.radius, pass, until);
}

std::optional<RayHit> ray(const World& world, const Time& now, const Vec3& origin, const Vec3& direction,
                          double most) {
  constexpr const char* kWhere = "ray";
  check_exclusions_of(Feature::ray, world);
  const Box& box = world.box();
  check_vector(direction, "the direction", kWhere);
  const double norm = length(direction);
  if (!(norm >= kSmallestMagnitude)) {
    throw Error("the direction has the length " + to_text(norm), kWhere,
                "give a finite vector that is not zero");
  }
  check_end(box, most, "distance", kWhere);
  const Path path{folded(box, origin, now, kWhere), (1 / norm) * direction, Time(0)};
  const auto state_of = [&](Slot slot) { return State{world.unfolded_position(slot, now), {}}; };
  const auto wait_of = [](Slot, const Relative& other) { return time_to_enter(other); };
  const double half = 0.5 * box.shortest_period();
  const double scale = world.motion().scale_at(now);
  First first;
  search_in_intervals([half](double) { return half; }, most,
                      [&](const Interval& during) {
                        first = {};
                        note_spheres(world, Time(0), scale, {path.position, path.velocity}, 0, kNoSlot,
                                     state_of, wait_of, during, first);
                        note_walls(world, now, path, during, first);
                        return first.time < kNever;
                      });
  if (!(first.time < kNever)) return std::nullopt;
  const double distance = first.time.value();
  const Vec3 way = distance * path.velocity;
  Vec3 point = path.position + way;
  box.fold(point);
  return RayHit{first.kind, first.body, distance, point, normal_of(world, now, first, point, way)};
}

std::optional<Clearance> clearance(const World& world, const Time& now, const Vec3& point) {
  return clearance_of(world, now, folded(world.box(), point, now, "clearance"), 0, kNoSlot);
}

std::optional<Clearance> clearance(const World& world, const Time& now, SphereId id) {
  const Slot slot = world.slot_of(id);
  return clearance_of(world, now, world.position(slot, now), world.radius(slot, now), slot);
}

}  // namespace hardball
