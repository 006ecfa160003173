// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// A ball among heavy rocks: where it is after each second, and what it hits next.
#include <cstdio>

#include "hardball/hardball.hpp"

int main() {
  hardball::World world(hardball::Box::walls({10, 10, 10}));
  const hardball::SphereId ball = world.add({.position = {2, 5, 5}, .velocity = {3, 0, 0}, .radius = 0.25});
  world.add({.position = {6, 5.5, 5}, .radius = 1, .mass = 100});
  world.add({.position = {5, 1.5, 4.5}, .radius = 1, .mass = 100});
  hardball::Simulation simulation(world);

  std::printf("time  ball at             hits next  at time\n");
  for (int second = 0; second <= 5; ++second) {
    simulation.run_until(second);
    const hardball::Vec3 place = simulation.position(ball);
    std::printf("%4d  %5.2f %5.2f %5.2f", second, place.x, place.y, place.z);
    if (const auto next = simulation.first_contact(ball, simulation.velocity(ball), 100)) {
      const char* what = next->kind == hardball::EventKind::collision ? "rock" : "wall";
      std::printf("   %4s %d     %7.3f", what, static_cast<int>(next->second), next->time);
    }
    std::printf("\n");
  }
}
