// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <chrono>
#include <filesystem>
#include <optional>
#include <utility>

#include "apps/cli/commands.hpp"
#include "apps/cli/directory_lock.hpp"
#include "apps/cli/interruption.hpp"
#include "apps/cli/seconds_since.hpp"
#include "apps/cli/start.hpp"
#include "apps/cli/started_run.hpp"
#include "apps/cli/terminal.hpp"
#include "hardball/error.hpp"

namespace hardball::cli {
namespace {

void check_resume(const RunOptions& options, bool has_directory) {
  if (!options.resume) return;
  if (options.overwrite)
    throw Error("--resume and --overwrite exclude each other", "command line", "give one of the two");
  if (!has_directory)
    throw Error("the run has no directory", "--resume", "name one with --out, or in [output]");
}

}  // namespace

ExitCode run(const RunOptions& options, Processes& processes) {
  catch_signals();
  return run_in_process(options, processes);
}

ExitCode run_in_process(const RunOptions& options, Processes& processes) {
  const auto begin = std::chrono::steady_clock::now();
  Scenario scenario = read_shared_scenario(options.scenario, processes);
  std::optional<std::filesystem::path> directory = scenario.output.directory;
  if (options.out) directory = *options.out;
  check_resume(options, directory.has_value());
  const auto holds = [&](const char* file) {
    return options.resume && processes.of_first(std::filesystem::exists(*directory / file));
  };
  if (holds(kCheckpoint)) {
    auto run = resumed_run({.directory = directory->string(),
                            .started = options.scenario,
                            .threads = options.engine.threads,
                            .output = options.output},
                           processes);
    return run ? carry_out(*run) : ExitCode::done;
  }
  Start start = set_up(options.engine, scenario, options.output.quiet, processes);
  if (processes.is_first()) write_notes(start.notes, options.output.quiet);
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
  // What was killed before its first checkpoint has left its lock.
  open_files(run, options.overwrite || holds(kRunLock));
  run.seconds.setup = seconds_since(begin);
  return carry_out(run);
}

}  // namespace hardball::cli
