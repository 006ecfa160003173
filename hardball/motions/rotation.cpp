// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/motions/rotation.hpp"

#include <cmath>

#include "hardball/motions/check_motion.hpp"
#include "hardball/surfaces/sine.hpp"

namespace hardball {

Rotation::Rotation(const Vec3& point, const Vec3& axis, double frequency)
    : point_(point), axis_(direction_of_motion(axis, "axis")), frequency_(frequency) {
  check_motion_vector(point, "point");
  check_motion_frequency(frequency);
}

Vec3 Rotation::displacement(const Vec3& from, const Time& elapsed) const {
  const Circular turn = circular(frequency_, elapsed);
  const Vec3 arm = from - point_;
  const Vec3 across = cross(axis_, arm);      // of the length of the arm, a quarter of a turn ahead
  const Vec3 outward = cross(across, axis_);  // the part of the arm across the axis
  return turn.sine.high * across + (turn.cosine - DoubleDouble<>{1, 0}).high * outward;
}

double Rotation::acceleration(const Vec3& from) const {
  const double turning = kTurnOfMotion * frequency_;
  return turning * turning * length(cross(axis_, from - point_));
}

Vec3 Rotation::span() const {
  Vec3 span;
  for (std::size_t axis = 0; axis < kAxes; ++axis) span[axis] = std::fabs(axis_[axis]) == 1 ? 0 : 1;
  return span;
}

bool Rotation::restored() const {
  check_motion_vector(point_, "point");
  check_motion_frequency(frequency_);
  return is_direction_of_motion(axis_);
}

}  // namespace hardball
