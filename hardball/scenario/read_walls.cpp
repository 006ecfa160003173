// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/scenario/read_tables.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <type_traits>
#include <variant>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/meshes/read_height_field.hpp"
#include "hardball/meshes/read_mesh.hpp"
#include "hardball/scenario/keys.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/surfaces/make_mesh.hpp"

namespace hardball {
namespace {

SurfaceMaterial read_material(const Section& section) {
  SurfaceMaterial material;
  if (const auto restitution = section.find("restitution")) material.restitution = restitution->number();
  if (const auto tangential = section.find("tangential_restitution"))
    material.tangential_restitution = tangential->number();
  if (const auto temperature = section.find("temperature")) material.temperature = temperature->number();
  for (const char* const restitution : {"restitution", "tangential_restitution"})
    section.refuse_both(
        restitution, "temperature",
        "remove one of the two: the velocities with which spheres leave a thermal wall do not "
        "depend on those before");
  return material;
}

// The plane, or one that oscillates if the section says so.
Shape read_oscillation(const Section& section, const Shape& plane) {
  if (!section.find("amplitude") && !section.find("frequency")) return plane;
  for (const char* const oscillation : {"amplitude", "frequency"})
    section.refuse_both("velocity", oscillation,
                        "a plane either moves evenly or oscillates; remove one of the two", "velocity");
  return oscillating(plane, section.need("amplitude").number(), section.need("frequency").number());
}

// Error, with `where` as its place: a number cannot be computed with.
SurfaceDescription described(const Shape& shape, const Vec3& point, const Vec3& velocity,
                             const SurfaceMaterial& material, const std::string& where) {
  return made_at(where, [&] { return SurfaceDescription{Surface(shape, point, velocity, material), where}; });
}

// The triangles of a wall that is a mesh of some shape.
MeshParts read_parts(const Section& section, std::string_view shape, const std::filesystem::path& folder) {
  if (shape == kMeshShapes[0]) return read_mesh(folder / section.need("file").text());
  if (shape == kMeshShapes[1]) return box_mesh(section.need("size").vector(kAxes));
  if (shape == kMeshShapes[2]) return segment_mesh(section.need("end").vector(kAxes));
  if (shape == kMeshShapes[4]) {
    const auto [heights, columns] = read_height_field(folder / section.need("file").text());
    return height_field_mesh(heights, columns, section.need("spacing").number());
  }
  const Value edges = section.need("edges");
  const std::vector<Vec3> both = edges.vectors(kAxes);
  if (both.size() != 2) edges.wrong_length(both.size(), "give two vectors, from a corner to the next ones");
  return plate_mesh(both[0], both[1]);
}

// Errors name the location of the wall.
MeshShape read_mesh_shape(const Section& section, std::string_view shape,
                          const std::filesystem::path& folder) {
  const bool is_file = shape == kMeshShapes[0];
  const bool is_box = shape == kMeshShapes[1];
  const bool is_capsule = shape == kMeshShapes[2];
  const auto number = [&](const char* key, bool is_known, double if_not_given) {
    const auto given = is_known ? section.find(key) : std::nullopt;
    return given ? given->number() : if_not_given;
  };
  const double scale = number("scale", is_file, 1);
  const double weld = number("weld", is_file, 0);
  const double thickness = is_capsule ? section.need("radius").number() : number("thickness", true, 0);
  Vec3 rotation;
  MeshSide spheres = is_box ? MeshSide::outside : MeshSide::both;
  if (is_file || is_box) {
    if (const auto given = section.find("rotation")) rotation = given->vector(kAxes);
    if (const auto given = section.find("spheres")) spheres = static_cast<MeshSide>(given->choice());
  }
  const MeshParts parts = read_parts(section, shape, folder);
  return made_at(section.location(), [&] {
    const auto mesh = std::make_shared<const Mesh>(transformed(parts, scale, rotation), weld);
    MeshShape made(mesh, spheres, thickness);
    if (!is_file) return made;
    for (const Section& group : section.sections("groups"))
      made.set_group_material(group.need("name").text(), read_material(group));
    return made;
  });
}

// The motion that drives a wall, if one does.
std::optional<std::size_t> read_motion_of_wall(const Section& section, const Scenario& scenario) {
  const std::optional<Value> name = section.find("motion");
  if (!name) return std::nullopt;
  for (const char* const other : {"velocity", "amplitude", "frequency"})
    section.refuse_both("motion", other, "remove one of the two: the motion moves the wall", other);
  return motion_named(*name, scenario.motions);
}

// A surface of a wall.
struct Part {
  Shape shape;
  Vec3 point;
};

// A cone between two planes across its axis. Error: it is a cylinder.
std::vector<Part> read_truncated_cone(const Section& section, const Vec3& point, std::size_t dimensions) {
  const Vec3 axis = direction_of(section.need("axis"), "axis", dimensions);
  const double bottom = section.need("bottom_radius").number();
  const double top = section.need("top_radius").number();
  const double height = section.need("height").number();
  if (bottom == top) {
    throw Error("both ends of a truncated cone have the radius " + to_text(top), section.location(),
                "give a cylinder, and planes");
  }
  const double slope = (top - bottom) / height;
  const Vec3 apex = point - (bottom / slope) * axis;
  return {{Cone(slope > 0 ? axis : -axis, std::fabs(slope)), apex},
          {Plane(axis), point},
          {Plane(-axis), point + height * axis}};
}

// The radii of a shell or an annulus.
struct Radii {
  double outer;
  double inner;
};

// Error: the inner radius is not the smaller one.
Radii read_radii_of_both(const Section& section) {
  const double outer = section.need("radius").number();
  const double inner = section.need("inner_radius").number();
  if (inner >= outer) {
    throw Error("the radii of a wall are " + to_text(outer) + " and " + to_text(inner), section.location(),
                "give an inner_radius that is smaller than the radius");
  }
  return {outer, inner};
}

// A sphere within another.
std::vector<Part> read_shell(const Section& section, const Vec3& point) {
  const auto [outer, inner] = read_radii_of_both(section);
  return {{HollowSphere(outer), point}, {Obstacle(inner), point}};
}

// A pillar within a tube, between two planes across their axis.
std::vector<Part> read_annulus(const Section& section, const Vec3& point, std::size_t dimensions) {
  const Vec3 axis = direction_of(section.need("axis"), "axis", dimensions);
  const auto [outer, inner] = read_radii_of_both(section);
  return {{Cylinder(axis, outer), point},
          {Pillar(axis, inner), point},
          {Plane(axis), point},
          {Plane(-axis), point + section.need("height").number() * axis}};
}

// Adds the surfaces of a wall.
void read_wall(const Section& section, const std::filesystem::path& folder, const Scenario& scenario,
               std::vector<SurfaceDescription>& surfaces) {
  const std::size_t dimensions = scenario.dimensions();
  const Value name = section.need("shape");
  static_cast<void>(name.choice());
  const Vec3 point = section.need("point").vector(dimensions);
  const std::string kind = name.text();
  const bool is_mesh = ranges::find(kMeshShapes, kind) != kMeshShapes.end();
  std::vector<Part> parts;
  if (is_mesh) {
    parts.push_back({read_mesh_shape(section, kind, folder), point});
  } else if (kind == kJoinedShapes[0]) {
    parts = read_truncated_cone(section, point, dimensions);
  } else if (kind == kJoinedShapes[1]) {
    parts = read_shell(section, point);
  } else if (kind == kJoinedShapes[2]) {
    parts = read_annulus(section, point, dimensions);
  } else {
    Shape shape = *from_description<Shape>(
        kind, [&](const auto& field) { return read_field(section, field, dimensions); });
    if (std::holds_alternative<Plane>(shape)) shape = read_oscillation(section, shape);
    parts.push_back({std::move(shape), point});
  }
  const SurfaceMaterial material = read_material(section);
  Vec3 velocity;
  if (const auto given = section.find("velocity")) velocity = given->vector(dimensions);
  for (const Part& part : parts) {
    SurfaceDescription& wall =
        surfaces.emplace_back(described(part.shape, part.point, velocity, material, section.location()));
    wall.motion = read_motion_of_wall(section, scenario);
    if (const auto about = section.find("torque_about"))
      wall.torque_offset = about->vector(dimensions) - part.point;
  }
}

std::vector<Vec3> read_positions(const Section& section, std::size_t dimensions) {
  section.refuse_both("position", "positions");
  if (const auto positions = section.find("positions")) return positions->vectors(dimensions);
  return {section.need("position").vector(dimensions)};
}

}  // namespace

Vec3 direction_of(const Value& value, std::string_view key, std::size_t dimensions) {
  const Vec3 direction = value.vector(dimensions);
  check_positive(std::hypot(direction.x, direction.y, direction.z), "the length of " + std::string(key),
                 value.location());
  // Components along an axis stay exact, and no square overflows.
  const double largest = std::max({std::fabs(direction.x), std::fabs(direction.y), std::fabs(direction.z)});
  const Vec3 scaled{direction.x / largest, direction.y / largest, direction.z / largest};
  const double norm = length(scaled);
  return {scaled.x / norm, scaled.y / norm, scaled.z / norm};
}

std::vector<FaceDescription> read_faces(const Section& box, std::size_t dimensions) {
  std::vector<FaceDescription> faces;
  const std::optional<Section> table = box.section("faces");
  for (Face face = 0; table && face < kFaces; ++face) {
    const std::optional<Section> section = table->section(kFaceNames[face]);
    if (!section) continue;
    FaceProperties properties{.material = read_material(*section)};
    if (const auto velocity = section->find("velocity")) properties.velocity = velocity->vector(dimensions);
    faces.push_back({face, properties, section->location()});
  }
  return faces;
}

std::vector<SurfaceDescription> read_surfaces(const Section& root, const std::filesystem::path& folder,
                                              const Scenario& scenario) {
  const std::size_t dimensions = scenario.dimensions();
  std::vector<SurfaceDescription> surfaces;
  for (const Section& section : root.sections("walls")) read_wall(section, folder, scenario, surfaces);
  for (const Section& section : root.sections("obstacles")) {
    const Obstacle obstacle(section.need("radius").number());
    const SurfaceMaterial material = read_material(section);
    for (const Vec3& position : read_positions(section, dimensions))
      surfaces.push_back(described(obstacle, position, {}, material, section.location()));
  }
  return surfaces;
}

}  // namespace hardball
