// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/face_forces.hpp"

#include "hardball/errors/error.hpp"
#include "hardball/trajectory/vtp_arrays.hpp"

namespace hardball {

std::string vtp_text(const FaceForces& forces) {
  const Mesh& mesh = *forces.mesh;
  const std::size_t vertices = mesh.vertices().size();
  const std::size_t triangles = mesh.triangles().size();
  VtpArrays arrays;
  const auto add = [&](const char* name, const auto& value) { return arrays.add(name, triangles, value); };
  std::string text = "<Piece NumberOfPoints=\"" + to_text(vertices) +
                     "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
                     to_text(triangles) + "\">\n<CellData Scalars=\"pressure\" Vectors=\"force\">\n";
  text += add("force", [&](std::size_t i) { return forces.forces[i]; });
  text += add("pressure", [&](std::size_t i) { return forces.pressures[i]; });
  text += add("contacts", [&](std::size_t i) { return static_cast<std::int64_t>(forces.contacts[i]); });
  text += add("group", [&](std::size_t i) {
    return static_cast<std::int64_t>(mesh.group(static_cast<std::uint32_t>(i)));
  });
  text += "</CellData>\n<Points>\n";
  text += arrays.add("points", vertices, [&](std::size_t i) { return forces.point + mesh.vertices()[i]; });
  text += "</Points>\n<Polys>\n";
  text += arrays.add("connectivity", 3 * triangles, [&](std::size_t i) {
    return static_cast<std::int64_t>(mesh.triangles()[i / 3][i % 3]);
  });
  text += add("offsets", [](std::size_t i) { return static_cast<std::int64_t>(3 * (i + 1)); });
  return vtp_file(text + "</Polys>\n</Piece>\n", arrays);
}

}  // namespace hardball
