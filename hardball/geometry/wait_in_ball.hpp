// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "hardball/geometry/motion.hpp"

namespace hardball {

/// How long a center on a straight path stays in a ball [T]: at `position` [L] relative to the middle, `room`
/// [L^2] being the squared radius of the ball less the squared distance.
inline double straight_wait_in_ball(const Vec3& position, Vec3 velocity, double room) {
  // The squares of slower speeds underflow; inelastic collapse leads to them.
  constexpr double kSlow = 0x1p-400;
  const bool is_slow = dot(velocity, velocity) < kSlow * kSlow;
  const double time_unit = is_slow ? 0x1p600 : 1;
  if (is_slow) velocity = time_unit * velocity;
  const double speed_squared = dot(velocity, velocity);
  if (!(speed_squared > 0)) return std::numeric_limits<double>::infinity();
  const double outwards = dot(position, velocity);
  const double root = std::sqrt(outwards * outwards + speed_squared * room);
  return time_unit * (outwards > 0 ? room / (root + outwards) : (root - outwards) / speed_squared);
}

/// A lower bound of the time for which a falling point stays in a ball [T]: either it would stay in a smaller
/// ball without gravity, and does not fall by the difference; or its way is shorter than the distance to the
/// edge. `radius` [L] is the ball's, `gravity` [L/T^2] the magnitude of the acceleration.
inline double falling_wait_in_ball(const Vec3& position, const Vec3& velocity, double gravity,
                                   double radius) {
  constexpr double kSmaller = 0.75;
  const double speed_squared = dot(velocity, velocity);
  const double ahead = std::max(0.0, radius - length(position));
  const double root = std::sqrt(speed_squared + 2 * gravity * ahead);
  const double way = root > 0 ? 2 * ahead / (std::sqrt(speed_squared) + root) : 0;
  const double smaller = kSmaller * radius;
  const double room = smaller * smaller - dot(position, position);
  if (!(room > 0)) return way;
  const double fall = std::sqrt(2 * (radius - smaller) / gravity);
  return std::max(way, std::min(fall, straight_wait_in_ball(position, velocity, room)));
}

/// A time [T] for which a center stays in a ball of this radius [L].
inline double wait_in_ball(const Motion& motion, const Vec3& position, const Vec3& velocity, double radius) {
  if (!motion.is_straight()) {
    return falling_wait_in_ball(position, velocity, length(motion.gravity()), radius);
  }
  return straight_wait_in_ball(position, velocity, std::max(0.0, radius * radius - dot(position, position)));
}

}  // namespace hardball
