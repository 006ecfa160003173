// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/tuning/cell_axes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "hardball/broadphase/subdivision.hpp"

namespace hardball {
namespace {

// For spheres between two walls, the sums over all rows of cells of the length over which centers may lie of
// those that touch the row, and of its square. A row near a wall holds fewer: the lengths are edge, 2 edge,
// ... up to edge + diameter, or to all the room.
struct RowSums {
  double lengths;
  double squares;
};

RowSums sum_rows(double edge, double diameter, double rows, double room) {
  const double reached = std::floor(diameter / edge) + 1;        // rows touched by a sphere at a wall
  const double near = std::clamp(rows - reached, 0.0, reached);  // rows at each wall that are not full
  const double full = std::min(edge + diameter, room);
  const double between = rows - 2 * near;
  return {edge * near * (near + 1) + between * full,
          edge * edge * near * (near + 1) * (2 * near + 1) / 3 + between * full * full};
}

// The sum of the lengths of the rows that a sphere at a wall touches.
double sum_rows_at_wall(double edge, double reached, double room) {
  const double near = std::min(reached, std::floor(room / edge));
  return edge * near * (near + 1) / 2 + (reached - near) * room;
}

// An axis that does not exist in two dimensions is like a single cell that is so long that spheres are points
// in it.
CellAxis missing_axis(double edge) {
  const double length = 0x1p60 * edge;
  return {.edge = length, .room = length, .crossings = 0, .is_divided = false};
}

CellAxis cell_axis(const GasStatistics& statistics, const Subdivision& cells, std::size_t axis) {
  if (statistics.box.boundary(axis) == Boundary::flat) return missing_axis(cells.edge(axis));
  const double diameter = 2 * statistics.mean_radius();
  const double edge = cells.edge(axis);
  const double rows_touched = 1 + diameter / edge;  // far from walls
  const double far_from_walls = rows_touched * (edge + diameter);
  CellAxis result{.edge = edge, .room = statistics.extent[axis], .crossings = 1 / edge};
  // Along an open axis cells may reach far beyond the spheres.
  if (statistics.box.is_open(axis)) result.candidates = std::min(1.0, result.room / far_from_walls);
  result.has_nearest_images = cells.has_nearest_images(axis, statistics.largest_radius);
  if (!statistics.box.is_wall(axis)) return result;
  const double rows = cells.last(axis) + 1;
  const double rows_at_wall = std::floor(diameter / edge) + 1;  // touched by a sphere there
  result.room = std::max(statistics.extent[axis] - diameter, statistics.extent[axis] / 1024);
  // A sphere's front never crosses faces less than a diameter from the wall behind it.
  result.crossings = std::max(0.0, rows - rows_at_wall) / result.room;
  result.is_divided = rows > 1;
  const RowSums sums = sum_rows(edge, diameter, rows, result.room);
  result.rows = sums.lengths / result.room / rows_touched;
  result.rows_at_wall = rows_at_wall / rows_touched;
  result.candidates = sums.squares / result.room / far_from_walls;
  result.candidates_at_wall = sum_rows_at_wall(edge, rows_at_wall, result.room) / far_from_walls;
  return result;
}

// A sphere somewhere on its path through the cells.
struct Flight {
  std::array<double, kAxes> slowness{};  // path length per length along the axis [1]
  std::array<double, kAxes> position{};  // of the front in the cell it entered last, in edges [1]
  double since_collision = 0;            // path length, in free paths [1]
};

// Directions, positions and path lengths that fill the space of these six numbers evenly. Source: Roberts,
// "The unreasonable effectiveness of quasirandom sequences" (2018): multiples of the powers of the root of
// x^7 = x + 1.
constexpr std::size_t kFlights = 512;
std::array<Flight, kFlights> even_flights(std::size_t dimensions) {
  constexpr double kRoot = 1.1127756842787055;
  std::array<Flight, kFlights> flights;
  std::array<double, 6> point;
  point.fill(0.5);
  for (Flight& flight : flights) {
    double step = 1;
    for (double& coordinate : point) coordinate = std::fmod(coordinate + (step /= kRoot), 1.0);
    const double up = dimensions == 2 ? 0 : point[0];
    const double flat = std::sqrt(1 - up * up);
    const double turn = point[1] * std::numbers::pi / 2;
    flight.slowness = {1 / (flat * std::cos(turn)), 1 / (flat * std::sin(turn)), 1 / up};
    flight.position = {point[2], point[3], point[4]};
    flight.since_collision = -std::log(1 - point[5]);
  }
  return flights;
}

}  // namespace

CellAxes cell_axes(const GasStatistics& statistics, double edge) {
  const Subdivision cells(statistics.box, edge);
  CellAxes axes;
  for (std::size_t axis = 0; axis < kAxes; ++axis) axes[axis] = cell_axis(statistics, cells, axis);
  return axes;
}

RowSurplus mean_row_surplus(const CellAxes& axes, double diameter, double free_path, std::size_t dimensions) {
  static const std::array<Flight, kFlights> kInSpace = even_flights(3);
  static const std::array<Flight, kFlights> kInPlane = even_flights(2);
  // How far a sphere extends into the rearmost row when its front enters one, in edges.
  std::array<double, kAxes> overhang{};
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    overhang[axis] = std::fmod(diameter, axes[axis].edge) / axes[axis].edge;
  }
  RowSurplus sum;
  for (const Flight& flight : dimensions == 2 ? kInPlane : kInSpace) {
    // Path lengths since the sphere last released rows, and since it left the row behind; negative if it has
    // not left it yet.
    double released = free_path * flight.since_collision;
    std::array<double, kAxes> left{};
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (!axes[axis].is_divided) continue;
      const double row = axes[axis].edge * flight.slowness[axis];
      released = std::min(released, flight.position[axis] * row);
      left[axis] = (flight.position[axis] - overhang[axis]) * row;
    }
    std::array<double, kAxes> surplus{};
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (axes[axis].is_divided) surplus[axis] = (left[axis] < released ? 1 : 0) - overhang[axis];
    }
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      sum.along[axis] += surplus[axis];
      sum.across[axis] += surplus[(axis + 1) % kAxes] * surplus[(axis + 2) % kAxes];
    }
    sum.all += surplus[0] * surplus[1] * surplus[2];
  }
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    sum.along[axis] /= kFlights;
    sum.across[axis] /= kFlights;
  }
  sum.all /= kFlights;
  return sum;
}

}  // namespace hardball
