// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>

#include "hardball/broadphase/subdivision.hpp"
#include "hardball/geometry/vec3.hpp"

namespace hardball {

/// The cells along a ray, one after the other. The outermost cells of axes that are not periodic have no end.
/// Source: Amanatides and Woo, Eurographics (1987) 3.
class CellWalk {
 public:
  /// A ray from a point inside a periodic box [L]; `direction` is a unit vector.
  CellWalk(const Subdivision& cells, const Vec3& origin, const Vec3& direction)
      : cells_(&cells), origin_(origin), direction_(direction), cell_(cells.cell_of(origin)) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) find_exit(axis);
  }

  /// The cell, which need not be folded into the box.
  const CellIndex& cell() const { return cell_; }
  /// The distance from the origin at which the ray leaves the cell [L]; infinite if it never does.
  double end() const { return exits_[nearest()]; }
  /// Moves on to the next cell. Precondition: end() is finite.
  void step() {
    const std::size_t axis = nearest();
    cell_[axis] += direction_[axis] > 0 ? 1 : -1;
    find_exit(axis);
  }

 private:
  std::size_t nearest() const {
    const std::size_t first = exits_.x <= exits_.y ? 0 : 1;
    return exits_[first] <= exits_.z ? first : 2;
  }
  void find_exit(std::size_t axis) {
    const bool up = direction_[axis] > 0;
    const bool is_outermost = cell_[axis] == (up ? cells_->last(axis) : cells_->first(axis));
    const double beyond = cells_->beyond_face(axis, cell_[axis] + (up ? 1 : 0), origin_[axis]);
    exits_[axis] = is_outermost || direction_[axis] == 0 ? std::numeric_limits<double>::infinity()
                                                         : -beyond / direction_[axis];
  }

  const Subdivision* cells_;
  Vec3 origin_;
  Vec3 direction_;
  CellIndex cell_;
  Vec3 exits_;  // along each axis
};

}  // namespace hardball
