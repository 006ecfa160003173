// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "hardball/errors/export.hpp"
#include "hardball/geometry/time.hpp"
#include "hardball/geometry/vec3.hpp"

namespace hardball {

/// A rotation about a fixed axis with a constant frequency.
class HARDBALL_EXPORT Rotation {
 public:
  static constexpr std::string_view kName = "rotation";

  /// `point` is on the axis [L]; `axis` points along it, and may have any length; `frequency` is in turns per
  /// time, counterclockwise as seen from where the axis points [1/T]. Error: a number is not finite or out of
  /// range; the axis has no length; the frequency is zero.
  Rotation(const Vec3& point, const Vec3& axis, double frequency);

  const Vec3& point() const { return point_; }
  const Vec3& axis() const { return axis_; }  ///< A unit vector [1].
  double frequency() const { return frequency_; }

  /// How far a body that was at `from` has moved after `elapsed` [L].
  Vec3 displacement(const Vec3& from, const Time& elapsed) const;
  /// The greatest acceleration of a body that begins at `from` [L/T^2].
  double acceleration(const Vec3& from) const;
  /// A vector with a component of zero along the axes of space along which bodies do not move.
  Vec3 span() const;

 private:
  friend class Persistence;
  Rotation() = default;
  static void persist(auto& archive, auto& self) { archive(self.point_, self.axis_, self.frequency_); }
  bool restored() const;

  Vec3 point_;
  Vec3 axis_;
  double frequency_ = 0;
};

}  // namespace hardball
