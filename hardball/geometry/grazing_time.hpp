// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "hardball/geometry/double_double.hpp"
#include "hardball/geometry/vec3.hpp"

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
template <class Number>
HARDBALL_ALWAYS_INLINE Number grazing_time_to_reach(const VectorOf<Number>& r, const VectorOf<Number>& v,
                                                    const Number& reach) {
  const Number zero(0.0);
  const auto x = difference_of_products(r.y, v.z, r.z, v.y);
  const auto y = difference_of_products(r.z, v.x, r.x, v.z);
  const auto z = difference_of_products(r.x, v.y, r.y, v.x);
  const auto reach_squared = product(reach, reach);
  const auto speed_squared = sum_of_three(product(v.x, v.x), product(v.y, v.y), product(v.z, v.z));
  const auto discriminant = speed_squared * reach_squared - sum_of_three(x * x, y * y, z * z);
  const auto excess = sum_of_three(product(r.x, r.x), product(r.y, r.y), product(r.z, r.z)) - reach_squared;
  const auto approach = sum_of_three(product(r.x, v.x), product(r.y, v.y), product(r.z, v.z));
  const auto touches = discriminant.high > zero;
  const Number root = square_root(select(touches, discriminant.high, zero));
  const Number wait = select(excess.high > zero, excess.high / (root - approach.high), zero);
  return select(touches, wait, Number(std::numeric_limits<double>::infinity()));
}

}  // namespace hardball
