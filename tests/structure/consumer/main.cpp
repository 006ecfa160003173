// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Two equal spheres on one line, a distance of 2 between them, exchange their velocities at time 2.
#include "hardball/hardball.hpp"

int main() {
  hardball::World world;
  const hardball::SphereId moving = world.add({.position = {0, 0, 0}, .velocity = {1, 0, 0}, .radius = 0.5});
  const hardball::SphereId resting = world.add({.position = {3, 0, 0}, .velocity = {0, 0, 0}, .radius = 0.5});
  hardball::Simulation simulation(world);
  simulation.run_until(4);
  const bool as_expected = simulation.counters().collision == 1 && simulation.position(moving).x == 2 &&
                           simulation.position(resting).x == 5;
  return as_expected ? 0 : 1;
}
