// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/geometry/vec3.hpp"

namespace hardball {

/// A box-shaped part of space.
struct Region {
  Vec3 low;   ///< [L]
  Vec3 high;  ///< [L]
};

}  // namespace hardball
