// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "hardball/surfaces/passage.hpp"

namespace hardball {

/// A plane through the origin, on one side of which spheres move.
class Plane {
 public:
  static constexpr std::string_view kName = "plane";

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

 private:
  friend class Persistence;
  Plane() = default;
  static void persist(auto& archive, auto& self) { archive(self.normal_); }

  Vec3 normal_;
};

}  // namespace hardball
