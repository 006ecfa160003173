// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/sampling_schedule.hpp"

#include <algorithm>
#include <cmath>

#include "hardball/errors/error.hpp"
#include "hardball/theory/kinetic_theory.hpp"

namespace hardball {

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

SamplingSchedule::SamplingSchedule(const Time& begin, double finest, std::int64_t window, double sample_cost,
                                   const Pace& pace)
    : SamplingSchedule(begin, power_of_two_from(finest)) {
  const double window_cost = sample_cost * static_cast<double>(window);
  window_ = period_ = window;
  contacts_wanted_ = window_cost / (kShare * pace.contact_cost);
  // How often the period must double until the run pays for windows, and how many are free.
  const double ratio = window_cost / (kShare * pace.cost * period());
  auto doublings = static_cast<std::int64_t>(std::ceil(std::log2(std::clamp(ratio, 1.0, 0x1p40))));
  const double free_windows = kAllowance / window_cost;
  for (; doublings > 0 && free_windows < static_cast<double>(doublings); --doublings) period_ *= 2;
  if (doublings > 0) {
    windows_per_count_ = static_cast<std::int64_t>(free_windows / static_cast<double>(doublings));
  }
  if (free_windows < 1) next_ = period_;
}

Time SamplingSchedule::next() const {
  return next_ == kNoSample ? kNever : Time(begin_ + static_cast<double>(next_) * interval_);
}

// To the next sample of this window, or the first of the next.
void SamplingSchedule::step() {
  ++next_;
  const std::int64_t left = next_ % period_;
  if (left >= window_) next_ += period_ - left;
}

void SamplingSchedule::double_period() {
  period_ *= 2;
  const std::int64_t left = next_ % period_;
  if (left >= window_) next_ += period_ - left;
}

void SamplingSchedule::advance(const Time& now, std::uint64_t contacts) {
  constexpr double kTolerance = 0.5;
  // Moments are doubles: beyond this many intervals from zero they no longer resolve one.
  constexpr double kMaxIntervals = 0x1p50;
  const double farthest = std::max(std::fabs(begin_), std::fabs(now.value()));
  while (!(farthest / interval_ < kMaxIntervals)) {
    if (contacts_wanted_ == 0) {
      throw Error(
          "samples every " + to_text(interval_) + " cannot be resolved at time " + to_text(now.value()),
          "measures.every", "give a longer time between samples");
    }
    interval_ *= 2;
    next_ = (next_ + 1) / 2;
  }
  const std::int64_t before = next_ / period_;
  next_ = std::max(next_, static_cast<std::int64_t>((now.value() - begin_) / interval_));
  do step();
  while (next() <= now);
  if (next_ / period_ == before || contacts_wanted_ == 0) return;
  if (++windows_ < windows_per_count_) return;
  const auto seen = static_cast<double>(contacts - contacts_before_);
  if (seen < kTolerance * static_cast<double>(windows_) * contacts_wanted_) double_period();
  contacts_before_ = contacts;
  windows_ = 0;
}

bool SamplingSchedule::restored() const {
  constexpr std::int64_t kMax = std::int64_t{1} << 60;
  return next_ == kNoSample ||
         (next_ >= 0 && next_ < kMax && std::isfinite(begin_) && interval_ > 0 && std::isfinite(interval_) &&
          window_ > 0 && period_ >= window_ && period_ < kMax && windows_ >= 0);
}

}  // namespace hardball
