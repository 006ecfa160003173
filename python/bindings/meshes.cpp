// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "documentation.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/meshes/read_mesh.hpp"
#include "hardball/surfaces/make_mesh.hpp"
#include "python/bindings/arrays.hpp"
#include "python/bindings/bindings.hpp"
#include "python/bindings/typed.hpp"

namespace py = pybind11;

namespace hardball::python {
namespace {

constexpr std::uint32_t kMostVertices = std::numeric_limits<std::uint32_t>::max() - 1;

// Rows of three indices.
std::vector<MeshParts::Triangle> triangles_of(const py::handle& object) {
  const auto array = py::array::ensure(object);
  if (!array || array.ndim() != 2 || array.shape(1) != 3)
    throw Error("they are not rows of three", "triangles", "give an array of shape (n, 3)");
  const std::vector<std::uint32_t> corners = counts_of(
      array.attr("reshape")(-1), "triangles", static_cast<std::size_t>(3 * array.shape(0)), kMostVertices);
  std::vector<MeshParts::Triangle> triangles;
  for (std::size_t i = 0; i < corners.size(); i += 3)
    triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
  return triangles;
}

py::array_t<double> vertices_of(const Mesh& mesh) {
  return array_around(std::vector<Vec3>(mesh.vertices().begin(), mesh.vertices().end()));
}

py::array_t<std::uint32_t> corners_of(const Mesh& mesh) {
  std::vector<std::uint32_t> corners;
  for (const Mesh::Triangle& triangle : mesh.triangles())
    corners.insert(corners.end(), triangle.begin(), triangle.end());
  return py::array_t<std::uint32_t>(array_around(std::move(corners)).attr("reshape")(-1, 3));
}

// One answer for each point.
template <class Answer>
py::array_t<Answer> for_each_point(const ArrayLike& points, const auto& answer) {
  const std::vector<Vec3> places = vectors_of(points, "points", false);
  py::array_t<Answer> answers(static_cast<py::ssize_t>(places.size()));
  for (std::size_t i = 0; i < places.size(); ++i)
    answers.mutable_at(static_cast<py::ssize_t>(i)) = answer(places[i]);
  return answers;
}

}  // namespace

void bind_meshes(py::module_& module) {
  const py::tuple origin = py::make_tuple(0.0, 0.0, 0.0);
  py::class_<Mesh, std::shared_ptr<Mesh>> mesh(module, "Mesh", doc::Mesh);
  mesh.def(py::init([](const ArrayLike& vertices, const ArrayLike& triangles, const OptionalArrayLike& groups,
                       const std::vector<std::string>& group_names, double weld) {
             MeshParts parts{
                 vectors_of(vertices, "vertices", false), triangles_of(triangles), {}, group_names};
             if (!groups.is_none())
               parts.groups = counts_of(groups, "groups", parts.triangles.size(), kMostVertices);
             return Mesh(std::move(parts), weld);
           }),
           py::arg("vertices"), py::arg("triangles"), py::kw_only(), py::arg("groups") = py::none(),
           py::arg("group_names") = std::vector<std::string>(), py::arg("weld") = 0.0,
           "`vertices` [L] has shape (n, 3), `triangles` the indices of the corners, counterclockwise as "
           "seen from "
           "outside, shape (m, 3); a triangle that names a corner twice is a segment. `groups` has the index "
           "of the "
           "group of each triangle among `group_names`. Vertices in one place become one; with `weld` [1], "
           "so do "
           "those that are closer than this fraction of the median edge.")
      .def_static(
          "read",
          [](const std::filesystem::path& path, double scale, const ArrayLike& rotation, double weld) {
            return Mesh(transformed(read_mesh(path), scale, vector_of(rotation, "rotation", false)), weld);
          },
          py::arg("path"), py::kw_only(), py::arg("scale") = 1.0, py::arg("rotation") = origin,
          py::arg("weld") = 0.0,
          "The mesh of an STL, OBJ or PLY file, scaled by `scale`, and then turned around the vector "
          "`rotation` by as "
          "many degrees as that is long.")
      .def_static(
          "box", [](const ArrayLike& size) { return Mesh(box_mesh(vector_of(size, "size", false))); },
          py::arg("size"), doc::box_mesh)
      .def_static(
          "plate",
          [](const ArrayLike& first, const ArrayLike& second) {
            return Mesh(plate_mesh(vector_of(first, "first", false), vector_of(second, "second", false)));
          },
          py::arg("first"), py::arg("second"), doc::plate_mesh)
      .def_static(
          "segment", [](const ArrayLike& end) { return Mesh(segment_mesh(vector_of(end, "end", false))); },
          py::arg("end"), doc::segment_mesh)
      .def_static(
          "height_field",
          [](const ArrayLike& heights, double spacing) {
            const Doubles rows = doubles(heights, "heights");
            if (rows.ndim() != 2)
              throw Error("they are not rows", "heights", "give an array of two dimensions");
            return Mesh(height_field_mesh({rows.data(), static_cast<std::size_t>(rows.size())},
                                          static_cast<std::size_t>(rows.shape(1)), spacing));
          },
          py::arg("heights"), py::arg("spacing"), doc::height_field_mesh)
      .def_property_readonly(
          "vertices", [](const Mesh& self) { return read_only(vertices_of(self)); }, "[L]. Shape (n, 3).")
      .def_property_readonly(
          "triangles", [](const Mesh& self) { return read_only(corners_of(self)); },
          "The indices of their corners. Shape (m, 3).")
      .def_property_readonly("volume", &Mesh::volume, doc::Mesh_volume)
      .def_property_readonly("area", &Mesh::area, doc::Mesh_area)
      .def_property_readonly("is_closed", &Mesh::is_closed, doc::Mesh_is_closed)
      .def(
          "contains",
          [](const Mesh& self, const ArrayLike& points) {
            if (!self.is_closed())
              throw Error("the mesh is not closed, and has no inside", "contains",
                          "use winding_number, above a half");
            return for_each_point<bool>(points, [&](const Vec3& point) { return self.contains(point); });
          },
          py::arg("points"),
          "Whether points, shape (k, 3) [L], are inside, decided by exact signs. Shape (k,).")
      .def(
          "winding_number",
          [](const Mesh& self, const ArrayLike& points) {
            return for_each_point<double>(points,
                                          [&](const Vec3& point) { return self.winding_number(point); });
          },
          py::arg("points"), doc::Mesh_winding_number)
      .def(
          "distance",
          [](const Mesh& self, const ArrayLike& points) {
            return for_each_point<double>(
                points, [&](const Vec3& point) { return length(self.nearest(point).point - point); });
          },
          py::arg("points"), "The distances of points, shape (k, 3) [L], from the mesh [L]. Shape (k,).")
      .def_property_readonly(
          "report", [](const Mesh& self) -> Typed<"dict[str, int]"> {
            const MeshReport& report = self.report();
            py::dict counts;
            counts["welded_vertices"] = report.welded_vertices;
            counts["duplicate_triangles"] = report.duplicate_triangles;
            counts["flat_triangles"] = report.flat_triangles;
            counts["split_triangles"] = report.split_triangles;
            counts["boundary_edges"] = report.boundary_edges;
            counts["branching_edges"] = report.branching_edges;
            counts["flipped_edges"] = report.flipped_edges;
            counts["components"] = report.components;
            return counts;
          },
          doc::MeshReport)
      .def("__repr__", [](const Mesh& self) {
        return "<Mesh of " + to_text(self.triangles().size()) + " triangles and " +
               to_text(self.vertices().size()) + " vertices>";
      });
}

}  // namespace hardball::python
