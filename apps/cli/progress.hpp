// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>

#include "hardball/simulation/simulation.hpp"

namespace hardball::cli {

/// A line on the terminal with a run's progress, speed and remaining time.
class Progress {
 public:
  /// Shows nothing unless `wanted` and the standard error is a terminal. `until` [T] is when the run ends.
  Progress(bool wanted, double until);
  /// Removes the line.
  ~Progress();
  Progress(const Progress&) = delete;

  /// Updates the line, at most ten times a second.
  void show(const Simulation& simulation);

 private:
  using Clock = std::chrono::steady_clock;

  bool visible_;
  double until_;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point next_ = begin_;
  std::size_t width_ = 0;  // of the line shown
};

}  // namespace hardball::cli
