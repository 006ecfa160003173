// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "hardball/geometry/extent.hpp"
#include "hardball/geometry/vec3.hpp"
#include "hardball/world/box.hpp"

namespace hardball {

/// A part of the box: an interval along the axes that are divided, and all of it along the others.
class Block {
 public:
  /// A block that is the whole box.
  explicit Block(const Box& box) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      period_[axis] = box.is_periodic(axis) ? box.size()[axis] : 0;
      low_[axis] = box.is_periodic(axis) ? 0 : -kInfinity;
      high_[axis] = box.is_periodic(axis) ? period_[axis] : kInfinity;
    }
  }

  /// Keeps what lies below `place` [L] along an axis, and returns the rest. Precondition: it lies inside.
  Block split(std::size_t axis, double place) {
    Block rest = *this;
    rest.low_[axis] = place;
    rest.is_divided_[axis] = true;
    high_[axis] = place;
    is_divided_[axis] = true;
    return rest;
  }

  /// The ends [L]; infinite where the box has no ends or walls, which nothing passes.
  double low(std::size_t axis) const { return low_[axis]; }
  double high(std::size_t axis) const { return high_[axis]; }
  /// The period of the box [L]; zero along an axis that is not periodic.
  double period(std::size_t axis) const { return period_[axis]; }
  /// Whether the block is only a part of the box along an axis.
  bool is_divided(std::size_t axis) const { return is_divided_[axis]; }

  /// How far a point between the block and its nearest image can be from both, along the divided axis where
  /// that is least, and where it is most [L]. Along a divided axis that is not periodic it is infinite; if no
  /// axis is divided, the least is infinity and the largest minus infinity.
  double least_half_gap() const {
    double least = kInfinity;
    for (std::size_t axis = 0; axis < kAxes; ++axis) least = std::min(least, half_gap(axis, kInfinity));
    return least;
  }
  double largest_half_gap() const {
    double largest = -kInfinity;
    for (std::size_t axis = 0; axis < kAxes; ++axis) largest = std::max(largest, half_gap(axis, -kInfinity));
    return largest;
  }

  /// The block and everything within this distance of it [L]; the whole box along axes that are not divided.
  Extent surroundings(double depth) const {
    Extent extent;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (!is_divided_[axis]) continue;
      extent.low[axis] = low_[axis] - depth;
      extent.high[axis] = high_[axis] + depth;
    }
    return extent;
  }

  /// How far a point is outside [L], by the axis along which it is farthest; negative inside, minus infinity
  /// if no axis is divided. Precondition: it is inside the box, along axes that are periodic.
  double distance(const Vec3& point) const {
    double most = -kInfinity;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (is_divided_[axis]) most = std::max(most, distance_along(axis, point[axis]));
    }
    return most;
  }

  /// The distance of the nearest point of another block [L].
  double distance(const Block& other) const {
    double most = -kInfinity;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (!is_divided_[axis] || !other.is_divided_[axis]) continue;
      most = std::max(most, gap_along(axis, other));
    }
    return most;
  }

  friend bool operator==(const Block&, const Block&) = default;

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  double half_gap(std::size_t axis, double where_undivided) const {
    if (!is_divided_[axis]) return where_undivided;
    return period_[axis] == 0 ? kInfinity : 0.5 * (period_[axis] - (high_[axis] - low_[axis]));
  }

  double distance_along(std::size_t axis, double x) const {
    const double outside = std::max(low_[axis] - x, x - high_[axis]);
    if (period_[axis] == 0 || outside <= 0) return outside;
    // An image may be nearer, or inside.
    const double below = std::max(low_[axis] - (x - period_[axis]), (x - period_[axis]) - high_[axis]);
    const double above = std::max(low_[axis] - (x + period_[axis]), (x + period_[axis]) - high_[axis]);
    return std::min({outside, below, above});
  }

  double gap_along(std::size_t axis, const Block& other) const {
    const auto gap = [&](double shift) {
      return std::max(low_[axis] - (other.high_[axis] + shift), (other.low_[axis] + shift) - high_[axis]);
    };
    if (period_[axis] == 0) return gap(0);
    return std::min({gap(0), gap(-period_[axis]), gap(period_[axis])});
  }

  Vec3 low_;
  Vec3 high_;
  Vec3 period_;  // zero along axes that are not periodic
  bool is_divided_[kAxes] = {};
};

}  // namespace hardball
