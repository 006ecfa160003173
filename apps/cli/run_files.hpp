// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "apps/cli/directory_lock.hpp"
#include "hardball/contact.hpp"
#include "hardball/event_log.hpp"
#include "hardball/measures.hpp"
#include "hardball/recording.hpp"
#include "hardball/scenario.hpp"
#include "hardball/simulation.hpp"
#include "hardball/trajectory.hpp"

namespace hardball::cli {

/// The checkpoint in an output directory.
inline constexpr const char* kCheckpoint = "checkpoint.hbc";
/// How its name and those of others end.
inline constexpr const char* kCheckpointEnding = ".hbc";
/// The folder of those that are kept.
inline constexpr const char* kKeptCheckpoints = "checkpoints";
/// The summary, which a run writes last.
inline constexpr const char* kSummary = "summary.json";

/// Error: there is no such checkpoint.
void require_checkpoint(const std::filesystem::path& checkpoint);

/// Whether the run whose output directory this is has come to an end.
bool is_finished(const std::filesystem::path& directory);

/// The files of a run in a directory that are there, by their names: the summary first, then checkpoints,
/// trajectories, event log and recording.
std::vector<std::filesystem::path> files_of_run(const std::filesystem::path& directory);

/// Starts recording a scenario's simulation, which is at its start. Error: the file cannot be written.
RecordingWriter begin_recording(const std::filesystem::path& path, const Scenario& scenario,
                                const Simulation& simulation);

/// How much of the files of a run belongs to a checkpoint.
struct FilesState {
  /// By the name of the file.
  std::vector<std::pair<std::string, TrajectoryPosition>> trajectories;
  std::optional<EventLogPosition> events;
  std::optional<std::string> recording;  ///< See RecordingWriter::save.

  static void persist(auto& archive, auto& self) { archive(self.trajectories, self.events, self.recording); }
};

/// The files of one run in its output directory: trajectories, events.npy and recording.hbr, if the
/// scenario requests them, measures/ and report.html, unless it disables them, and summary.json. No other run
/// can write to the directory meanwhile.
class RunFiles {
 public:
  /// Creates the directory, if necessary, and the files. Files of an earlier run are removed if `overwrites`.
  /// Error: that is impossible; one of them is a symbolic link; there are files of an earlier run, and they
  /// are not to be removed; the scenario starts from a file that would be; then nothing created remains.
  /// `simulation`: of which a recording begins; without a recording it may be missing.
  RunFiles(const std::filesystem::path& directory, const Scenario& scenario, const Simulation& simulation,
           bool overwrites);

  /// Opens the files of a run to continue from a checkpoint; what follows is cut off once something
  /// is written. Error: a file is missing, shorter than it was then, contains something else, or cannot be
  /// written to; then none is changed.
  RunFiles(const std::filesystem::path& directory, const Scenario& scenario, const FilesState& state);

  const std::filesystem::path& directory() const { return directory_; }

  /// Completes the files, waits until they are on the disk, and returns how much of them there is. Error
  /// (RunFailure): they cannot be written.
  FilesState save();

  /// Appends a frame at the current time to the trajectories, if there are any. Error (RunFailure): it cannot
  /// be written.
  void write_snapshot(const Simulation& simulation, double time);
  /// Appends a frame to one of the trajectories, which are in the order of SnapshotFormat; the spheres may
  /// come in parts. Error (RunFailure): it cannot be written.
  void write_snapshot(std::size_t trajectory, const Snapshot& snapshot);
  void write_snapshot(std::size_t trajectory, const FrameParts& frame);
  /// What appends the contacts and changes of a simulation to the event log and the recording; empty if there
  /// are neither. Both outlive it. Error (RunFailure), from its functions: they cannot be written.
  Observer observer(const Simulation& simulation);
  /// Makes the event log and the trajectories complete for readers, at most once a second, so that little is
  /// lost if the process is killed. Error (RunFailure): it cannot be written.
  void keep_current();
  /// Makes the recording, if there is one, complete for readers. Error (RunFailure): it cannot be written.
  void flush_recording();
  /// Completes all files at the end, at this time [T], and writes the measures, the forces on the triangles
  /// of meshes, the summary, and the report unless it is empty. Error (RunFailure): they cannot be written.
  void finish(double time, std::span<const Measurement> measurements, std::span<const FaceForces> forces,
              const std::string& summary, const std::string& report);

 private:
  std::filesystem::path directory_;
  std::optional<DirectoryLock> lock_;
  bool has_measures_;
  std::vector<std::pair<std::string, Trajectory>> trajectories_;  // by the name of the file
  std::optional<NpyEventLog> events_;
  std::optional<RecordingWriter> recording_;
  std::chrono::steady_clock::time_point next_flush_ = std::chrono::steady_clock::now();
};

}  // namespace hardball::cli
