// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/meshes/mesh.hpp"

/// What makes the parts of a file fit together: files of triangles repeat vertices, and cut edges short.
namespace hardball {

/// Makes vertices at one place one, the first of them, and leaves out those that no triangle names.
void weld_equal_vertices(MeshParts& parts, MeshReport& report);

/// Makes vertices that are closer than `distance` [L] one, at the place of the first.
void weld_near_vertices(MeshParts& parts, double distance, MeshReport& report);

/// Leaves out triangles that have the corners of an earlier one, and those that are one point.
void remove_duplicates(MeshParts& parts, MeshReport& report);

/// Splits triangles at the vertices that lie, within `tolerance` [L], on edges that belong to one triangle.
void split_at_vertices(MeshParts& parts, double tolerance, MeshReport& report);

}  // namespace hardball
