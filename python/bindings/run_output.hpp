// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "apps/cli/options.hpp"
#include "apps/cli/output_schedule.hpp"
#include "apps/cli/run_files.hpp"
#include "apps/cli/started_run.hpp"
#include "apps/cli/summary.hpp"
#include "hardball/measure/measures.hpp"
#include "hardball/run/observer.hpp"
#include "hardball/scenario/scenario.hpp"
#include "hardball/simulation/simulation.hpp"

namespace hardball::python {

/// The scenario of a simulation, and the text of which it was made.
struct Origin {
  Scenario scenario;
  cli::ScenarioChoice choice;
};

/// What is known of a simulation that no scenario describes, of which a run may write files.
Origin no_origin();

/// The scenario with further overrides, of which only those of its files and its run may matter. Error: as
/// for parse_scenario.
Origin with_overrides(const Origin& origin, const std::vector<std::string>& overrides);

/// What a run ends in.
struct RunEnd {
  std::string summary = {};  ///< As in summary.json.
  std::vector<Measurement> measurements = {};
  std::vector<FaceForces> face_forces = {};
  std::string report = {};  ///< A page of HTML.
};

/// The results of a run up to now. All processes call it. Cost: that of an audit.
RunEnd end_of(const Origin& origin, const Simulation& simulation, const Measures& measures,
              const cli::Seconds& seconds, bool is_complete);

/// The files that a simulation writes while it runs, by the program's code: those of the table [output] of a
/// scenario.
class RunOutput {
 public:
  /// Begins them now, in the directory that the scenario names. Error: see RunFiles; no directory is named.
  RunOutput(Origin origin, const Simulation& simulation, const Measures& measures, bool overwrites);
  /// Continues those of a checkpoint. Error: see RunFiles.
  RunOutput(Origin origin, const Simulation& simulation, const Measures& measures,
            const cli::FilesState& files, const cli::RunState& state);

  const std::filesystem::path& directory() const { return directory_; }
  const Origin& origin() const { return origin_; }
  /// Whether every change of the spheres is recorded.
  bool has_recording() const { return origin_.scenario.output.recording; }
  /// What writes contacts and changes; empty functions where no file has them.
  Observer observer(const Simulation& simulation);

  /// When something is due [T], in a run to `until` [T]; infinity if nothing is.
  double next_time(double until) const;
  const cli::OutputSchedule& schedule() const { return schedule_; }
  /// Makes files complete for readers, at most once a second.
  void keep_current();
  /// Makes the recording, if there is one, complete up to now. Error (RunFailure): it cannot be written.
  void flush_recording();
  /// Whether a file could not be written in the midst of a run.
  bool has_failed() const { return !failure_.empty(); }
  /// Error (RunFailure): a file could not be written.
  void throw_if_failed() const;

  /// Writes what is due at `time` [T], to which a run to `until` [T] has come. Error (RunFailure): it cannot
  /// be written; here and below.
  void write_due(const Simulation& simulation, const Measures& measures, double time, double until);
  /// Writes the snapshot that is due at the present number of contacts.
  void write_counted(const Simulation& simulation);
  void write_checkpoint(const Simulation& simulation, const Measures& measures);
  /// Completes all files and writes the results.
  void finish(const Simulation& simulation, const Measures& measures, bool is_complete);

  /// Wall time spent in runs.
  cli::Seconds seconds = {};

 private:
  void write_snapshot(const Simulation& simulation, double time);
  void write_checkpoint(const Simulation& simulation, const Measures& measures,
                        const std::filesystem::path& path);
  template <class Work>
  void write(Work&& work);

  Origin origin_;
  std::filesystem::path directory_;
  std::optional<cli::RunFiles> files_;  // in the first process
  cli::OutputSchedule schedule_;
  std::string failure_;
};

}  // namespace hardball::python
