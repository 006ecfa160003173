// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "hardball/theory/gas_statistics.hpp"

namespace hardball {

/// The costs of the steps of the event loop, in nanoseconds; only their ratios matter for the choice of the
/// cell edge. The defaults were measured on one core at 2.6 GHz with 4,000 spheres.
struct UnitCosts {
  double contact = 350;     ///< Independent of cells: new velocities, two new regions, two queue entries.
  double enter = 165;       ///< A crossing without its cells and pairs: taken from the queue and rescheduled.
  double cell = 4;          ///< Each cell searched or entered.
  double prediction = 2.2;  ///< Each candidate found in a cell.

  friend bool operator==(const UnitCosts&, const UnitCosts&) = default;
  static void persist(auto& archive, auto& self) {
    archive(self.contact, self.enter, self.cell, self.prediction);
  }
};

/// Whether a choice can be based on these costs: none is negative or infinite, and predictions and crossings
/// are not free.
bool are_meaningful(const UnitCosts& costs);

/// The unit costs for this many spheres, which are far away in memory: every cell and every candidate is
/// another cache line.
UnitCosts costs_with_memory(const GasStatistics& statistics, UnitCosts costs);

/// The length at which a broad phase is predicted to cost least; see PhaseSettings.
struct BestLength {
  double length = 1;                                      ///< [L]
  double cost = std::numeric_limits<double>::infinity();  ///< Per sphere and time [cost/T].
};

}  // namespace hardball
