// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/tuning/cell_counts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "hardball/broadphase/subdivision.hpp"
#include "hardball/tuning/kinetic_theory.hpp"

namespace hardball {
namespace {

// One axis of the box and of its cells.
struct Axis {
  double edge = 0;         // of a cell [L]
  double room = 0;         // the length that centres share [L]
  double crossings = 0;    // boundaries that surfaces pass for each length of way along the axis [1/L]
  bool is_divided = true;  // there are boundaries
  // The length over which a sphere's candidates spread, over what it would be far from walls [1]: for all
  // spheres, and for those that touch one of the two walls.
  double candidates = 1;
  double candidates_at_wall = 1;
};

// The share of pairs that have a row of cells in common, both being anywhere between two walls.
double share_of_pairs_in_a_row(double edge, double diameter, double room) {
  // One sphere's upper end lies in row k, the other's lower end beyond it, or the other way round.
  const auto beyond = [&](double row) { return std::max(0.0, room - row * edge); };
  const double first = std::floor(diameter / edge) + 1;
  double apart = (first * edge - diameter) * beyond(first);
  for (double row = first + 1; beyond(row) > 0; ++row) apart += edge * beyond(row);
  return 1 - 2 * apart / (room * room);
}

Axis axis_of_cells(const Moments& moments, const Subdivision& cells, std::size_t axis) {
  const double diameter = 2 * moments.mean_radius();
  const double edge = cells.edge(axis);
  Axis result{.edge = edge, .room = moments.extent[axis], .crossings = 1 / edge};
  if (!moments.box.is_wall(axis)) return result;
  const double rows = cells.last(axis) + 1;
  const double rows_touched = std::floor(diameter / edge) + 1;  // by a sphere at a wall
  result.room = std::max(moments.extent[axis] - diameter, moments.extent[axis] / 1024);
  // Surfaces do not pass the boundaries nearer than a diameter to the wall behind them.
  result.crossings = std::max(0.0, rows - rows_touched) / result.room;
  result.is_divided = rows > 1;
  const double far_from_walls = edge + 2 * diameter;
  result.candidates = share_of_pairs_in_a_row(edge, diameter, result.room) * result.room / far_from_walls;
  result.candidates_at_wall = std::min(rows_touched * edge, result.room) / far_from_walls;
  return result;
}

using Axes = std::array<Axis, kAxes>;

// Rows of cells that a sphere holds beyond the mean of those it touches, 1 + diameter / edge: products of
// these surpluses along several axes, averaged over time. CellGrid gives up the row behind a sphere only when
// the sphere enters another or collides.
struct Surplus {
  std::array<double, kAxes> along{};   // along an axis [1]
  std::array<double, kAxes> across{};  // along both other axes [1]
  double all = 0;                      // along all three [1]
};

// A sphere somewhere on its way through the cells.
struct Flight {
  std::array<double, kAxes> slowness{};  // way flown for each length along the axis [1]
  std::array<double, kAxes> place{};     // of the front in the cell it entered last, in edges [1]
  double since_collision = 0;            // way flown, in free paths [1]
};

// Directions, places and ways that fill the space of their six numbers evenly. Source: Roberts, "The
// unreasonable effectiveness of quasirandom sequences" (2018): multiples of the powers of the root of
// x^7 = x + 1.
constexpr std::size_t kFlights = 512;
std::array<Flight, kFlights> even_flights() {
  constexpr double kRoot = 1.1127756842787055;
  std::array<Flight, kFlights> flights;
  std::array<double, 6> point;
  point.fill(0.5);
  for (Flight& flight : flights) {
    double step = 1;
    for (double& coordinate : point) coordinate = std::fmod(coordinate + (step /= kRoot), 1.0);
    const double up = point[0];
    const double flat = std::sqrt(1 - up * up);
    const double turn = point[1] * std::numbers::pi / 2;
    flight.slowness = {1 / (flat * std::cos(turn)), 1 / (flat * std::sin(turn)), 1 / up};
    flight.place = {point[2], point[3], point[4]};
    flight.since_collision = -std::log(1 - point[5]);
  }
  return flights;
}

Surplus mean_surplus(const Axes& axes, double diameter, double free_path) {
  static const std::array<Flight, kFlights> kEvenFlights = even_flights();
  std::array<double, kAxes> span{};      // of a sphere, in edges
  std::array<double, kAxes> overhang{};  // what it reaches into the hindmost row when its front enters one
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    span[axis] = diameter / axes[axis].edge;
    overhang[axis] = span[axis] - std::floor(span[axis]);
  }
  Surplus sum;
  for (const Flight& flight : kEvenFlights) {
    // Ways flown since the sphere last gave up rows, and since it left the row behind.
    double kept = free_path * flight.since_collision;
    std::array<double, kAxes> left{};
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (!axes[axis].is_divided) continue;
      const double way = axes[axis].edge * flight.slowness[axis];
      kept = std::min(kept, flight.place[axis] * way);
      left[axis] = (flight.place[axis] - overhang[axis]) * way;
    }
    std::array<double, kAxes> surplus{};
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (!axes[axis].is_divided) continue;
      const bool touches_row_behind = flight.place[axis] < overhang[axis];
      const bool holds_row_behind = touches_row_behind || left[axis] < kept;
      surplus[axis] = (holds_row_behind ? 1 : 0) - overhang[axis];
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

// As many rows as two spheres hold together that do not know of each other.
Surplus both(const Surplus& rows) {
  Surplus sum;
  double products = 0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double others = rows.along[(axis + 1) % kAxes] * rows.along[(axis + 2) % kAxes];
    sum.along[axis] = 2 * rows.along[axis];
    sum.across[axis] = 2 * rows.across[axis] + 2 * others;
    products += rows.along[axis] * rows.across[axis];
  }
  sum.all = 2 * rows.all + 2 * products;
  return sum;
}

using Powers = std::array<double, 4>;  // means of the powers 0 to 3 of a length

// The mean of the product over all axes of (edge (1 + surplus) + width) [L^3].
double mean_region(const Axes& axes, const Surplus& surplus, const Powers& width) {
  const auto edge = [&](std::size_t axis) { return axes[axis].edge; };
  double region = edge(0) * edge(1) * edge(2) * (1 + surplus.all) + width[3];
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const std::size_t b = (axis + 1) % kAxes;
    const std::size_t c = (axis + 2) % kAxes;
    region += edge(0) * edge(1) * edge(2) * (surplus.along[axis] + surplus.across[axis]);
    region += width[1] * edge(b) * edge(c) * (1 + surplus.along[b] + surplus.along[c] + surplus.across[axis]);
    region += width[2] * edge(axis) * (1 + surplus.along[axis]);
  }
  return region;
}

