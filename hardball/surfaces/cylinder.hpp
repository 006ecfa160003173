// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>
#include <tuple>

#include "hardball/geometry/extent.hpp"
#include "hardball/surfaces/passage.hpp"
#include "hardball/surfaces/shape_fields.hpp"

namespace hardball {

/// A tube around an axis through the origin, in which spheres move.
class Cylinder {
 public:
  static constexpr std::string_view kName = "cylinder";
  static constexpr std::string_view kPoint = "a point on the axis of the cylinder";
  static constexpr std::string_view kMeaning = "A tube in which spheres move.";
  static constexpr auto fields() {
    return std::tuple{axis_field(&Cylinder::axis), radius_field(&Cylinder::radius)};
  }

  /// `axis` is a unit vector; `radius` [L] is that of the tube.
  Cylinder(const Vec3& axis, double radius) : axis_(axis), radius_(radius) {}

  const Vec3& axis() const { return axis_; }
  double radius() const { return radius_; }

  /// The difference of the squared distances of the surface and of the center of a touching sphere from the
  /// axis [L^2], as a function of time.
  Polynomial gap(const Passage& passage) const {
    const PreciseVector axis = precise(axis_);
    return room_within(radius_, passage,
                       squared_distance(cross(passage.position, axis), cross(passage.velocity, axis),
                                        cross(half(passage.acceleration), axis)));
  }
  /// The distance from a point to the surface [L]; negative beyond it.
  double distance(const Vec3& position) const { return radius_ - length(towards(position)); }
  /// A vector of any length from a point toward the surface.
  Vec3 towards(const Vec3& position) const { return part_across(position, axis_); }
  /// Where spheres may be along the axes of a box [L].
  Extent room() const {
    Extent room;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (axis_[axis] != 0) continue;
      room.low[axis] = -radius_;
      room.high[axis] = radius_;
    }
    return room;
  }
  /// What would make it the same in all images of a box that is periodic along an axis; null if it is, or if
  /// it is enclosed in the box.
  const char* remedy_for_period(std::size_t axis) const {
    const bool is_aligned = axis_[axis] == 0 || std::fabs(axis_[axis]) == 1;
    return is_aligned ? nullptr : "make it parallel to an axis of the box";
  }
  /// The radius of the largest sphere within [L].
  double largest_sphere() const { return radius_; }
  /// The volume within a box [L^3], see Box; NaN if it is not known.
  double volume(const auto& box, const Vec3&) const {
    const double section = std::numbers::pi * radius_ * radius_;
    if (box.is_flat()) return section;
    const std::size_t axis = axis_along(axis_);
    return axis < kAxes ? section * box.size()[axis] : std::numeric_limits<double>::quiet_NaN();
  }
  /// The area of the part in a box [L^2], see Box; NaN if it is not known.
  double area(const auto& box) const {
    if (box.is_flat()) return box.sphere_surface(radius_);
    const std::size_t axis = axis_along(axis_);
    return axis < kAxes ? 2 * std::numbers::pi * radius_ * box.size()[axis]
                        : std::numeric_limits<double>::quiet_NaN();
  }

 private:
  friend class Persistence;
  Cylinder() = default;
  static void persist(auto& archive, auto& self) { archive(self.axis_, self.radius_); }

  Vec3 axis_;
  double radius_;
};

}  // namespace hardball
