// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <thread>

#include "apps/viewer/shared_recording.hpp"
#include "hardball/recording/recording_writer.hpp"
#include "hardball/scenario/rest_watch.hpp"
#include "hardball/simulation/simulation.hpp"

namespace hardball::viewer {

/// A run in its own thread, recorded as it goes.
class LiveRun {
 public:
  /// Starts running `simulation` to `until` [T], or until `rest` sees it come to rest, recording it up to
  /// `most_bytes`. `writer` is at the
  /// simulation's start and writes the file that `recording` reads, which must outlive the run.
  LiveRun(Simulation simulation, RecordingWriter writer, SharedRecording& recording, double until,
          std::uint64_t most_bytes, RestWatch rest = {});
  /// Stops the run.
  ~LiveRun() = default;
  LiveRun(const LiveRun&) = delete;

 private:
  using Clock = std::chrono::steady_clock;

  void run(const std::stop_token& stop);
  void advance(const std::stop_token& stop);
  void note_division();
  void publish();

  Simulation simulation_;
  RecordingWriter writer_;
  SharedRecording* recording_;
  double until_;
  std::uint64_t most_bytes_;
  RestWatch rest_;
  Clock::time_point begin_ = Clock::now();
  RunProgress progress_;
  std::jthread thread_;  // last: what it uses outlives it
};

}  // namespace hardball::viewer
