// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "hardball/theory/gas_statistics.hpp"
#include "hardball/tuning/unit_costs.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// Spheres of nearly the same size.
struct SizeClass {
  double spheres = 0;     ///< How many.
  double radius = 0;      ///< Mean [L].
  double mean_speed = 0;  ///< [L/T]
};

/// All spheres by size, in classes a quarter of an octave wide, from the smallest on. Cost: O(n).
std::vector<SizeClass> size_classes(const World& world, const Time& moment);

/// Whether sizes differ so much that cells should be chosen by size classes: statistics do not say what the
/// large spheres cost.
bool are_sizes_spread(const GasStatistics& statistics);

/// The cost per sphere and time [cost/T] of cells of edge `edge` [L], those of LargeSphereGrid. Cost:
/// O(classes squared). Source: docs/theory.md.
double cost_rate_by_class(const GasStatistics& statistics, const std::vector<SizeClass>& classes, double edge,
                          const UnitCosts& costs);

/// The edge [L] at which these cells cost least, among those in which half of the spheres fit. Cost:
/// O(classes squared), less than a millisecond.
double optimal_edge_by_class(const GasStatistics& statistics, const std::vector<SizeClass>& classes,
                             const UnitCosts& costs = {});

/// The best edge for a world as it is at `moment`, with a LargeSphereGrid where it supports the world, and
/// otherwise with a CellGrid. Cost: O(n).
BestLength best_edge(const World& world, const Time& moment, const GasStatistics& statistics,
                     const UnitCosts& costs);

}  // namespace hardball
