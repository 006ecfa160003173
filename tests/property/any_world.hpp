// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "hardball/simulation/simulation.hpp"
#include "support/gas.hpp"
#include "support/random_world.hpp"

/// Worlds drawn by RapidCheck; to be called within a property.
namespace hardball::support {

/// Shrinking a seed says nothing: it makes another world.
inline std::uint64_t any_seed() {
  return *rc::gen::noShrink(rc::gen::arbitrary<std::uint64_t>());
}

/// Any world at all, with ties, clumps and mixed boundaries.
inline RandomWorld any_world() {
  return make_random_world(any_seed());
}

/// A gas without ties; what fails is shrunk to few spheres.
inline RandomWorld any_gas(const std::array<Boundary, kAxes>& boundary) {
  const std::size_t spheres = *rc::gen::inRange<std::size_t>(2, 40);
  return make_random_gas(any_seed(), boundary, spheres);
}

/// Boundaries of each kind along each axis.
inline std::array<Boundary, kAxes> any_boundary() {
  std::array<Boundary, kAxes> boundary{};
  for (Boundary& each : boundary)
    each = *rc::gen::element(Boundary::wall, Boundary::periodic, Boundary::open);
  return boundary;
}

/// An elastic gas of 20 to 60 spheres of similar radii and masses, in a box of four to seven diameters: at
/// packing fractions of 0.1 to 0.25 flights are short, and rounding errors grow slowly.
inline World any_dense_gas(const std::array<Boundary, kAxes>& boundary) {
  const std::size_t spheres = *rc::gen::inRange<std::size_t>(20, 60);
  const double packing_fraction = 0.01 * *rc::gen::inRange(10, 25);
  Random random(any_seed());
  std::vector<double> radii;
  std::vector<double> masses;
  for (std::size_t i = 0; i < spheres; ++i) {
    radii.push_back(0.4 + 0.1 * random.uniform());
    masses.push_back(0.5 + random.uniform());
  }
  const double edge = cube_edge(spheres, packing_fraction);
  const Vec3 size{edge, edge, edge};
  World world(Box(boundary, size));
  const std::vector<Vec3> centers = place_randomly(world.box(), {{}, size}, radii, random, "dense gas");
  const std::vector<Vec3> velocities = thermal_velocities(masses, random);
  for (std::size_t i = 0; i < spheres; ++i) world.add({centers[i], velocities[i], radii[i], masses[i]});
  return world;
}

inline constexpr std::array<Boundary, kAxes> kAllPeriodic{Boundary::periodic, Boundary::periodic,
                                                          Boundary::periodic};

/// Inelastic spheres may collide infinitely often in a finite time.
inline constexpr std::uint64_t kMostContacts = 2000;

}  // namespace hardball::support
