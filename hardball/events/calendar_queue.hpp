// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/events/event_queue.hpp"
#include "hardball/geometry/inlining.hpp"
#include "hardball/memory/huge_pages.hpp"
#include "hardball/memory/prefetch.hpp"

namespace hardball {

/// The production queue, a calendar queue: a ring of equal time buckets, each an unsorted list that is sorted
/// only when it becomes current.
///
/// An entry is just an owner: its time is in the event table. Replacing an event leaves the old entry in
/// place, dead: the owner's time belongs to another bucket. Entries for the current bucket go to a small heap
/// beside the sorted list, those beyond the ring to an overflow list until the ring comes round. Entries
/// whose times agree to the nearest double are ordered in the heap, which compares whole events. When buckets
/// become too full or too empty, the ring is resized. Cost: O(1) amortized per operation as long as rates
/// change slowly; never worse than O(log n) plus a sort. Source: Brown, Comm. ACM 31 (1988) 1220; Paul, J.
/// Comput. Phys. 221 (2007) 615.
class CalendarQueue {
 public:
  void reset(std::size_t owners, Time start);
  void add_owner(Owner owner) { owner_count_ = std::max(owner_count_, std::size_t{owner} + 1); }

  template <EventTable Table>
  void schedule(Owner owner, const Table& table) {
    const double time = table.time(owner);
    if (!(time < std::numeric_limits<double>::infinity())) return;
    ++counters_.scheduled;
    const std::int64_t number = bucket_of(time);
    if (number <= current_) {
      push_to_heap(owner, table);
    } else {
      insert_after_current({time, owner}, number, table);
    }
    if (entry_count() > kEntriesPerOwner * owner_count_ + kEntriesAlways) resize_ring(table);
  }

  template <EventTable Table>
  Owner least(Table& table) {
    for (;;) {
      for (; !sorted_.empty() && is_dead(sorted_.back(), table); sorted_.pop_back()) ++counters_.taken;
      if (!heap_.empty()) drop_dead_from_heap(table);
      if (sorted_.empty()) {
        if (!heap_.empty()) return heap_.front().owner;
        if (!open_next_bucket(table)) return kNoOwner;
        continue;
      }
      const double moment = sorted_.back().time;
      if (!heap_.empty() && heap_.front().event.time.high < moment) return heap_.front().owner;
      const bool is_tied = (!heap_.empty() && heap_.front().event.time.high == moment) ||
                           (sorted_.size() > 1 && sorted_[sorted_.size() - 2].time == moment);
      if (!is_tied || is_shared(table)) return sorted_.back().owner;
      for (; !sorted_.empty() && sorted_.back().time == moment; sorted_.pop_back()) {
        if (is_dead(sorted_.back(), table)) {
          ++counters_.taken;
        } else {
          push_to_heap(sorted_.back().owner, table);
        }
      }
    }
  }

  void pop() {
    HARDBALL_CHECK(!sorted_.empty() || !heap_.empty());
    const bool from_heap =
        sorted_.empty() || (!heap_.empty() && heap_.front().event.time.high < sorted_.back().time);
    if (from_heap) {
      std::pop_heap(heap_.begin(), heap_.end(), comes_later);
      heap_.pop_back();
    } else {
      sorted_.pop_back();
    }
    ++counters_.taken;
  }

  /// Moves the ring back, so that the bucket of `time` is opened next.
  template <EventTable Table>
  void go_back(double time, const Table& table) {
    const std::int64_t before = bucket_of(time) - 1;
    if (before >= current_) return;
    insert_pending();
    // The last buckets of the ring become the first.
    std::vector<Entry> moved;
    moved.swap(sorted_);
    for (const Scheduled& entry : heap_) moved.push_back({entry.event.time.high, entry.owner});
    heap_.clear();
    const std::uint64_t taken_in_turn = taken_in_turn_;
    const std::int64_t end = current_ + ring_size();
    for (current_ = std::max(before + ring_size(), current_ + 1); current_ < end; ++current_)
      if (bucket(current_).count > 0) take_live(table, moved);
    current_ = before;
    const bool turns_sooner = current_ + ring_size() < ring_end_;
    ring_end_ = std::min(ring_end_, current_ + ring_size());
    taken_in_turn_ = turns_sooner ? 0 : taken_in_turn;
    for (const Entry& entry : moved) {
      if (is_dead(entry, table)) {
        ++counters_.taken;
      } else {
        insert_or_overflow(entry);
      }
    }
  }

  /// The owner of an entry that comes about `ahead` events after the least; kNoOwner if the current bucket
  /// has no more.
  Owner upcoming(std::size_t ahead) const {
    return ahead < sorted_.size() ? sorted_[sorted_.size() - 1 - ahead].owner : kNoOwner;
  }

  /// The number of the bucket from which events are taken.
  std::int64_t current_bucket() const { return current_; }

  QueueCounters counters() const { return counters_; }
  std::size_t memory_bytes() const;

