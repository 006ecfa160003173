// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <vector>

#include "hardball/events/event_queue.hpp"

namespace hardball {

/// The paper's event tree: a balanced tree of all entries. Slower than CalendarQueue, and plainly right.
/// Cost: O(log n) per operation.
/// Source: Kim, Guibas and Shin (1997), section 2.
class OrderedQueue {
 public:
  void reset(std::size_t owners, Time start);
  void schedule(Owner owner, const Event& event);
  std::optional<Scheduled> least() const;
  void pop();

  QueueCounters counters() const { return counters_; }
  std::size_t memory_bytes() const;

 private:
  std::set<Scheduled> tree_;
  std::vector<Event> entry_of_;  // per owner; an event that does not happen stands for none
  QueueCounters counters_;
};

static_assert(EventQueue<OrderedQueue>);

}  // namespace hardball
