// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/sampling_schedule.hpp"

#include <algorithm>
#include <cmath>

#include "hardball/errors/error.hpp"
#include "hardball/numbers/event_random.hpp"
#include "hardball/theory/kinetic_theory.hpp"

namespace hardball {
namespace {

// A random number that is a function of both.
std::uint64_t drawn(std::int64_t which, std::int64_t among) {
  return event_random(static_cast<std::uint64_t>(among), 0, static_cast<std::uint64_t>(which)).bits();
}

}  // namespace

Pace expected_pace(const GasStatistics& statistics) {
  // The cost of a fast engine with spheres that fit in the caches; samples must be cheap compared with that,
  // too.
  constexpr double kContactCost = 1000;
  // Nothing moves, or there are no spheres: there is no time scale, and doubling the interval finds a
  // suitable one.
  if (!(statistics.mean_speed > 0)) return {1, 0, kContactCost};
  const double crossing =
      std::max({statistics.extent.x, statistics.extent.y, statistics.extent.z}) / statistics.mean_speed;
  const double free_time = mean_free_time(statistics);
  const auto spheres = static_cast<double>(statistics.spheres);
  const double contacts = spheres * (0.5 / free_time + wall_rate(statistics));
  return {std::min(free_time, crossing), contacts * kContactCost, kContactCost};
}

double power_of_two_from(double length) {
  int exponent = 0;
  const double fraction = std::frexp(length, &exponent);
  return std::ldexp(fraction == 0.5 ? 0.5 : 1, exponent);
}

double irrational_from(double length) {
  // The number has so few bits that multiples are exact.
  constexpr double kTwiceInverseGoldenRatio = 0x1.3c6ef3p0;
  return kTwiceInverseGoldenRatio * power_of_two_from(length / kTwiceInverseGoldenRatio);
}

SamplingSchedule::SamplingSchedule(const Time& begin, double interval, bool is_scattered)
    : begin_(begin.value()), interval_(interval), next_(0), is_scattered_(is_scattered) {
  if (is_scattered_) next_ = scattered_in(0);
}

SamplingSchedule SamplingSchedule::regular(const Time& begin, double interval) {
  return {begin, interval, false};
}

SamplingSchedule SamplingSchedule::regular(const Time& begin, double interval, std::int64_t window,
                                           double sample_cost, const Pace& pace) {
  SamplingSchedule schedule(begin, interval, false);
  schedule.window_ = schedule.period_ = window;
  schedule.spread(sample_cost, pace);
  return schedule;
}

SamplingSchedule SamplingSchedule::scattered(const Time& begin, double interval) {
  return {begin, interval, true};
}

SamplingSchedule SamplingSchedule::scattered(const Time& begin, double interval, double sample_cost,
                                             const Pace& pace) {
  SamplingSchedule schedule(begin, interval, true);
  schedule.spread(sample_cost, pace);
  return schedule;
}

// Chooses the first period, and how long it lasts.
void SamplingSchedule::spread(double sample_cost, const Pace& pace) {
  const double window_cost = sample_cost * static_cast<double>(window_);
  contacts_wanted_ = window_cost / (kShare * pace.contact_cost);
  // How often the period must double until the run pays for windows, and how many are free.
  const double ratio = window_cost / (kShare * pace.cost * period());
  auto doublings = static_cast<std::int64_t>(std::ceil(std::log2(std::clamp(ratio, 1.0, 0x1p40))));
  const double free_windows = kAllowance / window_cost;
  for (; doublings > 0 && free_windows < static_cast<double>(doublings); --doublings) period_ *= 2;
  if (doublings > 0) {
    windows_per_count_ = static_cast<std::int64_t>(free_windows / static_cast<double>(doublings));
  }
  next_ = first_from(free_windows < 1 ? period_ : 0);
}

Time SamplingSchedule::next() const {
  if (next_ == kNoSample) return kNever;
  const double within = is_scattered_ ? static_cast<double>(drawn(next_, 0) >> 11) * 0x1p-53 : 0;
  return Time(begin_ + (static_cast<double>(next_) + within) * interval_);
}

// The interval in which a period has its sample: that of one of its halves.
std::int64_t SamplingSchedule::scattered_in(std::int64_t period) const {
  std::int64_t interval = period;
  for (std::int64_t length = period_; length > 1; length /= 2) {
    interval = 2 * interval + static_cast<std::int64_t>(drawn(interval, length) >> 63);
  }
  return interval;
}

// The first interval with a sample that is not before `next`.
std::int64_t SamplingSchedule::first_from(std::int64_t next) const {
  const std::int64_t period = next / period_;
  if (is_scattered_) {
    const std::int64_t here = scattered_in(period);
    return here >= next ? here : scattered_in(period + 1);
  }
  const std::int64_t left = next % period_;
  return left < window_ ? next : next + period_ - left;
}

// A period of which one half is over continues as the other half.
void SamplingSchedule::double_period() {
  period_ *= 2;
  if (is_scattered_) {
    next_ = std::max(next_, scattered_in(next_ / period_));
  } else {
    next_ = first_from(next_);
  }
}

int SamplingSchedule::advance(const Time& now, std::uint64_t contacts) {
  constexpr double kTolerance = 0.5;
  // Moments are doubles: beyond this many intervals from zero they no longer resolve one.
  constexpr double kMaxIntervals = 0x1p50;
  const double farthest = std::max(std::fabs(begin_), std::fabs(now.value()));
  int doublings = 0;
  while (!(farthest / interval_ < kMaxIntervals)) {
    if (contacts_wanted_ == 0) {
      throw Error(
          "samples every " + to_text(interval_) + " cannot be resolved at time " + to_text(now.value()),
          "measures.every", "give a longer time between samples");
    }
    interval_ *= 2;
    next_ = (next_ + 1) / 2;
    ++doublings;
  }
  const std::int64_t before = next_ / period_;
  next_ = std::max(next_, static_cast<std::int64_t>((now.value() - begin_) / interval_));
  do next_ = first_from(next_ + 1);
  while (next() <= now);
  if (next_ / period_ == before || contacts_wanted_ == 0) return doublings;
  if (++windows_ < windows_per_count_) return doublings;
  const auto seen = static_cast<double>(contacts - contacts_before_);
  if (seen < kTolerance * static_cast<double>(windows_) * contacts_wanted_) {
    double_period();
    ++doublings;
  }
  contacts_before_ = contacts;
  windows_ = 0;
  return doublings;
}

bool SamplingSchedule::restored() const {
  constexpr std::int64_t kMax = std::int64_t{1} << 60;
  return next_ == kNoSample ||
         (next_ >= 0 && next_ < kMax && std::isfinite(begin_) && interval_ > 0 && std::isfinite(interval_) &&
          window_ > 0 && period_ >= window_ && period_ < kMax && windows_ >= 0);
}

}  // namespace hardball
