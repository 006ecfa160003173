// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "hardball/events/event_queue.hpp"

namespace hardball {

/// The production queue: a year of equal days, each an unsorted list, sorted only when it becomes today.
///
/// Replacing an entry leaves the old one where it lies, dead; the serial number of the owner's latest entry
/// tells. Entries beyond the year wait aside. When the year is over, the next one is laid out so that its
/// days hold a few entries each, whatever the rate of events has become. Entries that arrive for today go to
/// a small heap beside the sorted list. Cost: O(1) amortised per operation as long as rates change slowly;
/// never worse than O(log n) plus a sort. Source: Brown, Comm. ACM 31 (1988) 1220; Paul, J. Comput. Phys. 221
/// (2007) 615.
class CalendarQueue {
 public:
  void reset(std::size_t owners, Time start);
  void schedule(Owner owner, const Event& event);
  std::optional<Scheduled> least();
  void pop();

  QueueCounters counters() const { return counters_; }
  std::size_t memory_bytes() const;

 private:
  struct Entry {
    Scheduled scheduled;
    std::uint32_t serial;
  };
  using Entries = std::vector<Entry>;

  static bool comes_later(const Entry& a, const Entry& b) { return b.scheduled < a.scheduled; }

  bool is_live(const Entry& entry) const { return entry.serial == serial_of_[entry.scheduled.owner]; }
  std::size_t day_of(const Time& time) const;
  void file(const Entry& entry);
  void drop_dead(Entries& entries);
  void drop_dead_today();
  void begin_day();
  bool begin_year();
  void sweep();

  std::vector<std::uint32_t> serial_of_;  // per owner: the serial number of its latest entry
  std::vector<Entries> days_;             // the first day_count_ of them make the year
  Entries today_sorted_;                  // latest first, so that the least is at the back
  Entries today_heap_;                    // arrived today; std::push_heap order, the least in front
  Entries beyond_;                        // after the end of the year
  Time year_start_;
  double days_per_time_ = 0;  // [1/T]
  std::size_t day_count_ = 0;
  std::size_t today_ = 0;
  std::size_t entry_count_ = 0;  // live and dead
  QueueCounters counters_;
};

static_assert(EventQueue<CalendarQueue>);

}  // namespace hardball
