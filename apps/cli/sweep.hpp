// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "hardball/engine/run.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/tuning/cell_counts.hpp"

namespace hardball::cli {

/// What cells of one size cost, by the theory and by the clock.
struct SweepPoint {
  double edge = 0;  ///< The mean over the axes [L].
  bool is_chosen = false;
  bool is_paper = false;
  CellCounts expected;
  double predicted_seconds = 0;  ///< In one unit of simulated time [s/T].
  std::vector<double> seconds;   ///< As measured, in rising order [s/T].
  Counters counted;              ///< During all measurements.
  double median_seconds() const { return seconds[seconds.size() / 2]; }
};

/// The same motion run with cells of many sizes.
struct Sweep {
  double span = 0;                 ///< Simulated time of all measurements of a point together [T].
  std::vector<SweepPoint> points;  ///< In rising order of edges.

  const SweepPoint& chosen() const;
  const SweepPoint& paper() const;
  /// The one measured to cost least.
  const SweepPoint& best() const;
};

/// Goes on from `start` with twelve edges around the one that the options choose, from a quarter of it to
/// three times it, with the paper's, all in turn and several times over. Error: nothing moves. Error
/// (RunFailure): a signal has come.
Sweep sweep_cell_edges(const Simulation& start, const EngineOptions& options);

}  // namespace hardball::cli
