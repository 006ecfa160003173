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
/// scenario requests them, measures/ and report.html, unless it disables them, and summary.json.
class RunFiles {
 public:
  /// Creates the directory, if necessary, and the files, and removes those of an earlier run.
  /// Error: that is impossible, or the scenario starts from a file that would be overwritten; then nothing
  /// created remains.
  RunFiles(const std::filesystem::path& directory, const Scenario& scenario, const Simulation& simulation);

  /// Appends a frame at the current time, if there is a trajectory. Error (RunFailure): it cannot be written.
  void write_snapshot(const Simulation& simulation);
  /// Appends to the event log and the recording, if there are any; `world`: after the contact or change.
  /// Error (RunFailure): they cannot be written.
  void note(const Contact& contact, const World& world);
  void note(const VelocityChange& change, const World& world);
  /// Makes the event log complete for readers, at most once a second, so that little is lost if the process
  /// is killed. Error (RunFailure): it cannot be written.
  void keep_current();
  /// Completes all files and writes the measures, the summary, and the report unless it is empty. Error
  /// (RunFailure): they cannot be written.
  void finish(const Simulation& simulation, std::span<const Measurement> measurements,
              const std::string& summary, const std::string& report);

  /// Whether there is a file to which `note` appends.
  bool has_contacts() const { return events_ || recording_; }

 private:
  // Writes a file so that under its own name it is either complete or absent.
  void write(const std::filesystem::path& name, const std::string& text) const;

  std::filesystem::path directory_;
  bool has_measures_;
  std::optional<OutputFile> trajectory_;
  std::optional<NpyEventLog> events_;
  std::optional<RecordingWriter> recording_;
  std::chrono::steady_clock::time_point next_flush_ = std::chrono::steady_clock::now();
};

}  // namespace hardball::cli
