// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/world/world.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/world/sphere_edit.hpp"

namespace hardball {
namespace {

constexpr const char* kPositionNames[] = {"position along x", "position along y", "position along z"};
constexpr const char* kVelocityNames[] = {"velocity along x", "velocity along y", "velocity along z"};
constexpr const char* kSpinNames[] = {"spin about x", "spin about y", "spin about z"};

void check_vector(const Vec3& vector, const char* const (&names)[kAxes], const std::string& where) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double v = vector[axis];
    check_finite(v, names[axis], where);
    if (v != 0 && std::fabs(v) < kSmallestMagnitude) {
      throw Error(std::string(names[axis]) + " is " + to_text(v), where,
                  "give zero, or a magnitude of at least 1e-60");
    }
  }
}

std::string name_of(SphereId id) {
  return "sphere " + to_text(id);
}

}  // namespace

World::World(const Box& box, const Vec3& gravity, std::vector<Surface> surfaces)
    : Setting(box, gravity, std::move(surfaces)) {}

SphereId World::add(const Sphere& sphere, const Time& moment) {
  if (motion().has_growth()) check_exclusions(Feature::births, Feature::growth, name_of(next_id()));
  check(sphere);
  check_moment(moment, name_of(next_id()));
  Path path{sphere.position, sphere.velocity, moment};
  const Image beyond = box().fold(path.position, path.velocity, moment);
  const SphereState state{.path = path,
                          .radius = sphere.radius,
                          .mass = sphere.mass,
                          .inertia_factor = sphere.inertia_factor,
                          .spin = sphere.spin,
                          .folded = beyond,
                          .id = next_id(),
                          .species = sphere.species};
  append_with_highest_id(state);
  note_traits();
  if (has_journal_) journal_.record(Journal::Kind::birth, moment, static_cast<Slot>(size() - 1), state);
  return state.id;
}

void World::check(const Sphere& sphere) const {
  const std::string where = name_of(next_id());
  check_positive(sphere.radius, "radius", where);
  check_mass(sphere.mass, where);
  check_positive(sphere.inertia_factor, "moment", where);
  check_vector(sphere.velocity, kVelocityNames, where);
  check_vector(sphere.spin, kSpinNames, where);
  check_in_plane(sphere.velocity, "velocity", where);
  check_in_plane(sphere.position, "position", where);
  check_spin(sphere.spin, where);
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double x = sphere.position[axis];
    check_finite(x, kPositionNames[axis], where);
    if (!box().is_bounded(axis)) continue;
    const double size = box().size()[axis];
    check_fits(sphere.radius, axis, where);
    if (box().is_periodic(axis) && std::fabs(x / size) > Box::kMaxBoxesBeyond) {
      throw Error("center at " + to_text(x) + " along " + kAxisNames[axis] + " is more than 2^30 boxes away",
                  where, "place it inside the box, between 0 and " + to_text(size));
    }
    const double room = size * kWallTolerance;
    if (box().is_wall(axis) && (x < sphere.radius - room || x > size - sphere.radius + room)) {
      throw Error("center at " + to_text(x) + " along " + kAxisNames[axis] + " reaches through a wall", where,
                  "place it between " + to_text(sphere.radius) + " and " + to_text(size - sphere.radius));
    }
  }
  check_resolved(sphere.radius, where);
}

void World::check_in_plane(const Vec3& vector, const char* what, const std::string& where) const {
  if (box().is_flat()) refuse_out_of_plane(vector, what, where);
}

void World::check_spin(const Vec3& spin, const std::string& where) const {
  if (!box().is_flat() || (spin.x == 0 && spin.y == 0)) return;
  throw Error("the spin is not along z in a box of two dimensions", where,
              "give (0, 0, w), or give the box three dimensions");
}

void World::note_traits() {
  has_traits_ = has_traits_ || has_traits_of_their_own() || interactions().has_passing();
}

void World::check_mass(double mass, const std::string& where) const {
  if (mass != std::numeric_limits<double>::infinity()) return check_positive(mass, "mass", where);
  check_exclusions(Feature::kinematic, features(), where);
}

