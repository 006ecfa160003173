// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <string>

#include "apps/cli/status_line.hpp"
#include "hardball/packing.hpp"
#include "hardball/simulation.hpp"

namespace hardball::cli {

/// A line on the terminal with a run's progress, speed and remaining time.
class Progress {
 public:
  /// Shows nothing unless `wanted` and the standard error is a terminal. `until` [T] is when the run ends.
  Progress(bool wanted, double until) : line_(wanted), until_(until) {}

  /// Updates the line, at most ten times a second, with the time [T] and the collisions of the run so far.
  void show(double time, std::uint64_t collisions);

 private:
  using Clock = std::chrono::steady_clock;

  StatusLine line_;
  double until_;
  Clock::time_point begin_ = Clock::now();
};

/// Shows the progress of a packing.
class PackingProgress {
 public:
  explicit PackingProgress(bool wanted) : line_(wanted) {}

  void show(const Packer& packer);

 private:
  using Clock = std::chrono::steady_clock;

  StatusLine line_;
  double begin_share_ = -1;  // where a packing that is resumed begins
  Clock::time_point begin_ = Clock::now();
};

/// Shows the progress of the set-up of a run.
class SetUpProgress {
 public:
  explicit SetUpProgress(bool wanted) : line_(wanted) {}

  /// A function that shows the part of the set-up between two fractions of it, and must not outlive this
  /// object. It throws RunFailure after a signal; see catch_signals.
  OnProgress part(double begin, double end);

 private:
  StatusLine line_;
};

/// Shows the progress of work that ends when its time is spent.
class Budget {
 public:
  /// Begins now. Precondition: `seconds` is positive.
  Budget(double seconds, bool shown) : line_(shown), seconds_(seconds) {}

  /// The share of it that is spent [1]; may exceed one.
  double spent() const;
  /// Shows it, with what is being done. Error (RunFailure): interrupted by a signal.
  void show(const std::string& work);

 private:
  using Clock = std::chrono::steady_clock;

  StatusLine line_;
  double seconds_;
  Clock::time_point begin_ = Clock::now();
};

}  // namespace hardball::cli
