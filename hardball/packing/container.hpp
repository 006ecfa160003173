// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "hardball/describe/names.hpp"
#include "hardball/errors/export.hpp"
#include "hardball/meshes/mesh.hpp"
#include "hardball/surfaces/surface.hpp"
#include "hardball/world/box.hpp"

namespace hardball {

/// What spheres are packed into: a box, a solid of revolution about its vertical axis, or what a mesh
/// encloses. The corner of the box around it is the origin, but of a mesh: its coordinates are those of the
/// mesh.
struct HARDBALL_EXPORT Container {
  enum class Shape : std::uint8_t {
    box,
    cylinder,  ///< Upright, between two flat ends.
    sphere,
    cone,            ///< On its apex, with a lid.
    mesh,            ///< What a closed mesh encloses.
    truncated_cone,  ///< On its narrow end, with a floor and a lid.
    shell,           ///< Between two spheres about one center.
    annulus,         ///< Between two upright cylinders about one axis, and two flat ends.
  };

  Shape shape = Shape::box;
  std::size_t dimensions = 3;           ///< 2 for discs: then a sphere is a circle.
  Vec3 size = {};                       ///< Size of the box around it [L]; z is zero in two dimensions.
  std::array<bool, kAxes> has_walls{};  ///< The axes along which a box has walls and is not periodic.
  /// The smaller diameter: of a truncated cone at its bottom, or of what is within a shell or an annulus [L].
  double inner = 0;
  /// The mesh that is filled, before it is scaled; none of other shapes.
  std::shared_ptr<const Mesh> mesh = {};
  double scale = 1;  ///< The factor of the coordinates of the mesh [1].
  /// A bound of the radius of the largest sphere within the mesh, before it is scaled [L].
  double inscribed = 0;
  Vec3 low = {};  ///< The corner of the box around it with the least coordinates [L].

  /// A box that is periodic along all axes.
  static Container periodic(const Vec3& size) { return {.size = size}; }
  /// What a mesh encloses when its coordinates are multiplied by `scale` [1]. Error, with `where` as its
  /// place: it is not closed, or some of its triangles are inside out; a scale that is not positive. Cost:
  /// O(n log n) of n triangles.
  static Container within(std::shared_ptr<const Mesh> mesh, double scale, std::string_view where);

  /// The box of its periods and flat walls; open where only surfaces enclose spheres.
  Box box() const;
  /// The walls that are not faces of the box. Cost: of a mesh that is scaled, O(n log n) of n triangles.
  std::vector<Surface> surfaces() const;
  /// [L^3], of discs [L^2].
  double volume() const;
  /// The area of all walls [L^2], around discs the length [L].
  double wall_area() const;
  /// The radius of the largest sphere that fits [L]; of a mesh, a bound that is mostly no more than 1% above.
  double largest_radius() const;
  bool is_periodic(std::size_t axis) const { return shape == Shape::box && !has_walls[axis]; }
  /// How many independent motions of all spheres together the walls allow: translations and rotations.
  std::size_t free_motions() const;
  /// This shape with all lengths multiplied by `factor`.
  Container scaled(double factor) const;

  friend bool operator==(const Container&, const Container&) = default;
  static void persist(auto& archive, auto& self) {
    archive(self.shape, self.dimensions, self.size, self.has_walls);
    archive.require(self.shape <= Shape::annulus && (self.dimensions == 2 || self.dimensions == 3));
    if (self.shape == Shape::mesh) archive(self.mesh, self.scale, self.inscribed, self.low);
    if (self.shape > Shape::mesh) archive(self.inner);
  }
};

/// Error, with `where` as its place: the container cannot exist in its dimensions, an edge is not positive,
/// or what is to be the smaller diameter is not smaller.
void check(const Container& container, std::string_view where);

template <>
inline constexpr std::array<std::string_view, 8> kNames<Container::Shape>{
    "box", "cylinder", "sphere", "cone", "mesh", "truncated_cone", "shell", "annulus"};

}  // namespace hardball
