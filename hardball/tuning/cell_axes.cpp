// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/tuning/cell_axes.hpp"

#include <algorithm>
#include <cmath>

#include "hardball/broadphase/subdivision.hpp"

namespace hardball {
namespace {

// The length over which partners are spread that share a row of cells with a sphere, both being anywhere
// between two walls: `room` times the fraction of such pairs. Pairs that share no row are those with one's
// upper end in row k and the other's lower end beyond it; their fraction is the sum of an arithmetic series.
// The rest is written as a sum of positive terms, so that no digits are lost in a wide box.
double spread_of_row_mates(double edge, double diameter, double room) {
  const double first = (std::floor(diameter / edge) + 1) * edge;  // the first boundary with spheres below it
  const double beyond = room - first;
  if (!(beyond > 0)) return room;
  const double rest = std::fmod(beyond, edge);
  return (beyond * (edge + 2 * diameter) + first * first - rest * (edge - rest)) / room;
}

CellAxis cell_axis(const Moments& moments, const Subdivision& cells, std::size_t axis) {
  const double diameter = 2 * moments.mean_radius();
  const double edge = cells.edge(axis);
  const double far_from_walls = edge + 2 * diameter;
  CellAxis result{.edge = edge, .room = moments.extent[axis], .crossings = 1 / edge};
  // Along an open axis cells may reach far beyond the spheres.
  if (moments.box.is_open(axis)) result.candidates = std::min(1.0, result.room / far_from_walls);
  if (moments.box.is_periodic(axis)) {
    result.has_nearest_images =
        has_nearest_images(cells.period(axis), most_cells_touched(2 * moments.largest_radius, edge));
  }
  if (!moments.box.is_wall(axis)) return result;
  const double rows = cells.last(axis) + 1;
  const double rows_touched = std::floor(diameter / edge) + 1;  // by a sphere at a wall
  result.room = std::max(moments.extent[axis] - diameter, moments.extent[axis] / 1024);
  // A sphere's front never crosses faces less than a diameter from the wall behind it.
  result.crossings = std::max(0.0, rows - rows_touched) / result.room;
  result.is_divided = rows > 1;
  result.candidates = spread_of_row_mates(edge, diameter, result.room) / far_from_walls;
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
