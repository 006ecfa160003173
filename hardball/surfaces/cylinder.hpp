// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "hardball/surfaces/passage.hpp"

namespace hardball {

/// A tube around an axis through the origin, in which spheres move.
class Cylinder {
 public:
  static constexpr std::string_view kName = "cylinder";

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

 private:
  friend class Persistence;
  Cylinder() = default;
  static void persist(auto& archive, auto& self) { archive(self.axis_, self.radius_); }

  Vec3 axis_;
  double radius_;
};

}  // namespace hardball