// The same product over two of the axes only [L^2].
double mean_section(const Axes& axes, const Surplus& surplus, const Powers& width, std::size_t left_out) {
  const std::size_t b = (left_out + 1) % kAxes;
  const std::size_t c = (left_out + 2) % kAxes;
  return axes[b].edge * axes[c].edge * (1 + surplus.along[b] + surplus.along[c] + surplus.across[left_out]) +
         width[1] * (axes[b].edge * (1 + surplus.along[b]) + axes[c].edge * (1 + surplus.along[c])) +
         width[2];
}

// Means of the powers of the diameter of one sphere, and of the sum of two diameters.
Powers diameter_powers(const std::array<double, 6>& radius_power) {
  return {1, 2 * radius_power[1], 4 * radius_power[2], 8 * radius_power[3]};
}

Powers sum_powers(const Powers& a, const Powers& b) {
  return {1, a[1] + b[1], a[2] + 2 * a[1] * b[1] + b[2], a[3] + 3 * a[2] * b[1] + 3 * a[1] * b[2] + b[3]};
}

// The same for the spheres that collide, in proportion to the squared sum of their radii and their partners'.
Powers colliding_diameter_powers(const std::array<double, 6>& m) {
  const double all = 2 * m[2] + 2 * m[1] * m[1];
  return {1, 2 * (3 * m[1] * m[2] + m[3]) / all, 4 * (m[2] * m[2] + 2 * m[1] * m[3] + m[4]) / all,
          8 * (m[2] * m[3] + 2 * m[1] * m[4] + m[5]) / all};
}

}  // namespace

CellCounts expected_counts(const Moments& moments, double edge) {
  CellCounts counts;
  if (moments.spheres == 0) return counts;
  const Subdivision cells(moments.box, edge, 1 << 28);
  const double diameter = 2 * moments.mean_radius();
  Axes axes;
  double density = static_cast<double>(moments.spheres);  // of the centres in the room that they share
  double shared = 1;          // of the volume of candidates, what walls leave of it
  double shared_at_wall = 0;  // the same for a sphere that touches a wall
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    axes[axis] = axis_of_cells(moments, cells, axis);
    density /= axes[axis].room;
    shared *= axes[axis].candidates;
  }
  double walls = 0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!moments.box.is_wall(axis)) continue;
    shared_at_wall += shared * axes[axis].candidates_at_wall / axes[axis].candidates;
    ++walls;
  }
  if (walls > 0) shared_at_wall /= walls;
  const double free_path = mean_free_path(moments);
  const Surplus none;
  const Surplus surplus = mean_surplus(axes, diameter, free_path);
  const Powers one = diameter_powers(moments.radius_power);
  const Powers colliding = colliding_diameter_powers(moments.radius_power);

  counts.collision = 1 / mean_free_time(moments);
  counts.wall = wall_rate(moments);
  const auto pairs_in = [&](double region) { return density * shared * region; };
  counts.candidates_after_collision = std::max(
      1.0, pairs_in(mean_region(axes, surplus, sum_powers(colliding, one))) + excess_about_pair(moments));
  const double region = mean_region(axes, surplus, sum_powers(one, one));
  counts.candidates_after_wall =
      std::max(0.0, density * shared_at_wall * region + excess_about_sphere(moments));
  counts.candidates_at_any_time = std::max(0.0, pairs_in(region) + excess_about_sphere(moments));
  counts.candidates_when_stale =
      std::max(1.0, pairs_in(mean_region(axes, both(surplus), sum_powers(colliding, one))) +
                        excess_about_sphere(moments));

  const double cell = axes[0].edge * axes[1].edge * axes[2].edge;
  counts.cells = mean_region(axes, none, colliding) / cell;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double rate = moments.mean_speed / 2 * axes[axis].crossings;
    counts.enter += rate;
    counts.cells_entered += rate * mean_section(axes, none, one, axis) * axes[axis].edge / cell;
    counts.candidates_after_enter +=
        rate * pairs_in(axes[axis].edge * mean_section(axes, surplus, sum_powers(one, one), axis));
  }
  if (counts.enter > 0) {
    counts.cells_entered /= counts.enter;
    counts.candidates_after_enter /= counts.enter;
  }
  // Measured in simulations from dilute to dense: docs/theory.md.
  const double mean_edge = std::cbrt(cell);
  counts.stale = counts.collision / 2 * 0.38 * mean_edge / (mean_edge + 1.35 * free_path);
  return counts;
}

}  // namespace hardball
