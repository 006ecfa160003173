// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hardball/tuning/moments.hpp"

namespace hardball {

/// What a run is expected to cost, and how fast it evolves, by kinetic theory. Costs are those of one core at
/// 2.8 GHz; nothing is timed, so that a scenario is measured identically everywhere.
struct Pace {
  double free_time;     ///< Mean time between the collisions of a sphere, or in which it crosses the box [T].
  double cost;          ///< Of the run for each unit of time [ns/T].
  double contact_cost;  ///< Of the run for each contact [ns].
};

Pace expected_pace(const Moments& moments);

/// The times at which a measure is given the world: multiples of an interval after the start.
///
/// An interval of the measure's own choice is a power of two, so that its multiples are exact and those of
/// several measures coincide, and so long that sampling takes no more than kShare of the run. If contacts
/// become rarer than expected, as when a gas cools or disperses, the interval is doubled.
class Cadence {
 public:
  /// The fraction of a run that one measure's samples may take [1].
  static constexpr double kShare = 0.0025;

  /// Never.
  Cadence() = default;
  /// Every `interval` [T] from `begin` on, as the user asked.
  Cadence(const Time& begin, double interval) : begin_(begin.value()), interval_(interval), next_(0) {}
  /// Of its own choice: no more often than every `finest` [T]. A sample costs `sample_cost` [ns]; the first
  /// is taken at once unless it must wait until the run can afford it.
  Cadence(const Time& begin, double finest, double sample_cost, const Pace& pace);

  double interval() const { return interval_; }
  /// The next sampling time; kNever for one that never samples.
  Time next() const;
  /// Advances to the first sampling time after `now`; `contacts` is how many there were since the start.
  void advance(const Time& now, std::uint64_t contacts);

 private:
  friend class Persistence;
  static void persist(auto& archive, auto& self) {
    archive(self.begin_, self.interval_, self.next_, self.contacts_wanted_, self.contacts_before_,
            self.samples_);
  }
  bool restored() const;

  static constexpr std::int64_t kNoSample = -1;

  double begin_ = 0;
  double interval_ = 0;
  std::int64_t next_ = kNoSample;  // in intervals since the start
  double contacts_wanted_ = 0;     // for each sample; zero if the interval is not to change
  std::uint64_t contacts_before_ = 0;
  int samples_ = 0;  // since the contacts were last counted
};

/// The least power of two that is at least `length`. Precondition: it is positive and finite.
double power_of_two_from(double length);

}  // namespace hardball
