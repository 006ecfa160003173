// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/geometry/time.hpp"
#include "hardball/geometry/vec3.hpp"

namespace hardball {

/// The motion of a sphere's center since its last change: position, velocity and time.
///
/// A path is rewritten only when the motion itself changes. Along it the center moves as Motion says, and may
/// leave a periodic box without being folded back: Image counts the boxes.
struct alignas(64) Path {
  static constexpr bool kIsPlain = true;  ///< To archives.

  Vec3 position;  ///< Center at `time` [L].
  Vec3 velocity;  ///< At `time` [L/T].
  Time time;      ///< Of the last change.

  friend bool operator==(const Path&, const Path&) = default;
};

}  // namespace hardball
