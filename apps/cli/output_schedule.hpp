// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <utility>
#include <vector>

#include "apps/cli/seconds_since.hpp"
#include "hardball/scenario.hpp"
#include "hardball/trajectory.hpp"

namespace hardball::cli {

/// When the snapshots and checkpoints of a run are due.
class OutputSchedule {
 public:
  /// From `begin` [T] on, with the snapshot of this number; see SnapshotSchedule.
  OutputSchedule(const OutputDescription& output, std::uint64_t snapshot, double begin)
      : snapshots_(output.snapshots()),
        snapshot_(snapshot),
        kept_at_(output.checkpoint_at),
        kept_(begin),
        seconds_between_(output.checkpoint_every) {
    std::ranges::sort(kept_at_);
  }

  /// The number of the next snapshot.
  std::uint64_t snapshot() const { return snapshot_; }
  /// When it is due [T] in a run to `until` [T]; infinity if that depends on contacts, or none is.
  double snapshot_time(double until) const { return snapshots_.time(snapshot_, until); }
  /// At how many contacts it is due.
  std::uint64_t snapshot_contacts() const { return snapshots_.contacts(snapshot_); }
  void note_snapshot() { ++snapshot_; }
  /// Passes over the snapshots that were due before this time [T] and this number of contacts.
  void skip_snapshots(double time, std::uint64_t contacts) {
    while (snapshot_time(SnapshotSchedule::kNoTime) < time || snapshot_contacts() < contacts) ++snapshot_;
  }

  /// The first time after that of the last one at which a checkpoint is to be kept [T]; infinity if none is.
  double kept_time() const {
    const auto next = std::ranges::upper_bound(kept_at_, kept_);
    return next == kept_at_.end() ? SnapshotSchedule::kNoTime : *next;
  }
  void note_kept(double time) { kept_ = time; }

  /// Whether the last checkpoint was written as long ago as they are apart.
  bool is_checkpoint_due() const { return seconds_since(last_checkpoint_) >= seconds_between_; }
  void note_checkpoint() { last_checkpoint_ = std::chrono::steady_clock::now(); }

 private:
  SnapshotSchedule snapshots_;
  std::uint64_t snapshot_;
  std::vector<double> kept_at_;  // ascending
  double kept_;                  // when a checkpoint was kept last, or the run began
  double seconds_between_;
  std::chrono::steady_clock::time_point last_checkpoint_ = std::chrono::steady_clock::now();
};

}  // namespace hardball::cli
