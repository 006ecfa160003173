// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/interaction/restitution.hpp"

#include <algorithm>
#include <cmath>

#include "hardball/errors/error.hpp"
#include "hardball/interaction/roughness.hpp"
#include "hardball/interaction/thermal_wall.hpp"

namespace hardball {
namespace {

// A plane perpendicular to an axis leaves the other components of a velocity unchanged, to the bit.
bool is_along_axis(const Vec3& normal) {
  return std::fabs(normal.x) == 1 || std::fabs(normal.y) == 1 || std::fabs(normal.z) == 1;
}

}  // namespace

Restitution::Restitution(double coefficient, double elastic_below)
    : coefficient_(coefficient), elastic_below_(elastic_below) {
  if (!(coefficient >= 0 && coefficient <= 1)) {
    throw Error("restitution is " + to_text(coefficient), "restitution", "give a number between 0 and 1");
  }
  if (!(elastic_below >= 0 && std::isfinite(elastic_below))) {
    throw Error("elastic_below is " + to_text(elastic_below), "elastic_below",
                "give zero or a positive speed");
  }
}

bool Restitution::is_slow(const Contact& collision) const {
  const Vec3& r = collision.separation;
  const double closing = approach(r, collision.before);
  return closing * closing < elastic_below_ * elastic_below_ * dot(r, r);
}

Velocities Restitution::bounce(const Contact& contact) const {
  Velocities after = contact.before;
  if (contact.wall_material.temperature) {
    after.first = rethermalized(contact);
    return after;
  }
  const double impact_speed = dot(contact.before.first - contact.before.second, contact.wall_normal);
  const double coefficient =
      std::fabs(impact_speed) < elastic_below_ ? 1 : contact.wall_material.restitution.value_or(coefficient_);
  after.first = velocity_after_bounce(contact, coefficient, least_parting_speed(contact, elastic_below_));
  return after;
}

bool Restitution::decide_at_wall(Contact& contact) const {
  contact.after = bounce(contact);
  const SurfaceMaterial& material = contact.wall_material;
  if (!material.tangential_restitution || material.temperature) return false;
  rub(*material.tangential_restitution, contact);
  return true;
}

Vec3 velocity_after_bounce(const Contact& contact, double coefficient, double least_speed) {
  Vec3 after = contact.before.first;
  const Vec3& normal = contact.wall_normal;
  const Vec3 velocity = contact.before.first - contact.before.second;
  const double impact_speed = dot(velocity, normal);
  const double parting_speed = std::max(least_speed, coefficient * impact_speed);
  if (is_along_axis(normal)) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (normal[axis] == 0) continue;
      after[axis] = contact.before.second[axis] - parting_speed * normal[axis];
    }
  } else if (parting_speed > coefficient * impact_speed || !(impact_speed > 0)) {
    after -= (impact_speed + parting_speed) * normal;
  } else {
    // Scaled as the separation of spheres is, but by what varies at a plane, too.
    const Vec3 r = (1 + velocity.x * velocity.x / dot(velocity, velocity)) * normal;
    after -= ((1 + coefficient) * dot(velocity, r) / dot(r, r)) * r;
  }
  return after;
}

}  // namespace hardball
