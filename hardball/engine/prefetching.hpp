// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "hardball/engine/forecast.hpp"
#include "hardball/events/event_queue.hpp"
#include "hardball/events/plan.hpp"

namespace hardball {

/// Prefetches what the next events need, as the calendar knows which spheres come next.
class Prefetching {
 public:
  /// To be called before every event. `observe` is called with contacts; observe.prefetch(slot), if it has
  /// that member, prefetches what it needs.
  template <class Queue, class Observe>
  void prefetch_ahead(const Forecast& forecast, const Queue& queue, const Observe& observe) {
    if constexpr (requires { queue.upcoming(0); }) {
      if (forecast.is_cached()) {
        prefetch_regions(forecast, queue, observe);
      } else {
        forecast.owned_phase().visit(
            [&](const auto& phase) { prefetch_in_stages(forecast, phase, queue, observe); });
      }
    }
  }

  /// To be called before predicting slots[i], if all are to be predicted in turn.
  static void prefetch_prediction(const Forecast& forecast, std::span<const Slot> slots, std::size_t i) {
    constexpr std::size_t kSphere = 6;
    constexpr std::size_t kLists = 4;
    constexpr std::size_t kCandidates = 2;
    if (forecast.is_cached()) return;
    const BroadPhase& phase = forecast.phase();
    if (i + kSphere < slots.size()) forecast.prefetch_sphere(slots[i + kSphere]);
    if (i + kLists < slots.size()) phase.prefetch_lists(slots[i + kLists], false);
    if (i + kCandidates < slots.size())
      phase.prefetch_candidates(slots[i + kCandidates], false, forecast.copies());
  }

 private:
  template <class Observe>
  static void prefetch_for(const Observe& observe, Slot slot) {
    if constexpr (requires { observe.prefetch(slot); }) observe.prefetch(slot);
  }

  // Even with few spheres, regions may have been evicted from L1.
  template <class Queue, class Observe>
  static void prefetch_regions(const Forecast& forecast, const Queue& queue, const Observe& observe) {
    constexpr std::size_t kAhead = 2;
    constexpr std::size_t kPlan = 5;
    if (const Owner later = queue.upcoming(kPlan); later != kNoOwner) forecast.prefetch_event(later);
    const Owner slot = queue.upcoming(kAhead);
    if (slot == kNoOwner) return;
    const Plan& plan = forecast.plan(slot);
    const Slot other = plan.has_partner() ? plan.partner() : slot;
    forecast.prefetch_sphere(slot);
    forecast.prefetch_sphere(other);
    prefetch_for(observe, slot);
    prefetch_for(observe, other);
  }

  // Each stage runs a few events before the next, whose addresses it loads.
  template <class Phase, class Queue, class Observe>
  void prefetch_in_stages(const Forecast& forecast, const Phase& phase, const Queue& queue,
                          const Observe& observe) {
    constexpr std::size_t kSphere = 9;
    constexpr std::size_t kPartner = 6;
    constexpr std::size_t kLists = 4;
    constexpr std::size_t kCandidates = 2;
    const bool is_new = bucket_seen_ != queue.current_bucket();
    bucket_seen_ = queue.current_bucket();
    // Visits the sphere whose event comes `ahead` events after the next; of a bucket just opened, all up to
    // it.
    const auto for_upcoming = [&queue, is_new](std::size_t ahead, auto&& visit) {
      for (std::size_t i = is_new ? 0 : ahead; i <= ahead; ++i) {
        if (const Owner slot = queue.upcoming(i); slot != kNoOwner) visit(slot);
      }
    };
    for_upcoming(kSphere, [&](Slot slot) { forecast.prefetch_sphere(slot); });
    for_upcoming(kPartner, [&](Slot slot) {
      const Plan& plan = forecast.plan(slot);
      if (plan.meets_first()) forecast.prefetch_sphere(plan.partner());
    });
    for_upcoming(kLists, [&](Slot slot) {
      const Plan& plan = forecast.plan(slot);
      phase.prefetch_lists(slot, plan.will_cross_first());
      if (!plan.will_cross_first()) prefetch_for(observe, slot);
      if (!plan.meets_first()) return;
      phase.prefetch_lists(plan.partner(), false);
      prefetch_for(observe, plan.partner());
    });
    for_upcoming(kCandidates, [&](Slot slot) {
      const Plan& plan = forecast.plan(slot);
      phase.prefetch_candidates(slot, plan.will_cross_first(), forecast.copies());
      if (plan.meets_first()) phase.prefetch_candidates(plan.partner(), false, forecast.copies());
    });
  }

  std::int64_t bucket_seen_ = -1;  // the last for which data has been prefetched
};

}  // namespace hardball
