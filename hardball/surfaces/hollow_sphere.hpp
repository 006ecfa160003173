// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <tuple>

#include "hardball/geometry/extent.hpp"
#include "hardball/surfaces/passage.hpp"
#include "hardball/surfaces/shape_fields.hpp"

namespace hardball {

/// A hollow sphere around the origin, in which spheres move.
class HollowSphere {
 public:
  static constexpr std::string_view kName = "sphere";
  static constexpr std::string_view kPoint = "the center of the sphere";
  static constexpr std::string_view kMeaning = "A hollow sphere in which spheres move.";
  static constexpr auto fields() { return std::tuple{radius_field(&HollowSphere::radius)}; }

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
  /// Where spheres may be along the axes of a box [L].
  Extent room() const { return {{-radius_, -radius_, -radius_}, {radius_, radius_, radius_}}; }
  /// Null: it is enclosed in the box.
  static const char* remedy_for_period(std::size_t) { return nullptr; }
  /// The radius of the largest sphere within [L].
  double largest_sphere() const { return radius_; }
  /// The volume within [L^3], in a flat box the area [L^2], see Box.
  double volume(const auto& box, const Vec3&) const { return box.sphere_volume(radius_); }
  /// The area of the surface [L^2], in a flat box the circumference [L], see Box.
  double area(const auto& box) const { return box.sphere_surface(radius_); }

 private:
  friend class Persistence;
  HollowSphere() = default;
  static void persist(auto& archive, auto& self) { archive(self.radius_); }

  double radius_;
};

}  // namespace hardball
