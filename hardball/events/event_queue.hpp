// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "hardball/events/event.hpp"

namespace hardball {

/// Who an entry of the queue belongs to: a number below the owner count given to `reset`.
using Owner = std::uint32_t;

/// No owner. Not std::optional: it is written in two parts and read as one, for which the processor waits.
inline constexpr Owner kNobody = std::numeric_limits<Owner>::max();

/// Knows the event that is scheduled for each owner, so that a queue need keep no more than its time.
///
/// - `event(owner)` is that event, perhaps one that does not happen.
/// - `time(owner)` is its time.
///
/// - `prefetch_event(owner)`, if there is one, asks for the memory of both, which will be needed soon. With
///   it comes `is_cached()`: whether there is no need for that.
///
/// - `share_event(a, b)`, if there is one, may tell of two owners whose events have one time, to the nearest
///   double, that they are one event, as those of two spheres that are to meet.
///
/// Between two calls of `schedule` for an owner its event may become a lesser one at the same time; the queue
/// shows it no later than the one that was scheduled.
template <class A>
concept Agenda = requires(const A& agenda, Owner owner) {
  { agenda.event(owner) } -> std::same_as<Event>;
  { agenda.time(owner) } -> std::same_as<Time>;
};

/// Whether two owners of the same time are known to have one event: then either may stand for both.
template <Agenda A>
bool share_event(const A& agenda, Owner a, Owner b) {
  if constexpr (requires { agenda.share_event(a, b); }) {
    return agenda.share_event(a, b);
  } else {
    return false;
  }
}

/// An event and its owner.
struct Scheduled {
  Event event;
  Owner owner = 0;

  friend bool operator==(const Scheduled&, const Scheduled&) = default;
  /// The order of events; the owner only tells apart two entries of one event.
  friend std::partial_ordering operator<=>(const Scheduled&, const Scheduled&) = default;
};

/// What a queue has done since `reset`.
struct QueueCounters {
  std::uint64_t scheduled = 0;  ///< Entries put in.
  std::uint64_t taken = 0;      ///< Entries taken out, dead ones included.
};

/// An agenda of which nothing is known but what it must be able to tell.
struct AnyAgenda {
  Event event(Owner) const;
  Time time(Owner) const;
};

/// A queue with at most one event for each owner, from which the least comes first. The events themselves
/// stand in an agenda, always the same one.
///
/// - `reset(n, start)` empties it for owners 0..n-1 and events not before `start`.
/// - `schedule(owner, agenda)`: the agenda has another event for the owner, perhaps one that does not happen.
/// - `least(agenda)` is the owner of the least event, or kNobody; it may rearrange the queue within.
/// - `pop()` removes the event that `least()` has just shown; its owner has none until the next `schedule`,
///   before which the agenda must not show it any more.
template <class Queue>
concept EventQueue = requires(Queue queue, const Queue& view, std::size_t owners, Time start, Owner owner,
                              AnyAgenda agenda) {
  queue.reset(owners, start);
  queue.schedule(owner, agenda);
  { queue.least(agenda) } -> std::same_as<Owner>;
  queue.pop();
  { view.counters() } -> std::convertible_to<QueueCounters>;
  { view.memory_bytes() } -> std::convertible_to<std::size_t>;
};

}  // namespace hardball
