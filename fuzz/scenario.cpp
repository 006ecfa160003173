// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/scenario.hpp"

#include "fuzz/target.hpp"
#include "hardball/scenario/make_world.hpp"

void hardball::fuzz::read(std::string_view bytes) {
  const Scenario scenario = parse_scenario(bytes, "scenario.toml");
  std::size_t spheres = 0;
  for (const SphereGroup& group : scenario.spheres) {
    spheres += group.count;
    // A fuzzer must not name files.
    if (group.count > kMaxSpheres || spheres > kMaxSpheres) return;
    if (group.distribution && group.distribution->kind == RadiusDistribution::Kind::file) return;
  }
  if (scenario.start_file) return;
  Simulation simulation{make_world(scenario)};
  if (scenario.thermostat) simulation.set_thermostat(Thermostat(*scenario.thermostat, scenario.run.seed));
  run_a_little(simulation);
}
