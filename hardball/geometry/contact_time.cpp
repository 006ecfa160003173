// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/geometry/contact_time.hpp"

#include <cfloat>
#include <cmath>

#include "hardball/geometry/double_double.hpp"

static_assert(FLT_EVAL_METHOD == 0, "Hardball needs arithmetic that rounds every operation to double");

namespace hardball {
namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();

// The discriminant of a contact is (reach * |velocity| * cosine)^2, the cosine being that of the angle at
// which the spheres meet. Below this squared cosine its rounding error would show in the result.
constexpr double kGrazingCosineSquared = 5.0 / 16;

DoubleDouble dot_product(const Vec3& a, const Vec3& b) {
  return product(a.x, b.x) + product(a.y, b.y) + product(a.z, b.z);
}

DoubleDouble cross_component(double a, double b, double c, double d) {
  return product(a, b) - product(c, d);
}

// The same quadratic as in time_to_reach, with its coefficients carried to 106 bits.
double grazing_time_to_reach(const Vec3& r, const Vec3& v, double reach) {
  const DoubleDouble x = cross_component(r.y, v.z, r.z, v.y);
  const DoubleDouble y = cross_component(r.z, v.x, r.x, v.z);
  const DoubleDouble z = cross_component(r.x, v.y, r.y, v.x);
  const DoubleDouble reach_squared = product(reach, reach);
  const DoubleDouble discriminant = dot_product(v, v) * reach_squared - (x * x + y * y + z * z);
  if (!(discriminant.high > 0)) return kForever;
  const DoubleDouble excess = dot_product(r, r) - reach_squared;
  if (excess.high <= 0) return 0;
  return excess.high / (std::sqrt(discriminant.high) - dot_product(r, v).high);
}

}  // namespace

double time_to_reach(const Vec3& separation, const Vec3& velocity, double reach) {
  // Distance squared minus reach squared is excess + 2 approach t + speed_squared t^2.
  const double approach = dot(separation, velocity);
  if (!(approach < 0)) return kForever;
  const double reach_squared = reach * reach;
  const double excess = dot(separation, separation) - reach_squared;
  if (excess <= 0) return 0;
  // Lagrange's identity gives approach^2 - speed_squared * excess without its cancellation between far
  // spheres.
  const double closest = dot(velocity, velocity) * reach_squared;
  const Vec3 moment = cross(separation, velocity);
  const double discriminant = closest - dot(moment, moment);
  if (std::fabs(discriminant) <= kGrazingCosineSquared * closest) {
    return grazing_time_to_reach(separation, velocity, reach);
  }
  if (discriminant < 0) return kForever;
  // The smaller root, in the form that does not cancel when the spheres are close.
  return excess / (std::sqrt(discriminant) - approach);
}

}  // namespace hardball
