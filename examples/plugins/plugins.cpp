// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Extends Hardball without changing it: a surface, a thermostat, a measure and a response that the library
// does not have. Beads fall into a trough whose lowest layer is cooled. All engines give the same history.
#include <cstdio>
#include <memory>

#include "center_of_mass.hpp"
#include "hardball/hardball.hpp"
#include "layer_cooler.hpp"
#include "trough.hpp"

namespace {

// A response of one's own: beads that stick less the faster they meet.
hardball::Velocities bounce(const hardball::Contact& contact) {
  const double speed = contact.impact_speed();
  return hardball::Restitution((1 + speed) / (2 + speed))(contact);
}

hardball::World beads_above_a_trough() {
  const hardball::Surface trough(hardball::OwnShape(std::make_shared<Trough>(1.0)), {0, 0, 0});
  hardball::World world(
      hardball::Box({hardball::Boundary::open, hardball::Boundary::periodic, hardball::Boundary::open},
                    {1, 8, 1}),
      {0, 0, -1}, {trough});
  for (int k = 0; k < 60; ++k) {
    const double x = -2.4 + 1.2 * (k % 5);
    const double y = 1 + 2.0 * (k / 5 % 4);
    const double z = 5 + 1.5 * (k / 20);
    world.add({.position = {x, y, z}, .velocity = {0.1 * (k % 7 - 3), 0.1 * (k % 3 - 1), 0}, .radius = 0.45});
  }
  return world;
}

// Prints what is measured, and returns the hash of all contacts.
std::uint64_t run(hardball::EngineKind engine, bool prints) {
  hardball::Simulation simulation(beads_above_a_trough(), {.engine = engine});
  CenterOfMass measure;
  simulation.respond_with(bounce);
  simulation.add_actor(std::make_unique<LayerCooler>(2.0, 0.5, 0.25));
  simulation.observe({.contact = [&](const hardball::Contact& contact) { measure.record(contact); }});
  for (const double time : {1.0, 2.0, 3.0}) {
    simulation.run_until(time);
    measure.sample(simulation.world(), simulation.now());
    if (prints)
      std::printf("time %g: mean height %.4f, %.3f dissipated by contacts\n", time, measure.height(),
                  measure.dissipated());
  }
  return simulation.event_log_hash();
}

}  // namespace

int main() {
  const std::uint64_t cells = run(hardball::EngineKind::cells, true);
  const std::uint64_t lists = run(hardball::EngineKind::neighbors, false);
  const std::uint64_t pairs = run(hardball::EngineKind::all_pairs, false);
  std::puts(cells == lists && cells == pairs ? "all engines agree" : "ENGINES DIFFER");
  return cells == lists && cells == pairs ? 0 : 1;
}
