// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <string_view>
#include <tuple>

#include "hardball/geometry/extent.hpp"
#include "hardball/surfaces/passage.hpp"
#include "hardball/surfaces/shape_fields.hpp"

namespace hardball {

/// A plane through the origin, on one side of which spheres move.
class Plane {
 public:
  static constexpr std::string_view kName = "plane";
  static constexpr std::string_view kPoint = "a point of the plane";
  static constexpr std::string_view kMeaning = "A plane on one side of which spheres move.";
  static constexpr auto fields() { return std::tuple{normal_field(&Plane::normal)}; }

  /// `normal` is a unit vector, toward the spheres.
  explicit Plane(const Vec3& normal) : normal_(normal) {}

  const Vec3& normal() const { return normal_; }

  /// The gap between the surface and a sphere [L], as a function of time.
  Polynomial gap(const Passage& passage) const {
    const PreciseVector n = precise(normal_);
    return {{dot(passage.position, n) - DoubleDouble<>{passage.radius, 0},
             dot(passage.velocity, n) - DoubleDouble<>{passage.growth, 0},
             dot(half(passage.acceleration), n)}};
  }
  /// The distance from a point to the surface [L]; negative beyond it.
  double distance(const Vec3& position) const { return dot(position, normal_); }
  /// A vector of any length from a point toward the surface.
  Vec3 towards(const Vec3&) const { return -normal_; }
  /// Where spheres may be along the axes of a box [L].
  Extent room() const {
    Extent room;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (normal_[axis] == 1) room.low[axis] = 0;
      if (normal_[axis] == -1) room.high[axis] = 0;
    }
    return room;
  }
  /// What would make it the same in all images of a box that is periodic along an axis; null if it is.
  const char* remedy_for_period(std::size_t axis) const {
    return normal_[axis] == 0 ? nullptr : "make it parallel to the axis, or the axis not periodic";
  }
  /// The area of the part in a box [L^2], see Box; NaN if it is not known.
  double area(const auto& box) const {
    const std::size_t axis = axis_along(normal_);
    return axis < kAxes ? box.face_area(axis) : std::numeric_limits<double>::quiet_NaN();
  }

 private:
  friend class Persistence;
  Plane() = default;
  static void persist(auto& archive, auto& self) { archive(self.normal_); }

  Vec3 normal_;
};

}  // namespace hardball
