// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "apps/cli/commands.hpp"
#include "apps/cli/options.hpp"
#include "apps/cli/run_files.hpp"
#include "apps/cli/summary.hpp"
#include "hardball/io/checkpoint_file.hpp"
#include "hardball/measures.hpp"
#include "hardball/scenario.hpp"
#include "hardball/simulation.hpp"

namespace hardball::cli {

/// A run between its start, or a checkpoint, and its end. Several processes may carry it out together, each
/// with a StartedRun of its own, of which only that of the first has files.
struct StartedRun {
  ScenarioChoice choice;  ///< How the run was started.
  OutputStyle output;
  Scenario scenario;
  Simulation simulation;
  Measures measures;
  std::optional<std::filesystem::path> directory;  ///< The directory of the files, if the run has any.
  std::optional<RunFiles> files;
  std::uint64_t next_snapshot = 0;  ///< The number of the next snapshot; see SnapshotSchedule.
  Seconds seconds;                  ///< Wall time spent so far.
  std::vector<std::string> notes;   ///< See Start.

  Processes& processes() const { return simulation.processes(); }
};

/// What the section "run" of a checkpoint holds.
struct RunState {
  ScenarioChoice choice;
  std::string text;  ///< Contents of the scenario file.
  std::string name;  ///< Name of the scenario file.
  std::uint64_t next_snapshot = 0;
  Seconds seconds;
  std::vector<std::string> notes;  ///< Notes from the start of the run.

  static void persist(auto& archive, auto& self) {
    archive(self.choice, self.text, self.name, self.next_snapshot, self.seconds, self.notes);
  }
};

/// The path of the checkpoint that is kept of a time [T]; its folder is there on return. Error (RunFailure):
/// it cannot be created.
std::filesystem::path kept_checkpoint(const std::filesystem::path& directory, double time);

/// The sections by which the checkpoint of a run with files exceeds that of its simulation. Error
/// (RunFailure): the files cannot be written.
std::vector<CheckpointSection> sections_of(RunFiles& files, const ScenarioChoice& choice,
                                           const Scenario& scenario, std::uint64_t next_snapshot,
                                           const Seconds& seconds, const std::vector<std::string>& notes,
                                           const Measures& measures);

/// Opens the files of a run that has a directory and starts now. Error: see RunFiles.
void open_files(StartedRun& run, bool overwrites);

/// Carries a run out to its end, writes its files, checkpoints on the way, and the summary. Error
/// (RunFailure): as for Simulation::run; a file cannot be written.
ExitCode carry_out(StartedRun& run);

/// The run that has written a checkpoint into a directory, with its files truncated to then; nothing if it is
/// whole, which this says. Error: the checkpoint is missing or damaged, or the files are; the run was started
/// in another way than wanted, or has gone beyond its end; another run is writing to the directory.
std::optional<StartedRun> resumed_run(const ResumeOptions& options, Processes& processes);

}  // namespace hardball::cli
