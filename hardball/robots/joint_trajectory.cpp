// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/robots/joint_trajectory.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"

namespace hardball {
namespace {

using Row = JointTrajectory::Row;
using Cubic = JointTrajectory::Cubic;

// Error: there is not one row for each knot, of one length and finite.
void check_rows(const std::vector<double>& times, const std::vector<Row>& rows, const char* name,
                const char* where) {
  if (rows.size() != times.size()) {
    throw Error(
        "there are " + to_text(times.size()) + " times and " + to_text(rows.size()) + " rows of " + name,
        where, "give one row for each time");
  }
  for (const Row& row : rows) {
    if (row.size() != rows.front().size())
      throw Error(std::string("the rows of ") + name + " differ in length", where,
                  "give one number for each joint");
    for (const double number : row) check_finite(number, std::string("one of the ") + name, where);
  }
}

// The first derivatives at the knots of one joint's spline, row k of which is rows[k]. They solve a
// tridiagonal system, by elimination from the first knot to the last and back.
void spline_rates(const std::vector<double>& times, const std::vector<Row>& rows, std::size_t joint,
                  SplineEnds ends, std::vector<Row>& rates) {
  const std::size_t last = times.size() - 1;
  const auto step = [&](std::size_t k) { return times[k + 1] - times[k]; };
  const auto slope = [&](std::size_t k) { return (rows[k + 1][joint] - rows[k][joint]) / step(k); };
  // After elimination, rate k is right[k] - factor[k] rate k + 1.
  std::vector<double> factor(last + 1);
  std::vector<double> right(last + 1);
  const bool is_natural = ends == SplineEnds::natural;
  factor[0] = is_natural ? 0.5 : 0;
  right[0] = is_natural ? 1.5 * slope(0) : 0;
  for (std::size_t k = 1; k < last; ++k) {
    const double before = step(k);
    const double after = step(k - 1);
    const double pivot = 2 * (before + after) - before * factor[k - 1];
    factor[k] = after / pivot;
    right[k] = (3 * (before * slope(k - 1) + after * slope(k)) - before * right[k - 1]) / pivot;
  }
  rates[last][joint] = is_natural ? (3 * slope(last - 1) - right[last - 1]) / (2 - factor[last - 1]) : 0;
  for (std::size_t k = last; k-- > 0;) rates[k][joint] = right[k] - factor[k] * rates[k + 1][joint];
}

}  // namespace

JointTrajectory::JointTrajectory(const std::vector<double>& times, std::size_t rows, std::size_t joints,
                                 const char* where)
    : times_(times), joint_count_(joints) {
  if (times.size() < 2) throw Error("there are fewer than two times", where, "give the begin and the end");
  for (std::size_t k = 0; k < times.size(); ++k) {
    check_finite(times[k], "a time", where);
    if (k > 0 && !(times[k] > times[k - 1])) {
      throw Error("the time " + to_text(times[k]) + " follows " + to_text(times[k - 1]), where,
                  "give times that increase");
    }
  }
  cubics_.reserve(rows * joints);
}

JointTrajectory JointTrajectory::with_rates(const std::vector<double>& times,
                                            const std::vector<Row>& coordinates,
                                            const std::vector<Row>& rates, const char* where) {
  JointTrajectory trajectory(times, times.size() - 1, coordinates.front().size(), where);
  for (std::size_t k = 0; k + 1 < times.size(); ++k) {
    const double step = times[k + 1] - times[k];
    for (std::size_t j = 0; j < trajectory.joint_count_; ++j) {
      const double slope = (coordinates[k + 1][j] - coordinates[k][j]) / step;
      const double begin = rates[k][j];
      const double end = rates[k + 1][j];
      trajectory.cubics_.push_back({coordinates[k][j], begin, (3 * slope - 2 * begin - end) / step,
                                    (begin + end - 2 * slope) / (step * step)});
    }
  }
  return trajectory;
}

JointTrajectory JointTrajectory::cubic(const std::vector<double>& times, const std::vector<Row>& coordinates,
                                       SplineEnds ends) {
  constexpr const char* kWhere = "JointTrajectory::cubic";
  check_rows(times, coordinates, "coordinates", kWhere);
  const std::size_t joints = coordinates.empty() ? 0 : coordinates.front().size();
  const JointTrajectory checked(times, 0, joints, kWhere);
  std::vector<Row> rates(times.size(), Row(joints));
  for (std::size_t j = 0; j < joints; ++j) spline_rates(times, coordinates, j, ends, rates);
  return with_rates(times, coordinates, rates, kWhere);
}

JointTrajectory JointTrajectory::linear(const std::vector<double>& times,
                                        const std::vector<Row>& coordinates) {
  constexpr const char* kWhere = "JointTrajectory::linear";
  check_rows(times, coordinates, "coordinates", kWhere);
  const std::size_t joints = coordinates.empty() ? 0 : coordinates.front().size();
  JointTrajectory trajectory(times, times.size(), joints, kWhere);
  for (std::size_t k = 0; k + 1 < times.size(); ++k) {
    for (std::size_t j = 0; j < joints; ++j) {
      const double rise = coordinates[k + 1][j] - coordinates[k][j];
      trajectory.cubics_.push_back({coordinates[k][j], rise / (times[k + 1] - times[k]), 0, 0});
    }
  }
  return trajectory;
}

JointTrajectory JointTrajectory::from_rates(const std::vector<double>& times,
                                            const std::vector<Row>& coordinates,
                                            const std::vector<Row>& rates) {
  constexpr const char* kWhere = "JointTrajectory::from_rates";
  check_rows(times, coordinates, "coordinates", kWhere);
  check_rows(times, rates, "rates", kWhere);
  const std::size_t joints = coordinates.empty() ? 0 : coordinates.front().size();
  if (!rates.empty() && rates.front().size() != joints)
    throw Error("coordinates and rates are of different lengths", kWhere, "give one of each for each joint");
  const JointTrajectory checked(times, 0, joints, kWhere);
  return with_rates(times, coordinates, rates, kWhere);
}

JointTrajectory JointTrajectory::from_pieces(const std::vector<double>& times,
                                             const std::vector<std::vector<Cubic>>& pieces) {
  constexpr const char* kWhere = "JointTrajectory::from_pieces";
  constexpr double kLargestJump = 1e-9;
  const std::size_t joints = pieces.empty() ? 0 : pieces.front().size();
  JointTrajectory trajectory(times, pieces.size(), joints, kWhere);
  if (pieces.size() + 1 != times.size()) {
    throw Error("there are " + to_text(times.size()) + " times and " + to_text(pieces.size()) + " pieces",
                kWhere, "give one piece for each two times");
  }
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    if (pieces[k].size() != joints)
      throw Error("the pieces differ in length", kWhere, "give one polynomial for each joint");
    for (std::size_t j = 0; j < joints; ++j) {
      for (const double coefficient : pieces[k][j]) check_finite(coefficient, "a coefficient", kWhere);
      if (k > 0) {
        const double before = coordinate_at(pieces[k - 1][j], times[k] - times[k - 1]);
        const double jump = std::fabs(pieces[k][j][0] - before);
        if (jump > kLargestJump * std::max(1.0, std::fabs(before))) {
          throw Error(
              "joint " + to_text(j) + " jumps by " + to_text(jump) + " at the time " + to_text(times[k]),
              kWhere, "let each piece begin where the one before ends");
        }
      }
      trajectory.cubics_.push_back(pieces[k][j]);
    }
  }
  return trajectory;
}

JointTrajectory::Row JointTrajectory::coordinates_at(double time) const {
  if (!(time >= begin() && time <= end())) {
    throw Error("the time is " + to_text(time), "JointTrajectory::coordinates_at",
                "give one between " + to_text(begin()) + " and " + to_text(end()));
  }
  const auto next = std::upper_bound(times_.begin(), times_.end() - 1, time);
  const std::size_t k =
      std::min<std::size_t>(static_cast<std::size_t>(next - times_.begin()), piece_count()) - 1;
  Row coordinates;
  for (const Cubic& cubic : piece(k)) coordinates.push_back(coordinate_at(cubic, time - times_[k]));
  return coordinates;
}

}  // namespace hardball
