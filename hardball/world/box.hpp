// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include "hardball/geometry/vec3.hpp"

namespace hardball {

/// What lies at the two ends of the box along one axis.
enum class Boundary {
  wall,      ///< Hard faces at 0 and at the size.
  periodic,  ///< What leaves at one end enters at the other.
  open,      ///< Nothing: space goes on for ever.
};

/// The space in which spheres move: along each axis from 0 to a size, or unbounded.
class Box {
 public:
  /// Open space.
  Box() : Box({Boundary::open, Boundary::open, Boundary::open}, {}) {}

  /// `size` [L] counts along axes that are not open. Error: a size that is not finite, positive and in the
  /// operating range (range.hpp).
  Box(const std::array<Boundary, kAxes>& boundary, const Vec3& size);

  static Box walls(const Vec3& size) { return {{Boundary::wall, Boundary::wall, Boundary::wall}, size}; }
  static Box periodic(const Vec3& size) {
    return {{Boundary::periodic, Boundary::periodic, Boundary::periodic}, size};
  }
  static Box open() { return {}; }

  Boundary boundary(std::size_t axis) const { return boundary_[axis]; }
  bool is_wall(std::size_t axis) const { return boundary_[axis] == Boundary::wall; }
  bool is_periodic(std::size_t axis) const { return boundary_[axis] == Boundary::periodic; }
  bool is_open(std::size_t axis) const { return boundary_[axis] == Boundary::open; }
  bool is_all(Boundary boundary) const {
    return boundary_[0] == boundary && boundary_[1] == boundary && boundary_[2] == boundary;
  }

  /// Edge lengths [L]; infinite along open axes.
  const Vec3& size() const { return size_; }
  /// [L^3]; infinite if an axis is open.
  double volume() const { return size_.x * size_.y * size_.z; }

  /// The displacement [L] of the copy `image`.
  Vec3 shift(const Image& image) const {
    return {image[0] * period_.x, image[1] * period_.y, image[2] * period_.z};
  }

  /// Edge lengths along periodic axes, zero along the others [L].
  const Vec3& period() const { return period_; }

  /// One over each of those, zero along axes that are not periodic [1/L].
  const Vec3& inverse_period() const { return inverse_period_; }

  /// How many boxes `position` lies beyond this one; zero along axes that are not periodic.
  /// Error (RunFailure): more than 2^30 boxes away.
  Image boxes_beyond(const Vec3& position) const {
    Image beyond;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      // Most centres lie in the box, and need no division to tell.
      if (position[axis] >= 0 && position[axis] < period_[axis]) continue;
      beyond[axis] = boxes_beyond(position[axis], axis);
    }
    return beyond;
  }

 private:
  std::int32_t boxes_beyond(double place, std::size_t axis) const;

  std::array<Boundary, kAxes> boundary_;
  Vec3 size_;
  Vec3 period_;  // the size along periodic axes, zero along the others
  Vec3 inverse_period_;
};

}  // namespace hardball
