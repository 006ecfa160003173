// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/surfaces/oscillating_plane.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hardball/geometry/safe_step.hpp"
#include "hardball/surfaces/sine.hpp"

namespace hardball {
namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();
constexpr double kTurn = 0x1.921fb54442d18p+2;  // 2 pi

// As seen from `t` on.
Polynomial from(const Polynomial& p, double t) {
  Polynomial shifted;
  Polynomial derivative = p;
  double factorial = 1;
  for (std::size_t i = 0; i <= Polynomial::kMaxDegree; ++i) {
    shifted.coefficients[i] = divide(derivative(t), factorial);
    derivative = derivative.derivative();
    factorial *= static_cast<double>(i + 1);
  }
  return shifted;
}

}  // namespace

OscillatingPlane::Gap OscillatingPlane::gap_at(const Flight& flight, double t) const {
  const Circular phase = circular(frequency_, after(flight.start, t));
  const DoubleDouble<> amplitude{amplitude_, 0};
  const DoubleDouble<> greatest_speed = DoubleDouble<>{kTurn * amplitude_, 0} * DoubleDouble<>{frequency_, 0};
  const double turning = kTurn * frequency_;
  return {(flight.rest(t) - amplitude * phase.sine).high,
          (flight.rest.derivative()(t) - greatest_speed * phase.cosine).high,
          2 * flight.rest.coefficients[2].high + amplitude_ * turning * turning * phase.sine.high};
}

double OscillatingPlane::safe_step(const Flight& flight, const Gap& gap) const {
  constexpr double kRoundedUp = 1 + 0x1p-40;
  const double turning = kTurn * frequency_;
  const double acceleration = amplitude_ * turning * turning * kRoundedUp;
  const double most = std::fabs(2 * flight.rest.coefficients[2].high) + acceleration;
  return safe_step_of_smooth_gap(gap.width, gap.opening_speed, gap.curvature, most, acceleration * turning,
                                 1 / frequency_);
}

bool OscillatingPlane::is_met(const Flight& flight, const Polynomial& room, double& t) const {
  const double end = t + 2 / frequency_;
  // Shorter steps would not change the time.
  const double shortest = 0x1p-105 * std::fabs(flight.start.high);
  do {
    const Gap gap = gap_at(flight, t);
    if (gap.width <= 0 && !(gap.opening_speed > 0)) return true;
    const double next = t + std::max(shortest, safe_step(flight, gap));
    t = next > t ? next : std::nextafter(t, kForever);
  } while (t < end && !(room(t).high > 0));
  return false;
}

// A sphere that stays within the plane's reach is touched within a turn. If it is not, the time since the
// start of the flight is too coarse in one double, or the plane passes by the sphere so closely that rounding
// hides it.
Time OscillatingPlane::contact_time(const Passage& passage) const {
  constexpr double kManyTurns = 64;  // of which one double knows the phase less well than the place
  Flight flight{rest_.gap(passage), passage.start};
  double passed_by = 0;  // as a fraction of the amplitude
  double t = 0;
  const auto count_from = [&](double moment) {
    flight = {from(flight.rest, moment), after(flight.start, moment)};
    t = 0;
  };
  while (t < kForever) {
    Polynomial room = flight.rest;
    room.coefficients[0] =
        room.coefficients[0] - (DoubleDouble<>{amplitude_, 0} - DoubleDouble<>{passed_by * amplitude_, 0});
    if (room(t).high > 0) {
      const double wait = earliest_descent(from(room, t));
      if (!std::isfinite(wait)) return kNever;
      t += wait;
    }
    const double entry = t;
    if (entry * frequency_ > kManyTurns) {
      count_from(entry);
    } else if (is_met(flight, room, t)) {
      return after(flight.start, t);
    } else if (room(t).high > 0) {
      continue;
    } else if (entry > 0) {
      count_from(entry);
    } else {
      constexpr double kLeast = 0x1p-90;
      constexpr double kNext = 0x1p10;
      passed_by = passed_by > 0 ? std::min(2.0, passed_by * kNext) : kLeast;
    }
  }
  return kNever;
}

DoubleDouble<> OscillatingPlane::opening_speed(const Passage& passage) const {
  return {gap_at({rest_.gap(passage), passage.start}, 0).opening_speed, 0};
}

Vec3 OscillatingPlane::displacement_at(const Time& moment) const {
  return (amplitude_ * circular(frequency_, moment).sine.high) * normal();
}

Vec3 OscillatingPlane::velocity_at(const Time& moment) const {
  return (kTurn * amplitude_ * frequency_ * circular(frequency_, moment).cosine.high) * normal();
}

}  // namespace hardball
