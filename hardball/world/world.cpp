// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/world/world.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "hardball/errors/error.hpp"
#include "hardball/world/range.hpp"

namespace hardball {
namespace {

constexpr const char* kAxisNames[] = {"x", "y", "z"};

void check_velocity(const Vec3& velocity, const std::string& where) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double v = velocity[axis];
    check_finite(v, std::string("velocity along ") + kAxisNames[axis], where);
    if (v != 0 && std::fabs(v) < kSmallestMagnitude) {
      throw Error(std::string("velocity along ") + kAxisNames[axis] + " is " + to_text(v), where,
                  "give zero, or a magnitude of at least 1e-60");
    }
  }
}

// How far inside a wall's reach a centre may lie by rounding alone, relative to the box.
constexpr double kWallTolerance = 1e-12;

}  // namespace

SphereId World::add(const Sphere& sphere, const Time& moment) {
  check(sphere);
  const Image beyond = box_.boxes_beyond(sphere.position);
  ids_.push_back(next_id_);
  paths_.push_back({sphere.position - box_.shift(beyond), sphere.velocity, moment});
  radii_.push_back(sphere.radius);
  masses_.push_back(sphere.mass);
  folded_.push_back(beyond);
  return next_id_++;
}

void World::check(const Sphere& sphere) const {
  const std::string where = "sphere " + to_text(next_id_);
  check_positive(sphere.radius, "radius", where);
  check_positive(sphere.mass, "mass", where);
  check_velocity(sphere.velocity, where);
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double x = sphere.position[axis];
    check_finite(x, std::string("position along ") + kAxisNames[axis], where);
    if (box_.is_open(axis)) continue;
    const double size = box_.size()[axis];
    if (2 * sphere.radius > size * (1 + kWallTolerance)) {
      throw Error("diameter " + to_text(2 * sphere.radius) + " exceeds the box size " + to_text(size) +
                      " along " + kAxisNames[axis],
                  where, "enlarge the box or shrink the sphere");
    }
    const double room = size * kWallTolerance;
    if (box_.is_wall(axis) && (x < sphere.radius - room || x > size - sphere.radius + room)) {
      throw Error("centre at " + to_text(x) + " along " + kAxisNames[axis] + " reaches through a wall", where,
                  "place it between " + to_text(sphere.radius) + " and " + to_text(size - sphere.radius));
    }
  }
}

void World::remove(SphereId id) {
  const auto at = static_cast<std::ptrdiff_t>(slot_of(id));
  ids_.erase(ids_.begin() + at);
  paths_.erase(paths_.begin() + at);
  radii_.erase(radii_.begin() + at);
  masses_.erase(masses_.begin() + at);
  folded_.erase(folded_.begin() + at);
}

Image World::change_velocity(Slot slot, const Time& moment, const Vec3& velocity) {
  check_velocity(velocity, "sphere " + to_text(id(slot)));
  return rewrite_path(slot, moment, velocity);
}

Image World::rewrite_path(Slot slot, const Time& moment, const Vec3& velocity) {
  Path& path = paths_[slot];
  const Vec3 position = position_at(path, moment);
  const Image beyond = box_.boxes_beyond(position);
  path = {position - box_.shift(beyond), velocity, moment};
  folded_[slot] = folded_[slot] + beyond;
  return beyond;
}

Slot World::slot_of(SphereId id) const {
  const auto found = std::lower_bound(ids_.begin(), ids_.end(), id);
  if (found == ids_.end() || *found != id) {
    throw Error("there is no sphere " + to_text(id), "sphere id", "use an id that add() returned");
  }
  return static_cast<Slot>(found - ids_.begin());
}

Vec3 World::position(Slot slot, const Time& moment) const {
  const Vec3 unfolded = position_at(paths_[slot], moment);
  return unfolded - box_.shift(box_.boxes_beyond(unfolded));
}

Image World::image(Slot slot, const Time& moment) const {
  return folded_[slot] + box_.boxes_beyond(position_at(paths_[slot], moment));
}

double World::kinetic_energy() const {
  double energy = 0;
  for (Slot slot = 0; slot < size(); ++slot) energy += hardball::kinetic_energy(*this, slot);
  return energy;
}

Vec3 World::momentum() const {
  Vec3 momentum;
  for (Slot slot = 0; slot < size(); ++slot) momentum += masses_[slot] * paths_[slot].velocity;
  return momentum;
}

double World::sphere_volume() const {
  double cubes = 0;
  for (const double radius : radii_) cubes += radius * radius * radius;
  return 4 * std::numbers::pi / 3 * cubes;
}

double World::largest_radius() const {
  return radii_.empty() ? 0 : *std::max_element(radii_.begin(), radii_.end());
}

std::size_t World::memory_bytes() const {
  return paths_.capacity() * sizeof(Path) + (radii_.capacity() + masses_.capacity()) * sizeof(double) +
         ids_.capacity() * sizeof(SphereId) + folded_.capacity() * sizeof(Image);
}

Event next_wall_event(const World& world, Slot slot) {
  const Path& path = world.path(slot);
  const double radius = world.radius(slot);
  Event next;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!world.box().is_wall(axis) || path.velocity[axis] == 0) continue;
    const bool upper = path.velocity[axis] > 0;
    const double distance =
        upper ? (world.box().size()[axis] - radius) - path.position[axis] : path.position[axis] - radius;
    const double wait = time_to_plane(distance, std::fabs(path.velocity[axis]));
    const Event event{after(path.time, wait), EventKind::wall, slot, face_of(axis, upper), {}};
    if (event < next) next = event;
  }
  return next;
}

}  // namespace hardball
