// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "hardball/surfaces/passage.hpp"

namespace hardball {

/// A fixed sphere around the origin, outside which spheres move.
class Obstacle {
 public:
  static constexpr std::string_view kName = "obstacle";

  /// `radius` [L] is that of the obstacle.
  explicit Obstacle(double radius) : radius_(radius) {}

  double radius() const { return radius_; }

  /// The difference of the squared distance of a sphere's centre from the origin and that at which it touches
  /// [L^2], as a function of time.
  Polynomial gap(const Passage& passage, double radius) const {
    Polynomial gap = squared_distance(passage.place, passage.velocity, half(passage.acceleration));
    const DoubleDouble<> reach = sum(radius_, radius);
    gap.coefficients[0] = gap.coefficients[0] - reach * reach;
    return gap;
  }
  /// The distance from a point to the surface [L]; negative beyond it.
  double distance(const Vec3& place) const { return length(place) - radius_; }
  /// A vector of any length from a point towards the surface.
  Vec3 towards(const Vec3& place) const { return -place; }

 private:
  double radius_;
};

}  // namespace hardball
