// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "hardball/events/event.hpp"

namespace hardball {

/// Who an entry of the queue belongs to: a number below the owner count given to `reset`.
using Owner = std::uint32_t;

/// An event in the queue and its owner.
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
  std::uint64_t taken = 0;      ///< Entries taken out, live or not.
};

/// A queue with at most one entry for each owner, from which the least comes first.
///
/// - `reset(n, start)` empties it for owners 0..n-1 and events not before `start`.
/// - `schedule(owner, event)` replaces the owner's entry; an event that does not happen removes it.
/// - `least()` is the least entry, or nothing; it may rearrange the queue within.
/// - `pop()` removes the entry that `least()` has just shown.
template <class Queue>
concept EventQueue = requires(Queue queue, const Queue& view, std::size_t owners, Time start, Owner owner,
                              const Event& event) {
  queue.reset(owners, start);
  queue.schedule(owner, event);
  { queue.least() } -> std::same_as<std::optional<Scheduled>>;
  queue.pop();
  { view.counters() } -> std::convertible_to<QueueCounters>;
  { view.memory_bytes() } -> std::convertible_to<std::size_t>;
};

}  // namespace hardball
