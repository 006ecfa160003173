// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/world/totals.hpp"

#include <algorithm>

namespace hardball {

void Totals::note(const World& world, Slot slot, const Time& moment) {
  kinetic_energy += hardball::kinetic_energy(world, slot, moment);
  rotational_energy += hardball::rotational_energy(world, slot);
  energy += hardball::energy(world, slot, moment);
  const Vec3 of_sphere = hardball::momentum(world, slot, moment);
  for (std::size_t axis = 0; axis < kAxes; ++axis) momentum[axis] += of_sphere[axis];
  sphere_volume += world.box().sphere_volume(world.radius(slot, moment));
  if (!world.is_kinematic(slot)) mass += world.mass(slot);
  highest_speed =
      std::max({highest_speed, length(world.path(slot).velocity), length(world.velocity(slot, moment))});
}

void Totals::add(const Totals& other) {
  kinetic_energy.add(other.kinetic_energy);
  rotational_energy.add(other.rotational_energy);
  energy.add(other.energy);
  for (std::size_t axis = 0; axis < kAxes; ++axis) momentum[axis].add(other.momentum[axis]);
  sphere_volume.add(other.sphere_volume);
  mass.add(other.mass);
  highest_speed = std::max(highest_speed, other.highest_speed);
}

Totals totals_of(const World& world, const Time& moment) {
  Totals totals;
  for (Slot slot = 0; slot < world.size(); ++slot) totals.note(world, slot, moment);
  return totals;
}

}  // namespace hardball
