// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/events/event_queue.hpp"

namespace hardball::support {

/// The paper's event tree: a balanced tree of all entries, the slow twin of CalendarQueue.
/// Cost: O(log n) per operation.
/// Source: Kim, Guibas and Shin (1997), section 2.
class OrderedQueue {
 public:
  void reset(std::size_t owners, Time) {
    tree_.clear();
    entry_of_.assign(owners, Event{});
    counters_ = {};
  }

  void add_owner(Owner owner) {
    if (owner >= entry_of_.size()) entry_of_.resize(std::size_t{owner} + 1);
  }

  template <EventTable Table>
  void schedule(Owner owner, const Table& table) {
    Event& entry = entry_of_[owner];
    if (entry.happens()) tree_.erase({entry, owner});
    entry = table.event(owner);
    if (!entry.happens()) return;
    tree_.insert({entry, owner});
    ++counters_.scheduled;
  }

  template <EventTable Table>
  Owner least(const Table&) const {
    return tree_.empty() ? kNoOwner : tree_.begin()->owner;
  }

  void pop() {
    HARDBALL_CHECK(!tree_.empty());
    entry_of_[tree_.begin()->owner] = Event{};
    tree_.erase(tree_.begin());
    ++counters_.taken;
  }

  QueueCounters counters() const { return counters_; }

  std::size_t memory_bytes() const {
    constexpr std::size_t kTreeLinks = 4 * sizeof(void*);
    return tree_.size() * (sizeof(Scheduled) + kTreeLinks) + entry_of_.capacity() * sizeof(Event);
  }

 private:
  std::set<Scheduled> tree_;
  std::vector<Event> entry_of_;  // per owner; an event that does not happen if none
  QueueCounters counters_;
};

static_assert(EventQueue<OrderedQueue>);

}  // namespace hardball::support
