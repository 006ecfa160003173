// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "hardball/geometry/double_double.hpp"
#include "hardball/geometry/inlining.hpp"
#include "hardball/geometry/sliding_images.hpp"
#include "hardball/world/box.hpp"

namespace hardball {

/// The rows of cells in a sheared box, counted upwards along y: each slides along x with the flow at its
/// middle.
///
/// Adjacent rows slide past each other at the same speed wherever they are, those on both sides of the box's
/// face too. So the work for a sphere depends neither on where it is nor on the size of the box. Rows are
/// counted as cells are: those above the box belong to the image above.
class SlidingRows {
 public:
  SlidingRows() = default;
  /// The rows of a box from `now` on.
  SlidingRows(const Box& box, std::int32_t rows, const Time& now)
      : are_present_(box.is_sheared()),
        images_(box.images()),
        width_(box.size().x),
        rows_(rows),
        speed_of_half_step_(images_.speed() / (2 * rows)) {
    if (!are_present()) return;
    boxes_.resize(static_cast<std::size_t>(rows));
    displacements_.resize(static_cast<std::size_t>(rows + 2));
    leave_out_boxes(now);
    record(now);
  }

  bool are_present() const { return are_present_; }

  /// Makes displacements at moments near this one cheap. Cost: O(1), and O(rows) when images have slid by a
  /// box.
  void keep_near(const Time& now) {
    if (!is_near(duration(noted_at_, now))) [[unlikely]]
      record(now);
  }

  /// Makes displacements at moments near this one cheap, as keep_near does, and keeps them small: they may
  /// jump by whole boxes.
  void keep_near_and_small(const Time& now) {
    if (is_near(duration(noted_at_, now))) [[likely]]
      return;
    leave_out_boxes(now);
    record(now);
  }

  /// By how much a row is displaced along x at `moment` [L], less as many boxes as made that of a row of the
  /// box small at the time of construction.
  double displacement(std::int32_t row, const Time& moment) const {
    const double since = duration(noted_at_, moment);
    if (is_near(since) && is_noted(row)) [[likely]]
      return noted(row, since);
    return exact_displacement(row, moment);
  }
  /// The displacements of a row and of the one above [L].
  std::array<double, 2> displacements(std::int32_t row, const Time& moment) const {
    const double since = duration(noted_at_, moment);
    if (is_near(since) && is_noted(row) && is_noted(row + 1)) [[likely]]
      return {noted(row, since), noted(row + 1, since)};
    return {exact_displacement(row, moment), exact_displacement(row + 1, moment)};
  }
  /// By how much a row is displaced against the one below at `moment`, but for whole boxes: a few boxes at
  /// most [L].
  double step(const Time& moment) const {
    const double since = duration(noted_at_, moment);
    return is_near(since) ? step_ + 2 * speed_of_half_step_ * since : exact_step(moment);
  }
  /// How fast a row moves along x [L/T].
  double speed(std::int32_t row) const { return speed_of_half_step_ * half_steps(row); }
  /// How fast adjacent rows slide past each other [L/T].
  double speed_of_step() const { return 2 * std::fabs(speed_of_half_step_); }

 private:
  // The height of a row's middle over that of the box's, in halves of a row.
  double half_steps(std::int32_t row) const { return 2.0 * row + 1 - rows_; }
  DoubleDouble<double> half_step(const Time& moment) const {
    return divide(images_.displacement(moment), 2.0 * rows_);
  }
  HARDBALL_NEVER_INLINE double exact_displacement(std::int32_t row, const Time& moment) const {
    const std::int32_t rest = row % rows_;
    const std::int32_t inside = rest < 0 ? rest + rows_ : rest;
    const DoubleDouble<double> slid = half_step(moment) * DoubleDouble<double>{half_steps(inside), 0};
    const double in_box = (slid - product(boxes_[static_cast<std::size_t>(inside)], width_)).high;
    const double layer = (row - inside) / rows_;
    const DoubleDouble<double> above = images_.displacement(moment) - product(boxes_above_, width_);
    return layer == 0 ? in_box : in_box + layer * above.high;
  }
  double exact_step(const Time& moment) const {
    const DoubleDouble<double> slid = half_step(moment) * DoubleDouble<double>{2, 0};
    return (slid - product(std::round(slid.high / width_), width_)).high;
  }
  // Displacements are stored for the rows of the box and those next to it.
  bool is_noted(std::int32_t row) const {
    return static_cast<std::uint32_t>(row + 1) < static_cast<std::uint32_t>(rows_ + 2);
  }
  double noted(std::int32_t row, double since) const {
    return displacements_[static_cast<std::size_t>(row + 1)] + speed(row) * since;
  }
  // Whether images have slid by no more than a box since.
  bool is_near(double since) const { return std::fabs(images_.speed() * since) <= width_; }
  void leave_out_boxes(const Time& now) {
    boxes_above_ = std::round(images_.displacement(now).high / width_);
    for (std::int32_t row = 0; row < rows_; ++row) {
      const DoubleDouble<double> slid = half_step(now) * DoubleDouble<double>{half_steps(row), 0};
      boxes_[static_cast<std::size_t>(row)] = std::round(slid.high / width_);
    }
  }
  void record(const Time& now) {
    noted_at_ = now;
    for (std::int32_t row = -1; row <= rows_; ++row)
      displacements_[static_cast<std::size_t>(row + 1)] = exact_displacement(row, now);
    step_ = exact_step(now);
  }

  bool are_present_ = false;
  SlidingImages images_;
  double width_ = 1;
  std::int32_t rows_ = 1;
  double speed_of_half_step_ = 0;
  // By which displacements are less, of the image above and by row:
  double boxes_above_ = 0;
  std::vector<double> boxes_;
  // Displacements stored at a moment, from the row below the box on, and of each row relative to the one
  // below:
  Time noted_at_;
  std::vector<double> displacements_;
  double step_ = 0;
};

}  // namespace hardball
