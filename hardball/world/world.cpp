// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/world/world.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/numbers/exact_sum.hpp"
#include "hardball/world/setting.hpp"
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

// Events of spheres slowed down by inelastic collapse may lie beyond the moments that check_moment allows.
void check_queried(const Time& moment, std::string_view where) {
  if (!std::isfinite(moment.high)) refuse_moment(moment, where);
}

}  // namespace

World::World(const Box& box, const Vec3& gravity, std::vector<Surface> surfaces)
    : box_(box), motion_(gravity), surfaces_(std::move(surfaces)) {
  check_setting(box_, motion_, surfaces_);
  // A state that an earlier version has saved may have planes that are not.
  check_reachable(box_, surfaces_);
  refuse_shear_with_others();
}

void World::reserve(std::size_t count) {
  ids_.reserve(count);
  paths_.reserve(count);
  folded_.reserve(count);
}

SphereId World::add(const Sphere& sphere, const Time& moment) {
  if (motion_.has_growth()) {
    throw Error("spheres grow, and none can be added", name_of(next_id_),
                "add all before growth begins, or stop it");
  }
  check(sphere);
  check_moment(moment, name_of(next_id_));
  Path path{sphere.position, sphere.velocity, moment};
  const Image beyond = box_.fold(path.position, path.velocity, moment);
  append({.path = path,
          .radius = sphere.radius,
          .mass = sphere.mass,
          .inertia_factor = sphere.inertia_factor,
          .spin = sphere.spin,
          .folded = beyond,
          .id = next_id_,
          .species = sphere.species});
  order_.append();
  if (has_journal_) {
    const auto slot = static_cast<Slot>(size() - 1);
    journal_.note(Journal::Kind::birth, moment, slot, state_of(slot));
  }
  return next_id_++;
}

void World::check(const Sphere& sphere) const {
  const std::string where = name_of(next_id_);
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
    if (!box_.is_bounded(axis)) continue;
    const double size = box_.size()[axis];
    check_fits(sphere.radius, axis, where);
    if (box_.is_periodic(axis) && std::fabs(x / size) > Box::kMaxBoxesBeyond) {
      throw Error("center at " + to_text(x) + " along " + kAxisNames[axis] + " is more than 2^30 boxes away",
                  where, "place it inside the box, between 0 and " + to_text(size));
    }
    const double room = size * kWallTolerance;
    if (box_.is_wall(axis) && (x < sphere.radius - room || x > size - sphere.radius + room)) {
      throw Error("center at " + to_text(x) + " along " + kAxisNames[axis] + " reaches through a wall", where,
                  "place it between " + to_text(sphere.radius) + " and " + to_text(size - sphere.radius));
    }
  }
}

void World::check_in_plane(const Vec3& vector, const char* what, const std::string& where) const {
  if (box_.is_flat()) refuse_out_of_plane(vector, what, where);
}

void World::check_spin(const Vec3& spin, const std::string& where) const {
  if (!box_.is_flat() || (spin.x == 0 && spin.y == 0)) return;
  throw Error("the spin is not along z in a box of two dimensions", where,
              "give (0, 0, w), or give the box three dimensions");
}

void World::note_traits() {
  if (has_traits_) return;
  const bool have_inertia_factors =
      size() > 0 && !(inertia_factors_.is_common() && inertia_factors_.common() == kSphereInertiaFactor);
  has_traits_ = have_inertia_factors || !spins_.empty() || !species_.empty() || interactions_.has_passing() ||
                kinematic_count_ > 0;
}

void World::check_mass(double mass, const std::string& where) const {
  if (mass != std::numeric_limits<double>::infinity()) return check_positive(mass, "mass", where);
  if (motion_.is_straight()) return;
  throw Error("a kinematic sphere, of infinite mass, does not fall", where,
              "give it a finite mass, or remove gravity");
}

void World::check_fits(double radius, std::size_t axis, const std::string& where) const {
  const double size = box_.size()[axis];
  if (2 * radius <= size * (1 + kWallTolerance)) return;
  throw Error("diameter " + to_text(2 * radius) + " exceeds the box size " + to_text(size) + " along " +
                  kAxisNames[axis],
              where, "enlarge the box or shrink the sphere");
}

void World::check_velocity(SphereId id, const Vec3& velocity) const {
  check_vector(velocity, kVelocityNames, name_of(id));
  check_in_plane(velocity, "velocity", name_of(id));
}

World World::without_spheres() const {
  World world(box_);
  world.motion_ = motion_;
  world.surfaces_ = surfaces_;
  world.interactions_ = interactions_;
  world.note_reaches();
  world.has_grown_ = has_grown_;
  world.last_passage_ = last_passage_;
  return world;
}

