// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "hardball/errors/language.hpp"
#include "hardball/geometry/number.hpp"

namespace hardball {

/// A vector in space of such numbers (number.hpp): of vectors of doubles it has one in each lane.
template <class Number>
struct VectorOf {
  using PlainNumber = Number;  ///< To archives.

  Number x{};
  Number y{};
  Number z{};

  Number& operator[](std::size_t axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  Number operator[](std::size_t axis) const { return axis == 0 ? x : axis == 1 ? y : z; }

  VectorOf& operator+=(const VectorOf& o) { return *this = *this + o; }
  VectorOf& operator-=(const VectorOf& o) { return *this = *this - o; }

  HARDBALL_ALWAYS_INLINE friend VectorOf operator+(const VectorOf& a, const VectorOf& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  HARDBALL_ALWAYS_INLINE friend VectorOf operator-(const VectorOf& a, const VectorOf& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  HARDBALL_ALWAYS_INLINE friend VectorOf operator*(const Number& s, const VectorOf& a) {
    return {s * a.x, s * a.y, s * a.z};
  }
  HARDBALL_ALWAYS_INLINE friend VectorOf operator*(const VectorOf& a, const Number& s) { return s * a; }
  friend VectorOf operator-(const VectorOf& a) { return {-a.x, -a.y, -a.z}; }
  friend bool operator==(const VectorOf&, const VectorOf&) = default;
};

/// A vector in space; its dimension is that of the quantity it holds.
using Vec3 = VectorOf<double>;

inline constexpr std::size_t kAxes = 3;
inline constexpr const char* kAxisNames[kAxes] = {"x", "y", "z"};

/// Calls visit(axis) for every axis, a compile-time constant, so that member access is resolved at compile
/// time.
template <class Visit>
HARDBALL_ALWAYS_INLINE void for_each_axis(Visit&& visit) {
  visit(std::integral_constant<std::size_t, 0>());
  visit(std::integral_constant<std::size_t, 1>());
  visit(std::integral_constant<std::size_t, 2>());
}

template <class Number>
HARDBALL_ALWAYS_INLINE Number dot(const VectorOf<Number>& a, const VectorOf<Number>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Number>
HARDBALL_ALWAYS_INLINE VectorOf<Number> cross(const VectorOf<Number>& a, const VectorOf<Number>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline double length(const Vec3& a) {
  return std::sqrt(dot(a, a));
}

/// A periodic image of a sphere: the one displaced by this many box lengths along each axis. Zero along axes
/// that are not periodic.
struct Image {
  using PlainNumber = std::int32_t;  ///< To archives.

  std::array<std::int32_t, kAxes> boxes{};

  std::int32_t& operator[](std::size_t axis) { return boxes[axis]; }
  std::int32_t operator[](std::size_t axis) const { return boxes[axis]; }

  friend Image operator+(const Image& a, const Image& b) { return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}}; }
  friend Image operator-(const Image& a, const Image& b) { return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}}; }
  friend Image operator-(const Image& a) { return {{-a[0], -a[1], -a[2]}}; }
  friend Image operator*(std::int32_t s, const Image& a) { return {{s * a[0], s * a[1], s * a[2]}}; }
  bool is_zero() const { return (boxes[0] | boxes[1] | boxes[2]) == 0; }

  // Written out, as older libraries do not compare arrays.
  friend std::strong_ordering operator<=>(const Image& a, const Image& b) {
    if (a[0] != b[0]) return a[0] <=> b[0];
    return a[1] != b[1] ? a[1] <=> b[1] : a[2] <=> b[2];
  }
  // Member by member: a comparison by memcmp would stall on members just written.
  friend bool operator==(const Image& a, const Image& b) { return (a - b).is_zero(); }
};

/// By how many boxes along each axis one body lies beyond another, to the nearest integer, `apart` [L] being
/// the vector between them. Along axes that are not periodic `inverse_period` [1/L] is zero.
template <class Number>
HARDBALL_ALWAYS_INLINE VectorOf<Number> nearest_boxes(const VectorOf<Number>& apart,
                                                      const VectorOf<Number>& inverse_period) {
  return {round_to_integer(apart.x * inverse_period.x), round_to_integer(apart.y * inverse_period.y),
          round_to_integer(apart.z * inverse_period.z)};
}

}  // namespace hardball
