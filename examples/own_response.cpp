// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// A stream of beads with a custom response: fast impacts lose more energy than slow ones. Beads are added and
// removed between runs, and observed at equal times although no two collisions coincide.
#include <cmath>
#include <cstdio>
#include <vector>

#include "hardball/hardball.hpp"

namespace {

// Smooth beads whose restitution decreases with impact speed.
hardball::Velocities bounce(const hardball::Contact& contact) {
  const hardball::Restitution restitution(1 / (1 + 0.1 * contact.impact_speed()));
  return restitution(contact);
}

}  // namespace

int main() {
  hardball::Simulation simulation{hardball::World(hardball::Box::walls({20, 20, 20}))};
  simulation.respond_with(bounce);

  std::vector<hardball::SphereId> beads;
  for (int second = 0; second < 8; ++second) {
    // Every second a bead enters at the corner, faster than the previous one; after five seconds the oldest
    // leaves.
    const double speed = 2 + second;
    beads.push_back(
        simulation.add({.position = {1, 1, 1}, .velocity = {speed, speed, speed + 1}, .radius = 0.8}));
    if (second >= 5) {
      simulation.remove(beads.front());
      beads.erase(beads.begin());
    }
    simulation.run_until(second + 1);
    std::printf("time %g: %zu beads, kinetic energy %.4f, %llu collisions and %llu wall contacts so far\n",
                simulation.time(), simulation.size(), kinetic_energy(simulation.world(), simulation.now()),
                static_cast<unsigned long long>(simulation.counters().collision),
                static_cast<unsigned long long>(simulation.counters().wall));
  }
  for (const hardball::Vec3& position : simulation.positions()) {
    std::printf("(%.4f %.4f %.4f)\n", position.x, position.y, position.z);
  }
}
