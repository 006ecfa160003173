// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/meshes/read_mesh.hpp"

#include <algorithm>
#include <cctype>

#include "hardball/errors/error.hpp"
#include "hardball/io/read_file.hpp"

namespace hardball {

MeshParts read_mesh(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  const std::string where = path.string();
  if (ending == ".stl") return mesh_from_stl(read_file(path), where);
  if (ending == ".obj") return mesh_from_obj(read_file(path), where);
  if (ending == ".ply") return mesh_from_ply(read_file(path), where);
  throw Error("the name of a mesh ends in '" + ending + "'", where, "give a .stl, .obj or .ply file");
}

}  // namespace hardball
