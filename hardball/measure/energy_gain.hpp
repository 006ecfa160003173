// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "hardball/interaction/contact.hpp"

/// The energy that spheres gain at contacts, negative if they lose it; kinematic spheres gain none.
namespace hardball {

/// The kinetic energy, or with a moment of inertia and spins the rotational energy, that a body gains [M L^2
/// T^-2].
inline double energy_gain(double mass, const Vec3& before, const Vec3& after) {
  if (std::isinf(mass)) [[unlikely]]
    return 0;
  return mass * dot(after - before, after + before) / 2;
}

/// The rotational energy that the first sphere gains [M L^2 T^-2].
inline double rotational_energy_gain_of_first(const Contact& contact) {
  if (contact.spins_before.first == contact.spins_after.first) [[likely]]
    return 0;
  const double inertia = contact.first_inertia_factor * contact.first_radius * contact.first_radius;
  return inertia * energy_gain(contact.first_mass, contact.spins_before.first, contact.spins_after.first);
}

/// The kinetic and rotational energy that the first sphere gains [M L^2 T^-2].
inline double energy_gain_of_first(const Contact& contact) {
  return energy_gain(contact.first_mass, contact.before.first, contact.after.first) +
         rotational_energy_gain_of_first(contact);
}

/// The kinetic and rotational energy that both spheres of a collision gain [M L^2 T^-2].
inline double energy_gain_of_both(const Contact& contact) {
  const double inertia = contact.second_inertia_factor * contact.second_radius * contact.second_radius;
  return energy_gain_of_first(contact) +
         energy_gain(contact.second_mass, contact.before.second, contact.after.second) +
         inertia * energy_gain(contact.second_mass, contact.spins_before.second, contact.spins_after.second);
}

}  // namespace hardball