Slot World::insert(const SphereState& state) {
  HARDBALL_CHECK(!has_journal_);
  order_.insert(rank_of(state.id), static_cast<Slot>(size()));
  append(state);
  next_id_ = std::max(next_id_, state.id + 1);
  return static_cast<Slot>(size() - 1);
}

// When many have been appended.
void World::order_ids() {
  HARDBALL_CHECK(!has_journal_);
  for (const SphereId id : ids_) next_id_ = std::max(next_id_, id + 1);
  order_.sort(ids_, next_id_);
}

void World::remove_at(Slot slot, const Time& moment) {
  while (!levels_.of(slot).empty()) {
    const PairLevel pair = levels_.of(slot).back();
    set_level(slot, pair.partner, pair.potential, 0, moment);
  }
  if (has_journal_) journal_.note(Journal::Kind::death, moment, slot, state_of(slot));
  const auto last = static_cast<Slot>(size() - 1);
  levels_.take_place(slot, last);
  const std::size_t rank = rank_of(ids_[slot]);
  if (slot != last) order_.move(rank_of(ids_[last]), slot);
  order_.erase(rank);
  if (is_kinematic(slot)) --kinematic_count_;
  const auto erase = [slot](auto& values) {
    if (values.empty()) return;
    values[slot] = values.back();
    values.pop_back();
  };
  erase(ids_);
  erase(paths_);
  radii_.erase(slot);
  masses_.erase(slot);
  inertia_factors_.erase(slot);
  erase(spins_);
  erase(species_);
  erase(folded_);
}

void World::undo_add() {
  if (has_journal_) journal_.pop();
  const bool had_journal = std::exchange(has_journal_, false);
  remove(--next_id_);
  has_journal_ = had_journal;
}

void World::reorder(std::span<const Slot> order) {
  HARDBALL_CHECK(!has_journal_);
  const auto reordered = [order](const auto& values) {
    std::remove_cvref_t<decltype(values)> moved;
    if (values.empty()) return moved;
    moved.reserve(values.size());
    for (const Slot slot : order) moved.push_back(values[slot]);
    return moved;
  };
  ids_ = reordered(ids_);
  paths_ = reordered(paths_);
  folded_ = reordered(folded_);
  radii_.reorder(order);
  masses_.reorder(order);
  inertia_factors_.reorder(order);
  spins_ = reordered(spins_);
  species_ = reordered(species_);
  levels_.reorder(order);
  order_.sort(ids_, next_id_);
}

Image World::change_velocity(Slot slot, const Time& moment, const Vec3& velocity) {
  check_velocity(id(slot), velocity);
  check_moment(moment, name_of(id(slot)));
  return rewrite_path(slot, moment, velocity);
}

Image World::rewrite_path(Slot slot, const Time& moment, const Vec3& velocity) {
  Vec3 position = unfolded_position(slot, moment);
  const Image folded = box_.boxes_beyond(position, moment);
  position -= box_.shift(folded, moment);
  SphereEdit(*this, moment, slot).store_path(slot, {position, velocity, moment}, folded);
  return folded;
}

void World::set_spin(Slot slot, const Vec3& spin) {
  if (spins_.empty()) {
    if (spin == Vec3{}) return;
    spins_.assign(size(), Vec3{});
  }
  spins_[slot] = spin;
  note_traits();
}

void World::reshape(Slot slot, double radius, double mass, double inertia_factor) {
  const std::string where = name_of(id(slot));
  check_positive(radius, "radius", where);
  check_mass(mass, where);
  check_positive(inertia_factor, "moment", where);
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (box_.is_bounded(axis)) check_fits(radius, axis, where);
  }
  if (is_kinematic(slot)) --kinematic_count_;
  if (std::isinf(mass)) ++kinematic_count_;
  has_grown_ |= radius > radii_[slot];
  radii_.set(slot, radius);
  masses_.set(slot, mass);
  inertia_factors_.set(slot, inertia_factor);
  note_traits();
}

void World::set_interactions(const Interactions& interactions) {
  const Interactions before = std::exchange(interactions_, interactions);
  note_reaches();
  try {
    check_steps();
    if (motion_.has_growth()) refuse_growth_with_others();
    refuse_shear_with_others();
  } catch (...) {
    interactions_ = before;
    note_reaches();
    throw;
  }
  note_traits();
}