void World::check_fits(double radius, std::size_t axis, const std::string& where) const {
  const double size = box().size()[axis];
  if (2 * radius <= size * (1 + kWallTolerance)) return;
  throw Error("diameter " + to_text(2 * radius) + " exceeds the box size " + to_text(size) + " along " +
                  kAxisNames[axis],
              where, "enlarge the box or shrink the sphere");
}

void World::check_resolved(double radius, const std::string& where) const {
  for (const std::uint32_t number : meshes()) {
    const MeshShape& mesh = *surface(number).mesh();
    if (radius + mesh.thickness() >= MeshShape::kSmallestReach * mesh.mesh().largest_coordinate()) continue;
    throw Error("a sphere of radius " + to_text(radius) + " is lost in a mesh with coordinates up to " +
                    to_text(mesh.mesh().largest_coordinate()),
                where, "give it at least 2^-30 of that, or the mesh a thickness");
  }
}

void World::check_velocity(SphereId id, const Vec3& velocity) const {
  const bool is_in_plane = !box().is_flat() || velocity.z == 0;
  if (is_in_range(velocity.x) && is_in_range(velocity.y) && is_in_range(velocity.z) && is_in_plane) [[likely]]
    return;
  check_vector(velocity, kVelocityNames, name_of(id));
  check_in_plane(velocity, "velocity", name_of(id));
}

Features World::features() const {
  Features features = Setting::features();
  features.add(Feature::kinematic, kinematic_count() > 0);
  features.add(Feature::roughness, has_spins());
  return features;
}

World World::without_spheres() const {
  World world;
  static_cast<Setting&>(world) = *this;
  world.has_grown_ = has_grown_;
  world.last_passage_ = last_passage_;
  return world;
}

Slot World::insert(const SphereState& state) {
  HARDBALL_CHECK(!has_journal_);
  Spheres::insert(state);
  note_traits();
  return static_cast<Slot>(size() - 1);
}

void World::remove_at(Slot slot, const Time& moment) {
  while (!levels_.of(slot).empty()) {
    const PairLevel pair = levels_.of(slot).back();
    set_level(slot, pair.partner, pair.potential, 0, moment);
  }
  if (has_journal_) journal_.record(Journal::Kind::death, moment, slot, state_of(slot));
  levels_.take_place(slot, static_cast<Slot>(size() - 1));
  erase(slot);
}

void World::undo_add() {
  if (has_journal_) journal_.pop();
  const bool had_journal = std::exchange(has_journal_, false);
  release_last_id();
  remove(next_id());
  has_journal_ = had_journal;
}

void World::reorder(std::span<const Slot> order) {
  HARDBALL_CHECK(!has_journal_);
  Spheres::reorder(order);
  levels_.reorder(order);
}

Image World::change_velocity(Slot slot, const Time& moment, const Vec3& velocity) {
  check_velocity(id(slot), velocity);
  if (!is_moment(moment)) refuse_moment(moment, name_of(id(slot)));
  return rewrite_path(slot, moment, velocity);
}

Image World::rewrite_path(Slot slot, const Time& moment, const Vec3& velocity) {
  Vec3 position = unfolded_position(slot, moment);
  const Image folded = box().boxes_beyond(position, moment);
  position -= box().shift(folded, moment);
  SphereEdit(*this, moment, slot).store_path(slot, {position, velocity, moment}, folded);
  return folded;
}

Image World::put(Slot slot, const Time& moment, const Vec3& position, const Vec3& velocity) {
  const std::string where = name_of(id(slot));
  check_vector(velocity, kVelocityNames, where);
  check_in_plane(velocity, "velocity", where);
  check_in_plane(position, "position", where);
  for (std::size_t axis = 0; axis < kAxes; ++axis) check_finite(position[axis], kPositionNames[axis], where);
  if (!is_moment(moment)) refuse_moment(moment, where);
  Path path{position, velocity, moment};
  const Image folded = box().fold(path.position, path.velocity, moment) - this->folded(slot);
  SphereEdit(*this, moment, slot).store_path(slot, path, folded);
  return folded;
}

