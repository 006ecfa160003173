// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/surfaces/oscillating_plane.hpp"

#include <cmath>
#include <limits>

#include "hardball/errors/error.hpp"
#include "hardball/surfaces/sine.hpp"

namespace hardball {
namespace {

constexpr double kTurn = 0x1.921fb54442d18p+2;  // 2 pi

// As seen from `t` on.
Polynomial from(const Polynomial& p, double t) {
  Polynomial shifted;
  Polynomial derivative = p;
  double factorial = 1;
  for (std::size_t i = 0; i <= Polynomial::kMostDegree; ++i) {
    shifted.coefficients[i] = divide(derivative(t), factorial);
    derivative = derivative.derivative();
    factorial *= static_cast<double>(i + 1);
  }
  return shifted;
}

// The longest step in which a gap cannot close that opens with `speed` and whose curvature is no less than
// -`curvature`.
double safe_step(double gap, double speed, double curvature) {
  constexpr double kRoundedDown = 1 - 0x1p-40;
  if (gap <= 0) return kRoundedDown * speed / curvature;  // closed, but it opens: until that may change
  const double root = std::sqrt(speed * speed + 2 * curvature * gap);
  return kRoundedDown * (speed < 0 ? 2 * gap / (root - speed) : (root + speed) / curvature);
}

}  // namespace

OscillatingPlane::Gap OscillatingPlane::gap_at(const Polynomial& rest, const Time& start, double t) const {
  const Circular phase = circular(frequency_, after(start, t));
  const DoubleDouble<> amplitude{amplitude_, 0};
  const DoubleDouble<> greatest_speed = DoubleDouble<>{kTurn * amplitude_, 0} * DoubleDouble<>{frequency_, 0};
  return {(rest(t) - amplitude * phase.sine).high,
          (rest.derivative()(t) - greatest_speed * phase.cosine).high};
}

double OscillatingPlane::time_to_touch(const Passage& passage, double radius) const {
  const Polynomial rest = rest_.gap(passage, radius);
  Polynomial outermost = rest;
  outermost.coefficients[0] = rest.coefficients[0] - DoubleDouble<>{amplitude_, 0};
  const double turning = kTurn * frequency_;
  const double curvature =
      std::fabs(2 * rest.coefficients[2].high) + amplitude_ * turning * turning * (1 + 0x1p-40);
  double t = 0;
  constexpr int kMostSteps = 1 << 20;
  for (int step = 0; step < kMostSteps; ++step) {
    // Nothing happens beyond the plane's reach.
    if (outermost(t).high > 0) {
      const double wait = earliest_descent(from(outermost, t));
      if (!std::isfinite(wait)) return wait;
      t += wait;
    }
    const Gap gap = gap_at(rest, passage.start, t);
    if (gap.width <= 0 && !(gap.opening_speed > 0)) return t;
    const double next = t + safe_step(gap.width, gap.opening_speed, curvature);
    t = next > t ? next : std::nextafter(t, std::numeric_limits<double>::infinity());
  }
  throw RunFailure("a sphere stays so close to an oscillating wall that its contacts cannot be told apart");
}

DoubleDouble<> OscillatingPlane::opening_speed(const Passage& passage) const {
  const Gap gap = gap_at(rest_.gap(passage, 0), passage.start, 0);
  return {gap.opening_speed, 0};
}

Vec3 OscillatingPlane::displacement_at(const Time& moment) const {
  return (amplitude_ * circular(frequency_, moment).sine.high) * normal();
}

Vec3 OscillatingPlane::velocity_at(const Time& moment) const {
  return (kTurn * amplitude_ * frequency_ * circular(frequency_, moment).cosine.high) * normal();
}

}  // namespace hardball