void World::set_growth(const Growth& growth) {
  check_growth(growth);
  refuse_growth_with_others();
  const double largest = radii_.largest() * growth.largest_scale();
  const double room = largest_fitting_radius(box_, surfaces_);
  if (largest > room * (1 + kWallTolerance)) {
    throw Error("a sphere would grow to the radius " + to_text(largest) + " where " + to_text(room) + " fits",
                "growth", "end the growth earlier");
  }
  motion_.set_growth(growth);
  note_reaches();
}

void World::end_growth(const Time& moment) {
  HARDBALL_CHECK(!has_journal_);
  radii_.multiply(motion_.scale_at(moment));
  motion_.set_growth({});
  note_reaches();
  // When the present paths began, spheres of these sizes might have overlapped.
  for (Slot slot = 0; slot < size(); ++slot) rewrite_path(slot, moment, velocity(slot, moment));
}

void World::refuse_growth_with_others() const {
  const auto refuse = [](const char* what, const char* remedy) {
    throw Error(std::string("spheres grow, and ") + what, "growth", remedy);
  };
  if (!motion_.is_straight()) refuse("there is gravity", "remove one of them");
  if (kinematic_count_ > 0) refuse("some are kinematic, of infinite mass", "give them a finite mass");
  if (has_spins() || interactions_.table().is_rough()) refuse("some are rough, or spin", "make them smooth");
  if (interactions_.table().has_merging()) refuse("some merge", "let them bounce");
  if (interactions_.has_passing()) refuse("some pass through each other", "let them bounce");
  if (has_steps()) refuse("there are potentials of steps", "remove one of them");
  if (box_.is_sheared()) refuse("the box is sheared", "remove one of them");
  check_walls_for_growth(box_, surfaces_);
}

void World::refuse_shear_with_others() const {
  if (!box_.is_sheared()) return;
  const auto refuse = [](const char* what, const char* remedy) {
    throw Error(std::string("the box is sheared, and ") + what, "shear", remedy);
  };
  if (!motion_.is_straight()) refuse("there is gravity", "remove one of them");
  if (has_steps()) refuse("there are potentials of steps", "remove one of them");
}

std::optional<Slot> World::find(SphereId id, Slot hint) const {
  if (hint < size() && ids_[hint] == id) return hint;
  const std::size_t rank = rank_of(id);
  if (rank == size()) return std::nullopt;
  const Slot slot = slot_of_rank(rank);
  return ids_[slot] == id ? std::optional(slot) : std::nullopt;
}

Slot World::slot_of(SphereId id) const {
  const std::optional<Slot> slot = find(id);
  if (!slot) throw Error("there is no sphere " + to_text(id), "sphere id", "use an id that add() returned");
  return *slot;
}

Vec3 World::position(Slot slot, const Time& moment) const {
  check_queried(moment, "position");
  const Vec3 position = unfolded_position(slot, moment);
  return position - box_.shift(box_.boxes_beyond(position, moment), moment);
}

Vec3 World::velocity_in_box(Slot slot, const Time& moment) const {
  State state = motion_.state_at(paths_[slot], moment);
  box_.fold(state.position, state.velocity, moment);
  return state.velocity;
}

Image World::image(Slot slot, const Time& moment) const {
  check_queried(moment, "image");
  return folded_[slot] + box_.boxes_beyond(unfolded_position(slot, moment), moment);
}

double World::kinetic_energy(const Time& moment) const {
  ExactSum energy;
  for (Slot slot = 0; slot < size(); ++slot) energy += hardball::kinetic_energy(*this, slot, moment);
  return energy.value();
}

double World::rotational_energy() const {
  if (!has_spins()) return 0;
  ExactSum energy;
  for (Slot slot = 0; slot < size(); ++slot) energy += hardball::rotational_energy(*this, slot);
  return energy.value();
}

double World::energy(const Time& moment) const {
  ExactSum energy;
  for (Slot slot = 0; slot < size(); ++slot) energy += hardball::energy(*this, slot, moment);
  return energy.value();
}

Vec3 World::momentum(const Time& moment) const {
  std::array<ExactSum, kAxes> sums;
  for (Slot slot = 0; slot < size(); ++slot) {
    const Vec3 momentum = hardball::momentum(*this, slot, moment);
    for (std::size_t axis = 0; axis < kAxes; ++axis) sums[axis] += momentum[axis];
  }
  return {sums[0].value(), sums[1].value(), sums[2].value()};
}

double World::sphere_volume(const Time& moment) const {
  ExactSum volume;
  for (Slot slot = 0; slot < size(); ++slot) volume += box_.sphere_volume(radius(slot, moment));
  return volume.value();
}

double World::largest_radius() const {
  return radii_.largest() * motion_.largest_scale();
}

