// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "hardball/geometry/growth.hpp"
#include "hardball/geometry/inlining.hpp"
#include "hardball/geometry/path.hpp"

namespace hardball {

/// The position and velocity of a center at some moment, or of one center in each lane of the numbers
/// (number.hpp).
template <class Number>
struct StateOf {
  VectorOf<Number> position;  ///< [L]
  VectorOf<Number> velocity;  ///< [L/T]
};

/// The state of one center.
using State = StateOf<double>;

/// Motion along straight paths.
struct StraightMotion {
  template <class Number>
  HARDBALL_ALWAYS_INLINE StateOf<Number> state_at(const PathOf<Number>& path,
                                                  const TimeOf<Number>& moment) const {
    return {path.position + duration(path.time, moment) * path.velocity, path.velocity};
  }
};

/// Free fall, along parabolas.
template <class Number>
struct FallingMotion {
  HARDBALL_ALWAYS_INLINE StateOf<Number> state_at(const PathOf<Number>& path,
                                                  const TimeOf<Number>& moment) const {
    const Number age = duration(path.time, moment);
    return {path.position + age * (path.velocity + (Number(0.5) * age) * gravity),
            path.velocity + age * gravity};
  }

  VectorOf<Number> gravity;  ///< The acceleration [L/T^2].
};

/// Motion along straight paths of spheres whose sizes change; see Growth.
template <class Number>
struct GrowingMotion : StraightMotion {
  GrowingMotion(const Growth& growth)  // NOLINT(google-explicit-constructor)
      : begin(Number(growth.begin.high), Number(growth.begin.low)), scale(growth.scale), rate(growth.rate) {}

  /// See Growth::scale_at.
  HARDBALL_ALWAYS_INLINE Number scale_at(const TimeOf<Number>& moment) const {
    return scale + rate * duration(begin, moment);
  }

  TimeOf<Number> begin;  ///< Begin of the epoch [T].
  Number scale;          ///< At the begin [1].
  Number rate;           ///< [1/T]
};

/// How all spheres move along their paths between contacts: uniformly, or along parabolas; and how their
/// sizes change meanwhile.
///
/// The same for all, so that the separation of two centers always changes uniformly. Whether there is gravity
/// or growth, which exclude each other, is a branch that the processor predicts; kernels, where it would
/// cost, are compiled for each kind.
class Motion {
 public:
  /// Straight paths of spheres of constant size.
  Motion() = default;
  /// Free fall with this acceleration [L/T^2]; straight paths if it is zero.
  explicit Motion(const Vec3& gravity) : gravity_(gravity), is_straight_(gravity == Vec3{}) {}

  bool is_straight() const { return is_straight_; }
  /// The acceleration of every center [L/T^2].
  const Vec3& gravity() const { return gravity_; }
  /// Whether radii differ from base radii, or change.
  bool has_growth() const { return has_growth_; }
  const Growth& growth() const { return growth_; }
  /// Begins an epoch.
  void set_growth(const Growth& growth) {
    growth_ = growth;
    has_growth_ = growth.is_present();
    largest_scale_ = growth.largest_scale();
  }
  /// What base radii are to be multiplied by at `moment` [1]. Precondition: it is in the epoch.
  double scale_at(const Time& moment) const { return has_growth_ ? growth_.scale_at(moment) : 1; }
  /// The greatest of the epoch [1].
  double largest_scale() const { return largest_scale_; }

  /// The state at `moment`; the center may lie outside a periodic box. Precondition: `moment` is finite.
  HARDBALL_ALWAYS_INLINE State state_at(const Path& path, const Time& moment) const {
    if (is_straight_) [[likely]]
      return StraightMotion{}.state_at(path, moment);
    return falling_state_at(path, moment);
  }
  /// The position [L] or velocity [L/T] at `moment`.
  Vec3 position_at(const Path& path, const Time& moment) const { return state_at(path, moment).position; }
  Vec3 velocity_at(const Path& path, const Time& moment) const { return state_at(path, moment).velocity; }

 private:
  friend class Persistence;
  static void persist(auto& archive, auto& self) { archive(self.gravity_, self.growth_); }
  bool restored() {
    is_straight_ = gravity_ == Vec3{};
    set_growth(growth_);
    return true;
  }

  HARDBALL_NEVER_INLINE State falling_state_at(const Path& path, const Time& moment) const {
    return FallingMotion<double>{gravity_}.state_at(path, moment);
  }

  Vec3 gravity_;
  bool is_straight_ = true;
  bool has_growth_ = false;
  double largest_scale_ = 1;
  Growth growth_;
};

/// The time until a point that moves along a line with velocity `v` [L/T] and acceleration `a` [L/T^2] first
/// moves beyond `distance` >= 0 [L] ahead of it; infinity if it never does.
inline double time_to_pass(double distance, double v, double a) {
  constexpr double kForever = std::numeric_limits<double>::infinity();
  const double square = v * v + 2 * a * distance;
  if (!(square >= 0)) return kForever;
  const double root = std::sqrt(square);
  if (v > 0) return 2 * distance / (v + root);
  return a > 0 ? (root - v) / a : kForever;
}

/// The time until such a point first leaves the interval from `below` >= 0 behind it to `above` >= 0 ahead of
/// it [L]; infinity if it never does.
inline double time_to_leave(double below, double above, double v, double a) {
  const double ahead = time_to_pass(above, v, a);
  const double behind = time_to_pass(below, -v, -a);
  return behind < ahead ? behind : ahead;
}

}  // namespace hardball
