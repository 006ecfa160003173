// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/events/event.hpp"
#include "hardball/geometry/vec3.hpp"

namespace hardball {

/// A new velocity for a sphere.
struct VelocityEdit {
  SphereId id = 0;
  Vec3 velocity;  ///< [L/T]
};

}  // namespace hardball
