// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "hardball/surfaces.hpp"

/// A surface of one's own: a trough with a V-shaped section along the y axis, in which spheres move.
class Trough final : public hardball::ShapeInterface {
 public:
  /// `slope` [1] is the height of the sides over their distance from the bottom line.
  explicit Trough(double slope)
      : sides_{hardball::Plane(hardball::Vec3{slope / std::hypot(slope, 1), 0, 1 / std::hypot(slope, 1)}),
               hardball::Plane(hardball::Vec3{-slope / std::hypot(slope, 1), 0, 1 / std::hypot(slope, 1)})} {}

  std::string_view name() const override { return "trough"; }
  // The first of the contacts with its two sides, whose gaps are polynomials.
  hardball::Time contact_time(const hardball::Passage& passage) const override {
    const auto time_of = [&](const hardball::Plane& side) {
      return after(passage.start, earliest_descent(side.gap(passage)));
    };
    return std::min(time_of(sides_[0]), time_of(sides_[1]));
  }
  hardball::DoubleDouble<> opening_speed(const hardball::Passage& passage) const override {
    return nearest(rounded(passage.position)).gap(passage).coefficients[1];
  }
  double distance(const hardball::Vec3& position) const override {
    return nearest(position).distance(position);
  }
  hardball::Vec3 towards(const hardball::Vec3& position) const override {
    return nearest(position).towards(position);
  }
  const char* remedy_for_period(std::size_t axis) const override {
    return axis == 1 ? nullptr : "make it parallel to y, and x and z not periodic";
  }

 private:
  const hardball::Plane& nearest(const hardball::Vec3& position) const {
    return sides_[0].distance(position) <= sides_[1].distance(position) ? sides_[0] : sides_[1];
  }

  std::array<hardball::Plane, 2> sides_;
};
