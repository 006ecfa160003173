// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/events/event.hpp"
#include "hardball/geometry/time.hpp"
#include "hardball/geometry/vec3.hpp"

namespace hardball {

/// A change of a sphere's velocity without a contact, and its state at that moment.
struct VelocityChange {
  Time time;
  SphereId sphere = 0;
  double mass = 0;  ///< [M]
  Vec3 position;    ///< Center, folded into the box [L].
  Vec3 before;      ///< Velocity before [L/T].
  Vec3 after;       ///< Velocity after [L/T].
};

}  // namespace hardball
