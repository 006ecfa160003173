// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "hardball/errors/language.hpp"
#include "hardball/geometry/inlining.hpp"

namespace hardball {

/// A vector in space; its dimension is that of the quantity it holds.
struct Vec3 {
  static constexpr bool kIsPlain = true;  ///< To archives.

  double x = 0;
  double y = 0;
  double z = 0;

  double& operator[](std::size_t axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  double operator[](std::size_t axis) const { return axis == 0 ? x : axis == 1 ? y : z; }

  Vec3& operator+=(const Vec3& o) { return x += o.x, y += o.y, z += o.z, *this; }
  Vec3& operator-=(const Vec3& o) { return x -= o.x, y -= o.y, z -= o.z, *this; }

  friend Vec3 operator+(Vec3 a, const Vec3& b) { return a += b; }
  friend Vec3 operator-(Vec3 a, const Vec3& b) { return a -= b; }
  friend Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
  friend Vec3 operator*(double s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
  friend Vec3 operator*(const Vec3& a, double s) { return s * a; }
  friend bool operator==(const Vec3&, const Vec3&) = default;
};

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

inline double dot(const Vec3& a, const Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline double length(const Vec3& a) {
  return std::sqrt(dot(a, a));
}

/// A periodic image of a sphere: the one displaced by this many box lengths along each axis. Zero along axes
/// that are not periodic.
struct Image {
  static constexpr bool kIsPlain = true;  ///< To archives.

  std::array<std::int32_t, kAxes> boxes{};

  std::int32_t& operator[](std::size_t axis) { return boxes[axis]; }
  std::int32_t operator[](std::size_t axis) const { return boxes[axis]; }

  friend Image operator+(const Image& a, const Image& b) { return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}}; }
  friend Image operator-(const Image& a, const Image& b) { return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}}; }
  friend Image operator-(const Image& a) { return {{-a[0], -a[1], -a[2]}}; }
  friend Image operator*(std::int32_t s, const Image& a) { return {{s * a[0], s * a[1], s * a[2]}}; }
  bool is_zero() const { return (boxes[0] | boxes[1] | boxes[2]) == 0; }

  friend auto operator<=>(const Image&, const Image&) = default;
  // Member by member: a comparison by memcmp would stall on members just written.
  friend bool operator==(const Image& a, const Image& b) { return (a - b).is_zero(); }
};

}  // namespace hardball
