// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include "hardball/errors/export.hpp"
#include "hardball/meshes/mesh.hpp"

/// Meshes of simple shapes, and meshes turned and scaled.
namespace hardball {

/// A box with edges of this size along the axes [L], around the origin: twelve triangles. Error: a size that
/// is not positive or out of range.
HARDBALL_EXPORT MeshParts box_mesh(const Vec3& size);

/// A parallelogram with a corner at the origin, from which these edges lead [L]: two triangles.
HARDBALL_EXPORT MeshParts plate_mesh(const Vec3& first, const Vec3& second);

/// A segment from the origin to `end` [L], which with a thickness is a capsule.
HARDBALL_EXPORT MeshParts segment_mesh(const Vec3& end);

/// A surface over the plane z = 0, through points above a grid that begins at the origin: `heights` [L] has
/// rows along x of `columns` points along y each, `spacing` [L] apart. Two triangles for each cell of the
/// grid, the same way round. Error: fewer than two rows or columns, or a row that is not full; a spacing that
/// is not positive.
HARDBALL_EXPORT MeshParts height_field_mesh(std::span<const double> heights, std::size_t columns,
                                            double spacing);

/// A mesh scaled by this factor and then turned about the origin by as many degrees as `rotation` is long,
/// counter- clockwise as seen from its tip. About an axis of coordinates, multiples of 90 degrees are exact.
/// Error: a scale that is not positive; a rotation that is not finite.
HARDBALL_EXPORT MeshParts transformed(MeshParts parts, double scale, const Vec3& rotation);

}  // namespace hardball
