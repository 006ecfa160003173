// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "hardball/errors/export.hpp"
#include "hardball/meshes/mesh.hpp"

namespace hardball {

/// What a file of triangles has: an STL file, as text or binary, whose groups are its solids; a Wavefront OBJ
/// file, whose groups are those of `usemtl` and `g`, and whose lines are segments; or a PLY file, as text or
/// binary in either order of bytes, whose groups are the values of the faces' property `material`. Polygons
/// become fans of triangles. The ending of the name says which: .stl, .obj or .ply. Error, with the file and
/// the line or byte: it cannot be read, is none of these, or names vertices that it does not have. Cost:
/// O(bytes).
HARDBALL_EXPORT MeshParts read_mesh(const std::filesystem::path& path);

/// What the bytes of an STL file have; `where` names them in errors. Error: as of read_mesh.
MeshParts mesh_from_stl(std::string_view bytes, const std::string& where);
/// What the bytes of an OBJ file have; `where` names them in errors. Error: as of read_mesh.
MeshParts mesh_from_obj(std::string_view bytes, const std::string& where);
/// What the bytes of a PLY file have; `where` names them in errors. Error: as of read_mesh.
MeshParts mesh_from_ply(std::string_view bytes, const std::string& where);

}  // namespace hardball
