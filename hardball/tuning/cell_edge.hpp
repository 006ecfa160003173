// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "hardball/theory/gas_statistics.hpp"
#include "hardball/tuning/cell_counts.hpp"
#include "hardball/tuning/unit_costs.hpp"

namespace hardball {

/// The cost per sphere and time [cost/T]. Source: docs/theory.md.
double cost_rate(const CellCounts& counts, const UnitCosts& costs);

/// The cost per sphere of rebuilding cells and predictions [cost].
double rebuild_cost(const CellCounts& counts, const UnitCosts& costs);

/// The edge [L] of the cells at which the event loop costs least: smaller cells are crossed more often,
/// larger ones hold more candidates. Bounded below so that large spheres do not lie in hundreds of cells.
/// Cost: O(1), less than a millisecond. Source: Kim, Guibas and Shin (1997), section 3, completed in
/// docs/theory.md.
double optimal_cell_edge(const GasStatistics& statistics, const UnitCosts& costs = {});

/// The optimal edge with its cost, for a CellGrid of spheres of about one size.
BestLength best_cell_edge(const GasStatistics& statistics, const UnitCosts& costs);

/// The edge [L] by the paper's own equation, where c1 and c3 are the cost of a prediction and c4 that of
/// crossing into one cell. Cost: O(1). Source: Kim, Guibas and Shin (1997), section 3.
double paper_cell_edge(const GasStatistics& statistics, const UnitCosts& costs = {});

/// Decides when to rebuild cells as density and speeds change.
///
/// The excess cost of the edge in use over the best one is accumulated; once it exceeds the cost of a
/// rebuild, cells are rebuilt. Both together cost at most about twice what perfect foresight would.
class CellEdgeWatch {
 public:
  explicit CellEdgeWatch(const UnitCosts& costs = {}) : costs_(costs) {}

  /// Starts over with cells of this edge [L].
  void restart(double edge);
  /// The edge of the cells in use [L].
  double edge() const { return edge_; }

  /// The new edge [L] if cells should be rebuilt, `elapsed` [T] after the last call. It anticipates the best
  /// edge expected halfway to the next rebuild. Cost: O(1), and up to a millisecond if density or radii have
  /// changed by more than 2%.
  std::optional<double> update(const GasStatistics& statistics, double elapsed);

 private:
  UnitCosts costs_;
  double edge_ = 0;
  double best_before_ = 0;         // the best edge at the last rebuild
  double best_edge_ = 0;           // when last computed
  double regret_ = 0;              // excess cost per sphere since the last rebuild [cost]
  double regret_per_length_ = 0;   // per length that spheres travel [cost/L]
  double rebuild_ = 0;             // [cost]
  GasStatistics last_statistics_;  // for which best_edge_ was computed
};

}  // namespace hardball
