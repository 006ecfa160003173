// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>

#include "hardball/geometry/time.hpp"
#include "hardball/geometry/vec3.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// How long a centre stays in a ball [T]: at `place` [L] relative to the middle, `room` [L^2] being the
/// squared radius of the ball less the squared distance.
inline double wait_in_ball(const Vec3& place, Vec3 velocity, double room) {
  // The squares of slower speeds underflow; inelastic collapse leads to them.
  constexpr double kSlow = 0x1p-400;
  const bool is_slow = dot(velocity, velocity) < kSlow * kSlow;
  const double time_unit = is_slow ? 0x1p600 : 1;
  if (is_slow) velocity = time_unit * velocity;
  const double speed_squared = dot(velocity, velocity);
  if (!(speed_squared > 0)) return std::numeric_limits<double>::infinity();
  const double outwards = dot(place, velocity);
  const double root = std::sqrt(outwards * outwards + speed_squared * room);
  return time_unit * (outwards > 0 ? room / (root + outwards) : (root - outwards) / speed_squared);
}

/// More than the rounding error of the coordinates of a centre [L], which shows in spheres very far away.
inline double coordinate_error(const World& world, Slot slot, const Time& now) {
  return 0x1p-50 * length(position_at(world.path(slot), now));
}

}  // namespace hardball
