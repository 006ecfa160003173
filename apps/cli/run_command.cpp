// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <chrono>
#include <optional>
#include <utility>

#include "apps/cli/commands.hpp"
#include "apps/cli/interruption.hpp"
#include "apps/cli/seconds_since.hpp"
#include "apps/cli/start.hpp"
#include "apps/cli/started_run.hpp"
#include "apps/cli/terminal.hpp"

namespace hardball::cli {

ExitCode run(const RunOptions& options, Processes& processes) {
  const auto begin = std::chrono::steady_clock::now();
  catch_signals();
  Scenario scenario = read_shared_scenario(options.scenario, processes);
  Start start = set_up(options.engine, scenario, options.output.quiet, processes);
  if (processes.is_first()) write_notes(start.notes, options.output.quiet);
  std::optional<std::filesystem::path> directory = scenario.output.directory;
  if (options.out) directory = *options.out;
  // Measures are written to files.
  Measures measures(directory || !scenario.run.until_error.empty() ? scenario.measures
                                                                   : MeasureSettings{.names = {}});
  StartedRun run{options.scenario,
                 options.output,
                 std::move(scenario),
                 std::move(start.simulation),
                 std::move(measures),
                 directory,
                 std::nullopt,
                 0,
                 {},
                 std::move(start.notes)};
  open_files(run, options.overwrite);
  run.seconds.setup = seconds_since(begin);
  return carry_out(run);
}

}  // namespace hardball::cli
