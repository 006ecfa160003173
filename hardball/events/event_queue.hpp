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

/// The owner of a queue entry: a number below the owner count given to `reset`.
using Owner = std::uint32_t;

/// No owner. Not std::optional, which is written in two parts and read as one: a store-forwarding stall.
inline constexpr Owner kNoOwner = std::numeric_limits<Owner>::max();

/// An entry of a queue.
struct QueueEntry {
  double time = 0;  ///< Time of the owner's event, to the nearest double [T].
  Owner owner = 0;
};

/// Holds the event scheduled for each owner, so that a queue need store only its time.
///
/// - `event(owner)` is that event, perhaps one that does not happen.
/// - `time(owner)` is its time to the nearest double [T], infinite if it does not happen.
/// - `prefetch_event(owner)`, optional, prefetches both. With it comes `is_cached()`: whether prefetching is
///   needless.
/// - `share_event(a, b)`, optional, may report that two owners with the same time have the same event, as two
///   spheres do that will collide with each other.
/// - `refine(entries)`, optional, may postpone the events of a span of entries that come next, and updates
///   their times. With it comes `prefetch_refinement(owner)`.
///
/// Between two calls of `schedule` for an owner, its event may become a lesser one at the same time; the
/// queue returns it no later than the one that was scheduled.
template <class Table>
concept EventTable = requires(const Table& table, Owner owner) {
  { table.event(owner) } -> std::same_as<Event>;
  { table.time(owner) } -> std::same_as<double>;
};

/// Whether two owners of the same time are known to share one event: then either may stand for both.
template <EventTable Table>
bool share_event(const Table& table, Owner a, Owner b) {
  if constexpr (requires { table.share_event(a, b); }) {
    return table.share_event(a, b);
  } else {
    return false;
  }
}

/// An event and its owner.
struct Scheduled {
  Event event;
  Owner owner = 0;

  friend bool operator==(const Scheduled&, const Scheduled&) = default;
  /// The order of events; the owner only distinguishes two entries of one event.
  friend std::partial_ordering operator<=>(const Scheduled&, const Scheduled&) = default;
};

/// What a queue has done since `reset`.
struct QueueCounters {
  std::uint64_t scheduled = 0;  ///< Entries inserted.
  std::uint64_t taken = 0;      ///< Entries removed, dead ones included.
};

/// The minimal event table, for stating the concept EventQueue.
struct AnyEventTable {
  Event event(Owner) const;
  double time(Owner) const;
};

/// A priority queue with at most one event per owner, least first. The events themselves are in an event
/// table, always the same one.
///
/// - `reset(n, start)` empties it for owners 0..n-1 and events not before `start`.
/// - `add_owner(owner)`: there are events of this owner, too.
/// - `schedule(owner, table)`: the owner's event in the table has changed, perhaps to one that does not
///   happen.
/// - `least(table)` is the owner of the least event, or kNoOwner; it may rearrange the queue internally.
/// - `go_back(time, table)`, optional: events may be earlier than those it has shown, but none is before
/// `time`
///   [T]. It only makes these as cheap as others.
/// - `pop()` removes the event that `least()` has just returned; its owner has none until the next
///   `schedule`, by which time the table must no longer hold it.
template <class Queue>
concept EventQueue = requires(Queue queue, const Queue& view, std::size_t owners, Time start, Owner owner,
                              AnyEventTable table) {
  queue.reset(owners, start);
  queue.add_owner(owner);
  queue.schedule(owner, table);
  { queue.least(table) } -> std::same_as<Owner>;
  queue.pop();
  { view.counters() } -> std::convertible_to<QueueCounters>;
  { view.memory_bytes() } -> std::convertible_to<std::size_t>;
};

}  // namespace hardball
