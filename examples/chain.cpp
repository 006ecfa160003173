// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// A chain of eight beads that attract each other, between walls: what happens where they come to a step of
// their potential.
#include <cstdio>

#include "hardball/hardball.hpp"

int main() {
  hardball::World world(hardball::Box::walls({12, 12, 12}));
  for (int i = 0; i < 8; ++i) {
    const double sign = i % 2 == 0 ? 1 : -1;
    world.add({.position = {2 + 1.0625 * i, 6, 6}, .velocity = {0, sign, 0.5 * sign}, .radius = 0.5});
  }

  hardball::StepTable table;
  table.set_for_all(hardball::StepPotential({.steps = {{1.5, -1.0}}}));
  const hardball::StepTable::Number bond =
      table.add_bond(hardball::StepPotential({.steps = {{1.15, 0}}, .core = 0.9, .is_tether = true}));
  hardball::Interactions interactions;
  interactions.set_steps(table);
  world.set_interactions(interactions);
  for (hardball::SphereId id = 1; id < world.size(); ++id) add_bond(world, id - 1, id, bond);

  hardball::Simulation simulation(world);
  int entered = 0;
  int left = 0;
  int held = 0;
  simulation.on_contact([&](const hardball::Contact& contact) {
    const hardball::StepAttempt& step = contact.step;
    if (!step.happens()) return;
    ++(!step.passes ? held : step.is_outward ? left : entered);
  });
  simulation.run_until(20);
  std::printf("wells: %d entered, %d left; %d times held back by wells and tethers\n", entered, left, held);
  std::printf("energy %.6f, of potentials %.6f\n", energy(simulation.world(), simulation.now()),
              step_energy(simulation.world()));
}
