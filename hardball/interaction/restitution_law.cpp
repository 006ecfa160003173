// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/interaction/restitution_law.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/numbers/random.hpp"
#include "hardball/standard/ranges.hpp"

namespace hardball {
namespace {

// The coefficient of restitution as a function of b^(1/2) u^(1/10).
double viscoelastic(double x) {
  constexpr double kC1 = 0.501086;
  constexpr double kB2 = 1.15345;
  constexpr double kB3 = 0.577977;
  constexpr double kB4 = 0.532178;
  const double denominator = 1 + x * (kC1 + x * (kB2 + x * (kB3 + x * (kB4 + x * kC1))));
  return (1 + kC1 * x) / denominator;
}

double tenth_root(double x) {
  return portable_exp(portable_log(x) / 10);
}

}  // namespace

void check_restitution(double value) {
  if (value >= 0 && value <= 1) return;
  throw Error("restitution is " + to_text(value), "restitution", "give a number between 0 and 1");
}

ViscoelasticRestitution::ViscoelasticRestitution(double value, double speed) : speed_(speed), unit_(0) {
  check_restitution(value);
  check_positive(speed, "speed", "restitution");
  constexpr double kLargest = 16;
  if (value < viscoelastic(kLargest)) {
    throw Error("a viscoelastic restitution of " + to_text(value), "restitution",
                "give at least " + to_text(viscoelastic(kLargest)));
  }
  double low = 0;
  double high = kLargest;
  for (double middle = high / 2; low < middle && middle < high; middle = (low + high) / 2) {
    (viscoelastic(middle) > value ? low : high) = middle;
  }
  unit_ = low;
}

double ViscoelasticRestitution::at(double speed) const {
  return speed > kSmallestMagnitude ? viscoelastic(unit_ * tenth_root(speed / speed_)) : 1;
}

ViscoelasticRestitution ViscoelasticRestitution::scaled(double factor) const {
  ViscoelasticRestitution law(*this);
  law.speed_ *= factor;
  return law;
}

TabulatedRestitution TabulatedRestitution::scaled(double factor) const {
  TabulatedRestitution law(*this);
  for (Point& point : law.points_) point.speed *= factor;
  return law;
}

TabulatedRestitution::TabulatedRestitution(std::vector<Point> points) : points_(std::move(points)) {
  if (points_.empty()) {
    throw Error("a table of restitutions is empty", "restitution", "give at least one speed and value");
  }
  for (std::size_t i = 0; i < points_.size(); ++i) {
    check_restitution(points_[i].value);
    const bool is_in_order = points_[i].speed >= 0 && std::isfinite(points_[i].speed) &&
                             (i == 0 || points_[i].speed > points_[i - 1].speed);
    if (is_in_order) continue;
    throw Error("the speed " + to_text(points_[i].speed) + " is out of order", "restitution",
                "give impact speeds that increase from zero or more");
  }
}

double TabulatedRestitution::at(double speed) const {
  const auto above = ranges::find_if(points_, [speed](const Point& point) { return point.speed > speed; });
  if (above == points_.begin()) return points_.front().value;
  if (above == points_.end()) return points_.back().value;
  const Point& below = *std::prev(above);
  return below.value + (above->value - below.value) * ((speed - below.speed) / (above->speed - below.speed));
}

}  // namespace hardball
