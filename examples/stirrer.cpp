// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// A blade that stirs a gas: a kinematic sphere on a rotation, and the work that it does.
#include <cmath>
#include <cstdio>
#include <limits>

#include "hardball/hardball.hpp"

int main() {
  hardball::World world(hardball::Box::walls({10, 10, 10}));
  for (int i = 0; i < 27; ++i) {
    const hardball::Vec3 place{1.5 + 3.5 * (i % 3), 1.5 + 3.5 * (i / 3 % 3), 1.5 + 3.5 * (i / 9)};
    world.add({.position = place, .velocity = {0.1 * (i % 5 - 2), 0.1 * (i % 7 - 3), 0}, .radius = 0.4});
  }

  const double infinity = std::numeric_limits<double>::infinity();
  const hardball::SphereId blade = world.add({.position = {7, 5, 5}, .radius = 1, .mass = infinity});
  hardball::Simulation simulation(world);
  const auto turning = hardball::PrescribedMotion::rotation({5, 5, 5}, {0, 0, 1}, 0.5, 1e-4);
  simulation.drive(hardball::DrivenMotion("stirrer", turning, {blade}));
  simulation.run_until(10);

  const double before = simulation.tally().initial_energy();
  const double after = simulation.totals().energy.value();
  std::printf("after %g turns the blade has done the work %.6f\n", 0.5 * simulation.time(),
              simulation.work_of(simulation.motions().front()));
  std::printf("the energy of the gas was %.6f, and is %.6f\n", before, after);
  const hardball::Vec3 place = simulation.position(blade);
  std::printf("the blade is at (%.6f %.6f %.6f)\n", place.x, std::fabs(place.y), place.z);
}
