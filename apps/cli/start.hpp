// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "apps/cli/options.hpp"
#include "hardball/error.hpp"
#include "hardball/processes.hpp"
#include "hardball/scenario.hpp"
#include "hardball/simulation.hpp"

namespace hardball::cli {

/// The scenario with the changes of the command line; `until` is set. Error: see load_scenario; an option
/// that is not a number or out of range; neither scenario nor command line gives `until`.
Scenario read_scenario(const ScenarioChoice& choice);

/// A scenario with the changes that `choice` makes by --until and --seed. Error: as for read_scenario.
Scenario changed_by(const ScenarioChoice& choice, Scenario scenario);

/// The scenario of several processes, which each of them reads by itself: perhaps from the disk of another
/// machine. Error, in all processes: as for read_scenario; they read different things.
Scenario read_shared_scenario(const ScenarioChoice& choice, Processes& processes);

/// The options to run it with. The unit costs for choosing cells are measured if the run is expected to
/// take long, unless the command line says otherwise; of several processes by the first. Error: an unknown
/// engine; an edge that is not a positive number; invalid unit costs; several processes are to use
/// the paper's cell edge, for which one must have all spheres.
EngineOptions read_engine_options(const EngineChoice& choice, const Scenario& scenario, const World& start,
                                  Processes& processes = one_process());

/// Makes a simulation like make_simulation, with errors in options located on the command line.
Simulation start_simulation(const Scenario& scenario, World world, const EngineOptions& options,
                            const OnProgress& on_progress = {}, Processes& processes = one_process());

/// The number of threads that --threads gives as a text, zero for as many as pay. Error: it is not a number
/// of threads.
std::size_t read_threads(const std::string& threads);

/// A simulation and how it is run.
struct Start {
  EngineOptions options;
  Simulation simulation;
  std::vector<std::string> notes;  ///< What make_world has to say about the scenario, a sentence each.
};

/// Rethrows an error in an option of the engine as one in the option of the command line, and other errors
/// unchanged.
[[noreturn]] void throw_as_of_command_line(const Error& error);

/// The simulation of a scenario at its start, of which several processes make a part each, with progress
/// shown on the terminal unless `is_quiet`. Error: as for read_engine_options and start_simulation.
/// RunFailure: interrupted by a signal.
Start set_up(const EngineChoice& choice, const Scenario& scenario, bool is_quiet,
             Processes& processes = one_process());

}  // namespace hardball::cli
