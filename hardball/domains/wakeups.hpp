// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "hardball/events/event.hpp"
#include "hardball/geometry/time.hpp"
#include "hardball/memory/prefetch.hpp"
#include "hardball/standard/ranges.hpp"

namespace hardball {

/// When spheres must be looked at, by the slots in which they are stored, up to a horizon: in buckets of
/// time, unsorted. Cost: O(1) for each.
///
/// A sphere that has a wakeup does not get a later one. When it is due, the sphere may be on another path, or
/// another sphere in its slot: whoever is there is looked at, and gets the wakeup that it needs. So not
/// every contact sets one.
class Wakeups {
 public:
  struct Wakeup {
    double time = 0;  ///< [T]
    Slot slot = 0;
    Time path;  ///< When the path began for which the wakeup was set.
  };

  /// Up to which wakeups are set [T]; minus infinity before the first `restart`.
  double horizon() const { return horizon_; }
  /// Forgets all, and begins again at `now`, with another horizon [T].
  void restart(double now, double horizon) {
    begin_ = now;
    horizon_ = horizon;
    buckets_per_time_ = std::min(kBuckets / (horizon - now), std::numeric_limits<double>::max());
    first_ = kBuckets - 1;
    for (std::vector<Wakeup>& bucket : buckets_) bucket.clear();
    ranges::fill(standing_, kNone);
  }
  /// Sets a wakeup, unless the slot has an earlier one. Precondition: it is not beyond the horizon, and not
  /// before the start.
  void set(const Wakeup& wakeup) {
    const std::size_t bucket = bucket_of(wakeup.time);
    if (wakeup.slot >= standing_.size()) standing_.resize(wakeup.slot + 1, kNone);
    std::uint8_t& standing = standing_[wakeup.slot];
    if (bucket > standing) return;
    standing = static_cast<std::uint8_t>(bucket);
    first_ = std::min(first_, bucket);
    buckets_[bucket].push_back(wakeup);
  }
  /// Prefetches what `set` needs. The slot need not be in use.
  void prefetch(Slot slot) const { hardball::prefetch(standing_.data() + slot); }
  /// Takes those up to a time, in any order, and appends them to a list. Their slots have no wakeup then.
  void take(double until, std::vector<Wakeup>& taken) {
    for (const std::size_t last = bucket_of(until); first_ <= last; ++first_) {
      std::vector<Wakeup>& bucket = buckets_[first_];
      const auto later = std::partition(bucket.begin(), bucket.end(),
                                        [until](const Wakeup& wakeup) { return wakeup.time <= until; });
      for (auto wakeup = bucket.begin(); wakeup != later; ++wakeup) {
        std::uint8_t& standing = standing_[wakeup->slot];
        if (standing != first_) continue;  // the slot has had an earlier one
        standing = kNone;
        taken.push_back(*wakeup);
      }
      bucket.erase(bucket.begin(), later);
      if (first_ == last) return;
    }
  }

  std::size_t memory_bytes() const {
    std::size_t count = 0;
    for (const std::vector<Wakeup>& bucket : buckets_) count += bucket.capacity();
    return count * sizeof(Wakeup) + standing_.capacity();
  }

 private:
  // Few, so that the ends of all are in the cache.
  static constexpr std::size_t kBuckets = 128;
  static constexpr std::uint8_t kNone = 0xff;

  std::size_t bucket_of(double time) const {
    constexpr double kLast = kBuckets - 1;
    return static_cast<std::size_t>(std::clamp((time - begin_) * buckets_per_time_, 0.0, kLast));
  }

  double begin_ = 0;
  double horizon_ = -std::numeric_limits<double>::infinity();  // none before the first start
  double buckets_per_time_ = 0;
  std::size_t first_ = kBuckets - 1;  // those before it are empty
  std::array<std::vector<Wakeup>, kBuckets> buckets_;
  std::vector<std::uint8_t> standing_;  // by slot, the bucket of the first wakeup
};

}  // namespace hardball
