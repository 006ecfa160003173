// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/geometry/vec3.hpp"

/// Signs of determinants, exact whatever the rounding: from sums of doubles that do not overlap. Source:
/// Shewchuk, Discrete Comput. Geom. 18 (1997) 305.
namespace hardball {

/// The sign of twice the area of the triangle a, b, c, all seen along z: positive if they turn
/// counterclockwise, zero if they are on one line.
int orientation_along_z(const Vec3& a, const Vec3& b, const Vec3& c);

/// The sign of six times the volume of the tetrahedron a, b, c, d: positive if `d` lies on the side of the
/// triangle from which a, b, c turn clockwise, zero if all are in one plane.
int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

}  // namespace hardball
