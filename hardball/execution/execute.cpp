// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/execution/execute.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/world/pair_event.hpp"
#include "hardball/world/walls.hpp"

namespace hardball {
namespace {

// An approach is attributed to rounding if it is below this fraction of the speeds involved, or below the
// operating range, where numbers lose precision.
constexpr double kRounding = 1e-12;

[[noreturn]] void refuse_response(const Contact& contact, const std::string& what, const char* remedy) {
  throw Error(what + " at the contact at time " + to_text(contact.time.value()), place_of_response(contact),
              remedy);
}

void refuse_approach(const Contact& contact) {
  refuse_response(contact, "the bodies still approach each other",
                  "return velocities with which they separate or stay in contact");
}

std::string to_text(const Vec3& vector) {
  using hardball::to_text;
  return "(" + to_text(vector.x) + ", " + to_text(vector.y) + ", " + to_text(vector.z) + ")";
}

void undo_approach_to_face(Contact& contact) {
  double& velocity = contact.after.first[axis_of(contact.second)];
  const double approach = (is_upper(contact.second) ? velocity : -velocity) + contact.growth;
  if (!(approach > 0)) return;
  if (approach > kRounding * (length(contact.before.first) + std::fabs(contact.growth)))
    refuse_approach(contact);
  velocity = is_upper(contact.second) ? -contact.growth : contact.growth;
}

// The speeds that matter: rounding errors are relative to them.
double speeds_of(const Contact& contact) {
  return length(contact.before.first) + length(contact.before.second) + length(contact.after.first) +
         std::fabs(contact.growth);
}

void undo_approach_to_surface(const World& world, Contact& contact, double base_radius) {
  const Surface& surface = world.surface(contact.second);
  const Vec3 image = surface.mesh() ? world.box().shift(contact.image)
                                    : nearest_image_of(world.box(), surface, contact.position);
  const Vec3 settled = contact.after.first;
  double excess = dot(settled - contact.before.second, contact.wall_normal) + contact.growth;
  if (excess > kRounding * speeds_of(contact) + kSmallestMagnitude) refuse_approach(contact);
  excess = std::max(excess, 0x1p-60 * speeds_of(contact));
  const auto approaches = [&] {
    return surface.is_approached(world.motion(),
                                 {contact.position - image, contact.after.first, contact.time}, base_radius,
                                 contact.feature);
  };
  while (approaches()) {
    contact.after.first = settled - excess * contact.wall_normal;
    excess *= 2;
  }
}

// The part of a change of relative velocity that the first sphere takes.
double share_of_first(const Contact& contact) {
  if (std::isinf(contact.first_mass)) return 0;
  return std::isinf(contact.second_mass) ? 1
                                         : contact.second_mass / (contact.first_mass + contact.second_mass);
}

void undo_approach_of_spheres(const World& world, Contact& contact) {
  const Vec3& r = contact.separation;
  // As contacts are predicted.
  const auto approach_with = [&](const Velocities& velocities) {
    if (contact.image_speed != 0) {
      const Vec3 image{contact.image_speed, 0, 0};
      return dot(r, ((velocities.second - image) - velocities.first) + image);
    }
    if (!world.motion().has_growth()) return approach(r, velocities);
    return approach(
        GrowingPair<double>{r, velocities.second - velocities.first, contact.reach, contact.growth});
  };
  const double excess = approach_with(contact.after);
  if (!(excess < 0)) return;
  const double speeds = length(contact.before.first) + length(contact.before.second) +
                        length(contact.after.first) + length(contact.after.second) +
                        std::fabs(contact.growth);
  if (-excess > length(r) * (kRounding * speeds + kSmallestMagnitude)) refuse_approach(contact);
  const double share = share_of_first(contact);
  double exchange = excess / dot(r, r);
  Velocities settled = contact.after;
  while (approach_with(settled) < 0) {
    settled.first = contact.after.first + (exchange * share) * r;
    settled.second = contact.after.second - (exchange * (1 - share)) * r;
    exchange *= 2;
  }
  contact.after = settled;
}

// Sets the spins and species of a contact, and whether the spheres pass through each other. Precondition:
// the spheres' masses are set.
void describe_traits(const World& world, const Participants& participants, Contact& contact) {
  const bool is_collision = contact.is_collision();
  const Slot first = participants.first;
  const Slot second = participants.second;
  contact.spins_before = {world.spin(first), is_collision ? world.spin(second) : Vec3{}};
  contact.spins_after = contact.spins_before;
  contact.first_inertia_factor = world.inertia_factor(first);
  contact.second_inertia_factor = is_collision ? world.inertia_factor(second) : kSphereInertiaFactor;
  contact.first_species = world.species(first);
  contact.second_species = is_collision ? world.species(second) : SpeciesId{0};
  if (is_collision && pass(world, first, second)) contact.outcome = ContactOutcome::pass;
}

// Gives a contact whose radii are base radii those that they are at its time, and their growth.
void describe_growth(const Growth& growth, Contact& contact) {
  const double scale = growth.scale_at(contact.time);
  contact.growth = contact.reach * growth.rate;
  contact.reach *= scale;
  contact.first_radius *= scale;
  contact.second_radius *= scale;
}

// From the point of a surface to where a sphere touches it, in the coordinates of this image of the surface.
Vec3 arm_of(const Surface& surface, const Vec3& image, const Contact& contact) {
  Vec3 arm = (contact.position - image) + contact.separation - surface.point();
  if (surface.velocity() != Vec3{}) arm -= duration(surface.since(), contact.time) * surface.velocity();
  // The point of a plane that oscillates stays in it.
  if (const Vec3* const normal = surface.normal()) arm -= dot(arm, *normal) * *normal;
  return arm;
}

// Sets what a contact says of its wall, and the wall's velocity. Preconditions: time and position are set;
// the sphere of this base radius was on `path`, and its position has been folded back by so many boxes.
void describe_wall(const World& world, std::uint32_t wall, const Path& path, double radius,
                   const Image& folded, Contact& contact, Vec3& velocity) {
  if (wall < kFaces) {
    const std::size_t axis = axis_of(wall);
    contact.wall_normal = {};
    contact.wall_normal[axis] = is_upper(wall) ? 1 : -1;
    contact.separation = {};
    contact.separation[axis] = (is_upper(wall) ? world.box().size()[axis] : 0) - contact.position[axis];
    const FaceProperties& face = world.box().face(wall);
    contact.wall_material = face.material;
    contact.wall_arm = {};
    velocity = face.velocity;
  } else {
    const Surface& surface = world.surface(wall);
    velocity = surface.velocity_at(contact.time);
    if (surface.mesh()) {
      const MeshTouch touch = touch_of_mesh(world, wall, path, radius, contact.time);
      const double distance = length(touch.towards);
      contact.image = touch.image - folded;
      contact.feature = touch.feature;
      contact.triangle = surface.mesh()->mesh().triangle_of(touch.feature);
      contact.group = surface.mesh()->mesh().group(contact.triangle);
      contact.wall_normal = (1 / distance) * touch.towards;
      contact.separation = touch.towards - surface.mesh()->thickness() * contact.wall_normal;
      contact.wall_arm = arm_of(surface, world.box().shift(contact.image), contact);
      contact.wall_material = surface.material_of(touch.feature);
    } else {
      const Vec3 image = nearest_image_of(world.box(), surface, contact.position);
      const Vec3 position = contact.position - image;
      contact.wall_normal = surface.direction(position, contact.time);
      contact.separation = surface.distance(position, contact.time) * contact.wall_normal;
      contact.wall_arm = arm_of(surface, image, contact);
      contact.wall_material = surface.material();
    }
  }
  contact.wall_material.is_flat = world.box().is_flat();
  contact.pressing = dot(world.motion().gravity(), contact.wall_normal);
}

}  // namespace

Participants participants_of(const World& world, const Event& event) {
  const bool is_collision = event.kind == EventKind::collision;
  return {world.slot_of(event.first), is_collision ? world.slot_of(event.second) : 0};
}

void contact_at(const World& world, const Event& event, const Participants& participants, Executed& done) {
  const Box& box = world.box();
  const Path& path = world.path(participants.first);
  const double radius = world.base_radius(participants.first);
  auto [position, velocity] = world.motion().state_at(path, event.time);
  done.folded[0] = box.fold(position, velocity, event.time);
  Velocities before;
  Contact& contact = done.contact;
  contact.time = event.time;
  contact.kind = event.kind;
  contact.first = event.first;
  contact.second = event.second;
  contact.position = position;
  contact.first_radius = radius;
  contact.first_mass = world.mass(participants.first);
  contact.first_since = path.time;
  if (event.kind == EventKind::collision) {
    const Path& second_path = world.path(participants.second);
    const double second_radius = world.base_radius(participants.second);
    auto [second_position, second_velocity] = world.motion().state_at(second_path, event.time);
    done.folded[1] = box.fold(second_position, second_velocity, event.time);
    contact.image = participants.nearest ? box.nearest_image(position - second_position, event.time)
                                         : event.image + done.folded[1] - done.folded[0];
    contact.second_position = second_position;
    contact.separation = (second_position - position) + box.shift(contact.image, event.time);
    contact.second_radius = second_radius;
    contact.reach = radius + second_radius;
    contact.second_mass = world.mass(participants.second);
    contact.second_since = second_path.time;
    if (box.is_sheared()) [[unlikely]] {
      contact.image_speed = box.image_velocity(contact.image).x;
      second_velocity.x += contact.image_speed;
    }
    before = {velocity, second_velocity};
  } else {
    contact.image = {};
    contact.feature = 0;
    contact.triangle = 0;
    contact.group = 0;
    contact.image_speed = 0;
    contact.second_position = {};
    contact.second_radius = 0;
    contact.reach = radius;
    contact.second_mass = std::numeric_limits<double>::infinity();
    contact.second_since = Time(-std::numeric_limits<double>::infinity());
    before = {velocity, {}};
    describe_wall(world, event.second, path, radius, done.folded[0], contact, before.second);
  }
  contact.growth = 0;
  if (world.motion().has_growth()) [[unlikely]]
    describe_growth(world.motion().growth(), contact);
  contact.outcome = ContactOutcome::bounce;
  if (contact.step.happens()) [[unlikely]]
    contact.step = {};
  // Without traits, spins are zero unless the last response returned others that were refused.
  if (world.has_traits() || done.may_turn) [[unlikely]]
    describe_traits(world, participants, contact);
  // Twice from registers: reading back what has just been written would stall.
  contact.before = before;
  contact.after = before;
}

void keep_kinematic(Contact& contact) {
  if (!contact.is_collision()) return;
  if (std::isinf(contact.first_mass)) {
    contact.after.first = contact.before.first;
    contact.spins_after.first = contact.spins_before.first;
  }
  if (std::isinf(contact.second_mass)) {
    contact.after.second = contact.before.second;
    contact.spins_after.second = contact.spins_before.second;
  }
}

void check_spins(const Box& box, const Contact& contact) {
  const auto check = [&](const Vec3& spin) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      // A disc spins about z.
      const double most = axis < 2 && box.is_flat() ? 0 : kLargestMagnitude;
      if (std::fabs(spin[axis]) <= most) continue;
      refuse_response(contact, "the spin " + to_text(spin) + " is returned",
                      box.is_flat() ? "return finite spins of magnitude at most 1e60 about z"
                                    : "return finite spins of magnitude at most 1e60");
    }
  };
  check(contact.spins_after.first);
  if (contact.is_collision()) check(contact.spins_after.second);
}

