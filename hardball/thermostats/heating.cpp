// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/thermostats/heating.hpp"

#include <cmath>

#include "hardball/geometry/range.hpp"
#include "hardball/numbers/event_random.hpp"

namespace hardball {

Heating::Heating(double strength, double every) : strength_(strength), times_(every) {
  check_positive(strength, "strength", "thermostat");
}

void Heating::act(const World& world, const Time& moment, std::vector<NewVelocity>& changes) {
  times_.advance();
  const std::size_t first = changes.size();
  const double spread = std::sqrt(strength_ * times_.every());
  Vec3 momentum;
  double mass = 0;
  world.for_each_by_id([&](Slot slot) {
    if (world.is_kinematic(slot)) return;
    Random random = event_random(seed_, world.id(slot), times_.passed());
    const Vec3 kick = spread * random.normal_vector(world.box().dimensions());
    const Vec3 before = world.velocity(slot, moment);
    changes.push_back({slot, before, before + kick});
    momentum += world.mass(slot) * kick;
    mass += world.mass(slot);
  });
  const Vec3 drift = (1 / mass) * momentum;
  for (std::size_t i = first; i < changes.size(); ++i) changes[i].after -= drift;
}

}  // namespace hardball
