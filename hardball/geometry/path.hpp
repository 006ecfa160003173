// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

#include "hardball/geometry/time.hpp"
#include "hardball/geometry/vec3.hpp"

namespace hardball {

/// The motion of a sphere's center since its last change: position, velocity and time; or one in each lane of
/// the numbers (number.hpp). A single path is a cache line.
///
/// A path is rewritten only when the motion itself changes. Along it the center moves as Motion says, and may
/// leave a periodic box without being folded back: Image counts the boxes.
template <class Number>
struct alignas(std::is_same_v<Number, double> ? 64 : alignof(Number)) PathOf {
  using PlainNumber = Number;  ///< To archives.

  VectorOf<Number> position;  ///< Center at `time` [L].
  VectorOf<Number> velocity;  ///< At `time` [L/T].
  TimeOf<Number> time;        ///< Time of the last change.

  friend bool operator==(const PathOf&, const PathOf&) = default;
};

/// The path of one sphere.
using Path = PathOf<double>;

}  // namespace hardball
