// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "hardball/geometry/sine_cosine.hpp"
#include "hardball/geometry/vec3.hpp"

namespace hardball {

/// A rotation, by the unit vectors [1] into which it turns the axes. By default it turns nothing.
struct RotationMatrix {
  Vec3 x{1, 0, 0};
  Vec3 y{0, 1, 0};
  Vec3 z{0, 0, 1};

  /// The vector, turned.
  Vec3 turned(const Vec3& vector) const { return vector.x * x + vector.y * y + vector.z * z; }
  /// The vector, turned back.
  Vec3 turned_back(const Vec3& vector) const { return {dot(vector, x), dot(vector, y), dot(vector, z)}; }
  /// Turns by `inner` first, then by `outer`.
  friend RotationMatrix operator*(const RotationMatrix& outer, const RotationMatrix& inner) {
    return {outer.turned(inner.x), outer.turned(inner.y), outer.turned(inner.z)};
  }
  friend bool operator==(const RotationMatrix&, const RotationMatrix&) = default;
  /// The rotation that turns back.
  RotationMatrix inverse() const { return {{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}}; }

  /// Turns about the fixed axes x, y and z, one after the other, by these angles in radians, as URDF has it.
  static RotationMatrix from_angles(double roll, double pitch, double yaw) {
    const auto [sine_x, cosine_x] = sine_cosine(roll);
    const auto [sine_y, cosine_y] = sine_cosine(pitch);
    const auto [sine_z, cosine_z] = sine_cosine(yaw);
    const RotationMatrix about_x{{1, 0, 0}, {0, cosine_x, sine_x}, {0, -sine_x, cosine_x}};
    const RotationMatrix about_y{{cosine_y, 0, -sine_y}, {0, 1, 0}, {sine_y, 0, cosine_y}};
    const RotationMatrix about_z{{cosine_z, sine_z, 0}, {-sine_z, cosine_z, 0}, {0, 0, 1}};
    return about_z * (about_y * about_x);
  }
  /// The rotation of a quaternion w + x i + y j + z k of any length but zero.
  static RotationMatrix from_quaternion(double w, double x, double y, double z) {
    const double twice = 2 / (w * w + x * x + y * y + z * z);
    return {{1 - twice * (y * y + z * z), twice * (x * y + w * z), twice * (x * z - w * y)},
            {twice * (x * y - w * z), 1 - twice * (x * x + z * z), twice * (y * z + w * x)},
            {twice * (x * z + w * y), twice * (y * z - w * x), 1 - twice * (x * x + y * y)}};
  }
  /// A rotation that turns the axis z into a unit vector; exact if that lies along an axis.
  static RotationMatrix of_z_into(const Vec3& direction) {
    if (direction.y == 0 && direction.z == 0) return {{0, direction.x, 0}, {0, 0, 1}, {direction.x, 0, 0}};
    // Across the direction, and as far from it as axes are.
    const Vec3 across = std::fabs(direction.z) < 0.5 ? Vec3{0, 0, 1} : Vec3{0, 1, 0};
    const Vec3 sideways = cross(across, direction);
    const Vec3 x = (1 / length(sideways)) * sideways;
    return {x, cross(direction, x), direction};
  }
  /// Whether the three vectors are unit vectors at right angles, the third their cross product, to 1e-6.
  bool is_sound() const {
    constexpr double kRounding = 1e-6;
    return length(cross(x, y) - z) < kRounding && length(cross(y, z) - x) < kRounding &&
           length(cross(z, x) - y) < kRounding;
  }
};

}  // namespace hardball
