// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/thermostats/rescale.hpp"

#include <cmath>

#include "hardball/geometry/range.hpp"
#include "hardball/theory/thermal_motion.hpp"

namespace hardball {

Rescale::Rescale(double temperature, double every) : temperature_(temperature), times_(every) {
  check_positive(temperature, "temperature", "thermostat");
}

void Rescale::act(const World& world, const Time& moment, std::vector<NewVelocity>& changes) {
  times_.advance();
  const ThermalMotion motion = thermal_motion(world, moment);
  if (!(motion.energy > 0) || !(motion.degrees_of_freedom > 0)) return;
  const double factor = std::sqrt(temperature_ * motion.degrees_of_freedom / (2 * motion.energy));
  world.for_each_by_id([&](Slot slot) {
    if (world.is_kinematic(slot)) return;
    const Vec3 before = world.velocity(slot, moment);
    changes.push_back({slot, before, motion.drift + factor * (before - motion.drift)});
  });
}

}  // namespace hardball
