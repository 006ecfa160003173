// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/geometry/vec3.hpp"

namespace hardball {

/// The edge [L] of a cube such that `count` of them fill a box of this `extent` [L]. Cubes that are wider
/// than the box along an axis count with the part of them that lies inside. Precondition: all are positive.
double spacing(const Vec3& extent, double count);

}  // namespace hardball
