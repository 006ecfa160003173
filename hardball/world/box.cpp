// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/world/box.hpp"

#include <algorithm>
#include <cmath>

#include "hardball/errors/error.hpp"
#include "hardball/world/range.hpp"

namespace hardball {

Box::Box(const std::array<Boundary, kAxes>& boundary, const Vec3& size) : boundary_(boundary), size_(size) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    lower_end_[axis] = is_periodic(axis) ? 0 : -kInfinity;
    upper_end_[axis] = is_periodic(axis) ? size[axis] : kInfinity;
    if (is_open(axis)) {
      size_[axis] = kInfinity;
      continue;
    }
    if (boundary[axis] == Boundary::flat) {
      if (axis != 2) throw Error("an axis other than z is flat", "boundary", "make z flat instead");
      size_[axis] = 0;
      continue;
    }
    check_positive(size[axis], "box size", axis == 0 ? "size.x" : axis == 1 ? "size.y" : "size.z");
    if (!is_periodic(axis)) continue;
    period_[axis] = size[axis];
    inverse_period_[axis] = 1 / size[axis];
  }
}

Image Box::count_boxes_beyond(Vec3 position) const {
  Image beyond;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!is_periodic(axis)) continue;
    const double boxes = std::floor(position[axis] / size_[axis]);
    if (!(std::fabs(boxes) <= kMostBoxesBeyond)) {
      throw RunFailure(
          "a sphere has crossed the periodic box 2^30 times without a collision; use a larger box");
    }
    beyond[axis] = static_cast<std::int32_t>(boxes);
  }
  return beyond;
}

bool Box::restored() {
  const auto is_known = [](Boundary boundary) {
    return boundary >= Boundary::wall && boundary <= Boundary::flat;
  };
  if (!std::ranges::all_of(boundary_, is_known)) return false;
  *this = Box(boundary_, size_);
  return true;
}

}  // namespace hardball
