// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "hardball/surfaces/passage.hpp"

namespace hardball {

/// A hollow sphere around the origin, in which spheres move.
class HollowSphere {
 public:
  static constexpr std::string_view kName = "sphere";

  /// `radius` [L] is that of the cavity.
  explicit HollowSphere(double radius) : radius_(radius) {}

  double radius() const { return radius_; }

  /// The difference of the squared distances of the surface and of the center of a touching sphere from the
  /// origin [L^2], as a function of time.
  Polynomial gap(const Passage& passage) const {
    return room_within(radius_, passage,
                       squared_distance(passage.position, passage.velocity, half(passage.acceleration)));
  }
  /// The distance from a point to the surface [L]; negative beyond it.
  double distance(const Vec3& position) const { return radius_ - length(position); }
  /// A vector of any length from a point toward the surface.
  Vec3 towards(const Vec3& position) const { return position; }

 private:
  friend class Persistence;
  HollowSphere() = default;
  static void persist(auto& archive, auto& self) { archive(self.radius_); }

  double radius_;
};

}  // namespace hardball
