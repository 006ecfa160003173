// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/surfaces/make_mesh.hpp"

#include <cmath>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/surfaces/sine.hpp"

namespace hardball {

MeshParts box_mesh(const Vec3& size) {
  MeshParts parts;
  for (std::size_t axis = 0; axis < kAxes; ++axis) check_positive(size[axis], "the size", "box");
  for (std::uint32_t corner = 0; corner < 8; ++corner) {
    const auto side = [&](std::uint32_t bit) { return (corner & bit) != 0 ? 0.5 : -0.5; };
    parts.vertices.push_back({side(1) * size.x, side(2) * size.y, side(4) * size.z});
  }
  // Each face by its corners, counterclockwise as seen from outside.
  constexpr std::uint32_t kFaceCorners[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                                {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  for (const auto& [a, b, c, d] : kFaceCorners) {
    parts.triangles.push_back({a, b, c});
    parts.triangles.push_back({a, c, d});
  }
  return parts;
}

MeshParts plate_mesh(const Vec3& first, const Vec3& second) {
  return {{{}, first, first + second, second}, {{0, 1, 2}, {0, 2, 3}}, {}, {}};
}

MeshParts segment_mesh(const Vec3& end) {
  return {{{}, end}, {{0, 1, 1}}, {}, {}};
}

MeshParts height_field_mesh(std::span<const double> heights, std::size_t columns, double spacing) {
  check_positive(spacing, "the spacing", "height field");
  const std::size_t rows = columns > 0 ? heights.size() / columns : 0;
  if (rows < 2 || columns < 2 || rows * columns != heights.size()) {
    throw Error("a height field has " + to_text(heights.size()) + " heights in rows of " + to_text(columns),
                "height field", "give at least two full rows of at least two heights");
  }
  MeshParts parts;
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      parts.vertices.push_back({static_cast<double>(row) * spacing, static_cast<double>(column) * spacing,
                                heights[row * columns + column]});
    }
  }
  for (std::size_t row = 0; row + 1 < rows; ++row) {
    for (std::size_t column = 0; column + 1 < columns; ++column) {
      const auto corner = static_cast<std::uint32_t>(row * columns + column);
      const auto beyond = corner + static_cast<std::uint32_t>(columns);
      parts.triangles.push_back({corner, beyond, beyond + 1});
      parts.triangles.push_back({corner, beyond + 1, corner + 1});
    }
  }
  return parts;
}

MeshParts transformed(MeshParts parts, double scale, const Vec3& rotation) {
  check_positive(scale, "the scale", "mesh");
  for (std::size_t axis = 0; axis < kAxes; ++axis) check_finite(rotation[axis], "rotation", "mesh");
  const double degrees = length(rotation);
  constexpr double kDegreesOfTurn = 360;
  const Circular turn = circular(degrees / kDegreesOfTurn, Time(1));
  const Vec3 axis =
      degrees > 0 ? Vec3{rotation.x / degrees, rotation.y / degrees, rotation.z / degrees} : Vec3{};
  for (Vec3& vertex : parts.vertices) {
    vertex = scale * vertex;
    const Vec3 along = dot(vertex, axis) * axis;
    const Vec3 across = vertex - along;
    if (degrees > 0) vertex = along + (turn.cosine.high * across + turn.sine.high * cross(axis, across));
  }
  return parts;
}

}  // namespace hardball
