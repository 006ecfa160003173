// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "hardball/numbers/random.hpp"
#include "hardball/world/world.hpp"

namespace hardball::support {

/// A crystal given by its orthogonal cell, with nearest neighbors at distance one.
struct Lattice {
  Vec3 cell;                ///< Edges.
  std::vector<Vec3> basis;  ///< In units of the edges.
};

inline Lattice simple_cubic() {
  return {{1, 1, 1}, {{0, 0, 0}}};
}
inline Lattice body_centered_cubic() {
  const double a = 2 / std::sqrt(3);
  return {{a, a, a}, {{0, 0, 0}, {0.5, 0.5, 0.5}}};
}
inline Lattice face_centered_cubic() {
  const double a = std::sqrt(2);
  return {{a, a, a}, {{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}}};
}
inline Lattice hexagonal_close_packing() {
  return {{1, std::sqrt(3), std::sqrt(8.0 / 3)},
          {{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 5.0 / 6, 0.5}, {0, 1.0 / 3, 0.5}}};
}

inline Lattice square_of_discs() {
  return {{1, 1, 0}, {{0, 0, 0}}};
}
inline Lattice hexagonal_of_discs() {
  return {{1, std::sqrt(3), 0}, {{0, 0, 0}, {0.5, 0.5, 0}}};
}

/// This many cells along each axis in a periodic box, flat if the cells are, with spheres of diameter one at
/// rest at `spacing` from their nearest neighbors.
inline World make_crystal(const Lattice& lattice, std::size_t cells, double spacing) {
  const Vec3 edge = spacing * lattice.cell;
  const Vec3 size = static_cast<double>(cells) * edge;
  const bool is_flat = edge.z == 0;
  World world(is_flat ? Box::flat_periodic(size.x, size.y) : Box::periodic(size));
  for (std::size_t x = 0; x < cells; ++x) {
    for (std::size_t y = 0; y < cells; ++y) {
      for (std::size_t z = 0; z < (is_flat ? 1 : cells); ++z) {
        for (const Vec3& site : lattice.basis) {
          const Vec3 place =
              site + Vec3{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
          world.add({.position = {place.x * edge.x, place.y * edge.y, place.z * edge.z}, .radius = 0.5});
        }
      }
    }
  }
  return world;
}

/// Spheres of these radii at independent random positions, overlaps allowed: an ideal gas, all of whose
/// averages are known. Centers are at least a radius away from walls.
inline World make_ideal_gas(const Box& box, const std::vector<double>& radii, std::uint64_t seed) {
  Random random(seed);
  World world(box);
  for (const double radius : radii) {
    Vec3 place;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const double inset = box.is_wall(axis) ? radius : 0;
      place[axis] = inset + random.uniform() * (box.size()[axis] - 2 * inset);
    }
    world.add({.position = place, .radius = radius});
  }
  return world;
}

}  // namespace hardball::support
