// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/geometry/double_double.hpp"
#include "hardball/geometry/time.hpp"
#include "hardball/geometry/vec3.hpp"
#include "hardball/surfaces/polynomial.hpp"

namespace hardball {

/// A vector in twice the precision.
using PreciseVector = VectorOf<DoubleDouble<>>;

/// a - b, exactly.
inline PreciseVector precise_difference(const Vec3& a, const Vec3& b) {
  return {difference(a.x, b.x), difference(a.y, b.y), difference(a.z, b.z)};
}

inline PreciseVector precise(const Vec3& a) {
  return {{a.x, 0}, {a.y, 0}, {a.z, 0}};
}

/// More precise than the sum of two sums.
inline DoubleDouble<> dot(const PreciseVector& a, const PreciseVector& b) {
  return sum_of_three(a.x * b.x, a.y * b.y, a.z * b.z);
}

/// The motion of a sphere's center past a surface, from the start of its path on: where it is relative to the
/// point that defines the surface, and in the frame in which that point rests. A parabola, or a line.
struct Passage {
  PreciseVector position;      ///< At the start [L].
  PreciseVector velocity;      ///< At the start [L/T].
  PreciseVector acceleration;  ///< [L/T^2]
  Time start;                  ///< [T]
};

/// The high parts of a vector.
inline Vec3 rounded(const PreciseVector& a) {
  return {a.x.high, a.y.high, a.z.high};
}

/// The square of the distance from the origin, along the curve a + b t + c t^2.
inline Polynomial squared_distance(const PreciseVector& a, const PreciseVector& b, const PreciseVector& c) {
  const DoubleDouble<> two{2, 0};
  return {{dot(a, a), two * dot(a, b), dot(b, b) + two * dot(a, c), two * dot(b, c), dot(c, c)}};
}

inline PreciseVector half(const PreciseVector& a) {
  const auto of = [](const DoubleDouble<>& component) {
    return DoubleDouble<>{0.5 * component.high, 0.5 * component.low};
  };
  return {of(a.x), of(a.y), of(a.z)};
}

/// The difference between the greatest squared distance and this one: positive inside.
inline Polynomial room_within(double distance, const Polynomial& squared) {
  Polynomial room;
  for (std::size_t i = 0; i <= Polynomial::kMaxDegree; ++i) room.coefficients[i] = -squared.coefficients[i];
  room.coefficients[0] = product(distance, distance) - squared.coefficients[0];
  return room;
}

}  // namespace hardball
