// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/world/world.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/world/range.hpp"

namespace hardball {
namespace {

constexpr const char* kAxisNames[] = {"x", "y", "z"};
constexpr const char* kPositionNames[] = {"position along x", "position along y", "position along z"};
constexpr const char* kVelocityNames[] = {"velocity along x", "velocity along y", "velocity along z"};

void check_velocity(const Vec3& velocity, const std::string& where) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double v = velocity[axis];
    check_finite(v, kVelocityNames[axis], where);
    if (v != 0 && std::fabs(v) < kSmallestMagnitude) {
      throw Error(std::string(kVelocityNames[axis]) + " is " + to_text(v), where,
                  "give zero, or a magnitude of at least 1e-60");
    }
  }
}

// A plane or a tube must be the same in every image of the box; what encloses spheres must lie inside it.
void refuse_in_periodic_box(const Surface& surface, const Box& box) {
  const auto refuse = [&](std::size_t axis, const char* remedy) {
    throw Error("a " + std::string(surface.name()) + " is not periodic along " + kAxisNames[axis], "walls",
                remedy);
  };
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!box.is_periodic(axis) || std::holds_alternative<Obstacle>(surface.shape())) continue;
    const Vec3* const normal = std::visit(
        [](const auto& shape) -> const Vec3* {
          if constexpr (requires { shape.normal(); }) return &shape.normal();
          return nullptr;
        },
        surface.shape());
    if (normal != nullptr) {
      if ((*normal)[axis] != 0) refuse(axis, "make it parallel to the axis, or the axis not periodic");
      continue;
    }
    const auto* cylinder = std::get_if<Cylinder>(&surface.shape());
    if (cylinder != nullptr && std::fabs(cylinder->axis()[axis]) == 1) continue;
    if (cylinder != nullptr && cylinder->axis()[axis] != 0)
      refuse(axis, "let it run along an axis of the box");
    const double radius =
        cylinder != nullptr ? cylinder->radius() : std::get<HollowSphere>(surface.shape()).radius();
    const double center = surface.point()[axis];
    if (surface.velocity()[axis] != 0 || center < radius || center > box.size()[axis] - radius) {
      refuse(axis, "keep it inside the box and at rest, or make the axis open");
    }
  }
}

std::string name_of(SphereId id) {
  return "sphere " + to_text(id);
}

// Events of spheres slowed down by inelastic collapse may lie beyond the moments that check_moment allows.
void check_queried(const Time& moment, std::string_view where) {
  if (!std::isfinite(moment.high)) refuse_moment(moment, where);
}

// How much closer to a wall than its radius a centre may lie through rounding alone, relative to the box.
constexpr double kWallTolerance = 1e-12;

}  // namespace

World::World(const Box& box, const Vec3& gravity, std::vector<Surface> surfaces)
    : box_(box), motion_(gravity), surfaces_(std::move(surfaces)) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double g = gravity[axis];
    check_finite(g, "gravity", "gravity");
    if (g != 0 && std::fabs(g) < kSmallestMagnitude) {
      throw Error("gravity is " + to_text(g), "gravity", "give zero, or a magnitude of at least 1e-60");
    }
  }
  for (const Surface& surface : surfaces_) refuse_in_periodic_box(surface, box_);
}

void World::reserve(std::size_t count) {
  ids_.reserve(count);
  paths_.reserve(count);
  folded_.reserve(count);
}

SphereId World::add(const Sphere& sphere, const Time& moment) {
  check(sphere);
  check_moment(moment, name_of(next_id_));
  const Image beyond = box_.boxes_beyond(sphere.position);
  if (!slots_by_id_.empty()) slots_by_id_.push_back(static_cast<Slot>(size()));
  ids_.push_back(next_id_);
  paths_.push_back({sphere.position - box_.shift(beyond), sphere.velocity, moment});
  radii_.push_back(sphere.radius);
  masses_.push_back(sphere.mass);
  folded_.push_back(beyond);
  return next_id_++;
}

void World::check(const Sphere& sphere) const {
  const std::string where = name_of(next_id_);
  check_positive(sphere.radius, "radius", where);
  check_positive(sphere.mass, "mass", where);
  check_velocity(sphere.velocity, where);
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double x = sphere.position[axis];
    check_finite(x, kPositionNames[axis], where);
    if (box_.is_open(axis)) continue;
    const double size = box_.size()[axis];
    if (2 * sphere.radius > size * (1 + kWallTolerance)) {
      throw Error("diameter " + to_text(2 * sphere.radius) + " exceeds the box size " + to_text(size) +
                      " along " + kAxisNames[axis],
                  where, "enlarge the box or shrink the sphere");
    }
    if (box_.is_periodic(axis) && std::fabs(x / size) > Box::kMostBoxesBeyond) {
      throw Error("centre at " + to_text(x) + " along " + kAxisNames[axis] + " is more than 2^30 boxes away",
                  where, "place it inside the box, between 0 and " + to_text(size));
    }
    const double room = size * kWallTolerance;
    if (box_.is_wall(axis) && (x < sphere.radius - room || x > size - sphere.radius + room)) {
      throw Error("centre at " + to_text(x) + " along " + kAxisNames[axis] + " reaches through a wall", where,
                  "place it between " + to_text(sphere.radius) + " and " + to_text(size - sphere.radius));
    }
  }
}

