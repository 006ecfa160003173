// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/world/totals.hpp"

#include <algorithm>
#include <array>

#include "hardball/world/step_levels.hpp"

namespace hardball {

double rotational_energy(const World& world, Slot slot) {
  if (!world.has_spins() || world.is_kinematic(slot)) return 0;
  const Vec3 spin = world.spin(slot);
  const double radius = world.base_radius(slot);
  return world.inertia_factor(slot) * world.mass(slot) * radius * radius * dot(spin, spin) / 2;
}

double energy(const World& world, Slot slot, const Time& moment) {
  if (world.is_kinematic(slot)) return 0;
  const double kinetic = kinetic_energy(world, slot, moment) + rotational_energy(world, slot);
  if (world.has_steps()) return kinetic + step_energy(world, slot);
  if (world.motion().is_straight()) return kinetic;
  return kinetic - world.mass(slot) * dot(world.motion().gravity(), unwrapped_position(world, slot, moment));
}

double kinetic_energy(const World& world, const Time& moment) {
  ExactSum energy;
  for (Slot slot = 0; slot < world.size(); ++slot) energy += kinetic_energy(world, slot, moment);
  return energy.value();
}

double rotational_energy(const World& world) {
  if (!world.has_spins()) return 0;
  ExactSum energy;
  for (Slot slot = 0; slot < world.size(); ++slot) energy += rotational_energy(world, slot);
  return energy.value();
}

double energy(const World& world, const Time& moment) {
  ExactSum sum;
  for (Slot slot = 0; slot < world.size(); ++slot) sum += energy(world, slot, moment);
  return sum.value();
}

Vec3 momentum(const World& world, const Time& moment) {
  std::array<ExactSum, kAxes> sums;
  for (Slot slot = 0; slot < world.size(); ++slot) {
    const Vec3 of_sphere = momentum(world, slot, moment);
    for (std::size_t axis = 0; axis < kAxes; ++axis) sums[axis] += of_sphere[axis];
  }
  return {sums[0].value(), sums[1].value(), sums[2].value()};
}

double sphere_volume(const World& world, const Time& moment) {
  ExactSum volume;
  for (Slot slot = 0; slot < world.size(); ++slot)
    volume += world.box().sphere_volume(world.radius(slot, moment));
  return volume.value();
}

void Totals::record(const World& world, Slot slot, const Time& moment) {
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
  for (Slot slot = 0; slot < world.size(); ++slot) totals.record(world, slot, moment);
  return totals;
}

}  // namespace hardball
