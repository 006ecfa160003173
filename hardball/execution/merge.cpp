// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "hardball/errors/error.hpp"
#include "hardball/execution/execute.hpp"
#include "hardball/numbers/cube_root.hpp"

namespace hardball {
namespace {

double cube(double x) {
  return x * x * x;
}

double inertia(double inertia_factor, double mass, double radius) {
  return inertia_factor * mass * radius * radius;
}

}  // namespace

void merge(World& world, Contact& contact, const Participants& participants) {
  HARDBALL_CHECK(contact.is_collision());
  if (world.has_steps()) check_exclusions(Feature::steps, Feature::merging, place_of_response(contact));
  const double mass = contact.first_mass + contact.second_mass;
  const double a = contact.first_radius;
  const double b = contact.second_radius;
  const double radius = world.box().is_flat() ? std::sqrt(a * a + b * b) : cube_root(cube(a) + cube(b));
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!world.box().is_bounded(axis) || 2 * radius <= world.box().size()[axis]) continue;
    throw RunFailure("spheres " + to_text(contact.first) + " and " + to_text(contact.second) +
                     " would merge into a sphere larger than the box, at time " +
                     to_text(contact.time.value()) + "; enlarge the box, or end the run before this time");
  }
  const bool is_kinematic = std::isinf(mass);
  // The share of the second in the merged sphere; of a kinematic sphere only the size changes.
  const double weight = is_kinematic ? (std::isinf(contact.second_mass) ? 1 : 0) : contact.second_mass / mass;
  const double inertia_factor =
      contact.first_inertia_factor + weight * (contact.second_inertia_factor - contact.first_inertia_factor);
  const Vec3 relative = contact.before.second - contact.before.first;
  const Vec3 velocity = contact.before.first + weight * relative;
  Vec3 spin = weight == 1 ? contact.spins_before.second : contact.spins_before.first;
  if (!is_kinematic) {
    const Vec3 angular_momentum =
        (contact.first_mass * weight) * cross(contact.separation, relative) +
        inertia(contact.first_inertia_factor, contact.first_mass, contact.first_radius) *
            contact.spins_before.first +
        inertia(contact.second_inertia_factor, contact.second_mass, contact.second_radius) *
            contact.spins_before.second;
    spin = (1 / inertia(inertia_factor, mass, radius)) * angular_momentum;
  }
  SphereEdit edit(world, contact.time, participants.first);
  edit.reshape(participants.first, radius, mass, inertia_factor);
  // The path is brought to this time first, so that boxes crossed until then are counted.
  world.rewrite_path(participants.first, contact.time, velocity);
  Path path{contact.position + weight * contact.separation, velocity, contact.time};
  const Image folded = world.box().fold(path.position, path.velocity, contact.time);
  edit.store_path(participants.first, path, folded);
  edit.store_spin(participants.first, spin);
  contact.after = {velocity, velocity};
  contact.spins_after = {spin, spin};
}

}  // namespace hardball
