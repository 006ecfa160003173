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

/// The part of a vector that is perpendicular to a unit vector: its direction is right, however small it is
/// beside the vector.
inline Vec3 part_across(const Vec3& vector, const Vec3& axis) {
  const Vec3 rest = vector - dot(vector, axis) * axis;
  constexpr double kSmall = 0x1p-40;  // by the squares
  if (dot(rest, rest) > kSmall * dot(vector, vector)) return rest;
  const PreciseVector turned = cross(precise(vector), precise(axis));
  return cross(axis, Vec3{turned.x.high, turned.y.high, turned.z.high});
}

/// The motion of a sphere past a surface, from the start of its path or of the epoch of its growth on: where
/// its center is relative to the point that defines the surface, in the frame in which that point rests, on a
/// parabola or a line; and its radius.
struct Passage {
  PreciseVector position;      ///< At the start [L].
  PreciseVector velocity;      ///< At the start [L/T].
  PreciseVector acceleration;  ///< [L/T^2]
  double radius = 0;           ///< At the start [L].
  double growth = 0;           ///< Rate of the radius [L/T].
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

/// The square of the length a + b t + c t^2.
inline Polynomial square_of(const DoubleDouble<>& a, const DoubleDouble<>& b, const DoubleDouble<>& c = {}) {
  const DoubleDouble<> two{2, 0};
  return {{a * a, two * a * b, b * b + two * a * c, two * b * c, c * c}};
}

/// a - b.
inline Polynomial difference(const Polynomial& a, const Polynomial& b) {
  Polynomial difference;
  for (std::size_t i = 0; i <= Polynomial::kMaxDegree; ++i)
    difference.coefficients[i] = a.coefficients[i] - b.coefficients[i];
  return difference;
}

/// The difference between the squared distance that a center may have, `distance` less the radius, and the
/// one that it has: positive inside.
inline Polynomial room_within(double distance, const Passage& passage, const Polynomial& squared) {
  return difference(square_of({distance - passage.radius, 0}, {-passage.growth, 0}), squared);
}

}  // namespace hardball
