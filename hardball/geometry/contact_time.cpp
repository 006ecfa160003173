// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/geometry/contact_time.hpp"

#include <cfloat>
#include <cmath>
#include <limits>

#include "hardball/geometry/grazing_time.hpp"

static_assert(FLT_EVAL_METHOD == 0, "Hardball needs arithmetic that rounds every operation to double");

namespace hardball {
namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();

}  // namespace

double time_to_reach(const Vec3& separation, const Vec3& velocity, double reach) {
  // Distance squared minus reach squared is excess + 2 approach t + speed_squared t^2.
  const double approach = dot(separation, velocity);
  if (!(approach < 0)) return kForever;
  const double reach_squared = reach * reach;
  const double distance_squared = dot(separation, separation);
  const double excess = distance_squared - reach_squared;
  if (excess <= 0) return 0;
  // Lagrange's identity gives approach^2 - speed_squared * excess without its cancellation between far
  // spheres.
  const double speed_squared = dot(velocity, velocity);
  const double closest = speed_squared * reach_squared;
  const Vec3 moment = cross(separation, velocity);
  const double discriminant = closest - dot(moment, moment);
  if (discriminant < -kCertainMiss * (speed_squared * distance_squared)) return kForever;
  if (discriminant <= kGrazingCosineSquared * closest) {
    return grazing_time_to_reach(separation.x, separation.y, separation.z, velocity.x, velocity.y, velocity.z,
                                 reach);
  }
  // The smaller root, in the form that does not cancel when the spheres are close.
  return excess / (std::sqrt(discriminant) - approach);
}

}  // namespace hardball
