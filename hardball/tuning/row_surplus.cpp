// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/tuning/row_surplus.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hardball {
namespace {

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
