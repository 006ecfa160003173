// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>

#include "hardball/meshes/mesh.hpp"

namespace hardball::support {

/// The parts of a closed torus about the axis z, with its middle at `center` [L]: `rings` rings of `sides`
/// points.
inline MeshParts torus_parts(std::uint32_t rings, std::uint32_t sides, double large, double small,
                             const Vec3& center = {}) {
  MeshParts parts;
  for (std::uint32_t ring = 0; ring < rings; ++ring) {
    for (std::uint32_t side = 0; side < sides; ++side) {
      const double around = 2 * std::numbers::pi * ring / rings;
      const double across = 2 * std::numbers::pi * side / sides;
      const double from_axis = large + small * std::cos(across);
      parts.vertices.push_back(center + Vec3{from_axis * std::cos(around), from_axis * std::sin(around),
                                             small * std::sin(across)});
      const std::uint32_t next_ring = (ring + 1) % rings * sides;
      const std::uint32_t next_side = (side + 1) % sides;
      const std::uint32_t here = ring * sides;
      parts.triangles.push_back({here + side, next_ring + side, next_ring + next_side});
      parts.triangles.push_back({here + side, next_ring + next_side, here + next_side});
    }
  }
  return parts;
}

/// A mesh of these parts.
inline std::shared_ptr<const Mesh> torus(std::uint32_t rings, std::uint32_t sides, double large, double small,
                                         const Vec3& center = {}) {
  return std::make_shared<const Mesh>(torus_parts(rings, sides, large, small, center));
}

}  // namespace hardball::support
