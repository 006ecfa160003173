// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/events/event.hpp"
#include "hardball/geometry/vec3.hpp"

namespace hardball {

/// A velocity that a sphere is given between contacts.
struct NewVelocity {
  Slot slot = 0;
  Vec3 before;  ///< [L/T]
  Vec3 after;   ///< [L/T]
};

}  // namespace hardball
