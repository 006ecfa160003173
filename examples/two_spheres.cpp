// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Two spheres in a box: all their collisions.
#include <cstdio>

#include "hardball/simulation.hpp"
#include "hardball/world.hpp"

int main() {
  hardball::World world(hardball::Box::walls({10, 10, 10}));
  world.add({.position = {2, 5, 5}, .velocity = {1, 0, 0}, .radius = 1});
  world.add({.position = {8, 5.5, 5}, .velocity = {-1, 0, 0}, .radius = 1});

  hardball::Simulation simulation(world);
  simulation.on_contact([](const hardball::Contact& contact) {
    if (contact.is_collision())
      std::printf("%.6f: %u meets %u\n", contact.time.value(), contact.first, contact.second);
  });
  simulation.run_until(50);
}
