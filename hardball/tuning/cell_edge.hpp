// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "hardball/world/world.hpp"

namespace hardball {

/// What kinetic theory needs to know of a world.
struct Moments {
  std::size_t spheres = 0;
  double volume = 0;       ///< Of the box; along open axes, of the stretch that holds most spheres [L^3].
  double mean_radius = 0;  ///< [L]
  double mean_square_radius = 0;  ///< [L^2]
  double mean_cube_radius = 0;    ///< [L^3]
  double largest_radius = 0;      ///< [L]
  double mean_speed = 0;          ///< [L/T]

  double number_density() const { return static_cast<double>(spheres) / volume; }  ///< [L^-3]
  double packing_fraction() const;                                                 ///< [1]
  /// The factor by which excluded volume raises the collision rate over that of a dilute gas [1].
  /// Source: Carnahan and Starling, J. Chem. Phys. 51 (1969) 635; Enskog's contact value.
  double contact_value() const;
  /// Mean path of a sphere between collisions [L]; infinite if there are fewer than two spheres.
  double mean_free_path() const;
  /// Mean time between the collisions of one sphere [T]; infinite if nothing moves.
  double mean_free_time() const;
};

/// Cost: O(n).
Moments moments_of(const World& world, const Time& moment);

/// What the steps of the event loop cost relative to the prediction of one pair [1].
struct UnitCosts {
  double prediction = 1;
  double cell_update = 8;  ///< One entry and one removal of a sphere in a cell.
  double queue_operation = 8;
};

/// The edge [L] of the cells at which the event loop costs least: smaller cells are crossed more often,
/// larger ones hold more candidates. Cost: O(1). Source: Kim, Guibas and Shin (1997), section 3, with the
/// counts of docs/theory.md.
double optimal_cell_edge(const Moments& moments, const UnitCosts& costs = {});

}  // namespace hardball
