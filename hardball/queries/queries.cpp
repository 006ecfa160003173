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
#include "hardball/memory/prefetch.hpp"
#include "hardball/queries/cell_walk.hpp"
#include "hardball/queries/image_search.hpp"
#include "hardball/queries/sphere_search.hpp"
#include "hardball/standard/ranges.hpp"
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
std::optional<NextContact> first_contact_on(const SphereSearch& search, SphereId id, const Path& path,
                                            double radius, const Pass& pass, const Time& until) {
  const World& world = search.world();
  check_exclusions_of(Feature::first_contact, world);
  const Time& now = path.time;
  const Box& box = world.box();
  const double last = until.high < kNever.high ? duration(now, until) : until.high;
  check_end(box, last, "time", "first_contact");
  // Contacts whose time rounds to that of the end count.
  double end = last + 0x1p-52 * std::fabs(until.high);
  const State from{path.position, path.velocity};
  const double own_speed = length(path.velocity);
  const Motion& motion = world.motion();

  // What is no later than what has been found, or simultaneous.
  constexpr double kAfterRounding = 1 + 0x1p-48;
  First first;
  const auto record_wall = [&](const Event& wall) {
    if (!(wall.time <= after(now, end))) return;
    first.record({wall.time, wall.kind, wall.second, {}});
    end = std::min(end, std::max(0.0, duration(now, wall.time)) * kAfterRounding);
  };
  record_wall(next_wall_event(world, id, path, radius, now));
  const double half = 0.5 * box.shortest_period();
  const bool has_obstacles = has_images_of_solids(world);
  const auto stride_to_obstacles = [&](double begin) {
    if (!has_obstacles) return kInfinity;
    const double gravity = length(motion.gravity());
    return time_to_pass(half, own_speed + gravity * begin, gravity);
  };
  search_in_intervals(stride_to_obstacles, end, [&](const Interval& during) {
    record_wall(
        next_solid_event(world, id, path, radius, after(now, during.begin), after(now, during.end).high));
  });

  const bool some_pass = has_passing_pairs(world) || id == kNoSphere;
  const Slot self = world.find(id).value_or(kNoSlot);
  Interval looked_at{};
  const auto look_at = [&](Slot slot) {
    if (slot == self) return;
    const State state = motion.state_at(world.path(slot), now);
    const Relative other{state.position - from.position, state.velocity - from.velocity,
                         radius + world.base_radius(slot)};
    const auto wait_of = [&](const Relative& image) {
      if (some_pass && pass(slot)) return time_to_begin(world, now, id, world.id(slot), image);
      return time_to_touch(image);
    };
    for_each_touch(box, other, looked_at, end, wait_of, [&](double wait, const Vec3& separation) {
      first.record({after(now, wait), EventKind::collision, world.id(slot), separation});
      end = std::min(end, wait * kAfterRounding);
    });
  };
  const auto look_at_all = [&](const Interval& during) {
    looked_at = during;
    for (Slot slot = 0; slot < world.size(); ++slot) look_at(slot);
  };
  const MovingSpheres* const moving = search.moving(now);
  double fastest = moving ? own_speed + moving->fastest() : 0;
  for (Slot slot = 0; !moving && is_periodic(box) && slot < world.size(); ++slot) {
    const Vec3 velocity = motion.velocity_at(world.path(slot), now) - path.velocity;
    if (slot != self) fastest = std::max(fastest, length(velocity));
  }
  const auto look_near = [&](const Interval& interval) {
    const Function<void(Slot)> visit = look_at;
    // A first contact is likely to be near: shorter intervals come first.
    const double speed = own_speed + moving->usual_speed();
    constexpr double kCells = 3;
    const double shortest = moving->cell_edge() > 0 ? kCells * moving->cell_edge() / speed : kInfinity;
    double begin = interval.begin;
    do {
      const bool are_all_near = begin * speed > moving->extent();
      const double limit = std::min(interval.end, end);
      const double next = begin + std::max(shortest, begin);
      // A short rest is not worth looking from anew.
      looked_at = {begin, are_all_near || 1.5 * next > limit ? limit : next};
      moving->for_each_near(from, radius, looked_at.begin, looked_at.end, visit);
      begin = looked_at.end;
    } while (begin < std::min(interval.end, end));
  };
  const auto stride_to_spheres = [longest = half / fastest](double) { return longest; };
  search_in_intervals(stride_to_spheres, end, [&](const Interval& interval) {
    moving ? look_near(interval) : look_at_all(interval);
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

// Calls record(distance, number, separation) for each wall that a ray hits in an interval, as for_each_touch
// does for spheres.
template <class Record>
void for_each_wall_hit(const World& world, const Time& now, const Path& path, const Interval& during,
                       const double& latest, Record&& record) {
  const Box& box = world.box();
  const auto record_if_near = [&](double distance, std::uint32_t number) {
    if (distance <= latest) record(distance, number, Vec3{});
  };
  const auto record_mesh = [&](std::uint32_t number, const Surface& mesh) {
    const double end = std::min(during.end, latest);
    const auto [contact, image] =
        first_contact_with_mesh(box, Motion(), mesh, path, 0, Time(during.begin), end);
    const double distance = contact.time.high;
    if (!(distance <= end)) return;
    // Where the ray is still off the surface.
    const double before = distance - 0x1p-20 * (distance + mesh.mesh()->mesh().largest_coordinate());
    const Path passing{path.position - box.shift(image), path.velocity, path.time};
    const Vec3 towards = mesh.towards_feature(Motion(), passing, 0, Time(before), contact.feature);
    record(distance, number, distance * path.velocity + (1 / length(towards)) * towards);
  };
  for_each_face(box, [&](std::size_t axis, bool upper) {
    const double approach = upper ? path.velocity[axis] : -path.velocity[axis];
    record_if_near(time_to_plane(distance_to_face(box, path.position, axis, upper), approach),
                   face_of(axis, upper));
  });
  for_each_surface(world, now, [&](std::uint32_t number, const Surface& surface) {
    if (surface.mesh()) return record_mesh(number, surface);
    const auto* obstacle = std::get_if<Obstacle>(&surface.shape());
    if (obstacle == nullptr) return record_if_near(surface.contact_time(Motion(), path, 0).high, number);
    const Relative other{surface.point() - path.position, -path.velocity, obstacle->radius()};
    for_each_touch(box, other, during, latest, time_to_enter,
                   [&](double distance, const Vec3& separation) { record(distance, number, separation); });
  });
}

void check_vector(const Vec3& vector, const char* name, const char* where) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) check_finite(vector[axis], name, where);
}

void check_size(double size, const char* name, const char* where) {
  check_finite(size, name, where);
  if (size < 0) throw Error(std::string(name) + " is " + to_text(size), where, "give zero or more");
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

// Whether an image of a sphere overlaps a box with these half edges [L]; its center is at `apart` as seen
// from that of the box.
bool overlaps_extent(const Box& box, const Vec3& apart, double radius, const Vec3& half, const Time& now) {
  const auto beyond = [&](double distance, std::size_t axis) {
    return std::max(0.0, std::fabs(distance) - half[axis]);
  };
  const auto nearest = [&](double distance, std::size_t axis) {
    return distance - round_to_integer(distance * box.inverse_period()[axis]) * box.period()[axis];
  };
  const double z = beyond(nearest(apart.z, 2), 2);
  const auto is_near = [&](double x, double y) {
    const Vec3 outside{beyond(nearest(x, 0), 0), beyond(y, 1), z};
    return dot(outside, outside) < radius * radius;
  };
  if (!box.is_sheared()) [[likely]]
    return is_near(apart.x, nearest(apart.y, 1));
  const double middle = apart.y * box.inverse_period().y;
  const double rows = (half.y + radius) * box.inverse_period().y;
  const auto last = static_cast<std::int32_t>(std::ceil(middle + rows));
  for (auto row = static_cast<std::int32_t>(std::floor(middle - rows)); row <= last; ++row) {
    const Vec3 image = apart - box.shift({{0, row, 0}}, now);
    if (is_near(image.x, image.y)) return true;
  }
  return false;
}

// The body nearest to a sphere that has this id, or to one that is not in the world.
std::optional<Clearance> clearance_of(const SphereSearch& search, const Time& now, const Vec3& center,
                                      double radius, SphereId self, const BodyFilter& filter) {
  const World& world = search.world();
  const Box& box = world.box();
  std::optional<Clearance> nearest;
  double least = kInfinity;
  if (filter.walls) {
    for_each_face(box, [&](std::size_t axis, bool upper) {
      const double distance = distance_to_face(box, center, axis, upper) - radius;
      note_nearer({distance, EventKind::wall, face_of(axis, upper)}, nearest);
    });
    for_each_surface(world, now, [&](std::uint32_t number, const Surface& surface) {
      const double distance = distance_to_surface(box, surface, center, now) - radius;
      note_nearer({distance, EventKind::wall, number}, nearest);
    });
    if (nearest) least = nearest->distance;
  }
  for (const SphereSearch::Part& part : search.parts()) {
    const World& its = *part.world;
    const auto look_at = [&](Slot slot) {
      if (its.id(slot) == self) return;
      const Vec3 apart = shortest_image(box, its.unfolded_position(slot, now) - center, now);
      const double reach = radius + its.radius(slot, now);
      const double square = dot(apart, apart);
      // Most are certainly farther, and need no square root.
      const double within = least + reach;
      if (within < 0 || square * (1 - kRounding) > within * within) return;
      if (!filter.accepts(part, slot)) return;
      note_nearer({std::sqrt(square) - reach, EventKind::collision, its.id(slot)}, nearest);
      least = nearest->distance;
    };
    const BroadPhase::VisitSlots look_at_all = [&](std::span<const Slot> slots) {
      for (const Slot slot : slots) look_at(slot);
    };
    if (part.phase) part.phase->visit_hollow(look_at_all);
    const Subdivision* const cells = part.phase ? part.phase->search_cells() : nullptr;
    const Vec3 edges = cells ? cells->edges() : Vec3{};
    // Whatever is outside of the extent is at least this far from the center.
    double reach = 0.5 * std::min({edges.x, edges.y, edges.z});
    while (true) {
      const Extent extent = Extent{center, center}.grown(reach * (1 + kRounding));
      if (is_scan_cheaper(part, extent)) {
        for_each_sphere(part, look_at);
        break;
      }
      part.phase->visit_cells(cells_of(*cells, extent), look_at_all);
      if (least + radius <= reach) break;
      reach = std::min(2 * reach, least + radius);
    }
  }
  return nearest;
}

// The way of a ray, from inside a periodic box. Error: see ray.
Path path_of_ray(const World& world, const Time& now, const Vec3& origin, const Vec3& direction,
                 double most) {
  constexpr const char* kWhere = "ray";
  check_exclusions_of(Feature::ray, world);
  check_vector(direction, "the direction", kWhere);
  const double norm = length(direction);
  if (!(norm >= kSmallestMagnitude)) {
    throw Error("the direction has the length " + to_text(norm), kWhere,
                "give a finite vector that is not zero");
  }
  check_end(world.box(), most, "distance", kWhere);
  return {folded(world.box(), origin, now, kWhere), (1 / norm) * direction, Time(0)};
}

// Calls record(hit) for what a ray hits up to `end`, which may come nearer meanwhile, some perhaps more than
// once.
template <class Record>
void search_along(const SphereSearch& search, const Time& now, const Path& path, const double& end,
                  const BodyFilter& filter, const Record& record) {
  const World& world = search.world();
  const Box& box = world.box();
  const double half = 0.5 * box.shortest_period();
  const auto halves = [half](double) { return half; };
  if (filter.walls) {
    search_in_intervals(halves, end, [&](const Interval& during) {
      for_each_wall_hit(world, now, path, during, end,
                        [&](double distance, std::uint32_t number, const Vec3& separation) {
                          record(First{Time(distance), EventKind::wall, number, separation});
                        });
    });
  }
  const double scale = world.motion().scale_at(now);
  for (const SphereSearch::Part& part : search.parts()) {
    const World& its = *part.world;
    Interval looked_at{};
    const auto look_at = [&](Slot slot) {
      const Relative other{its.unfolded_position(slot, now) - path.position, -path.velocity,
                           scale * its.base_radius(slot)};
      for_each_touch(box, other, looked_at, end, time_to_enter, [&](double distance, const Vec3& separation) {
        if (filter.accepts(part, slot))
          record(First{Time(distance), EventKind::collision, its.id(slot), separation});
      });
    };
    const Subdivision* const cells = part.phase ? part.phase->search_cells() : nullptr;
    double walked = 0;
    if (cells) {
      const BroadPhase::VisitSlots look_at_all = [&](std::span<const Slot> slots) {
        for (const Slot slot : slots) prefetch(&its.path(slot));
        for (const Slot slot : slots) look_at(slot);
      };
      // Then a scan of the rest costs less than what the walk has cost already.
      const double most_cells = static_cast<double>(its.size()) / part.cell_cost;
      CellWalk walk(*cells, path.position, path.velocity);
      for (double count = 0; walked < end && count < most_cells; ++count) {
        looked_at = {walked, std::min(walk.end(), end)};
        part.phase->visit_cells({walk.cell(), walk.cell()}, look_at_all);
        walked = std::max(walked, looked_at.end);
        if (walked < end) walk.step();
      }
    }
    if (cells && !(walked < end)) continue;
    search_in_intervals(halves, end, [&](const Interval& during) {
      looked_at = during;
      if (during.end >= walked) for_each_sphere(part, look_at);
    });
  }
}

RayHit hit_of(const World& world, const Time& now, const Path& path, const First& hit) {
  const double distance = hit.time.value();
  const Vec3 way = distance * path.velocity;
  Vec3 point = path.position + way;
  world.box().fold(point);
  return {hit.kind, hit.body, distance, point, normal_of(world, now, hit, point, way)};
}

// The spheres that overlap a part of space with these half edges [L]: is_inside(apart, radius) says so of
// one whose center, or that of some image, is at `apart` as seen from the middle.
template <class IsInside>
std::vector<SphereId> overlap_with(const SphereSearch& search, const Time& now, const Vec3& middle,
                                   const Vec3& half, const BodyFilter& filter, const IsInside& is_inside) {
  const World& world = search.world();
  const Vec3 center = folded(world.box(), middle, now, "overlap");
  std::vector<SphereId> found;
  for (const SphereSearch::Part& part : search.parts()) {
    const World& its = *part.world;
    const auto look_at = [&](Slot slot) {
      const Vec3 apart = its.unfolded_position(slot, now) - center;
      if (is_inside(apart, its.radius(slot, now)) && filter.accepts(part, slot))
        found.push_back(its.id(slot));
    };
    const Extent extent{center - half, center + half};
    if (is_scan_cheaper(part, extent)) {
      for_each_sphere(part, look_at);
      continue;
    }
    const BroadPhase::VisitSlots look_at_all = [&](std::span<const Slot> slots) {
      for (const Slot slot : slots) look_at(slot);
    };
    part.phase->visit_cells(cells_of(*part.phase->search_cells(), extent), look_at_all);
    part.phase->visit_hollow(look_at_all);
  }
  ranges::sort(found);
  const auto rest = ranges::unique(found);
  found.erase(rest.begin(), rest.end());
  return found;
}

}  // namespace

std::optional<NextContact> first_contact(const SphereSearch& search, const Time& now, SphereId id,
                                         const Vec3& velocity, const Time& until) {
  const World& world = search.world();
  const Slot slot = world.slot_of(id);
  world.check_velocity(id, velocity);
  const Path path{world.position(slot, now), velocity, now};
  const auto passes = [&](Slot other) { return pass(world, slot, other); };
  return first_contact_on(search, id, path, world.base_radius(slot), passes, until);
}

std::optional<NextContact> first_contact(const SphereSearch& search, const Time& now, const Sphere& sphere,
                                         const Time& until) {
  const World& world = search.world();
  world.check(sphere);
  Path path{sphere.position, sphere.velocity, now};
  world.box().fold(path.position);
  const auto passes = [&](Slot other) {
    return world.interactions().pass(sphere.species, world.species(other)) ||
           (std::isinf(sphere.mass) && world.is_kinematic(other));
  };
  return first_contact_on(search, kNoSphere, path, sphere.radius, passes, until);
}

std::optional<RayHit> ray(const SphereSearch& search, const Time& now, const Vec3& origin,
                          const Vec3& direction, double most, const BodyFilter& filter) {
  const Path path = path_of_ray(search.world(), now, origin, direction, most);
  First first;
  double end = most;
  const auto record = [&](const First& hit) {
    first.record(hit);
    end = std::min(end, hit.time.high);
  };
  search_along(search, now, path, end, filter, record);
  if (!(first.time < kNever)) return std::nullopt;
  return hit_of(search.world(), now, path, first);
}

std::vector<RayHit> ray_hits(const SphereSearch& search, const Time& now, const Vec3& origin,
                             const Vec3& direction, double most, const BodyFilter& filter) {
  const Path path = path_of_ray(search.world(), now, origin, direction, most);
  const World& world = search.world();
  std::vector<First> found;
  double end = most;
  search_along(search, now, path, end, filter, [&](const First& hit) {
    found.push_back(hit);
    const bool ends =
        hit.kind == EventKind::wall &&
        (hit.body < kFaces || !std::holds_alternative<Obstacle>(world.surface(hit.body).shape()));
    if (ends) end = std::min(end, hit.time.high);
  });
  const auto order = [](const First& hit) { return std::tie(hit.time, hit.kind, hit.body); };
  ranges::sort(found, {}, order);
  const auto rest = ranges::unique(found, {}, order);
  found.erase(rest.begin(), rest.end());
  std::vector<RayHit> hits;
  for (const First& hit : found) {
    if (hit.time.high <= end) hits.push_back(hit_of(world, now, path, hit));
  }
  return hits;
}

std::optional<Clearance> clearance(const SphereSearch& search, const Time& now, const Vec3& point,
                                   const BodyFilter& filter) {
  return clearance_of(search, now, folded(search.world().box(), point, now, "clearance"), 0, kNoSphere,
                      filter);
}

std::optional<Clearance> clearance(const SphereSearch& search, const Time& now, SphereId id,
                                   const BodyFilter& filter) {
  const World& world = search.world();
  const Slot slot = world.slot_of(id);
  return clearance_of(search, now, world.position(slot, now), world.radius(slot, now), id, filter);
}

std::vector<SphereId> overlap(const SphereSearch& search, const Time& now, const Vec3& center, double radius,
                              const BodyFilter& filter) {
  check_size(radius, "the radius", "overlap");
  const Box& box = search.world().box();
  const Vec3 half{radius, radius, radius};
  return overlap_with(search, now, center, half, filter, [&](const Vec3& apart, double its_radius) {
    const Vec3 nearest = shortest_image(box, apart, now);
    const double reach = radius + its_radius;
    return dot(nearest, nearest) < reach * reach;
  });
}

std::vector<SphereId> overlap(const SphereSearch& search, const Time& now, const Extent& extent,
                              const BodyFilter& filter) {
  constexpr const char* kWhere = "overlap";
  check_vector(extent.low, "a coordinate", kWhere);
  check_vector(extent.high, "a coordinate", kWhere);
  const Vec3 half = 0.5 * (extent.high - extent.low);
  const Box& box = search.world().box();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    check_size(half[axis], "half the size of the extent", kWhere);
    if (box.is_periodic(axis) && 2 * half[axis] > box.size()[axis]) {
      throw Error("the extent is larger than the periodic box", kWhere, "give one that is not");
    }
  }
  return overlap_with(search, now, extent.low + half, half, filter, [&](const Vec3& apart, double radius) {
    return overlaps_extent(box, apart, radius, half, now);
  });
}

}  // namespace hardball
