// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/make_simulation.hpp"

#include <cstdint>
#include <utility>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/scenario/section.hpp"

namespace hardball {
namespace {

// What a motion of a scenario drives.
DrivenMotion driven_motion(const Scenario& scenario, std::size_t motion) {
  std::vector<SphereId> spheres;
  std::vector<std::uint32_t> surfaces;
  SphereId next = 0;
  for (const SphereGroup& group : scenario.spheres) {
    for (std::size_t i = 0; i < group.count; ++i, ++next) {
      if (group.motion == motion) spheres.push_back(next);
    }
  }
  for (std::size_t k = 0; k < scenario.surfaces.size(); ++k) {
    if (scenario.surfaces[k].motion == motion) surfaces.push_back(static_cast<std::uint32_t>(kFaces + k));
  }
  const MotionDescription& description = scenario.motions[motion];
  DrivenMotion driven(description.name, description.made(scenario.dimensions()), spheres, surfaces);
  if (description.stop_pressure > 0)
    driven.stop_at_pressure(description.stop_pressure, description.stop_interval);
  return driven;
}

void drive(const Scenario& scenario, Simulation& simulation) {
  for (std::size_t k = 0; k < scenario.motions.size(); ++k) {
    const DrivenMotion motion = driven_motion(scenario, k);
    made_at(scenario.motions[k].where, [&] { simulation.drive(motion); });
  }
}

// A simulation without the motions.
Simulation started(const Scenario& scenario, World start, const EngineOptions& options,
                   const OnProgress& on_progress, Processes& processes) {
  try {
    Simulation simulation = processes.size() > 1
                                ? Simulation::from_parts(std::move(start), options, processes)
                                : Simulation(std::move(start), options, on_progress);
    if (scenario.thermostat) simulation.set_thermostat(Thermostat(*scenario.thermostat, scenario.run.seed));
    if (scenario.growth) simulation.grow(*scenario.growth);
    return simulation;
  } catch (const Error& error) {
    // Of the options, not of the scenario.
    const bool is_of_options =
        (options.cell_edge && error.where() == "cell edge") || error.where() == "threads";
    if (is_of_options) throw;
    // Spheres whose bonds are too long would not become closer.
    const bool could_shrink = error.where() == "start state" && scenario.start_file &&
                              !scenario.shrinks_start && !scenario.has_steps();
    throw Error(error.problem(), scenario.name + ": " + error.where(),
                error.remedy() + (could_shrink ? ", as shrink = true in [start] does with all" : ""));
  }
}

}  // namespace

Simulation make_simulation(const Scenario& scenario, World start, const EngineOptions& options,
                           const OnProgress& on_progress, Processes& processes) {
  Simulation simulation = started(scenario, std::move(start), options, on_progress, processes);
  drive(scenario, simulation);
  return simulation;
}

}  // namespace hardball
