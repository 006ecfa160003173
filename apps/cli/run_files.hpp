// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "hardball/io/npy_event_log.hpp"
#include "hardball/io/output_file.hpp"
#include "hardball/io/recording_writer.hpp"
#include "hardball/measure/measurement.hpp"
#include "hardball/response/contact.hpp"
#include "hardball/scenario/scenario.hpp"
#include "hardball/simulation/simulation.hpp"

namespace hardball::cli {

/// The files of one run in its output directory: trajectory.xyz, events.npy and recording.hbr, if the
/// scenario asks for them, measures/ and report.html, unless it asks for none, and summary.json.
class RunFiles {
 public:
  /// Creates the directory, if need be, and the files, and removes those of an earlier run.
  /// Error: that cannot be done, or the scenario starts from a file that would be overwritten; then nothing
  /// that was made is left.
  RunFiles(const std::filesystem::path& directory, const Scenario& scenario, const Simulation& simulation);

  /// Adds a frame as of now, if there is a trajectory. Error (RunFailure): it cannot be written.
  void write_snapshot(const Simulation& simulation);
  /// Adds to the event log and the recording, if there are any. Error (RunFailure): they cannot be written.
  void note(const Contact& contact);
  /// Completes the event log for readers, once a second at the most: whatever kills the program, no more is
  /// lost. Error (RunFailure): it cannot be written.
  void keep_current();
  /// Completes all files as of now and writes what was measured, the summary, and the report unless it is
  /// empty. Error (RunFailure): they cannot be written.
  void finish(const Simulation& simulation, std::span<const Measurement> measurements,
              const std::string& summary, const std::string& report);

  /// Whether there is a file that `note` adds to.
  bool has_contacts() const { return events_ || recording_; }

 private:
  // Writes a file that under its own name is whole or not there at all.
  void write(const std::filesystem::path& name, const std::string& text) const;

  std::filesystem::path directory_;
  bool has_measures_;
  std::optional<OutputFile> trajectory_;
  std::optional<NpyEventLog> events_;
  std::optional<RecordingWriter> recording_;
  std::chrono::steady_clock::time_point next_flush_ = std::chrono::steady_clock::now();
};

}  // namespace hardball::cli
