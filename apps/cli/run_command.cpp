// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <chrono>
#include <optional>
#include <utility>

#include "apps/cli/commands.hpp"
#include "apps/cli/interruption.hpp"
#include "apps/cli/start.hpp"
#include "apps/cli/started_run.hpp"
#include "apps/cli/terminal.hpp"

namespace hardball::cli {

ExitCode run(const RunOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  catch_signals();
  Scenario scenario = read_scenario(options.scenario);
  Start start = set_up(options.engine, scenario, options.output.quiet);
  write_notes(start.notes, options.output.quiet);
  Simulation& simulation = start.simulation;
  std::optional<RunFiles> files;
  if (options.out) {
    files.emplace(*options.out, scenario, &simulation, options.overwrite);
  } else if (scenario.output_directory) {
    files.emplace(*scenario.output_directory, scenario, &simulation, options.overwrite);
  }
  // Measures are written to files.
  Measures measures(files ? scenario.measures : MeasureSettings{.names = {}});
  const std::chrono::duration<double> setup = std::chrono::steady_clock::now() - begin;
  StartedRun started{options.scenario,
                     options.output,
                     std::move(scenario),
                     std::move(simulation),
                     std::move(measures),
                     std::move(files),
                     0,
                     {.setup = setup.count()},
                     std::move(start.notes)};
  return carry_out(started);
}

}  // namespace hardball::cli
