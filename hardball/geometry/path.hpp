// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/geometry/time.hpp"
#include "hardball/geometry/vec3.hpp"

namespace hardball {

/// The motion of a sphere's centre from its last change on: where it was, how fast it went, and when.
///
/// A path is rewritten only when the motion itself changes. Along it the centre moves uniformly, and in a
/// periodic box it leaves the box without being folded back: the periodic copies are counted by Image.
struct alignas(64) Path {
  Vec3 position;  ///< Centre at `time` [L].
  Vec3 velocity;  ///< [L/T]
  Time time;      ///< Moment of the last change.

  friend bool operator==(const Path&, const Path&) = default;
};

/// The centre at `moment` [L]. Precondition: `moment` is finite.
inline Vec3 position_at(const Path& path, const Time& moment) {
  return path.position + duration(path.time, moment) * path.velocity;
}

}  // namespace hardball
