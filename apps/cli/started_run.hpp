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
#include "hardball/measure/measures.hpp"
#include "hardball/scenario/scenario.hpp"
#include "hardball/simulation/simulation.hpp"

namespace hardball::cli {

/// A run between its start, or a checkpoint, and its end.
struct StartedRun {
  ScenarioChoice choice;  ///< With which it was started.
  OutputStyle output;
  Scenario scenario;
  Simulation simulation;
  Measures measures;
  std::optional<RunFiles> files;
  std::uint64_t next_snapshot = 0;  ///< Its number, see SnapshotSchedule.
  Seconds seconds;                  ///< That it has taken so far.
  std::vector<std::string> notes;   ///< See Start.
};

/// What the section "run" of a checkpoint holds.
struct RunState {
  ScenarioChoice choice;
  std::string text;  ///< Of the scenario.
  std::string name;  ///< Likewise.
  std::uint64_t next_snapshot = 0;
  Seconds seconds;
  std::vector<std::string> notes;  ///< Of the start.

  static void persist(auto& archive, auto& self) {
    archive(self.choice, self.text, self.name, self.next_snapshot, self.seconds);
    if (archive.version() >= kVersionOfNotes) archive(self.notes);
  }
  static constexpr std::uint32_t kVersionOfNotes = 11;  // of archives
};

/// The path of the checkpoint that is kept of a time [T]; its folder is there on return. Error (RunFailure):
/// it cannot be created.
std::filesystem::path kept_checkpoint(const std::filesystem::path& directory, double time);

/// Carries a run out to its end, writes its files, checkpoints on the way, and the summary. Error
/// (RunFailure): as for Simulation::run; a file cannot be written.
ExitCode carry_out(StartedRun& run);

/// Writes a checkpoint of a run that has files, under the name of the current one. Error (RunFailure): it
/// cannot be written; the one before is kept.
void write_checkpoint(StartedRun& run, const std::filesystem::path& path);

/// Whether a run that has reached `time` [T] and is to end at `until` [T] is whole, files included. Error: it
/// has gone further.
bool is_whole(const std::filesystem::path& directory, double time, double until);

/// Says that the run in a directory is whole; with --json, writes its summary to the standard output.
void tell_of_whole_run(const std::filesystem::path& directory, double time, const OutputStyle& output);

/// The run that has written a checkpoint into a directory, with its files truncated to then; nothing if it is
/// whole, which this says. `until` [T] replaces the end of the run. Error: the checkpoint is missing or
/// damaged, or the files are; the run has gone beyond its end; another run is writing to the directory.
std::optional<StartedRun> resumed_run(const std::filesystem::path& directory,
                                      const std::filesystem::path& checkpoint, const ResumeOptions& options);

}  // namespace hardball::cli
