// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/viewer/live_run.hpp"

#include <algorithm>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "hardball/errors/error.hpp"

namespace hardball::viewer {
namespace {

// Steps between two looks at the clock and the size of the recording: milliseconds.
constexpr std::uint64_t kStepsPerSlice = 1 << 14;

// Between two updates for clients: short to the eye, but long enough that keyframes do not keep the disk
// busy.
std::chrono::duration<double> time_between_chunks(const RecordingWriter& writer) {
  constexpr double kSeconds = 0.25;
  constexpr double kBytesPerSecond = 20e6;
  return std::chrono::duration<double>(
      std::max(kSeconds, static_cast<double>(writer.keyframe_bytes()) / kBytesPerSecond));
}

}  // namespace

LiveRun::LiveRun(Simulation simulation, RecordingWriter writer, SharedRecording& recording, double until,
                 std::uint64_t most_bytes, RestWatch rest)
    : simulation_(std::move(simulation)),
      writer_(std::move(writer)),
      recording_(&recording),
      until_(until),
      most_bytes_(most_bytes),
      rest_(std::move(rest)) {
  simulation_.observe(recording_observer(writer_, simulation_));
  note_division();
  publish();
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

void LiveRun::run(const std::stop_token& stop) {
  // Whatever fails, what was recorded is shown, and the first failure is reported.
  const auto attempt = [this](const auto& action) {
    try {
      action();
    } catch (const std::exception& error) {
      if (progress_.failure) return;
      progress_.failure = std::string(error.what()) + "; the run reached time " + to_text(simulation_.time());
    }
  };
  attempt([&] { advance(stop); });
  attempt([&] { writer_.close(simulation_.time()); });
  progress_.is_finished = true;
  attempt([&] { publish(); });
}

void LiveRun::advance(const std::stop_token& stop) {
  // The keyframes of a slice's chunks take no more space than their contacts; the last step may be an action
  // of the thermostat on all spheres.
  const std::uint64_t most_bytes_of_slice =
      2 * (kStepsPerSlice + simulation_.size()) * writer_.contact_bytes() + writer_.keyframe_bytes();
  Clock::time_point next = begin_;
  for (;;) {
    if (writer_.bytes() + most_bytes_of_slice > most_bytes_) {
      progress_.failure = "the recording has reached its limit of " + to_text(most_bytes_) +
                          " bytes at time " + to_text(simulation_.time());
      return;
    }
    const double now = simulation_.time();
    rest_.look(now, [&] { return simulation_.totals(); });
    if (rest_.since()) return;
    const double next_look = std::min(until_, rest_.next_look(now));
    const RunStatus status =
        simulation_.run({.until = Time(next_look), .steps = kStepsPerSlice, .stop = [&stop] {
                           return stop.stop_requested();
                         }});
    note_division();
    const bool has_looked = status == RunStatus::time_reached && simulation_.time() < until_;
    if (status != RunStatus::steps_reached && !has_looked) return;
    if (Clock::now() < next) continue;
    writer_.flush();
    publish();
    next = Clock::now() + std::chrono::duration_cast<Clock::duration>(time_between_chunks(writer_));
  }
}

void LiveRun::note_division() {
  std::vector<Block> blocks = simulation_.blocks();
  std::vector<TimedBlocks>& divisions = progress_.divisions;
  if (!divisions.empty() && divisions.back().blocks == blocks) return;
  divisions.push_back({simulation_.time(), std::move(blocks)});
}

void LiveRun::publish() {
  const Counters counters = simulation_.counters();
  const double seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
  progress_.collisions = counters.collision - simulation_.tally().passes();
  progress_.mergers = simulation_.tally().mergers();
  progress_.walls = counters.wall;
  progress_.rate = seconds > 0 ? static_cast<double>(counters.contacts()) / seconds : 0;
  progress_.windows = simulation_.windows();
  progress_.hash = simulation_.event_log_hash();
  recording_->update(progress_);
}

}  // namespace hardball::viewer
