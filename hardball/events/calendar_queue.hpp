// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/events/event_queue.hpp"
#include "hardball/memory/huge_pages.hpp"
#include "hardball/memory/prefetch.hpp"

namespace hardball {

/// The production queue: a ring of equal days, each an unsorted list, sorted only when it becomes today.
///
/// An entry is a time and an owner. Replacing an event leaves the old entry where it lies, dead: its owner
/// has another time. Entries for today go to a small heap beside the sorted list, entries beyond the ring
/// wait aside until it comes round. Entries at one and the same time, to the nearest double, meet in the
/// heap, which alone knows the whole order of events. When days turn out too full or too empty, they are laid
/// out anew. Cost: O(1) amortised per operation as long as rates change slowly; never worse than O(log n)
/// plus a sort. Source: Brown, Comm. ACM 31 (1988) 1220; Paul, J. Comput. Phys. 221 (2007) 615.
class CalendarQueue {
 public:
  void reset(std::size_t owners, Time start);

  template <Agenda A>
  void schedule(Owner owner, const A& agenda) {
    const double time = agenda.time(owner).high;
    current_[owner] = time;
    if (!(time < std::numeric_limits<double>::infinity())) return;
    ++counters_.scheduled;
    const double before = days_before(time);
    if (before < static_cast<double>(today_)) {
      put_late(owner, agenda);
    } else if (before + 1 >= static_cast<double>(today_ + days_in_ring())) {
      beyond_.push_back({time, owner});
    } else if (is_cached(agenda)) {
      file({time, owner}, day(day_after(before)));
    } else {
      file_soon({time, owner}, day_after(before));
    }
    if (entry_count() > kEntriesPerOwner * owner_count_ + kEntriesAlways) lay_out();
  }

  template <Agenda A>
  Owner least(const A& agenda) {
    for (;;) {
      for (; !sorted_.empty() && is_dead(sorted_.back()); sorted_.pop_back()) ++counters_.taken;
      if (!late_.empty()) drop_dead_late(agenda);
      if (sorted_.empty()) {
        if (!late_.empty()) return late_.front().owner;
        if (!begin_day(agenda)) return kNobody;
        continue;
      }
      const double moment = sorted_.back().time;
      if (!late_.empty() && late_.front().event.time.high < moment) return late_.front().owner;
      const bool has_twin = (!late_.empty() && late_.front().event.time.high == moment) ||
                            (sorted_.size() > 1 && sorted_[sorted_.size() - 2].time == moment);
      if (!has_twin || is_shared(agenda)) return sorted_.back().owner;
      for (; !sorted_.empty() && sorted_.back().time == moment; sorted_.pop_back()) {
        if (is_dead(sorted_.back())) {
          ++counters_.taken;
        } else {
          put_late(sorted_.back().owner, agenda);
        }
      }
    }
  }

  void pop() {
    HARDBALL_CHECK(!sorted_.empty() || !late_.empty());
    const bool from_late =
        sorted_.empty() || (!late_.empty() && late_.front().event.time.high < sorted_.back().time);
    current_[from_late ? late_.front().owner : sorted_.back().owner] = kNever.high;
    if (from_late) {
      std::pop_heap(late_.begin(), late_.end(), comes_later);
      late_.pop_back();
    } else {
      sorted_.pop_back();
    }
    ++counters_.taken;
  }

  /// The owner of an entry that comes about `ahead` events after the least; kNobody if today has no more.
  Owner upcoming(std::size_t ahead) const {
    return ahead < sorted_.size() ? sorted_[sorted_.size() - 1 - ahead].owner : kNobody;
  }

  QueueCounters counters() const { return counters_; }
  std::size_t memory_bytes() const;

 private:
  struct Entry {
    double time;
    Owner owner;
  };
  // Without the gap behind the owner.
  struct PackedEntry {
    std::array<std::uint32_t, 2> time;
    Owner owner;
  };
  static PackedEntry pack(const Entry& entry) {
    return {std::bit_cast<std::array<std::uint32_t, 2>>(entry.time), entry.owner};
  }
  static Entry unpack(const PackedEntry& entry) { return {std::bit_cast<double>(entry.time), entry.owner}; }
  // Two cache lines of entries; fuller days chain several.
  struct Block {
    static constexpr std::uint32_t kRoom = 10;
    std::array<PackedEntry, kRoom> entries;
    std::uint32_t next;
  };
  // The last block of a day is the one with room.
  struct Day {
    std::uint32_t last_block = kNone;
    std::uint32_t count = 0;
  };
  static constexpr std::uint32_t kNone = UINT32_MAX;
  static constexpr std::size_t kUnfiled = 8;
  // Dead entries are swept out when they outnumber the owners by this factor.
  static constexpr std::size_t kEntriesPerOwner = 4;
  static constexpr std::size_t kEntriesAlways = 64;

  static bool comes_later(const Scheduled& a, const Scheduled& b) { return b < a; }

  // Of an entry that waits until it is filed.
  struct Unfiled {
    Entry entry;
    std::int64_t day = 0;
  };

  // Days are counted from one. Uses the leading part of the time alone: rounding then keeps the order of
  // times.
  double days_before(double time) const { return std::max(0.0, (time - origin_) * days_per_time_); }
  static std::int64_t day_after(double days) { return static_cast<std::int64_t>(days) + 1; }
  std::int64_t days_in_ring() const { return static_cast<std::int64_t>(days_.size()); }
  Day& day(std::int64_t number) { return days_[static_cast<std::size_t>(number) & (days_.size() - 1)]; }
  // Live and dead.
  std::size_t entry_count() const { return counters_.scheduled - counters_.taken; }
  bool is_dead(const Entry& entry) const { return current_[entry.owner] != entry.time; }

