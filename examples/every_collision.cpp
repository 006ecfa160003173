// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The shortest useful program: four balls in a closed box, and every collision as it happens.
#include <cstdio>

#include "hardball/hardball.hpp"

int main() {
  hardball::World world(hardball::Box::walls({10, 10, 10}));
  world.add({.position = {2, 5, 5}, .velocity = {1, 0, 0}, .radius = 1});
  world.add({.position = {8, 5.5, 5}, .velocity = {-1, 0, 0}, .radius = 1});
  world.add({.position = {5, 2, 5}, .velocity = {0, 0.5, 0.25}, .radius = 1.5, .mass = 3});
  world.add({.position = {3, 8, 3}, .velocity = {0.5, -0.5, 0.5}, .radius = 0.5, .mass = 0.2});

  hardball::Simulation simulation(world);
  simulation.on_contact([](const hardball::Contact& contact) {
    if (!contact.is_collision()) return;
    const hardball::Vec3 point = contact.point();
    std::printf("%8.5f  %u meets %u at (%.4f %.4f %.4f), impulse %.4f\n", contact.time.value(), contact.first,
                contact.second, point.x, point.y, point.z, hardball::length(contact.impulse()));
  });
  simulation.run_until(20);
}
