// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/packing/packed_spheres.hpp"

namespace hardball {

/// How densely spheres fill a container at each distance from its curved wall.
struct WallProfile {
  double width = 0;  ///< Width of a step of the distance, 1/25 of the mean diameter or a little less [L].
  /// The share of the surface at the distance (k + 1/2) width from the wall that is within spheres [1]; the
  /// porosity is one less this.
  std::vector<double> packing_fraction;

  double distance(std::size_t step) const { return (static_cast<double>(step) + 0.5) * width; }
};

/// The profile from the mantle of a cylinder or a cone, or from the wall of a sphere or a circle, of a shell
/// from the outer one; empty in a box or a mesh. Surfaces at one distance are taken from end to end.
/// Precondition: the spheres are within the container and do not overlap. Cost: O(n), some 10 us for each
/// sphere.
HARDBALL_EXPORT WallProfile wall_profile(const PackedSpheres& spheres);

}  // namespace hardball
