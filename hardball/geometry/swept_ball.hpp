// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "hardball/geometry/extent.hpp"
#include "hardball/geometry/four_extents.hpp"
#include "hardball/geometry/nearest_point.hpp"
#include "hardball/geometry/safe_step.hpp"
#include "hardball/geometry/vec3.hpp"

namespace hardball {

/// A ball whose center moves on a line or a parabola and whose radius grows evenly: when it comes near
/// things.
class SweptBall {
 public:
  /// Where the center is at time zero [L], its velocity [L/T] and acceleration [L/T^2], the radius [L] and
  /// its growth [L/T].
  SweptBall(const Vec3& position, const Vec3& velocity, const Vec3& acceleration, double radius,
            double growth)
      : position_(position),
        velocity_(velocity),
        acceleration_(acceleration),
        radius_(radius),
        growth_(growth) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      from_low_[axis] = {growth + velocity[axis], 1 / (growth + velocity[axis])};
      from_high_[axis] = {growth - velocity[axis], 1 / (growth - velocity[axis])};
    }
  }

  Vec3 position_at(double t) const { return position_ + t * (velocity_ + (0.5 * t) * acceleration_); }
  Vec3 velocity_at(double t) const { return velocity_ + t * acceleration_; }
  double radius_at(double t) const { return radius_ + t * growth_; }
  double growth() const { return growth_; }
  /// The magnitude of the acceleration [L/T^2].
  double acceleration() const { return length(acceleration_); }

  /// An interval of time [T]; an empty one ends before it begins.
  struct Stay {
    double first;
    double last;
  };
  /// A part of the time from `begin` to `end` outside which it does not reach into an extent; an empty one if
  /// it never does. `margin` [L] is more than the rounding of coordinates.
  Stay stay_within(const Extent& extent, double begin, double end, double margin) const {
    double first = begin;
    double last = end;
    const double reach = radius_ + margin;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const double half = 0.5 * acceleration_[axis];
      keep(position_[axis] - extent.low[axis] + reach, from_low_[axis], half, begin, first, last);
      keep(extent.high[axis] - position_[axis] + reach, from_high_[axis], -half, begin, first, last);
      if (!(first <= last)) return {std::numeric_limits<double>::infinity(), begin};
    }
    return {first, last};
  }
  /// A time from `begin` on before which it does not touch an extent; infinite if it never does until `end`.
  /// `margin` [L] is more than the rounding of coordinates.
  double free_until(const Extent& extent, double begin, double end, double margin) const {
    const Stay stay = stay_within(extent, begin, end, margin);
    const double t = stay.first;
    if (!(t <= stay.last && t < std::numeric_limits<double>::infinity()))
      return std::numeric_limits<double>::infinity();
    // The corners of the box around the ball reach farther than the ball itself.
    const Vec3 center = position_at(t);
    const Vec3 apart = center - nearest_in_box(extent.low, extent.high, center);
    const double distance = length(apart);
    const double width = distance - radius_at(t) - margin;
    if (!(width > 0)) return t;
    const double touched =
        t + safe_step({width, dot(apart, velocity_at(t)) / distance - growth_, acceleration()});
    return touched <= stay.last ? touched : std::numeric_limits<double>::infinity();
  }
  /// For each of four extents a time from `begin` on before which the ball does not touch it; infinite if it
  /// never does until `end`. `margin` [L] is more than the rounding of coordinates.
  FourNumbers free_until(const FourExtents& extents, double begin, double end, double margin) const {
    constexpr double kForever = std::numeric_limits<double>::infinity();
    if (!(acceleration() == 0)) {
      std::array<double, FourNumbers::kCount> first;
      for (std::size_t i = 0; i < FourNumbers::kCount; ++i)
        first[i] = free_until(extents[i], begin, end, margin);
      return FourNumbers(first);
    }
    FourNumbers first(begin);
    FourNumbers last(end);
    const FourNumbers reach(radius_ + margin);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const FourNumbers place(position_[axis]);
      keep(place - extents.low[axis] + reach, from_low_[axis], first, last);
      keep(extents.high[axis] - place + reach, from_high_[axis], first, last);
    }
    if (are_larger(first, last)) return FourNumbers(kForever);
    const FourNumbers zero;
    FourNumbers square;
    FourNumbers opening;  // how fast the distance grows, times the distance
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const FourNumbers velocity(velocity_[axis]);
      const FourNumbers place = FourNumbers(position_[axis]) + first * velocity;
      const FourNumbers apart =
          smaller(place - extents.low[axis], zero) + larger(place - extents.high[axis], zero);
      square = square + apart * apart;
      opening = opening + apart * velocity;
    }
    const FourNumbers growth(growth_);
    const FourNumbers distance = square_root(square);
    const FourNumbers width = distance - (FourNumbers(radius_) + first * growth) - FourNumbers(margin);
    const FourNumbers closing = growth - opening / distance;
    const FourNumbers wait = select(closing, zero, width / closing, FourNumbers(kForever));
    first = first + select(width, zero, wait, zero);
    return select(first, last, FourNumbers(kForever), first);
  }

 private:
  // How fast the ball reaches beyond a plane, and one over that: products take less than quotients.
  struct Rate {
    double value;
    double inverse;
  };

  // Restricts [first, last] to where a + b t + c t^2 >= 0 from `begin` on, or to an interval around that.
  static void keep(double a, const Rate& rate, double c, double begin, double& first, double& last) {
    constexpr double kForever = std::numeric_limits<double>::infinity();
    const double b = rate.value;
    if (c == 0) {
      // What does not move stays on its side forever.
      if (b >= 0) {
        first = std::max(first, -a * rate.inverse);
      } else {
        last = std::min(last, -a * rate.inverse);
      }
      return;
    }
    const double discriminant = b * b - 4 * a * c;
    if (c > 0) {
      if (a + begin * (b + begin * c) >= 0 || discriminant < 0) return;
      first = std::max(first, later_root(a, b, c, std::sqrt(discriminant)));
    } else if (discriminant < 0) {
      first = kForever;
    } else {
      const double root = std::sqrt(discriminant);
      // Of the parabola turned over.
      last = std::min(last, later_root(-a, -b, -c, root));
      first = std::max(first, earlier_root(-a, -b, -c, root));
    }
  }
  // Restricts four intervals to where a + b t >= 0.
  static void keep(const FourNumbers& a, const Rate& rate, FourNumbers& first, FourNumbers& last) {
    const FourNumbers bound = a * FourNumbers(-rate.inverse);
    if (rate.value >= 0) {
      first = larger(bound, first);
    } else {
      last = smaller(bound, last);
    }
  }
  // The roots of a + b t + c t^2 for c > 0.
  static double later_root(double a, double b, double c, double root) {
    return b > 0 ? -2 * a / (b + root) : (root - b) / (2 * c);
  }
  static double earlier_root(double a, double b, double c, double root) {
    return b > 0 ? -(b + root) / (2 * c) : 2 * a / (root - b);
  }

  Vec3 position_;
  Vec3 velocity_;
  Vec3 acceleration_;
  double radius_;
  double growth_;
  std::array<Rate, kAxes> from_low_;
  std::array<Rate, kAxes> from_high_;
};

}  // namespace hardball
