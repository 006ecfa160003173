// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/events/event.hpp"
#include "hardball/geometry/vec3.hpp"

namespace hardball {

/// A place and a velocity that a sphere is given between contacts.
struct NewPlace {
  Slot slot = 0;
  SphereId id = 0;
  Vec3 position;  ///< Center, perhaps outside a periodic box [L].
  Vec3 before;    ///< Velocity before [L/T].
  Vec3 after;     ///< Velocity after [L/T].
};

}  // namespace hardball
