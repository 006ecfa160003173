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

/// A round pillar along an axis through the origin, without ends, outside which spheres move.
class Pillar {
 public:
  static constexpr std::string_view kName = "pillar";
  static constexpr std::string_view kPoint = "a point on the axis of the pillar";
  static constexpr std::string_view kMeaning = "A round pillar without ends, around which spheres move.";
  static constexpr auto fields() {
    return std::tuple{axis_field(&Pillar::axis), radius_field(&Pillar::radius)};
  }

  /// `axis` is a unit vector; `radius` [L] is that of the pillar.
  Pillar(const Vec3& axis, double radius) : axis_(axis), radius_(radius) {}

  const Vec3& axis() const { return axis_; }
  double radius() const { return radius_; }

  /// The difference of the squared distances of the center of a sphere from the axis and of that at which it
  /// touches [L^2], as a function of time.
  Polynomial gap(const Passage& passage) const {
    const PreciseVector axis = precise(axis_);
    return difference(squared_distance(cross(passage.position, axis), cross(passage.velocity, axis),
                                       cross(half(passage.acceleration), axis)),
                      square_of(sum(radius_, passage.radius), {passage.growth, 0}));
  }
  /// The distance from a point to the surface [L]; negative within the pillar.
  double distance(const Vec3& position) const { return length(part_across(position, axis_)) - radius_; }
  /// A vector of any length from a point toward the surface.
  Vec3 towards(const Vec3& position) const { return -part_across(position, axis_); }
  /// Spheres may be anywhere around it.
  static Extent room() { return {}; }
  /// What would make it the same in all images of a box that is periodic along an axis; null if it is.
  const char* remedy_for_period(std::size_t axis) const {
    return std::fabs(axis_[axis]) == 1 ? nullptr : "make the axis a wall, or open, or use a mesh";
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
  Pillar() = default;
  static void persist(auto& archive, auto& self) { archive(self.axis_, self.radius_); }

  Vec3 axis_;
  double radius_;
};

}  // namespace hardball
