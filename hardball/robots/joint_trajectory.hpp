// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hardball/errors/export.hpp"

namespace hardball {

/// What a spline does at its ends.
enum class SplineEnds : std::uint8_t {
  natural,  ///< Second derivatives of zero.
  clamped,  ///< First derivatives of zero: the robot starts and ends at rest.
};

/// The coordinates of the joints of a robot as functions of time: a cubic polynomial for each joint, between
/// each two of the times that are called knots.
///
/// Angles are in radians and lengths in [L], as the joints have it.
class HARDBALL_EXPORT JointTrajectory {
 public:
  /// Coefficients of a polynomial of the time since the last knot, from the constant on.
  using Cubic = std::array<double, 4>;
  /// The coordinates of all joints at one knot.
  using Row = std::vector<double>;

  /// The spline through rows of coordinates at the knots, with continuous second derivatives. Error: fewer
  /// than two knots; knots that do not increase; another number of rows; rows of different lengths; a number
  /// that is not finite. Cost: O(knots joints).
  static JointTrajectory cubic(const std::vector<double>& times, const std::vector<Row>& coordinates,
                               SplineEnds ends = SplineEnds::natural);
  /// Straight lines between rows of coordinates at the knots. Error: as for `cubic`.
  static JointTrajectory linear(const std::vector<double>& times, const std::vector<Row>& coordinates);
  /// Cubic polynomials with these coordinates and first derivatives [1/T] at the knots. Error: as for
  /// `cubic`.
  static JointTrajectory from_rates(const std::vector<double>& times, const std::vector<Row>& coordinates,
                                    const std::vector<Row>& rates);
  /// The polynomials themselves: pieces[k][j] is that of joint j from knot k on. Error: as for `cubic`, one
  /// row for each two knots; a coordinate that jumps at a knot by more than 1e-9 of it, or of one.
  static JointTrajectory from_pieces(const std::vector<double>& times,
                                     const std::vector<std::vector<Cubic>>& pieces);

  /// The knots [T].
  std::span<const double> times() const { return times_; }
  double begin() const { return times_.front(); }
  double end() const { return times_.back(); }
  /// The number of joints.
  std::size_t joint_count() const { return joint_count_; }
  /// The number of pieces, one less than that of knots.
  std::size_t piece_count() const { return times_.size() - 1; }
  /// The polynomial of each joint in a piece. Precondition: there is such a piece.
  std::span<const Cubic> piece(std::size_t number) const {
    return {cubics_.data() + number * joint_count_, joint_count_};
  }
  /// The coordinates at a time. Error: it is not between the first knot and the last.
  Row coordinates_at(double time) const;

 private:
  JointTrajectory(const std::vector<double>& times, std::size_t rows, std::size_t joints, const char* where);
  static JointTrajectory with_rates(const std::vector<double>& times, const std::vector<Row>& coordinates,
                                    const std::vector<Row>& rates, const char* where);

  std::vector<double> times_;
  std::size_t joint_count_ = 0;
  std::vector<Cubic> cubics_;
};

/// The value of a polynomial of a joint, `time` after its piece began.
inline double coordinate_at(const JointTrajectory::Cubic& cubic, double time) {
  return cubic[0] + time * (cubic[1] + time * (cubic[2] + time * cubic[3]));
}

}  // namespace hardball
