// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>

#include "apps/cli/options.hpp"
#include "apps/viewer/live_run.hpp"
#include "apps/viewer/shared_recording.hpp"

namespace hardball::cli {

/// The run that a command is to show: one that a directory holds, or a scenario, which begins to run.
///
/// A live run is recorded in an unnamed file in the directory for temporary files: no other user can read it,
/// and it is gone when the program ends, however it ends.
class ShownRun {
 public:
  /// `most_bytes` limits the recording of a scenario. Error: a directory without a recording, or with options
  /// that belong to a scenario; see read_scenario and the others in start.hpp; no temporary file can be
  /// created.
  ShownRun(const ShownRunChoice& choice, std::uint64_t most_bytes);

  const viewer::SharedRecording& recording() const { return *recording_; }

 private:
  void open_directory(const ShownRunChoice& choice);
  void start_scenario(const ShownRunChoice& choice, std::uint64_t most_bytes);

  std::unique_ptr<viewer::SharedRecording> recording_;
  std::unique_ptr<viewer::LiveRun> run_;  // ends before the recording
};

}  // namespace hardball::cli
