// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/interaction/contact.hpp"

namespace hardball {

/// The angular momentum that a contact gives to its wall, about a point of the wall that is `offset` [L] from
/// the point of the surface [M L^2/T]; zero if it is no more than rounding, as of smooth spheres about the
/// center of an obstacle.
inline Vec3 angular_impulse_on_wall(const Contact& contact, const Vec3& offset = {}) {
  constexpr double kRounding = 1e-12;
  const Vec3 arm = contact.wall_arm - offset;
  const Vec3 impulse = contact.impulse();
  const Vec3 angular = -1 * cross(arm, impulse);
  const double most = kRounding * kRounding * dot(arm, arm) * dot(impulse, impulse);
  return dot(angular, angular) <= most ? Vec3{} : angular;
}

}  // namespace hardball
