// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/events/ordered_queue.hpp"

#include "hardball/errors/error.hpp"

namespace hardball {

void OrderedQueue::reset(std::size_t owners, Time) {
  tree_.clear();
  entry_of_.assign(owners, Event{});
  counters_ = {};
}

void OrderedQueue::schedule(Owner owner, const Event& event) {
  Event& entry = entry_of_[owner];
  if (entry.happens()) tree_.erase({entry, owner});
  entry = event;
  if (!event.happens()) return;
  tree_.insert({event, owner});
  ++counters_.scheduled;
}

std::optional<Scheduled> OrderedQueue::least() const {
  if (tree_.empty()) return std::nullopt;
  return *tree_.begin();
}

void OrderedQueue::pop() {
  HARDBALL_CHECK(!tree_.empty());
  entry_of_[tree_.begin()->owner] = Event{};
  tree_.erase(tree_.begin());
  ++counters_.taken;
}

std::size_t OrderedQueue::memory_bytes() const {
  constexpr std::size_t kTreeLinks = 4 * sizeof(void*);
  return tree_.size() * (sizeof(Scheduled) + kTreeLinks) + entry_of_.capacity() * sizeof(Event);
}

}  // namespace hardball