 private:
  using Entry = QueueEntry;
  // Two cache lines of entries; fuller buckets chain several.
  static constexpr std::uint32_t kRoom = 32;
  using Block = std::array<Owner, kRoom>;
  // Only the last block of a bucket has room.
  struct Bucket {
    std::uint32_t last_block = kNone;
    std::uint32_t count = 0;
  };
  static constexpr std::uint32_t kNone = UINT32_MAX;
  static constexpr std::size_t kPending = 8;
  // Dead entries are removed once there are this many entries per owner.
  static constexpr std::size_t kEntriesPerOwner = 4;
  static constexpr std::size_t kEntriesAlways = 64;

  static bool comes_later(const Scheduled& a, const Scheduled& b) { return b < a; }

  // An entry waiting to be inserted into its bucket.
  struct Pending {
    Owner owner = 0;
    std::int64_t bucket = 0;
  };

  // The number of the bucket of a time: buckets are counted from one, those too far away are as one. Rounding
  // preserves the order of times.
  std::int64_t bucket_of(double time) const {
    constexpr double kFarthest = 0x1p62;
    const double before = std::min(std::max(0.0, (time - origin_) * buckets_per_time_), kFarthest);
    return static_cast<std::int64_t>(before) + 1;
  }
  std::int64_t ring_size() const { return static_cast<std::int64_t>(buckets_.size()); }
  Bucket& bucket(std::int64_t number) {
    return buckets_[static_cast<std::size_t>(number) & (buckets_.size() - 1)];
  }
  // Live and dead.
  std::size_t entry_count() const { return counters_.scheduled - counters_.taken; }
  template <EventTable Table>
  static bool is_dead(const Entry& entry, const Table& table) {
    return table.time(entry.owner) != entry.time;
  }

  template <EventTable Table>
  static bool is_cached([[maybe_unused]] const Table& table) {
    if constexpr (requires { table.is_cached(); }) {
      return table.is_cached();
    } else {
      return false;
    }
  }

  template <EventTable Table>
  void push_to_heap(Owner owner, const Table& table) {
    heap_.push_back({table.event(owner), owner});
    std::push_heap(heap_.begin(), heap_.end(), comes_later);
  }

  // Whether exactly two entries have the least time, and both stand for one event.
  template <EventTable Table>
  bool is_shared(const Table& table) const {
    const double moment = sorted_.back().time;
    const std::size_t size = sorted_.size();
    if (!heap_.empty() && heap_.front().event.time.high == moment) return false;
    if (size > 2 && sorted_[size - 3].time == moment) return false;
    const Owner twin = sorted_[size - 2].owner;
    return table.time(twin) == moment && share_event(table, sorted_.back().owner, twin);
  }

  template <EventTable Table>
  void drop_dead_from_heap(const Table& table) {
    while (!heap_.empty()) {
      const Owner owner = heap_.front().owner;
      const bool is_dead = table.time(owner) != heap_.front().event.time.high;
      if (!is_dead && table.event(owner) == heap_.front().event) return;
      std::pop_heap(heap_.begin(), heap_.end(), comes_later);
      heap_.pop_back();
      if (is_dead) {
        ++counters_.taken;
      } else {
        push_to_heap(owner, table);  // another event at the same time
      }
    }
  }

  // Makes the next bucket with entries current; false if there is none.
  template <EventTable Table>
  bool open_next_bucket(Table& table) {
    for (;;) {
      insert_pending();
      if (bucketed_count_ == 0) {
        if (overflow_.empty()) return false;
        resize_ring(table);
        if (bucketed_count_ == 0) return false;
      }
      if (++current_ == ring_end_ && !turn_ring()) {
        resize_ring(table);
        continue;
      }
      if (bucket(current_).count == 0) continue;
      sorted_.clear();
      take_live(table, sorted_);
      if constexpr (requires { table.refine(std::span<Entry>()); }) refine_current(table);
      sort_current();
      prefetch_next_buckets(table);
      if (!sorted_.empty()) return true;
    }
  }

  // Takes the live entries of the current bucket out of it, and appends them to a list.
  template <EventTable Table>
  void take_live(const Table& table, std::vector<Entry>& list) {
    const Bucket& current = bucket(current_);
    const std::size_t before = list.size();
    list.resize(before + current.count);
    // Branchless: half of the entries are dead, and which is unpredictable.
    Entry* end = list.data() + before;
    for_each_owner(current, [&](Owner owner) {
      const double time = table.time(owner);
      *end = {time, owner};
      end += bucket_of(time) == current_ ? 1 : 0;
    });
    const auto live = static_cast<std::size_t>(end - list.data());
    counters_.taken += list.size() - live;
    list.resize(live);
    empty_current();
  }