void World::set_surface(std::uint32_t number, const Surface& surface) {
  HARDBALL_CHECK(!has_journal_);
  if (surface.velocity() != Vec3{}) check_exclusions(features() | Feature::moving_walls);
  Setting::set_surface(number, surface);
}

void World::set_spin(Slot slot, const Vec3& spin) {
  Spheres::set_spin(slot, spin);
  note_traits();
}

void World::set_state(Slot slot, const SphereState& state) {
  Spheres::set_state(slot, state);
  note_traits();
}

void World::set_level(Slot a, Slot b, StepTable::Number potential, StepPotential::Level level,
                      const Time& moment) {
  if (has_journal_) {
    const PairLevel* const before = levels_.find(a, b);
    journal_.note_level(moment, a, before ? *before : PairLevel{b, potential, 0});
  }
  levels_.set(a, b, potential, level);
}

void World::reshape(Slot slot, double radius, double mass, double inertia_factor) {
  const std::string where = name_of(id(slot));
  check_positive(radius, "radius", where);
  check_mass(mass, where);
  check_positive(inertia_factor, "moment", where);
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (box().is_bounded(axis)) check_fits(radius, axis, where);
  }
  check_resolved(radius, where);
  has_grown_ |= radius > base_radius(slot);
  set_size(slot, radius, mass, inertia_factor);
  note_traits();
}

void World::set_interactions(const Interactions& interactions) {
  Setting::set_interactions(interactions);
  note_traits();
}

void World::set_growth(const Growth& growth) {
  check_exclusions(features() | Feature::growth);
  const double largest = base_radii().largest() * growth.largest_scale();
  const double room = largest_fitting_radius(box(), surfaces());
  if (largest > room * (1 + kWallTolerance)) {
    throw Error("a sphere would grow to the radius " + to_text(largest) + " where " + to_text(room) + " fits",
                "growth", "end the growth earlier");
  }
  Setting::set_growth(growth);
}

void World::end_growth(const Time& moment) {
  HARDBALL_CHECK(!has_journal_);
  multiply_radii(motion().scale_at(moment));
  Setting::end_growth();
  // When the present paths began, spheres of these sizes might have overlapped.
  for (Slot slot = 0; slot < size(); ++slot) rewrite_path(slot, moment, velocity(slot, moment));
}

Vec3 World::position(Slot slot, const Time& moment) const {
  check_finite(moment, "position");
  const Vec3 position = unfolded_position(slot, moment);
  return position - box().shift(box().boxes_beyond(position, moment), moment);
}

Vec3 World::velocity_in_box(Slot slot, const Time& moment) const {
  State state = motion().state_at(path(slot), moment);
  box().fold(state.position, state.velocity, moment);
  return state.velocity;
}

std::size_t World::memory_bytes() const {
  return Setting::memory_bytes() + Spheres::memory_bytes() + levels_.memory_bytes();
}

bool World::restored() {
  if (last_passage_.kind > EventKind::wall) return false;
  const StepTable& steps = interactions().steps();
  for (const auto& [slot, pair] : levels_.in_order()) {
    if (pair.potential >= steps.size() || pair.level > steps[pair.potential].steps()) return false;
  }
  for (Slot slot = 0; slot < size(); ++slot) {
    const SphereState state = state_of(slot);
    const std::string where = name_of(state.id);
    check_positive(state.radius, "radius", where);
    check_mass(state.mass, where);
    check_positive(state.inertia_factor, "moment", where);
    check_moment(state.path.time, where);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const double x = state.path.position[axis];
      check_finite(x, kPositionNames[axis], where);
      check_finite(state.path.velocity[axis], kVelocityNames[axis], where);
      check_finite(state.spin[axis], kSpinNames[axis], where);
      if (box().is_bounded(axis)) check_fits(state.radius, axis, where);
      if (box().is_periodic(axis) && !(x >= 0 && x <= box().size()[axis])) return false;
    }
    check_resolved(state.radius, where);
    check_in_plane(state.path.position, "position", where);
    check_in_plane(state.path.velocity, "velocity", where);
    check_spin(state.spin, where);
  }
  note_traits();
  if (motion().has_growth()) set_growth(motion().growth());
  return true;
}

}  // namespace hardball
