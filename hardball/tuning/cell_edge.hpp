// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "hardball/tuning/cell_counts.hpp"
#include "hardball/tuning/moments.hpp"

namespace hardball {

/// What the steps of the event loop cost: nanoseconds on some machine, of which only the ratios matter to the
/// choice of the cell edge. The defaults are those of one core at 2.8 GHz with 20,000 spheres.
struct UnitCosts {
  double contact = 900;    ///< Whatever the cells: new velocities, two new regions, two entries in the queue.
  double enter = 350;      ///< A crossing, whatever it finds: taken from the queue and scheduled anew.
  double cell = 50;        ///< Each cell that a sphere looks into or enters.
  double prediction = 18;  ///< Each pair.

  friend bool operator==(const UnitCosts&, const UnitCosts&) = default;
};

/// Whether a choice can be made by these: none is negative or infinite, and pairs and crossings cost
/// something.
bool are_meaningful(const UnitCosts& costs);

/// What one sphere costs in unit time [cost/T]. Source: docs/theory.md.
double cost_rate(const CellCounts& counts, const UnitCosts& costs);

/// What it costs for each sphere to make cells and predictions anew [cost].
double rebuild_cost(const CellCounts& counts, const UnitCosts& costs);

/// The edge [L] of the cells at which the event loop costs least: smaller cells are crossed more often,
/// larger ones hold more candidates. Not so small that large spheres would lie in hundreds of cells.
/// Cost: O(1), less than a millisecond. Source: Kim, Guibas and Shin (1997), section 3, completed in
/// docs/theory.md.
double optimal_cell_edge(const Moments& moments, const UnitCosts& costs = {});

/// The edge [L] by the paper's own equation, with its c1 and c3 a prediction and its c4 the crossing of one
/// cell. Cost: O(1). Source: Kim, Guibas and Shin (1997), section 3.
double paper_cell_edge(const Moments& moments, const UnitCosts& costs = {});

/// Keeps an eye on the cell edge while density and speeds change.
///
/// What the edge in use costs beyond the best one is added up over time; once it exceeds what a rebuild
/// costs, the rebuild has paid. So both together are at most about twice what perfect foresight would cost.
class CellEdgeWatch {
 public:
  explicit CellEdgeWatch(const UnitCosts& costs = {}) : costs_(costs) {}

  /// From now on cells have this edge [L].
  void begin(double edge);

  /// The edge [L] that cells have from now on, if it has come to a rebuild, `elapsed` [T] after the last
  /// look. It is ahead of the best one of the moment, as far as that will move until the middle of the time
  /// to the next. Cost: O(1), and less than a millisecond if density or radii have changed by more than 2%
  /// since the last.
  std::optional<double> look(const Moments& moments, double elapsed);

 private:
  UnitCosts costs_;
  double edge_ = 0;
  double best_before_ = 0;    // the best edge at the last rebuild
  double best_edge_ = 0;      // at the last reckoning
  double regret_ = 0;         // what could have been saved since the last rebuild, for each sphere [cost]
  double regret_by_way_ = 0;  // for each length that spheres fly [cost/L]
  double rebuild_ = 0;        // [cost]
  Moments seen_;              // at the last reckoning
};

}  // namespace hardball
