// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/tuning/cell_axes.hpp"

#include <algorithm>
#include <cmath>

#include "hardball/broadphase/subdivision.hpp"

namespace hardball {
namespace {

// The fraction of pairs that share a row of cells, both spheres being anywhere between two walls.
double share_of_pairs_in_a_row(double edge, double diameter, double room) {
  // One sphere's upper end lies in row k, the other's lower end beyond it, or vice versa.
  const auto beyond = [&](double row) { return std::max(0.0, room - row * edge); };
  const double first = std::floor(diameter / edge) + 1;
  double apart = (first * edge - diameter) * beyond(first);
  for (double row = first + 1; beyond(row) > 0; ++row) apart += edge * beyond(row);
  return 1 - 2 * apart / (room * room);
}

CellAxis cell_axis(const Moments& moments, const Subdivision& cells, std::size_t axis) {
  const double diameter = 2 * moments.mean_radius();
  const double edge = cells.edge(axis);
  CellAxis result{.edge = edge, .room = moments.extent[axis], .crossings = 1 / edge};
  if (!moments.box.is_wall(axis)) return result;
  const double rows = cells.last(axis) + 1;
  const double rows_touched = std::floor(diameter / edge) + 1;  // by a sphere at a wall
  result.room = std::max(moments.extent[axis] - diameter, moments.extent[axis] / 1024);
  // A sphere's front never crosses faces less than a diameter from the wall behind it.
  result.crossings = std::max(0.0, rows - rows_touched) / result.room;
  result.is_divided = rows > 1;
  const double far_from_walls = edge + 2 * diameter;
  result.candidates = share_of_pairs_in_a_row(edge, diameter, result.room) * result.room / far_from_walls;
  result.candidates_at_wall = std::min(rows_touched * edge, result.room) / far_from_walls;
  return result;
}

}  // namespace

CellAxes cell_axes(const Moments& moments, double edge) {
  constexpr std::int32_t kMostCellsPerAxis = 1 << 28;
  const Subdivision cells(moments.box, edge, kMostCellsPerAxis);
  CellAxes axes;
  for (std::size_t axis = 0; axis < kAxes; ++axis) axes[axis] = cell_axis(moments, cells, axis);
  return axes;
}

}  // namespace hardball
