// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/surfaces/surface.hpp"
#include "hardball/world/box.hpp"

namespace hardball {

/// What spheres are packed into: a box, or a solid of revolution about its vertical axis.
struct HARDBALL_EXPORT Container {
  enum class Shape : std::uint8_t {
    box,
    cylinder,  ///< Upright, between two flat ends.
    sphere,
    cone,  ///< On its apex, with a lid.
  };

  Shape shape = Shape::box;
  std::size_t dimensions = 3;           ///< 2 for discs: then a sphere is a circle.
  Vec3 size = {};                       ///< Size of the box around it [L]; z is zero in two dimensions.
  std::array<bool, kAxes> has_walls{};  ///< The axes along which a box has walls and is not periodic.

  /// A box that is periodic along all axes.
  static Container periodic(const Vec3& size) { return {.size = size}; }

  /// The box of its periods and flat walls; open where only surfaces enclose spheres.
  Box box() const;
  /// The walls that are curved.
  std::vector<Surface> surfaces() const;
  /// [L^3], of discs [L^2].
  double volume() const;
  /// The area of all walls [L^2], around discs the length [L].
  double wall_area() const;
  /// The radius of the largest sphere that fits [L].
  double largest_radius() const;
  bool is_periodic(std::size_t axis) const { return shape == Shape::box && !has_walls[axis]; }
  /// How many independent motions of all spheres together the walls allow: translations and rotations.
  std::size_t free_motions() const;
  /// This shape with all lengths multiplied by `factor`.
  Container scaled(double factor) const;

  friend bool operator==(const Container&, const Container&) = default;
  static void persist(auto& archive, auto& self) {
    archive(self.shape, self.dimensions, self.size, self.has_walls);
    archive.require(self.shape <= Shape::cone && (self.dimensions == 2 || self.dimensions == 3));
  }
};

/// Error, with `where` as its place: the container cannot exist in its dimensions, or an edge is not
/// positive.
void check(const Container& container, std::string_view where);

}  // namespace hardball
