// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <string_view>
#include <tuple>

#include "hardball/geometry/extent.hpp"
#include "hardball/surfaces/passage.hpp"
#include "hardball/surfaces/shape_fields.hpp"

namespace hardball {

/// A fixed sphere around the origin, outside which spheres move.
class Obstacle {
 public:
  static constexpr std::string_view kName = "obstacle";
  static constexpr std::string_view kMeaning = "A sphere that spheres bounce off, and that nothing deflects.";
  static constexpr auto fields() { return std::tuple{radius_field(&Obstacle::radius)}; }

  /// `radius` [L] is that of the obstacle.
  explicit Obstacle(double radius) : radius_(radius) {}

  double radius() const { return radius_; }

  /// The difference of the squared distance of a sphere's center from the origin and that at which it touches
  /// [L^2], as a function of time.
  Polynomial gap(const Passage& passage) const {
    return difference(squared_distance(passage.position, passage.velocity, half(passage.acceleration)),
                      square_of(sum(radius_, passage.radius), {passage.growth, 0}));
  }
  /// Whether a sphere certainly passes by: a cheap test, as most do.
  bool is_missed(const Passage& passage) const {
    if (rounded(passage.acceleration) != Vec3{} || passage.growth != 0) return false;
    const Vec3 position = rounded(passage.position);
    const Vec3 velocity = rounded(passage.velocity);
    const double square = dot(position, position);
    const double speed_squared = dot(velocity, velocity);
    const double approach = dot(position, velocity);
    const double reach = radius_ + passage.radius;
    // Far more than rounding.
    constexpr double kMargin = 1e-12;
    if (!(square > (1 + kMargin) * (reach * reach))) return false;
    if (approach > kMargin * std::sqrt(square * speed_squared)) return true;
    return (square - reach * reach) * speed_squared - approach * approach > kMargin * square * speed_squared;
  }
  /// The distance from a point to the surface [L]; negative beyond it.
  double distance(const Vec3& position) const { return length(position) - radius_; }
  /// A vector of any length from a point toward the surface.
  Vec3 towards(const Vec3& position) const { return -position; }
  /// Spheres may be anywhere around it.
  static Extent room() { return {}; }
  /// Null: it has images.
  static const char* remedy_for_period(std::size_t) { return nullptr; }
  /// The area of the surface [L^2], in a flat box the circumference [L], see Box.
  double area(const auto& box) const { return box.sphere_surface(radius_); }

 private:
  friend class Persistence;
  Obstacle() = default;
  static void persist(auto& archive, auto& self) { archive(self.radius_); }

  double radius_;
};

}  // namespace hardball
