// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// A drone that avoids collisions: it queries the next contact, tries several velocities on copies of the
// simulation, and takes the one that stays free of contacts longest.
#include <array>
#include <cstdio>

#include "hardball/hardball.hpp"

namespace {

constexpr double kHorizon = 30;

// How long the drone stays free of contacts at this velocity.
double time_until_touched(hardball::Simulation what_if, hardball::SphereId drone,
                          const hardball::Vec3& velocity) {
  what_if.change_velocity(drone, velocity);
  double touched = kHorizon;
  what_if.on_contact([&](const hardball::Contact& contact) {
    const bool involved = contact.first == drone || (contact.is_collision() && contact.second == drone);
    if (involved && contact.time.value() < touched) touched = contact.time.value();
  });
  what_if.run_until(kHorizon);
  return touched;
}

}  // namespace

int main() {
  hardball::World world(hardball::Box::walls({40, 40, 40}));
  const hardball::SphereId drone = world.add({.position = {5, 20, 20}, .velocity = {2, 0, 0}, .radius = 0.5});
  world.add({.position = {20, 35, 20}, .velocity = {0, -2, 0}, .radius = 1, .mass = 5});
  world.add({.position = {30, 21, 19}, .velocity = {-1, 0, 0}, .radius = 2, .mass = 20});
  world.add({.position = {30, 5, 30}, .velocity = {-0.5, 1, -0.5}, .radius = 3, .mass = 50});

  hardball::Simulation simulation(world);
  if (const auto next = simulation.next_contact(kHorizon)) {
    std::printf("unchanged, the next contact is at %.4f, between %u and %u\n", next->time, next->first,
                next->second);
  }
  constexpr std::array<hardball::Vec3, 4> kWays = {{{2, 0, 0}, {1, 0, 0}, {0, 0.5, 0}, {0, 0.25, -0.5}}};
  hardball::Vec3 best;
  double longest = -1;
  for (const hardball::Vec3& way : kWays) {
    const double touched = time_until_touched(simulation, drone, way);
    std::printf("velocity (%g %g %g): untouched until %.4f\n", way.x, way.y, way.z, touched);
    if (touched <= longest) continue;
    longest = touched;
    best = way;
  }
  simulation.change_velocity(drone, best);
  simulation.run_until(10);
  const hardball::Vec3 place = simulation.position(drone);
  std::printf("at time %g the drone is at (%.4f %.4f %.4f)\n", simulation.time(), place.x, place.y, place.z);
}
