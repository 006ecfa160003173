// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/cadence.hpp"

#include <algorithm>
#include <cmath>

#include "hardball/errors/error.hpp"
#include "hardball/tuning/kinetic_theory.hpp"

namespace hardball {

Pace expected_pace(const Moments& moments) {
  // The cost of a fast engine with spheres that fit in the caches; samples must be cheap compared with that,
  // too.
  constexpr double kContactCost = 1000;
  // Nothing moves, or there are no spheres: there is no time scale, and doubling the interval finds a
  // suitable one.
  if (!(moments.mean_speed > 0)) return {1, 0, kContactCost};
  const double crossing =
      std::max({moments.extent.x, moments.extent.y, moments.extent.z}) / moments.mean_speed;
  const double free_time = mean_free_time(moments);
  const auto spheres = static_cast<double>(moments.spheres);
  const double contacts = spheres * (0.5 / free_time + wall_rate(moments));
  return {std::min(free_time, crossing), contacts * kContactCost, kContactCost};
}

double power_of_two_from(double length) {
  int exponent = 0;
  const double fraction = std::frexp(length, &exponent);
  return std::ldexp(fraction == 0.5 ? 0.5 : 1, exponent);
}

Cadence::Cadence(const Time& begin, double finest, double sample_cost, const Pace& pace)
    : Cadence(begin, finest) {
  const double affordable = pace.cost > 0 ? sample_cost / (kShare * pace.cost) : finest;
  interval_ = power_of_two_from(std::max(finest, affordable));
  if (affordable > finest) next_ = 1;
  contacts_wanted_ = sample_cost / (kShare * pace.contact_cost);
}

Time Cadence::next() const {
  return next_ == kNoSample ? kNever : Time(begin_ + static_cast<double>(next_) * interval_);
}

void Cadence::advance(const Time& now, std::uint64_t contacts) {
  constexpr int kSamplesPerCount = 8;
  constexpr double kTolerance = 0.5;
  // Moments are doubles: beyond this many intervals from zero they no longer resolve one.
  constexpr double kMostIntervals = 0x1p50;
  const double farthest = std::max(std::fabs(begin_), std::fabs(now.value()));
  while (!(farthest / interval_ < kMostIntervals)) {
    if (contacts_wanted_ == 0) {
      throw Error(
          "samples every " + to_text(interval_) + " cannot be resolved at time " + to_text(now.value()),
          "measures.every", "give a longer time between samples");
    }
    interval_ *= 2;
    next_ = (next_ + 1) / 2;
  }
  next_ = std::max(next_, static_cast<std::int64_t>((now.value() - begin_) / interval_));
  while (next() <= now) ++next_;
  if (++samples_ < kSamplesPerCount) return;
  const auto seen = static_cast<double>(contacts - contacts_before_);
  if (seen < kTolerance * kSamplesPerCount * contacts_wanted_) {
    interval_ *= 2;
    next_ = (next_ + 1) / 2;
  }
  contacts_before_ = contacts;
  samples_ = 0;
}

bool Cadence::restored() const {
  constexpr std::int64_t kMost = std::int64_t{1} << 60;
  return next_ == kNoSample || (next_ >= 0 && next_ < kMost && std::isfinite(begin_) && interval_ > 0 &&
                                std::isfinite(interval_) && samples_ >= 0);
}

}  // namespace hardball
