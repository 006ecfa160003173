// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "hardball/theory/gas_statistics.hpp"

namespace hardball {

/// Cells along one axis of the box, and the effect of its walls on CellCounts.
struct CellAxis {
  double edge = 0;         ///< Edge of a cell [L].
  double room = 0;         ///< The length accessible to centers [L].
  double crossings = 0;    ///< Cell faces that a sphere's front crosses per length along the axis [1/L].
  bool is_divided = true;  ///< There are faces of cells along the axis.
  bool has_nearest_images = true;  ///< Spheres that share a cell are nearest images of each other.
  double rows = 1;  ///< Rows of cells that a sphere touches, relative to the number far from walls [1].
  double rows_at_wall = 1;  ///< Rows for spheres that touch one of the walls [1].
  /// The candidates of a sphere, counted in each of these rows, relative to those far from walls [1].
  double candidates = 1;
  double candidates_at_wall = 1;  ///< Candidates for spheres that touch one of the walls [1].
};

using CellAxes = std::array<CellAxis, kAxes>;

/// For a wanted edge of `edge` [L], see Subdivision. Error: the edge is not positive and finite.
CellAxes cell_axes(const GasStatistics& statistics, double edge);

/// Rows of cells that a sphere holds along an axis in excess of the mean number it touches, 1 + diameter /
/// edge: products of these surpluses along several axes, averaged over time. CellGrid releases the row behind
/// a sphere only when the sphere enters another or collides.
struct RowSurplus {
  std::array<double, kAxes> along{};   ///< Along an axis [1].
  std::array<double, kAxes> across{};  ///< Along both other axes [1].
  double all = 0;                      ///< Along all three [1].
};

/// For spheres in a gas of mean free path `free_path` [L]. Cost: O(1), a few microseconds.
/// Source: docs/theory.md.
RowSurplus mean_row_surplus(const CellAxes& axes, double diameter, double free_path, std::size_t dimensions);

}  // namespace hardball
