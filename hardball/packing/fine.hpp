// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>

#include "hardball/geometry/double_double.hpp"
#include "hardball/geometry/vec3.hpp"

/// Numbers in twice the precision, for gaps that are far smaller than what they are between.
namespace hardball {

using Fine = DoubleDouble<double>;

inline Fine square(const Fine& a) {
  return a * a;
}

/// sqrt(a), by a step of Newton's method from the root of its high part.
inline Fine square_root(const Fine& a) {
  const double rough = std::sqrt(a.high);
  if (!(rough > 0)) return {0, 0};
  const Fine rest = a - product(rough, rough);
  return normalized(rough, (rest.high + rest.low) / (2 * rough));
}

/// a / b.
inline Fine quotient(const Fine& a, const Fine& b) {
  const Fine rough = divide(a, b.high);
  return rough - Fine{rough.high * b.low / b.high, 0};
}

inline Fine length_of(const std::array<Fine, kAxes>& vector) {
  return square_root(sum_of_three(square(vector[0]), square(vector[1]), square(vector[2])));
}

}  // namespace hardball
