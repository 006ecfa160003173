// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "hardball/geometry/motion.hpp"

namespace hardball {

/// How long a point that moves straight stays in a ball [T]: `room` [L^2] is the squared radius of the ball
/// less the squared distance from its middle, `outwards` [L^2/T] the product of position and velocity, and
/// `speed_squared` [L^2/T^2] is not zero.
template <class Real>
Real straight_wait_in_ball(Real outwards, Real speed_squared, Real room) {
  const Real root = std::sqrt(outwards * outwards + speed_squared * room);
  return outwards > 0 ? room / (root + outwards) : (root - outwards) / speed_squared;
}

/// How long a center on a straight path stays in a ball [T]: at `position` [L] relative to the middle;
/// infinite at rest. `room` [L^2] is the squared radius of the ball less the squared distance.
inline double straight_wait_in_ball(const Vec3& position, Vec3 velocity, double room) {
  // The squares of slower speeds underflow; inelastic collapse leads to them.
  constexpr double kSlow = 0x1p-400;
  const bool is_slow = dot(velocity, velocity) < kSlow * kSlow;
  const double time_unit = is_slow ? 0x1p600 : 1;
  if (is_slow) velocity = time_unit * velocity;
  const double speed_squared = dot(velocity, velocity);
  if (!(speed_squared > 0)) return std::numeric_limits<double>::infinity();
  return time_unit * straight_wait_in_ball(dot(position, velocity), speed_squared, room);
}

/// A lower bound of the time for which a falling point stays in a ball [T]: either it would stay in a smaller
/// ball without gravity, and does not fall by the difference; or its way is shorter than the distance to the
/// edge. `radius` [L] is the ball's, `gravity` [L/T^2] at least the magnitude of the acceleration, and not
/// zero; the rest as for straight_wait_in_ball, with the squared distance from the middle.
template <class Real>
Real falling_wait_in_ball(Real distance_squared, Real outwards, Real speed_squared, Real gravity,
                          Real radius) {
  constexpr Real kSmaller = 0.75;
  const Real ahead = std::max(Real{0}, radius - std::sqrt(distance_squared));
  const Real root = std::sqrt(speed_squared + 2 * gravity * ahead);
  const Real way = root > 0 ? 2 * ahead / (std::sqrt(speed_squared) + root) : 0;
  const Real smaller = kSmaller * radius;
  const Real room = smaller * smaller - distance_squared;
  if (!(room > 0)) return way;
  const Real fall = std::sqrt(2 * (radius - smaller) / gravity);
  if (!(speed_squared > 0)) return std::max(way, fall);
  return std::max(way, std::min(fall, straight_wait_in_ball(outwards, speed_squared, room)));
}

/// A time [T] for which a center stays in a ball of this radius [L].
inline double wait_in_ball(const Motion& motion, const Vec3& position, const Vec3& velocity, double radius) {
  if (!motion.is_straight()) {
    return falling_wait_in_ball(dot(position, position), dot(position, velocity), dot(velocity, velocity),
                                length(motion.gravity()), radius);
  }
  return straight_wait_in_ball(position, velocity, std::max(0.0, radius * radius - dot(position, position)));
}

}  // namespace hardball
