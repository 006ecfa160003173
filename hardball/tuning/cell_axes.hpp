// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "hardball/tuning/moments.hpp"

namespace hardball {

/// Cells along one axis of the box, and what walls there do to the counts of CellCounts.
struct CellAxis {
  double edge = 0;  ///< Of a cell [L].
  double room = 0;  ///< The length that centres share [L].
  double crossings =
      0;  ///< Boundaries that a sphere's front passes for each length of way along the axis [1/L].
  bool is_divided = true;  ///< There are such boundaries.
  /// The length over which a sphere's candidates spread, over what it would be far from walls [1].
  double candidates = 1;
  double candidates_at_wall = 1;  ///< The same for spheres that touch one of the two walls.
};

using CellAxes = std::array<CellAxis, kAxes>;

/// With cells of wanted edge `edge` [L], see Subdivision. Error: the edge is not positive and finite.
CellAxes cell_axes(const Moments& moments, double edge);

}  // namespace hardball
