// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include "hardball/broadphase/subdivision.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// The sizes that follow from the cells of a LargeSphereGrid, and which spheres are too large for these
/// cells.
///
/// If none of the others is larger than a cell, these are kept in blocks of cells, which is the fastest. So
/// all that do not fit into cells are large if they are few; otherwise only those that are so large that
/// crossing from row to row would cost more than changing all cells at their surfaces. Source:
/// docs/decisions/0012-large-spheres-as-shells-of-cells.md.
struct LargeSizes {
  /// The largest radius of a sphere that touches at most two cells along each axis, in edges of a cell.
  static constexpr double kLargestInCell = 0.4999;
  /// The largest radius that is not large where many do not fit into cells, in edges.
  static constexpr double kLargestInRows = 1.5;
  /// The skin, in edges; less in small boxes. Measured.
  static constexpr double kSkin = 0.25;

  /// The mean number of cells that the surface of a large sphere of this radius, in edges, touches.
  static double cells_of_surface(double radius, std::size_t dimensions);

  /// The largest radius that is not large, in edges, if the surfaces of all spheres that do not fit into
  /// cells touch this many cells.
  static constexpr double largest_in_edges(double surfaces, double spheres) {
    constexpr double kFewSurfaces = 0.5;  // for each sphere; measured
    return surfaces <= kFewSurfaces * spheres ? kLargestInCell : kLargestInRows;
  }

  /// Nothing if the cells do not suit the world: no sphere is large, more are large than not, or the box is
  /// so small that candidates would not be nearest images. Cost: O(n).
  static std::optional<LargeSizes> in(const World& world, const Subdivision& cells);
  /// The sizes for some of the spheres of a world that the cells suit, however many of them are large;
  /// nothing if the cells suit no such world. Cost: O(n).
  static std::optional<LargeSizes> in_part(const World& part, const Subdivision& cells);

  double largest_in_grid = 0;  ///< The largest radius that is not large [L].
  double largest = 0;          ///< The largest radius that there may be [L].
  double second_largest = 0;   ///< The largest radius of all spheres but one [L].
  std::size_t count = 0;       ///< Number of large spheres.
  double skin = 0;             ///< How far a large sphere moves from its anchor [L].
  double surfaces = 0;         ///< Cells that the surfaces of the large ones touch, about [1].
  double farthest = 0;         ///< The distance of a large sphere and a candidate [L].
};

}  // namespace hardball
