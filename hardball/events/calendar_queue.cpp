// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/events/calendar_queue.hpp"

#include <bit>
#include <utility>

namespace hardball {
namespace {

// A day's entries should fit the nearest cache and be worth the visit. Few owners have short days, lest most
// events come late for theirs; many have long ones, so that the days after today fit a cache, too.
std::size_t entries_per_day(std::size_t owners) {
  return std::clamp<std::size_t>(owners / 256, 8, 64);
}

// Days are laid out anew when their entries are off by this factor.
constexpr double kOff = 3;

}  // namespace

void CalendarQueue::reset(std::size_t owners, Time start) {
  owner_count_ = owners;
  unfiled_count_ = 0;
  current_.assign(owners, kNever.high);
  sorted_.clear();
  late_.clear();
  days_.assign(1, Day{});
  blocks_.clear();
  free_block_ = kNone;
  beyond_.clear();
  beyond_.reserve(owners);  // where all events wait that are scheduled before the days are laid out
  origin_ = start.high;
  days_per_time_ = 0;
  today_ = 0;
  year_end_ = 1;
  filed_count_ = 0;
  taken_in_year_ = 0;
  counters_ = {};
}

std::size_t CalendarQueue::memory_bytes() const {
  return (sorted_.capacity() + beyond_.capacity()) * sizeof(Entry) + late_.capacity() * sizeof(Scheduled) +
         days_.capacity() * sizeof(Day) + current_.capacity() * sizeof(double) +
         blocks_.capacity() * sizeof(Block);
}

void CalendarQueue::file_all() {
  const std::size_t first = unfiled_count_ > kUnfiled ? unfiled_count_ - kUnfiled : 0;
  for (std::size_t i = first; i < unfiled_count_; ++i) {
    const Unfiled& unfiled = unfiled_[i % kUnfiled];
    file(unfiled.entry, day(unfiled.day));
  }
  unfiled_count_ = 0;
}

// Precondition: the entry is not for today.
void CalendarQueue::file_or_wait(const Entry& entry) {
  const double before = days_before(entry.time);
  if (before + 1 < static_cast<double>(today_ + days_in_ring())) {
    file(entry, day(day_after(before)));
  } else {
    beyond_.push_back(entry);
  }
}

// Takes the live entries of today. Precondition: those before are done.
void CalendarQueue::sort_today() {
  const Day& today = day(today_);
  sorted_.resize(today.count);
  // Without a branch: half of the entries are dead, and nobody can foresee which.
  Entry* end = sorted_.data();
  for_each_filed(today, [&](const Entry& entry) {
    *end = entry;
    end += is_dead(entry) ? 0 : 1;
  });
  const auto live = static_cast<std::size_t>(end - sorted_.data());
  counters_.taken += sorted_.size() - live;
  sorted_.resize(live);
  empty_today();
  std::sort(sorted_.begin(), sorted_.end(), [](const Entry& a, const Entry& b) { return a.time > b.time; });
}

// Moves the entries of today to a list.
void CalendarQueue::take_day(std::vector<Entry>& entries) {
  for_each_filed(day(today_), [&entries](const Entry& entry) { entries.push_back(entry); });
  empty_today();
}

void CalendarQueue::empty_today() {
  Day& today = day(today_);
  filed_count_ -= today.count;
  taken_in_year_ += today.count;
  for (std::uint32_t block = today.last_block; block != kNone;) {
    const std::uint32_t freed = block;
    block = std::exchange(blocks_[block].next, free_block_);
    free_block_ = freed;
  }
  today = {};
}

// The ring has come round: what waited aside may have its day in it. False if the days should be laid out
// anew.
bool CalendarQueue::turn_year() {
  const double per_day = static_cast<double>(taken_in_year_) / static_cast<double>(days_.size());
  taken_in_year_ = 0;
  year_end_ = today_ + days_in_ring();
  const auto wanted = static_cast<double>(entries_per_day(owner_count_));
  if (per_day > kOff * wanted || per_day * kOff < wanted) return false;
  std::vector<Entry> waiting;
  waiting.swap(beyond_);
  for (const Entry& entry : waiting) file_or_wait(entry);
  return true;
}

// Lays the days out anew for all entries that are alive.
void CalendarQueue::lay_out() {
  file_all();
  gather();
  counters_.taken += std::erase_if(beyond_, [this](const Entry& entry) { return is_dead(entry); });
  if (beyond_.size() > owner_count_) drop_twins();
  spread_out();
}

// Lets all entries wait beyond.
void CalendarQueue::gather() {
  for (; filed_count_ > 0; ++today_) {
    if (day(today_).count > 0) take_day(beyond_);
  }
  beyond_.insert(beyond_.end(), sorted_.begin(), sorted_.end());
  for (const Scheduled& entry : late_) beyond_.push_back({entry.event.time.high, entry.owner});
  sorted_.clear();
  late_.clear();
}

// Leaves each owner one entry: one that is dead looks alive if its time is, to the nearest double, that of
// the owner's event. Precondition: all wait beyond.
void CalendarQueue::drop_twins() {
  std::vector<bool> is_known(owner_count_);
  const std::size_t dropped = std::erase_if(beyond_, [&](const Entry& entry) {
    if (is_known[entry.owner]) return true;
    is_known[entry.owner] = true;
    return false;
  });
  counters_.taken += dropped;
}

// Makes as many days as the entries waiting beyond need, and files those. Precondition: all wait there.
void CalendarQueue::spread_out() {
  taken_in_year_ = 0;
  today_ = 0;
  if (beyond_.empty()) return;
  const auto by_time = [](const Entry& a, const Entry& b) { return a.time < b.time; };
  const std::size_t half = beyond_.size() / 2;
  const auto middle = beyond_.begin() + static_cast<std::ptrdiff_t>(half);
  std::nth_element(beyond_.begin(), middle, beyond_.end(), by_time);
  const double first = std::min_element(beyond_.begin(), std::next(middle), by_time)->time;
  const double half_time = middle->time - first;
  // The ring holds four times the days that the earlier half of the entries needs.
  const std::size_t wanted = entries_per_day(owner_count_);
  days_.assign(std::bit_ceil(2 * beyond_.size() / wanted + 4), Day{});
  days_per_time_ = std::min((static_cast<double>(half) + 1) / static_cast<double>(wanted) / half_time,
                            std::numeric_limits<double>::max());
  origin_ = first;
  year_end_ = days_in_ring();
  std::vector<Entry> waiting;
  waiting.swap(beyond_);
  for (const Entry& entry : waiting) file_or_wait(entry);
}

std::uint32_t CalendarQueue::new_block(std::uint32_t next) {
  std::uint32_t block = free_block_;
  if (block == kNone) {
    block = static_cast<std::uint32_t>(blocks_.size());
    append_sparingly(blocks_, Block{});
  } else {
    free_block_ = blocks_[block].next;
  }
  blocks_[block].next = next;
  return block;
}

}  // namespace hardball