std::size_t World::memory_bytes() const {
  return paths_.capacity() * sizeof(Path) + radii_.memory_bytes() + masses_.memory_bytes() +
         ids_.capacity() * sizeof(SphereId) + order_.memory_bytes() + inertia_factors_.memory_bytes() +
         spins_.capacity() * sizeof(Vec3) + species_.capacity() * sizeof(SpeciesId) +
         folded_.capacity() * sizeof(Image) + surfaces_.capacity() * sizeof(Surface) + levels_.memory_bytes();
}

double rotational_energy(const World& world, Slot slot) {
  if (!world.has_spins() || world.is_kinematic(slot)) return 0;
  const Vec3 spin = world.spin(slot);
  const double radius = world.base_radius(slot);
  return world.inertia_factor(slot) * world.mass(slot) * radius * radius * dot(spin, spin) / 2;
}

double energy(const World& world, Slot slot, const Time& moment) {
  if (world.is_kinematic(slot)) return 0;
  const double kinetic = kinetic_energy(world, slot, moment) + rotational_energy(world, slot);
  if (world.has_steps()) return kinetic + world.step_energy(slot);
  if (world.motion().is_straight()) return kinetic;
  return kinetic - world.mass(slot) * dot(world.motion().gravity(), world.unwrapped_position(slot, moment));
}

Time sheared_contact_time(const World& world, Slot a, Slot b, const Image& image) {
  // This returns the same bits at less cost.
  if (image[1] == 0) {
    return contact_time(world.motion(), world.path(a), world.path(b), world.box().shift(image),
                        world.base_radius(a) + world.base_radius(b));
  }
  const Vec3 boxes{static_cast<double>(image[0]), static_cast<double>(image[1]),
                   static_cast<double>(image[2])};
  return contact_time_of_sliding(world.box().images(), world.box().period(), world.path(a), world.path(b),
                                 boxes, world.base_radius(a) + world.base_radius(b));
}

bool are_passing(const World& world, Slot a, Slot b, const Image& image) {
  const Time start = later(world.path(a).time, world.path(b).time);
  const Vec3 separation = relative_state(world, a, b, image, start).position;
  return are_inside(separation, world.base_radius(a) + world.base_radius(b)) ||
         is_recorded(make_collision(contact_time(world, a, b, image), world.id(a), world.id(b), {}),
                     world.last_passage());
}

bool World::restored() {
  const std::size_t count = ids_.size();
  const auto fits = [count](const auto& values) { return values.empty() || values.size() == count; };
  const bool is_complete = paths_.size() == count && folded_.size() == count && radii_.size() == count &&
                           masses_.size() == count && inertia_factors_.size() == count && fits(spins_) &&
                           fits(species_);
  if (!is_complete || last_passage_.kind > EventKind::wall) return false;
  const StepTable& steps = interactions_.steps();
  for (const auto& [slot, pair] : levels_.in_order()) {
    if (pair.potential >= steps.size() || pair.level > steps[pair.potential].steps()) return false;
  }
  note_reaches();
  check_steps();
  check_setting(box_, motion_, surfaces_);
  check_growth(motion_.growth());
  std::vector<SphereId> sorted(ids_.begin(), ids_.end());
  std::ranges::sort(sorted);
  if (std::ranges::adjacent_find(sorted) != sorted.end() || (count > 0 && sorted.back() >= next_id_))
    return false;
  for (Slot slot = 0; slot < count; ++slot) {
    const Path& path = paths_[slot];
    const std::string where = name_of(ids_[slot]);
    check_positive(radii_[slot], "radius", where);
    check_mass(masses_[slot], where);
    check_positive(inertia_factors_[slot], "moment", where);
    check_moment(path.time, where);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const double x = path.position[axis];
      check_finite(x, kPositionNames[axis], where);
      check_finite(path.velocity[axis], kVelocityNames[axis], where);
      check_finite(spin(slot)[axis], kSpinNames[axis], where);
      if (box_.is_bounded(axis)) check_fits(radii_[slot], axis, where);
      if (box_.is_periodic(axis) && !(x >= 0 && x <= box_.size()[axis])) return false;
    }
    check_in_plane(path.position, "position", where);
    check_in_plane(path.velocity, "velocity", where);
    check_spin(spin(slot), where);
    if (std::isinf(masses_[slot])) ++kinematic_count_;
  }
  order_.sort(ids_, next_id_);
  note_traits();
  if (motion_.has_growth()) set_growth(motion_.growth());
  refuse_shear_with_others();
  return true;
}

}  // namespace hardball
