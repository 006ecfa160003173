// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/interaction/roughness.hpp"

namespace hardball {

void rub(double tangential_restitution, Contact& contact) {
  const Vec3 normal = contact.normal();
  const double first_radius = contact.first_radius;
  const double second_radius = contact.second_radius;
  const Vec3 turning =
      first_radius * contact.spins_before.first + second_radius * contact.spins_before.second;
  const Vec3 slip = (contact.before.first - contact.before.second) + cross(turning, normal);
  const Vec3 tangential = slip - dot(slip, normal) * normal;
  const double first_inverse = 1 / contact.first_mass;
  const double second_inverse = 1 / contact.second_mass;
  const double inverse = first_inverse * (1 + 1 / contact.first_inertia_factor) +
                         second_inverse * (1 + 1 / contact.second_inertia_factor);
  if (inverse == 0) return;  // a kinematic sphere at a wall
  const Vec3 impulse = (-(1 + tangential_restitution) / inverse) * tangential;
  const Vec3 torque = cross(normal, impulse);
  contact.after.first += first_inverse * impulse;
  contact.spins_after.first += (first_inverse / (contact.first_inertia_factor * first_radius)) * torque;
  if (!contact.is_collision()) return;
  contact.after.second -= second_inverse * impulse;
  contact.spins_after.second += (second_inverse / (contact.second_inertia_factor * second_radius)) * torque;
}

}  // namespace hardball
