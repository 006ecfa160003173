// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/packing/container.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/packing/inscribed_radius.hpp"
#include "hardball/surfaces/make_mesh.hpp"
#include "hardball/world/setting.hpp"
#include "hardball/world/walls.hpp"

namespace hardball {
namespace {

// Not std::hypot, which may differ in the last bit from one platform to the next.
double slant(double radius, double height) {
  return std::sqrt(radius * radius + height * height);
}

std::shared_ptr<const Mesh> scaled(const std::shared_ptr<const Mesh>& mesh, double scale) {
  if (scale == 1) return mesh;
  MeshParts parts;
  parts.vertices.assign(mesh->vertices().begin(), mesh->vertices().end());
  parts.triangles.assign(mesh->triangles().begin(), mesh->triangles().end());
  return std::make_shared<const Mesh>(transformed(std::move(parts), scale, {}));
}

}  // namespace

Container Container::within(std::shared_ptr<const Mesh> mesh, double scale, std::string_view where) {
  check_positive(scale, "the scale of the mesh", where);
  const MeshReport& report = mesh->report();
  if (!mesh->is_closed()) {
    throw Error("the mesh is not closed and encloses nothing: " + to_text(report.boundary_edges) +
                    " of its edges belong to one triangle, and " + to_text(report.branching_edges) +
                    " to more than two",
                std::string(where), "close its holes, or weld vertices that nearly coincide");
  }
  if (!(mesh->volume() > 0)) {
    throw Error("the mesh encloses no certain volume: at " + to_text(report.flipped_edges) +
                    " of its edges one of two triangles is inside out",
                std::string(where), "turn all of its triangles outward");
  }
  const Extent& extent = mesh->extent();
  Container container{.shape = Shape::mesh, .size = extent.high - extent.low, .low = extent.low};
  container.inscribed = inscribed_radius(*mesh);
  container.mesh = std::move(mesh);
  return container.scaled(scale);
}

Box Container::box() const {
  using enum Boundary;
  std::array<Boundary, kAxes> boundary{open, open, wall};
  if (shape == Shape::sphere || shape == Shape::shell || shape == Shape::mesh) boundary = {open, open, open};
  if (shape == Shape::box) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) boundary[axis] = has_walls[axis] ? wall : periodic;
  }
  if (dimensions == 2) boundary[2] = flat;
  return {boundary, size};
}

std::vector<Surface> Container::surfaces() const {
  const Vec3 up{0, 0, 1};
  const Vec3 center = 0.5 * size;
  const double radius = size.x / 2;
  if (shape == Shape::cylinder) return {Surface(Cylinder(up, radius), {center.x, center.y, 0})};
  if (shape == Shape::sphere) return {Surface(HollowSphere(radius), center)};
  if (shape == Shape::cone) return {Surface(Cone(up, radius / size.z), {center.x, center.y, 0})};
  if (shape == Shape::truncated_cone) {
    const double wider = size.x - inner;
    return {Surface(Cone(up, wider / 2 / size.z), {center.x, center.y, -(inner / wider) * size.z})};
  }
  if (shape == Shape::annulus) {
    const Vec3 foot{center.x, center.y, 0};
    return {Surface(Cylinder(up, radius), foot), Surface(Pillar(up, inner / 2), foot)};
  }
  if (shape == Shape::shell)
    return {Surface(HollowSphere(radius), center), Surface(Obstacle(inner / 2), center)};
  if (shape == Shape::mesh) return {Surface(MeshShape(hardball::scaled(mesh, scale), MeshSide::inside), {})};
  return {};
}

double Container::volume() const {
  if (shape == Shape::mesh) return scale * scale * scale * mesh->volume();
  // Without the differences of large numbers that nearly equal diameters would leave.
  if (shape == Shape::truncated_cone)
    return std::numbers::pi / 12 * size.z * (size.x * size.x + size.x * inner + inner * inner);
  return accessible_volume(World(box(), {}, surfaces()));
}

double Container::wall_area() const {
  const Box whole = box();
  const double radius = size.x / 2;
  const double disc = std::numbers::pi * radius * radius;
  if (shape == Shape::mesh) return scale * scale * mesh->area();
  if (shape == Shape::sphere) return whole.sphere_surface(radius);
  if (shape == Shape::shell) return whole.sphere_surface(radius) + whole.sphere_surface(inner / 2);
  if (shape == Shape::annulus) {
    const double narrow = inner / 2;
    return 2 * std::numbers::pi * (radius + narrow) * (radius - narrow + size.z);
  }
  if (shape == Shape::truncated_cone) {
    const double narrow = inner / 2;
    return disc + std::numbers::pi * narrow * narrow +
           std::numbers::pi * (radius + narrow) * slant(radius - narrow, size.z);
  }
  if (shape == Shape::cylinder) return 2 * disc + 2 * std::numbers::pi * radius * size.z;
  if (shape == Shape::cone) return disc + std::numbers::pi * radius * slant(radius, size.z);
  double area = 0;
  for (std::size_t axis = 0; axis < dimensions; ++axis)
    if (has_walls[axis]) area += 2 * whole.face_area(axis);
  return area;
}

double Container::largest_radius() const {
  if (shape == Shape::mesh) return scale * inscribed;
  if (shape == Shape::shell) return (size.x - inner) / 4;
  if (shape == Shape::annulus) return std::min((size.x - inner) / 4, size.z / 2);
  if (shape != Shape::cone && shape != Shape::truncated_cone)
    return largest_fitting_radius(box(), surfaces());
  // The sphere that touches the lid and the mantle, unless it is too high.
  const double radius = size.x / 2;
  const double wider = radius - inner / 2;
  const double touching = radius * size.z / (wider + slant(wider, size.z));
  return std::min(touching, size.z / 2);
}

std::size_t Container::free_motions() const {
  if (shape == Shape::sphere || shape == Shape::shell) return dimensions == 2 ? 1 : 3;
  if (shape == Shape::mesh) return 0;
  if (shape != Shape::box) return 1;
  std::size_t translations = 0;
  for (std::size_t axis = 0; axis < dimensions; ++axis)
    if (is_periodic(axis)) ++translations;
  return translations;
}

Container Container::scaled(double factor) const {
  Container result = *this;
  result.size = factor * size;
  result.low = factor * low;
  result.inner = factor * inner;
  result.scale = factor * scale;
  return result;
}

void check(const Container& container, std::string_view where) {
  for (std::size_t axis = 0; axis < container.dimensions; ++axis)
    check_positive(container.size[axis], "size", where);
  using enum Container::Shape;
  const bool is_flat_too = container.shape == box || container.shape == sphere || container.shape == shell;
  if (container.dimensions == 2 && !is_flat_too) {
    throw Error("discs do not fit into a cylinder, a cone or a mesh", std::string(where),
                "give a box, or a sphere or a shell, which are circles for discs");
  }
  if (container.shape != truncated_cone && container.shape != shell && container.shape != annulus) return;
  check_positive(container.inner, "the smaller diameter", where);
  if (container.inner < container.size.x) return;
  throw Error("the diameters are " + to_text(container.inner) + " and " + to_text(container.size.x),
              std::string(where),
              container.shape != truncated_cone
                  ? "give the smaller one first"
                  : "give the smaller one first, at the bottom: a packing can be turned over");
}

}  // namespace hardball
