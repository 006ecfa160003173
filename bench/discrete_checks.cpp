// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "bench/discrete_checks.hpp"

#include <cmath>

namespace hardball::bench {

double overlap_duration(const Contact& contact) {
  // The second root of |separation + velocity * s| = reach; the first is the contact itself, s = 0.
  const Vec3 velocity = contact.before.second - contact.before.first;
  return 2 * contact.reach * contact.impact_speed() / dot(velocity, velocity);
}

bool is_seen(double begin, double duration, double step) {
  return std::ceil(begin / step) * step < begin + duration;
}

double expected_missed_share(double advance) {
  constexpr int kIntervals = 4000;
  constexpr double kFastest = 6;
  constexpr double kWidth = kFastest / kIntervals;
  double share = 0;
  for (int i = 0; i < kIntervals; ++i) {
    const double u = (i + 0.5) * kWidth;
    // Lengths in units of twice the sum of the radii: of overlaps along a chord c, checks `passed` apart miss
    // the fraction 1 - c / passed, if positive; c^2 is uniform between 0 and 1.
    const double passed = u * advance / 2;
    const double missed = passed < 1 ? passed * passed / 3 : 1 - 2 / (3 * passed);
    share += missed * 2 * u * u * u * std::exp(-u * u) * kWidth;
  }
  return share;
}

void MissedCounter::record(const Contact& contact) {
  if (!contact.is_collision()) return;
  ++collisions_;
  const double duration = overlap_duration(contact);
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    if (!is_seen(contact.time.value(), duration, steps_[i])) ++missed_[i];
  }
}

void MissedCounter::add(const MissedCounter& other) {
  collisions_ += other.collisions_;
  for (std::size_t i = 0; i < missed_.size(); ++i) missed_[i] += other.missed_[i];
}

}  // namespace hardball::bench
