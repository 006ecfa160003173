// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hardball/theory/gas_statistics.hpp"

namespace hardball {

/// What a run is expected to cost, and how fast it evolves, by kinetic theory. Costs are those of one core at
/// 2.8 GHz; nothing is timed, so that a scenario is measured identically everywhere.
struct Pace {
  double free_time;     ///< Mean time between the collisions of a sphere, or in which it crosses the box [T].
  double cost;          ///< Cost of the run for each unit of time [ns/T].
  double contact_cost;  ///< Cost of the run for each contact [ns].
};

Pace expected_pace(const GasStatistics& statistics);

/// The times at which a measure is given the world.
///
/// No sample shares a beat with anything periodic, such as a thermostat or an oscillating wall, or its mean
/// would be that of one phase. *Scattered* samples are for means over time: time is divided into periods, and
/// each has one sample, at a moment chosen at random within it, the same in every run. So their mean is that
/// over time, whatever else repeats. Where the period is twice as long, samples are every other one of those
/// before, so that samples of several measures coincide. *Regular* samples are for correlations in time:
/// windows of samples at multiples of an interval, by default an irrational one.
///
/// The interval never grows, since it is what resolves the motion; what grows is the period, from the start
/// of one window to that of the next. A schedule of the measure's own choice starts with one window after the
/// other. Work that takes kAllowance is free; it is spread over the doublings of the period after which
/// sampling takes no more than kShare of the run. If contacts become rarer than expected, as when a gas cools
/// or disperses, the period is doubled again.
class SamplingSchedule {
 public:
  /// The fraction of a run that one measure's samples may take [1].
  static constexpr double kShare = 0.0025;
  /// What they may take besides [ns]: of all measures together, some two seconds.
  static constexpr double kAllowance = 0.25e9;

  /// Never.
  SamplingSchedule() = default;

  /// At multiples of `interval` [T] since `begin`.
  static SamplingSchedule regular(const Time& begin, double interval);
  /// In windows of `window` samples, a power of two, `interval` apart [T], as often as the run can afford. A
  /// sample costs `sample_cost` [ns]. The first window begins at once unless it costs more than kAllowance.
  static SamplingSchedule regular(const Time& begin, double interval, std::int64_t window, double sample_cost,
                                  const Pace& pace);
  /// One sample in each `interval` [T] since `begin`.
  static SamplingSchedule scattered(const Time& begin, double interval);
  /// As often as the run can afford, but no more than one sample in each `interval` [T]. A sample costs
  /// `sample_cost` [ns].
  static SamplingSchedule scattered(const Time& begin, double interval, double sample_cost, const Pace& pace);

  /// Between the samples of a window [T].
  double interval() const { return interval_; }
  /// Between the beginnings of windows [T].
  double period() const { return static_cast<double>(period_) * interval_; }
  /// The next sampling time; kNever for one that never samples.
  Time next() const;
  /// Advances to the first sampling time after `now`; `contacts` is how many there were since the start.
  /// Returns how often the period has doubled: each sample now stands for that many times twice as much time
  /// as those before.
  int advance(const Time& now, std::uint64_t contacts);

 private:
  friend class Persistence;
  static void persist(auto& archive, auto& self) {
    archive(self.begin_, self.interval_, self.next_, self.contacts_wanted_, self.contacts_before_,
            self.windows_, self.window_, self.period_, self.windows_per_count_, self.is_scattered_);
  }
  bool restored() const;

  static constexpr std::int64_t kNoSample = -1;
  static constexpr std::int64_t kMinWindowsPerCount = 8;

  SamplingSchedule(const Time& begin, double interval, bool is_scattered);
  void spread(double sample_cost, const Pace& pace);
  std::int64_t scattered_in(std::int64_t period) const;
  std::int64_t first_from(std::int64_t next) const;
  void double_period();

  double begin_ = 0;
  double interval_ = 0;
  std::int64_t next_ = kNoSample;  // in intervals since the start
  std::int64_t window_ = 1;        // in intervals
  std::int64_t period_ = 1;        // in intervals
  double contacts_wanted_ = 0;     // for each window; zero if the period is not to change
  std::uint64_t contacts_before_ = 0;
  std::int64_t windows_ = 0;  // since the contacts were last counted
  std::int64_t windows_per_count_ = kMinWindowsPerCount;
  bool is_scattered_ = false;
};

/// The least power of two that is at least `length`. Precondition: it is positive and finite.
double power_of_two_from(double length);

/// The least product of a power of two and twice the golden ratio's inverse that is at least `length` [T]:
/// multiples of it come to all phases of anything whose period is a rational number, evenly. Precondition: as
/// for power_of_two_from().
double irrational_from(double length);

}  // namespace hardball