void World::remove(SphereId id) {
  const Slot slot = slot_of(id);
  const auto at = static_cast<std::ptrdiff_t>(slot);
  ids_.erase(ids_.begin() + at);
  paths_.erase(paths_.begin() + at);
  radii_.erase(slot);
  masses_.erase(slot);
  folded_.erase(folded_.begin() + at);
  sort_slots_by_id();
}

void World::reorder(std::span<const Slot> order) {
  const auto reordered = [order](const auto& values) {
    std::remove_cvref_t<decltype(values)> moved;
    moved.reserve(values.size());
    for (const Slot slot : order) moved.push_back(values[slot]);
    return moved;
  };
  ids_ = reordered(ids_);
  paths_ = reordered(paths_);
  folded_ = reordered(folded_);
  radii_.reorder(order);
  masses_.reorder(order);
  sort_slots_by_id();
}

void World::sort_slots_by_id() {
  if (std::is_sorted(ids_.begin(), ids_.end())) {
    slots_by_id_ = {};
    return;
  }
  constexpr Slot kNone = std::numeric_limits<Slot>::max();
  slots_by_id_.assign(next_id_, kNone);
  for (Slot slot = 0; slot < size(); ++slot) slots_by_id_[ids_[slot]] = slot;
  std::erase(slots_by_id_, kNone);
}

Image World::change_velocity(Slot slot, const Time& moment, const Vec3& velocity) {
  check_velocity(velocity, name_of(id(slot)));
  check_moment(moment, name_of(id(slot)));
  return rewrite_path(slot, moment, velocity);
}

Image World::rewrite_path(Slot slot, const Time& moment, const Vec3& velocity) {
  Vec3 position = unfolded_position(slot, moment);
  const Image folded = box_.fold(position);
  store_path(slot, {position, velocity, moment}, folded);
  return folded;
}

Slot World::slot_of(SphereId id) const {
  if (id < size() && ids_[id] == id) return id;
  std::size_t low = 0;
  std::size_t high = size();
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    if (ids_[slot_of_rank(middle)] < id) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  if (low == size() || ids_[slot_of_rank(low)] != id) {
    throw Error("there is no sphere " + to_text(id), "sphere id", "use an id that add() returned");
  }
  return slot_of_rank(low);
}

Vec3 World::position(Slot slot, const Time& moment) const {
  check_queried(moment, "position");
  Vec3 position = unfolded_position(slot, moment);
  box_.fold(position);
  return position;
}

Image World::image(Slot slot, const Time& moment) const {
  check_queried(moment, "image");
  return folded_[slot] + box_.boxes_beyond(unfolded_position(slot, moment));
}

double World::kinetic_energy(const Time& moment) const {
  double energy = 0;
  for_each_by_id([&](Slot slot) { energy += hardball::kinetic_energy(*this, slot, moment); });
  return energy;
}

double World::energy(const Time& moment) const {
  double energy = 0;
  for_each_by_id([&](Slot slot) { energy += hardball::energy(*this, slot, moment); });
  return energy;
}

Vec3 World::momentum(const Time& moment) const {
  Vec3 momentum;
  for_each_by_id([&](Slot slot) { momentum += masses_[slot] * velocity(slot, moment); });
  return momentum;
}

double World::sphere_volume() const {
  double cubes = 0;
  for_each_by_id([&](Slot slot) { cubes += radii_[slot] * radii_[slot] * radii_[slot]; });
  return 4 * std::numbers::pi / 3 * cubes;
}

double World::largest_radius() const {
  return radii_.largest();
}

std::size_t World::memory_bytes() const {
  return paths_.capacity() * sizeof(Path) + radii_.memory_bytes() + masses_.memory_bytes() +
         ids_.capacity() * sizeof(SphereId) + slots_by_id_.capacity() * sizeof(Slot) +
         folded_.capacity() * sizeof(Image) + surfaces_.capacity() * sizeof(Surface);
}

double energy(const World& world, Slot slot, const Time& moment) {
  const double kinetic = kinetic_energy(world, slot, moment);
  if (world.motion().is_straight()) return kinetic;
  return kinetic - world.mass(slot) * dot(world.motion().gravity(), world.unwrapped_position(slot, moment));
}

}  // namespace hardball
