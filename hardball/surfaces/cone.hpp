// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>
#include <tuple>

#include "hardball/geometry/extent.hpp"
#include "hardball/surfaces/passage.hpp"
#include "hardball/surfaces/plane.hpp"
#include "hardball/surfaces/shape_fields.hpp"

namespace hardball {

/// A cone whose apex is the origin, in which spheres move: a funnel or a tapering bed.
class Cone {
 public:
  static constexpr std::string_view kName = "cone";
  static constexpr std::string_view kPoint = "the apex of the cone";
  static constexpr std::string_view kMeaning = "A cone in which spheres move: a funnel or a tapering bed.";
  static constexpr auto fields() {
    return std::tuple{axis_field(&Cone::axis), Field{"slope", &Cone::slope, NumberRange::positive, "",
                                                     "its radius over the distance from its apex", "0.5"}};
  }

  /// `axis` is a unit vector, from the apex into the cone; `slope` [1] its radius over the distance from the
  /// apex, the tangent of half the opening angle.
  Cone(const Vec3& axis, double slope) : axis_(axis), slope_(slope), secant_(std::sqrt(1 + slope * slope)) {}

  const Vec3& axis() const { return axis_; }
  double slope() const { return slope_; }

  /// When a sphere first touches the cone while they approach, at the start of a passage or later.
  Time contact_time(const Passage& passage) const {
    const Polynomial across = square_from_axis(passage);
    Room room = room_of(passage);
    // What overlaps by rounding touches.
    const double from_axis = std::sqrt(across.coefficients[0].high);
    if (room.at_start.high < from_axis) room.at_start = {from_axis, 0};
    // On the axis, a sphere that comes to the apex is met where it has no room left.
    const double wait = std::min(earliest_descent(gap(room, across)),
                                 earliest_descent({{room.at_start, room.rate, room.half_curvature}}));
    return after(passage.start, wait);
  }
  /// The speed at which the difference of squares that `contact_time` follows changes; at the apex, where
  /// that is zero, the one at which the room does.
  DoubleDouble<> opening_speed(const Passage& passage) const {
    const Polynomial across = square_from_axis(passage);
    Room room = room_of(passage);
    // As of a sphere that touches: where it fills the cone around the apex, rounding could be as large as
    // both.
    room.at_start = {std::sqrt(across.coefficients[0].high), 0};
    const DoubleDouble<> speed = gap(room, across).coefficients[1];
    return speed.high == 0 && speed.low == 0 ? room.rate : speed;
  }
  /// The distance from a point to the surface [L]; negative beyond it.
  double distance(const Vec3& position) const {
    const double along = dot(position, axis_);
    return (along * slope_ - length(part_across(position, axis_))) / secant_;
  }
  /// The unit vector toward the surface.
  Vec3 towards(const Vec3& position) const {
    const Vec3 outwards = part_across(position, axis_);
    const double from_axis = length(outwards);
    // At the apex, or where a sphere touches all around: less is what rounding leaves.
    if (!(from_axis > 0x1p-90 * length(position))) return -axis_;
    return (1 / secant_) * ((1 / from_axis) * outwards - slope_ * axis_);
  }
  /// Where spheres may be along the axes of a box [L].
  Extent room() const { return Plane(axis_).room(); }
  /// What would make it the same in all images of a box that is periodic along an axis.
  static const char* remedy_for_period(std::size_t) { return "make the axis a wall, or open"; }
  /// The volume of the part between two faces of a box across its axis [L^3], see Box, where its apex is at
  /// `point`; NaN if it is not known.
  double volume(const auto& box, const Vec3& point) const {
    const std::size_t axis = axis_along(axis_);
    if (axis == kAxes) return std::numeric_limits<double>::quiet_NaN();
    const double behind = axis_[axis] > 0 ? -point[axis] : point[axis] - box.size()[axis];
    const double ahead = axis_[axis] > 0 ? box.size()[axis] - point[axis] : point[axis];
    const double near = std::max<double>(0, behind);
    const double far = std::max<double>(0, ahead);
    if (box.is_flat()) return slope_ * (far * far - near * near);
    return std::numbers::pi / 3 * slope_ * slope_ * (far * far * far - near * near * near);
  }

 private:
  friend class Persistence;
  Cone() : Cone({0, 0, 1}, 1) {}
  static void persist(auto& archive, auto& self) { archive(self.axis_, self.slope_); }
  bool restored() {
    *this = Cone(axis_, slope_);
    return true;
  }

  // How far from the axis the center of a sphere may be [L], a polynomial in time.
  struct Room {
    DoubleDouble<> at_start;
    DoubleDouble<> rate;
    DoubleDouble<> half_curvature;
  };
  Room room_of(const Passage& passage) const {
    const PreciseVector axis = precise(axis_);
    const DoubleDouble<> slope{slope_, 0};
    const DoubleDouble<> secant{secant_, 0};
    return {slope * dot(passage.position, axis) - secant * DoubleDouble<>{passage.radius, 0},
            slope * dot(passage.velocity, axis) - secant * DoubleDouble<>{passage.growth, 0},
            slope * dot(half(passage.acceleration), axis)};
  }
  // The square of the distance that the center has from the axis.
  Polynomial square_from_axis(const Passage& passage) const {
    const PreciseVector axis = precise(axis_);
    return squared_distance(cross(passage.position, axis), cross(passage.velocity, axis),
                            cross(half(passage.acceleration), axis));
  }
  // By how much the square of the distance that it may have is larger.
  static Polynomial gap(const Room& room, const Polynomial& across) {
    return difference(square_of(room.at_start, room.rate, room.half_curvature), across);
  }

  Vec3 axis_;
  double slope_;
  double secant_;  // the distance of two points on the wall over that along the axis
};

}  // namespace hardball
