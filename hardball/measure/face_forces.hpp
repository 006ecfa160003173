// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// The forces on the triangles of a mesh. What touches an edge or a vertex acts on the first triangle that it
/// is part of.
struct FaceForces {
  std::string wall;  ///< The name of the wall in the results of `wall_forces`: "mesh_0".
  std::shared_ptr<const Mesh> mesh;
  Vec3 point;                     ///< Where the origin of the mesh is at the end [L].
  std::vector<Vec3> forces = {};  ///< On each triangle: the mean force [M L T^-2].
  /// On each triangle: the mean of the forces along the normals of contacts, over its area, from both sides
  /// [M L^-1 T^-2]; NaN if it has no area.
  std::vector<double> pressures = {};
  std::vector<std::uint64_t> contacts = {};  ///< How many each triangle had.
};

/// A file for ParaView and other readers of VTK's PolyData: the triangles where the mesh is at the end, and
/// for each `force`, `pressure`, `contacts` and `group`, the index of its group.
HARDBALL_EXPORT std::string vtp_text(const FaceForces& forces);

}  // namespace hardball
