// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "hardball/memory/function.hpp"
#include "hardball/meshes/mesh.hpp"
#include "hardball/packing/fine.hpp"

namespace hardball {

/// A wall near the center of a sphere.
struct NearWall {
  std::uint32_t number = 0;
  Vec3 separation;  ///< From the center to the nearest point of the wall [L].
  Fine distance;    ///< The length of that [L].
};

/// The walls that a mesh is for packings, which count contacts: flat parts, however many triangles make them
/// up; edges and vertices that spheres can touch. A sphere touches a wall only in its normal cone, and so
/// exactly those that hold it.
class MeshWalls {
 public:
  /// Cost: O(n) of n triangles.
  explicit MeshWalls(std::shared_ptr<const Mesh> mesh);

  /// The number of the wall that a feature of the mesh (see Mesh) is part of: kFaces and the least feature of
  /// that wall.
  std::uint32_t number(std::uint32_t feature) const;
  /// Calls visit(wall) for all walls that are no farther from a center inside the mesh than this [L], by
  /// their numbers; of those with one nearest point, for the first, at the least of their distances. Cost:
  /// O(log n), and that of all triangles within this distance.
  void for_each_near(const Vec3& center, double within, const Function<void(const NearWall&)>& visit) const;

 private:
  std::shared_ptr<const Mesh> mesh_;
  std::vector<std::uint32_t> flat_parts_;  // by triangle: the first of its flat part
};

}  // namespace hardball
