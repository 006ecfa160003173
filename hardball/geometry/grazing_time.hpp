// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>

#include "hardball/geometry/double_double.hpp"

namespace hardball {

/// The discriminant of a contact is (reach * |velocity| * cosine)^2, the cosine being that of the angle at
/// which the spheres meet. Below this squared cosine [1] its rounding error would show in the contact time.
inline constexpr double kGrazingCosineSquared = 5.0 / 16;

/// For points farther apart than reach, the rounding error of a discriminant no larger than grazing is less
/// than this fraction of (|separation| * |velocity|)^2 [1]: farther below zero it is a certain miss. Three
/// products and their differences make at worst 15 * 2^-53, as the separation exceeds reach.
inline constexpr double kCertainMiss = 0x1p-48;

/// As time_to_reach (contact_time.hpp) for approaching points, with the coefficients of the quadratic
/// computed to 106 bits: for grazing contacts.
HARDBALL_ALWAYS_INLINE double grazing_time_to_reach(double rx, double ry, double rz, double vx, double vy,
                                                    double vz, double reach) {
  const DoubleDouble x = difference_of_products(ry, vz, rz, vy);
  const DoubleDouble y = difference_of_products(rz, vx, rx, vz);
  const DoubleDouble z = difference_of_products(rx, vy, ry, vx);
  const DoubleDouble reach_squared = product(reach, reach);
  const DoubleDouble speed_squared = sum_of_three(product(vx, vx), product(vy, vy), product(vz, vz));
  const DoubleDouble discriminant = speed_squared * reach_squared - sum_of_three(x * x, y * y, z * z);
  if (!(discriminant.high > 0)) return std::numeric_limits<double>::infinity();
  const DoubleDouble excess = sum_of_three(product(rx, rx), product(ry, ry), product(rz, rz)) - reach_squared;
  if (excess.high <= 0) return 0;
  const DoubleDouble approach = sum_of_three(product(rx, vx), product(ry, vy), product(rz, vz));
  return excess.high / (std::sqrt(discriminant.high) - approach.high);
}

}  // namespace hardball
