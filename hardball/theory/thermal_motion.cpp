// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/theory/thermal_motion.hpp"
#include "hardball/world/images.hpp"

#include <cmath>

namespace hardball {

double mean_over_normal(double degrees_of_freedom) {
  const double f = degrees_of_freedom;
  return std::sqrt(f / 2) * std::exp(std::lgamma(f / 2) - std::lgamma((f + 1) / 2));
}

std::array<bool, kAxes> drift_axes(const World& world) {
  std::array<bool, kAxes> has_drift{};
  const Box& box = world.box();
  if (world.kinematic_count() > 0 || !world.surfaces().empty() || !box.has_plain_faces()) return has_drift;
  for (std::size_t axis = 0; axis < box.dimensions(); ++axis) {
    has_drift[axis] = !box.is_wall(axis) && world.motion().gravity()[axis] == 0;
  }
  return has_drift;
}

ThermalMotion thermal_motion(const World& world, const Time& moment) {
  ThermalMotion motion;
  motion.is_driven = world.box().is_sheared();
  if (world.size() == 0) return motion;
  Vec3 momentum;
  double mass = 0;
  std::size_t deflected = 0;
  world.for_each_by_id([&](Slot slot) {
    if (world.is_kinematic(slot)) return;
    ++deflected;
    momentum += world.mass(slot) * peculiar_velocity(world, slot, moment);
    mass += world.mass(slot);
  });
  motion.degrees_of_freedom = static_cast<double>(world.box().dimensions() * deflected);
  const std::array<bool, kAxes> has_drift = drift_axes(world);
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!has_drift[axis]) continue;
    motion.drift[axis] = momentum[axis] / mass;
    --motion.degrees_of_freedom;
  }
  world.for_each_by_id([&](Slot slot) {
    if (world.is_kinematic(slot)) return;
    const Vec3 velocity = peculiar_velocity(world, slot, moment) - motion.drift;
    motion.energy += world.mass(slot) * dot(velocity, velocity) / 2;
  });
  return motion;
}

bool is_energy_conserved(const ThermalMotion& begin, const ThermalMotion& end) {
  constexpr double kRounding = 1e-9;
  return !end.is_driven && std::fabs(end.energy - begin.energy) <= kRounding * begin.energy;
}

}  // namespace hardball
