// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/events/event.hpp"
#include "hardball/geometry/vec3.hpp"

namespace hardball {

/// A new place and a new velocity for a sphere.
struct PlaceEdit {
  SphereId id = 0;
  Vec3 position;  ///< Center [L].
  Vec3 velocity;  ///< [L/T]
};

}  // namespace hardball