void store_spins(SphereEdit& edit, const Contact& contact, const Participants& participants) {
  edit.store_spin(participants.first, contact.spins_after.first);
  if (contact.is_collision()) edit.store_spin(participants.second, contact.spins_after.second);
}

void refuse_velocities(const Box& box, const Contact& contact) {
  std::string what = "the velocity " + to_text(contact.after.first) + " is returned";
  if (contact.is_collision()) {
    what = "the velocities " + to_text(contact.after.first) + " and " + to_text(contact.after.second) +
           " are returned";
  }
  refuse_response(contact, what,
                  box.is_flat() ? "return finite velocities of magnitude at most 1e60, and none along z"
                                : "return finite velocities of magnitude at most 1e60");
}

std::string place_of_response(const Contact& contact) {
  return "response to sphere " + to_text(contact.first) + " and " +
         (contact.is_collision() ? "sphere " : "wall ") + to_text(contact.second);
}

void decide_between_surfaces(const Interactions& interactions, Contact& contact) {
  const Velocities centers = contact.before;
  // A radius grows by as much of `growth` as it has of `reach`.
  const Vec3 rate = (contact.growth / contact.reach) * contact.normal();
  contact.before.first += contact.first_radius * rate;
  if (contact.is_collision()) contact.before.second -= contact.second_radius * rate;
  contact.after = contact.before;
  static_cast<void>(interactions.decide(contact));
  if (contact.outcome == ContactOutcome::merge)
    check_exclusions(Feature::growth, Feature::merging, place_of_response(contact));
  if (!(contact.spins_after == contact.spins_before))
    check_exclusions(Feature::growth, Feature::roughness, place_of_response(contact));
  contact.after.first = centers.first + (contact.after.first - contact.before.first);
  contact.after.second = centers.second + (contact.after.second - contact.before.second);
  contact.before = centers;
}

void undo_approach(const World& world, Contact& contact, const Participants& participants) {
  if (contact.is_collision()) {
    undo_approach_of_spheres(world, contact);
  } else if (contact.second < kFaces) {
    undo_approach_to_face(contact);
  } else {
    undo_approach_to_surface(world, contact, world.base_radius(participants.first));
  }
}

}  // namespace hardball
