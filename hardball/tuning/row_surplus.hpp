// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "hardball/tuning/cell_axes.hpp"

namespace hardball {

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
