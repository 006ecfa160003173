// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "hardball/theory/gas_statistics.hpp"
#include "hardball/tuning/unit_costs.hpp"

namespace hardball {

/// The work of a NeighborList in a gas, as predicted by kinetic theory. Source: docs/theory.md.
struct NeighborCounts {
  // Rates per sphere [1/T].
  double collision = 0;
  double wall = 0;
  double stale = 0;
  double rebuild = 0;  ///< A sphere reaches the edge of its ball.

  double neighbors = 0;  ///< Neighbors in a sphere's list [1].
  double searched = 0;   ///< Anchors in the cells around a sphere's own [1].
  bool is_far = false;   ///< Whether these are far away in memory.
  double listed = 0.9;   ///< What a neighbor in a list costs, in candidates of a cell [1].
  double rows = 9;       ///< Rows of three cells that are adjacent in memory, visited by a rebuild [1].
};

/// The counts expected for balls of radius `skin` [L]. Cost: O(1). Precondition: `skin` is positive.
NeighborCounts expected_neighbor_counts(const GasStatistics& statistics, double skin);

/// The cost per sphere and time [cost/T].
double cost_rate(const NeighborCounts& counts, const UnitCosts& costs);

/// The ball radius [L] at which neighbor lists cost least: small balls are left more often, large ones make
/// longer lists. Cost: O(1).
double optimal_skin(const GasStatistics& statistics, const UnitCosts& costs = {});

/// The optimal ball radius with its cost.
BestLength best_skin(const GasStatistics& statistics, const UnitCosts& costs);

/// What lists have been found to do, per sphere that collides.
struct ListUse {
  double neighbors = 0;  ///< Neighbors looked at, with padding [1].
  double rebuilds = 0;   ///< Lists rebuilt [1].
};

/// A ball radius [L] at which lists cost less by a tenth or more, if there is one, when those with `skin`
/// have been used so: where spheres heap up or form clusters, theory, which knows their mean density, makes
/// lists too long. Theory says how both change with the radius. Cost: O(1).
std::optional<double> better_skin(const GasStatistics& statistics, double skin, const ListUse& use,
                                  const UnitCosts& costs = {});

}  // namespace hardball
