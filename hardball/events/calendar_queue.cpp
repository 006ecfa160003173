// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/events/calendar_queue.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <utility>

namespace hardball {
namespace {

// A bucket's entries should fit the L1 cache and be worth the visit. With few owners buckets are small, lest
// most events be scheduled into the current one; with many they are large, so that the buckets being filled
// fit a cache, too.
std::size_t entries_per_bucket(std::size_t owners) {
  return std::clamp<std::size_t>(owners / 256, 8, 64);
}

// The ring is resized when entries per bucket are off by this factor.
constexpr double kResizeFactor = 3;

constexpr std::size_t kFew = 64;  // a bit for each fits a word

// Sorts up to kFew entries, the latest first. Each goes to the index given by the number of later ones: that
// many comparisons take less than the branches of a sort, which are unpredictable.
void sort_few(std::vector<QueueEntry>& entries) {
  using Times = double __attribute__((vector_size(16)));
  using Counts = long long __attribute__((vector_size(16)));
  const std::size_t size = entries.size();
  std::array<QueueEntry, kFew> unsorted;
  std::array<Times, kFew / 2> times;
  for (std::size_t i = 0; i < size; ++i) {
    unsorted[i] = entries[i];
    times[i / 2][i % 2] = entries[i].time;
  }
  if (size % 2 == 1) times[size / 2][1] = -std::numeric_limits<double>::infinity();
  std::uint64_t taken = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const double time = unsorted[i].time;
    const Times same{time, time};
    Counts later{};
    for (std::size_t pair = 0; 2 * pair < size; ++pair) later -= times[pair] > same;
    auto index = static_cast<std::size_t>(later[0] + later[1]);
    while ((taken >> index & 1) != 0) ++index;  // another of the same time
    taken |= std::uint64_t{1} << index;
    entries[index] = unsorted[i];
  }
}

}  // namespace

void CalendarQueue::reset(std::size_t owners, Time start) {
  owner_count_ = owners;
  pending_count_ = 0;
  sorted_.clear();
  heap_.clear();
  buckets_.assign(1, Bucket{});
  blocks_.clear();
  next_block_.clear();
  free_block_ = kNone;
  overflow_.clear();
  overflow_.reserve(owners);  // holds all events until the ring has its size
  origin_ = start.high;
  buckets_per_time_ = 0;
  current_ = 0;
  ring_end_ = 1;
  bucketed_count_ = 0;
  taken_in_turn_ = 0;
  counters_ = {};
}

std::size_t CalendarQueue::memory_bytes() const {
  return (sorted_.capacity() + overflow_.capacity()) * sizeof(Entry) + heap_.capacity() * sizeof(Scheduled) +
         buckets_.capacity() * sizeof(Bucket) + blocks_.capacity() * sizeof(Block) +
         next_block_.capacity() * sizeof(std::uint32_t);
}

void CalendarQueue::insert_pending() {
  const std::size_t first = pending_count_ > kPending ? pending_count_ - kPending : 0;
  for (std::size_t i = first; i < pending_count_; ++i) {
    const Pending& pending = pending_[i % kPending];
    insert(pending.owner, bucket(pending.bucket));
  }
  pending_count_ = 0;
}

// Precondition: the entry does not belong to the current bucket.
void CalendarQueue::insert_or_overflow(const Entry& entry) {
  const std::int64_t number = bucket_of(entry.time);
  if (number < current_ + ring_size()) {
    insert(entry.owner, bucket(number));
  } else {
    overflow_.push_back(entry);
  }
}

void CalendarQueue::sort_current() {
  if (sorted_.size() <= kFew) return sort_few(sorted_);
  std::sort(sorted_.begin(), sorted_.end(), [](const Entry& a, const Entry& b) { return a.time > b.time; });
}

void CalendarQueue::empty_current() {
  Bucket& current = bucket(current_);
  bucketed_count_ -= current.count;
  taken_in_turn_ += current.count;
  for (std::uint32_t block = current.last_block; block != kNone;) {
    const std::uint32_t freed = block;
    block = std::exchange(next_block_[block], free_block_);
    free_block_ = freed;
  }
  current = {};
}

// The ring has come round: entries of the overflow list may fall into it. False if it should be resized
// instead.
bool CalendarQueue::turn_ring() {
  const double per_bucket = static_cast<double>(taken_in_turn_) / static_cast<double>(buckets_.size());
  taken_in_turn_ = 0;
  ring_end_ = current_ + ring_size();
  const auto wanted = static_cast<double>(entries_per_bucket(owner_count_));
  if (per_bucket > kResizeFactor * wanted || per_bucket * kResizeFactor < wanted) return false;
  std::vector<Entry> waiting;
  waiting.swap(overflow_);
  for (const Entry& entry : waiting) insert_or_overflow(entry);
  return true;
}

// Leaves one entry per owner: a dead one looks alive if its time agrees with the owner's event to the nearest
// double. Precondition: all entries are in the overflow list.
void CalendarQueue::drop_duplicates() {
  std::vector<bool> is_known(owner_count_);
  const std::size_t dropped = std::erase_if(overflow_, [&](const Entry& entry) {
    if (is_known[entry.owner]) return true;
    is_known[entry.owner] = true;
    return false;
  });
  counters_.taken += dropped;
}

// Makes as many buckets as the entries of the overflow list need, and inserts those. Precondition: all
// entries are there.
void CalendarQueue::distribute() {
  taken_in_turn_ = 0;
  current_ = 0;
  ring_end_ = ring_size();
  if (overflow_.empty()) return;
  const auto by_time = [](const Entry& a, const Entry& b) { return a.time < b.time; };
  const std::size_t half = overflow_.size() / 2;
  const auto middle = overflow_.begin() + static_cast<std::ptrdiff_t>(half);
  std::nth_element(overflow_.begin(), middle, overflow_.end(), by_time);
  const double first = std::min_element(overflow_.begin(), std::next(middle), by_time)->time;
  const double half_time = middle->time - first;
  // The ring has four times the buckets that the earlier half of the entries needs.
  const std::size_t wanted = entries_per_bucket(owner_count_);
  buckets_.assign(std::bit_ceil(2 * overflow_.size() / wanted + 4), Bucket{});
  buckets_per_time_ = std::min((static_cast<double>(half) + 1) / static_cast<double>(wanted) / half_time,
                               std::numeric_limits<double>::max());
  origin_ = first;
  ring_end_ = ring_size();
  std::vector<Entry> waiting;
  waiting.swap(overflow_);
  for (const Entry& entry : waiting) insert_or_overflow(entry);
}

std::uint32_t CalendarQueue::new_block(std::uint32_t next) {
  std::uint32_t block = free_block_;
  if (block == kNone) {
    block = static_cast<std::uint32_t>(blocks_.size());
    append_sparingly(blocks_, Block{});
    next_block_.push_back(kNone);
  } else {
    free_block_ = next_block_[block];
  }
  next_block_[block] = next;
  return block;
}

}  // namespace hardball
