// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "apps/cli/progress.hpp"
#include "hardball/simulation.hpp"
#include "hardball/tuning/cell_counts.hpp"

namespace hardball::cli {

/// The cost of cells of one size, predicted and measured.
struct EdgePoint {
  double edge = 0;  ///< The mean over the axes [L].
  bool is_chosen = false;
  bool is_paper = false;
  CellCounts expected;
  double predicted_seconds = 0;  ///< In one unit of simulated time [s/T].
  std::vector<double> seconds;   ///< As measured, in ascending order [s/T].
  Counters counted;              ///< During all measurements.
  double median_seconds() const { return seconds[seconds.size() / 2]; }
};

/// Measurements of one motion that is run with cells of many sizes.
struct EdgeSweep {
  double span = 0;                ///< Total simulated time of all measurements of a point [T].
  std::vector<EdgePoint> points;  ///< In ascending order of edges.

  const EdgePoint& chosen() const;
  const EdgePoint& paper() const;
  /// The one with the least measured cost.
  const EdgePoint& best() const;
};

/// Continues from `start` with up to twelve edges from a quarter to three times the one that the options
/// choose, and with the paper's, all in turn and repeatedly until the budget is spent. If time is short,
/// these are fewer, the nearest; each is measured once in any case. Error: nothing moves. Error (RunFailure):
/// interrupted by a signal.
EdgeSweep sweep_cell_edges(const Simulation& start, const EngineOptions& options, Budget& budget);

}  // namespace hardball::cli
