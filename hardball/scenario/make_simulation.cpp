// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/make_simulation.hpp"

#include <utility>

#include "hardball/errors/error.hpp"

namespace hardball {

Simulation make_simulation(const Scenario& scenario, World start, const EngineOptions& options,
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

}  // namespace hardball
