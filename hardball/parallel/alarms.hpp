// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "hardball/events/event.hpp"
#include "hardball/geometry/time.hpp"

namespace hardball {

/// When spheres must be looked at, up to a horizon: in buckets of time, unsorted. Cost: O(1) for each.
class Alarms {
 public:
  /// The sphere, if its path began then, must be looked at.
  struct Alarm {
    double time = 0;  ///< [T]
    SphereId sphere = 0;
    Slot slot = 0;  ///< Where it was stored.
    Time path;
  };

  double horizon() const { return horizon_; }
  /// Forgets all, and begins again at `now`, with another horizon [T].
  void restart(double now, double horizon) {
    begin_ = now;
    horizon_ = horizon;
    buckets_per_time_ = std::min(kBuckets / (horizon - now), std::numeric_limits<double>::max());
    first_ = kBuckets - 1;
    for (std::vector<Alarm>& bucket : buckets_) bucket.clear();
  }
  /// Precondition: it is not beyond the horizon, and not before the start.
  void set(const Alarm& alarm) {
    const std::size_t bucket = bucket_of(alarm.time);
    first_ = std::min(first_, bucket);
    buckets_[bucket].push_back(alarm);
  }
  /// Takes those up to a time, in any order, and appends them to a list.
  void take(double until, std::vector<Alarm>& taken) {
    for (const std::size_t last = bucket_of(until); first_ <= last; ++first_) {
      std::vector<Alarm>& bucket = buckets_[first_];
      const auto later = std::partition(bucket.begin(), bucket.end(),
                                        [until](const Alarm& alarm) { return alarm.time <= until; });
      taken.insert(taken.end(), bucket.begin(), later);
      bucket.erase(bucket.begin(), later);
      if (first_ == last) return;
    }
  }

  std::size_t memory_bytes() const {
    std::size_t count = 0;
    for (const std::vector<Alarm>& bucket : buckets_) count += bucket.capacity();
    return count * sizeof(Alarm);
  }

 private:
  static constexpr std::size_t kBuckets = 256;

  std::size_t bucket_of(double time) const {
    constexpr double kLast = kBuckets - 1;
    return static_cast<std::size_t>(std::clamp((time - begin_) * buckets_per_time_, 0.0, kLast));
  }

  double begin_ = 0;
  double horizon_ = std::numeric_limits<double>::infinity();
  double buckets_per_time_ = 0;
  std::size_t first_ = kBuckets - 1;  // those before it are empty
  std::array<std::vector<Alarm>, kBuckets> buckets_;
};

}  // namespace hardball