  // Entries postponed beyond the current bucket are inserted where they belong.
  template <EventTable Table>
  void refine_current(Table& table) {
    table.refine(std::span<Entry>(sorted_));
    std::erase_if(sorted_, [&](const Entry& entry) {
      const std::int64_t number = bucket_of(entry.time);
      if (number <= current_) return false;
      if (entry.time < std::numeric_limits<double>::infinity()) {
        insert_after_current(entry, number, table);
      } else {
        ++counters_.taken;
      }
      return true;
    });
  }

  // Prefetches what refining the next bucket will need and, one bucket earlier, the events that show which
  // entries are dead.
  template <EventTable Table>
  void prefetch_next_buckets([[maybe_unused]] const Table& table) {
    if constexpr (requires { table.prefetch_event(Owner{}); }) {
      if (is_cached(table)) return;
      for_each_owner(bucket(current_ + 2), [&](Owner owner) { table.prefetch_event(owner); });
      if constexpr (requires { table.prefetch_refinement(Owner{}); }) {
        for_each_owner(bucket(current_ + 1), [&](Owner owner) {
          if (bucket_of(table.time(owner)) == current_ + 1) table.prefetch_refinement(owner);
        });
      }
    }
  }

  template <class Visit>
  void for_each_owner(const Bucket& bucket, Visit&& visit) const {
    if (bucket.count == 0) return;
    std::uint32_t in_block = (bucket.count - 1) % kRoom + 1;
    for (std::uint32_t b = bucket.last_block; b != kNone; b = next_block_[b]) {
      for (std::uint32_t i = 0; i < in_block; ++i) visit(blocks_[b][i]);
      in_block = kRoom;
    }
  }

  template <EventTable Table>
  void insert_after_current(const Entry& entry, std::int64_t number, const Table& table) {
    if (number >= current_ + ring_size()) {
      overflow_.push_back(entry);
    } else if (is_cached(table)) {
      insert(entry.owner, bucket(number));
    } else {
      insert_delayed(entry.owner, number);
    }
  }

  HARDBALL_ALWAYS_INLINE void insert(Owner owner, Bucket& bucket) {
    const std::uint32_t index = bucket.count++ % kRoom;
    if (index == 0) bucket.last_block = new_block(bucket.last_block);
    blocks_[bucket.last_block][index] = owner;
    ++bucketed_count_;
  }

  // Buckets are scattered in memory: an entry is inserted a few entries later, when the prefetched cache line
  // has arrived.
  void insert_delayed(Owner owner, std::int64_t number) {
    Pending& entry = pending_[pending_count_ % kPending];
    if (pending_count_ >= kPending) insert(entry.owner, bucket(entry.bucket));
    entry = {owner, number};
    prefetch(&bucket(number));
    if (pending_count_ >= kPending / 2) {
      const Bucket& sooner = bucket(pending_[(pending_count_ - kPending / 2) % kPending].bucket);
      if (sooner.last_block != kNone) {
        prefetch(&blocks_[sooner.last_block][sooner.count % kRoom]);
      }
    }
    ++pending_count_;
  }

  void insert_pending();
  void insert_or_overflow(const Entry& entry);
  void sort_current();
  void empty_current();
  bool turn_ring();
  // Sets up new buckets for all live entries.
  template <EventTable Table>
  void resize_ring(const Table& table) {
    insert_pending();
    for (; bucketed_count_ > 0; ++current_) {
      if (bucket(current_).count > 0) take_live(table, overflow_);
    }
    overflow_.insert(overflow_.end(), sorted_.begin(), sorted_.end());
    for (const Scheduled& entry : heap_) overflow_.push_back({entry.event.time.high, entry.owner});
    sorted_.clear();
    heap_.clear();
    counters_.taken += std::erase_if(overflow_, [&](const Entry& entry) { return is_dead(entry, table); });
    if (overflow_.size() > owner_count_) drop_duplicates();
    distribute();
  }

  void drop_duplicates();
  void distribute();
  std::uint32_t new_block(std::uint32_t next);

  std::size_t owner_count_ = 0;
  std::array<Pending, kPending> pending_{};  // a ring of the latest entries
  std::size_t pending_count_ = 0;            // entries since the last insert_pending()
  std::vector<Entry> sorted_;                // of the current bucket, latest first: the least is at the back
  std::vector<Scheduled> heap_;  // scheduled in the current bucket since it was sorted; the least in front
  LargeVector<Bucket> buckets_;  // a ring, a power of two
  LargeVector<Block> blocks_;
  LargeVector<std::uint32_t> next_block_;  // of the same bucket, or of the free ones
  std::uint32_t free_block_ = kNone;
  std::vector<Entry> overflow_;  // beyond the end of the ring
  double origin_ = 0;
  double buckets_per_time_ = 0;  // [1/T]
  std::int64_t current_ = 0;
  std::int64_t ring_end_ = 0;
  std::size_t bucketed_count_ = 0;  // those in buckets after the current one
  std::uint64_t taken_in_turn_ = 0;
  QueueCounters counters_;
};

static_assert(EventQueue<CalendarQueue>);

}  // namespace hardball
