// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hardball/interaction/contact.hpp"

namespace hardball::bench {

/// How long two spheres would overlap after this collision if both continued in a straight line [T]; infinite
/// if they are at relative rest.
double overlap_duration(const Contact& contact);

/// Whether a check for overlaps at the times k * `step` [T], k an integer, finds an overlap that starts at
/// `begin` [T] and lasts for `duration` [T].
bool is_seen(double begin, double duration, double step);

/// The fraction of collisions that such checks miss in a gas in equilibrium [1]; `advance` is the distance
/// that two spheres cover in a step at the most probable relative speed, over the sum of their radii [1].
/// Source: kinetic theory; relative speeds of colliding pairs are distributed as u^3 exp(-u^2), and squared
/// impact parameters uniformly.
double expected_missed_share(double advance);

/// Counts the collisions that checks at intervals of several steps miss.
class MissedCounter {
 public:
  /// The steps [T].
  explicit MissedCounter(std::vector<double> steps) : steps_(std::move(steps)), missed_(steps_.size()) {}

  void record(const Contact& contact);
  void add(const MissedCounter& other);

  std::uint64_t collisions() const { return collisions_; }
  /// The number of collisions missed by each step.
  std::span<const std::uint64_t> missed() const { return missed_; }
  /// Missed over all collisions [1].
  double share(std::size_t step) const {
    return static_cast<double>(missed_[step]) / static_cast<double>(collisions_);
  }

 private:
  std::vector<double> steps_;
  std::vector<std::uint64_t> missed_;
  std::uint64_t collisions_ = 0;
};

}  // namespace hardball::bench
