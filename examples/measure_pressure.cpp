// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The pressure of a gas in a periodic box, with its error, compared with theory.
#include <cstdio>

#include "hardball/hardball.hpp"

int main() {
  hardball::World world(hardball::Box::periodic({12, 12, 12}));
  for (int i = 0; i < 216; ++i) {
    const hardball::Vec3 site{1.0 + 2 * (i % 6), 1.0 + 2 * (i / 6 % 6), 1.0 + 2 * (i / 36)};
    const double sign = i % 2 == 0 ? 1 : -1;
    world.add({.position = site, .velocity = {sign, sign * (i % 3 - 1), 0.5 * sign}, .radius = 0.6});
  }

  hardball::Simulation simulation(world);
  hardball::Measures measures({.names = {"pressure"}, .from = 10});
  simulation.run_until(200, measures);
  for (const hardball::Measurement& found : measures.results(simulation.world(), simulation.now())) {
    const hardball::Quantity& z = found.quantities.front();
    std::printf("%s %.2f +- %.2f, expected %.2f\n", z.name.c_str(), z.value, z.error, z.theory);
  }
}