  template <Agenda A>
  static bool is_cached([[maybe_unused]] const A& agenda) {
    if constexpr (requires { agenda.is_cached(); }) {
      return agenda.is_cached();
    } else {
      return false;
    }
  }

  template <Agenda A>
  void put_late(Owner owner, const A& agenda) {
    late_.push_back({agenda.event(owner), owner});
    std::push_heap(late_.begin(), late_.end(), comes_later);
  }

  // Whether the least two entries, and no others, are of its moment, and stand for one event.
  template <Agenda A>
  bool is_shared(const A& agenda) const {
    const double moment = sorted_.back().time;
    const std::size_t size = sorted_.size();
    if (!late_.empty() && late_.front().event.time.high == moment) return false;
    if (size > 2 && sorted_[size - 3].time == moment) return false;
    const Owner twin = sorted_[size - 2].owner;
    return current_[twin] == moment && share_event(agenda, sorted_.back().owner, twin);
  }

  template <Agenda A>
  void drop_dead_late(const A& agenda) {
    while (!late_.empty()) {
      const Owner owner = late_.front().owner;
      const bool is_dead = agenda.time(owner) != late_.front().event.time;
      if (!is_dead && agenda.event(owner) == late_.front().event) return;
      std::pop_heap(late_.begin(), late_.end(), comes_later);
      late_.pop_back();
      if (is_dead) {
        ++counters_.taken;
      } else {
        put_late(owner, agenda);  // another event at the same moment
      }
    }
  }

  // Makes the next day with entries today; false if there is none.
  template <Agenda A>
  bool begin_day(const A& agenda) {
    file_all();
    for (;;) {
      if (filed_count_ == 0) {
        if (beyond_.empty()) return false;
        lay_out();
        if (filed_count_ == 0) return false;
      }
      if (++today_ == year_end_ && !turn_year()) {
        lay_out();
        continue;
      }
      if (day(today_).count == 0) continue;
      sort_today();
      prefetch_tomorrow(agenda);
      return true;
    }
  }

  // Asks for the events of the next day's entries, and one day earlier for what tells the dead among them.
  template <Agenda A>
  void prefetch_tomorrow([[maybe_unused]] const A& agenda) {
    if constexpr (requires { agenda.prefetch_event(Owner{}); }) {
      if (is_cached(agenda)) return;
      for_each_filed(day(today_ + 2), [this](const Entry& entry) { prefetch(&current_[entry.owner]); });
      for_each_filed(day(today_ + 1), [&](const Entry& entry) {
        if (!is_dead(entry)) agenda.prefetch_event(entry.owner);
      });
    }
  }

  template <class Visit>
  void for_each_filed(const Day& day, Visit&& visit) const {
    if (day.count == 0) return;
    std::uint32_t in_block = (day.count - 1) % Block::kRoom + 1;
    for (std::uint32_t b = day.last_block; b != kNone; b = blocks_[b].next) {
      for (std::uint32_t i = 0; i < in_block; ++i) visit(unpack(blocks_[b].entries[i]));
      in_block = Block::kRoom;
    }
  }

  void file(const Entry& entry, Day& day) {
    const std::uint32_t place = day.count++ % Block::kRoom;
    if (place == 0) day.last_block = new_block(day.last_block);
    blocks_[day.last_block].entries[place] = pack(entry);
    ++filed_count_;
  }

  // Days lie all over the memory: an entry is filed some entries later, when the memory asked for has come.
  void file_soon(const Entry& entry, std::int64_t number) {
    Unfiled& place = unfiled_[unfiled_count_ % kUnfiled];
    if (unfiled_count_ >= kUnfiled) file(place.entry, day(place.day));
    place = {entry, number};
    prefetch(&day(number));
    if (unfiled_count_ >= kUnfiled / 2) {
      const Day& sooner = day(unfiled_[(unfiled_count_ - kUnfiled / 2) % kUnfiled].day);
      if (sooner.last_block != kNone) {
        prefetch(&blocks_[sooner.last_block].entries[sooner.count % Block::kRoom]);
      }
    }
    ++unfiled_count_;
  }

  void file_all();
  void file_or_wait(const Entry& entry);
  void sort_today();
  void take_day(std::vector<Entry>& entries);
  void empty_today();
  bool turn_year();
  void drop_dead(std::vector<Entry>& entries);
  void lay_out();
  void gather();
  void drop_twins();
  void spread_out();
  std::uint32_t new_block(std::uint32_t next);

  std::size_t owner_count_ = 0;
  LargeVector<double> current_;  // by owner: the time of its event, to the nearest double; kNever if none
  std::array<Unfiled, kUnfiled> unfiled_{};  // a ring: the last of all entries that went through it
  std::size_t unfiled_count_ = 0;            // of those since all were filed
  std::vector<Entry> sorted_;                // today's, latest first, so that the least is at the back
  std::vector<Scheduled>
      late_;               // filed for today when it had begun; std::push_heap order, the least in front
  std::vector<Day> days_;  // a ring, a power of two
  LargeVector<Block> blocks_;
  std::uint32_t free_block_ = kNone;
  std::vector<Entry> beyond_;  // after the end of the ring
  double origin_ = 0;
  double days_per_time_ = 0;  // [1/T]
  std::int64_t today_ = 0;
  std::int64_t year_end_ = 0;
  std::size_t filed_count_ = 0;  // those in days after today
  std::uint64_t taken_in_year_ = 0;
  QueueCounters counters_;
};

static_assert(EventQueue<CalendarQueue>);

}  // namespace hardball
