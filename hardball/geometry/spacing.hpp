// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/geometry/vec3.hpp"

namespace hardball {

/// The edge [L] of cubes of which `count` fill a box of this `extent` [L]; of squares if it has none along z.
/// Of cubes wider than the box along an axis, only the part inside it counts. Precondition: all arguments are
/// positive, but that z may be zero.
double spacing(const Vec3& extent, double count);

}  // namespace hardball
