// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "hardball/numbers/random.hpp"
#include "hardball/placement/placement.hpp"
#include "hardball/world/world.hpp"
#include "support/gas.hpp"

/// Gases of discs made in code; diameter, mass and kT are one.
namespace hardball::support {

/// The edge of the square in which `count` discs of diameter one have this packing fraction.
inline double square_edge(std::size_t count, double packing_fraction) {
  return std::sqrt(static_cast<double>(count) * std::numbers::pi / 4 / packing_fraction);
}

/// Maxwell velocities in the plane with zero total momentum, for masses of one, scaled so that the mean of
/// v^2 is 2 up to rounding.
inline std::vector<Vec3> thermal_velocities_in_plane(std::size_t count, Random& random) {
  std::vector<Vec3> velocities;
  Vec3 sum;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = random.normal();
    const double y = random.normal();
    velocities.push_back({x, y, 0});
    sum += velocities.back();
  }
  double squares = 0;
  for (Vec3& velocity : velocities) {
    velocity -= (1 / static_cast<double>(count)) * sum;
    squares += dot(velocity, velocity);
  }
  for (Vec3& velocity : velocities) velocity = std::sqrt(2 * static_cast<double>(count) / squares) * velocity;
  return velocities;
}

/// A gas of discs in a square, at random up to a packing fraction of 0.5, otherwise from a hexagonal lattice
/// in a box that suits it if `count` is twice the square of a number.
inline World make_discs(std::size_t count, double packing_fraction, std::uint64_t seed,
                        Boundary boundary = Boundary::periodic) {
  constexpr double kMaxRandom = 0.5;
  const bool is_random = packing_fraction <= kMaxRandom;
  const double stretch = is_random ? 1 : std::sqrt(std::sqrt(3.0));
  const double edge = square_edge(count, packing_fraction);
  const Vec3 size{edge / stretch, edge * stretch, 0};
  World world(Box({boundary, boundary, Boundary::flat}, size));
  Random random(seed);
  const std::vector<double> radii(count, kDiameter / 2);
  const std::vector<Vec3> centers =
      is_random ? place_randomly(world.box(), {{}, size}, radii, random, "discs")
                : place_on_lattice(world.box(), {{}, size}, count, kDiameter / 2, "discs");
  const std::vector<Vec3> velocities = thermal_velocities_in_plane(count, random);
  for (std::size_t i = 0; i < count; ++i) {
    world.add({.position = centers[i], .velocity = velocities[i], .radius = radii[i]});
  }
  return world;
}

}  // namespace hardball::support
