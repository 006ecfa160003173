// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/events/calendar_queue.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

// A day's entries should fit the nearest cache and be worth the visit.
constexpr std::size_t kEntriesPerDay = 8;

// A year is laid out over this share of the waiting entries, the earliest ones.
constexpr std::size_t kYearShare = 2;

// Dead entries are swept out when they outnumber the owners by this factor.
constexpr std::size_t kEntriesPerOwner = 4;

}  // namespace

void CalendarQueue::reset(std::size_t owners, Time start) {
  serial_of_.assign(owners, 0);
  for (Entries& day : days_) day.clear();
  day_count_ = 0;
  today_sorted_.clear();
  today_heap_.clear();
  beyond_.clear();
  year_start_ = start;
  days_per_time_ = 0;
  today_ = 0;
  entry_count_ = 0;
  counters_ = {};
}

void CalendarQueue::schedule(Owner owner, const Event& event) {
  const std::uint32_t serial = ++serial_of_[owner];
  if (!event.happens()) return;
  ++counters_.scheduled;
  if (entry_count_ > kEntriesPerOwner * serial_of_.size()) sweep();
  ++entry_count_;
  file({{event, owner}, serial});
}

std::optional<Scheduled> CalendarQueue::least() {
  for (;;) {
    drop_dead_today();
    if (!today_sorted_.empty() || !today_heap_.empty()) break;
    if (today_ + 1 < day_count_) {
      ++today_;
      begin_day();
    } else if (!begin_year()) {
      return std::nullopt;
    }
  }
  if (today_heap_.empty()) return today_sorted_.back().scheduled;
  if (today_sorted_.empty()) return today_heap_.front().scheduled;
  return std::min(today_sorted_.back().scheduled, today_heap_.front().scheduled);
}

void CalendarQueue::pop() {
  HARDBALL_CHECK(!today_sorted_.empty() || !today_heap_.empty());
  const bool from_heap = today_sorted_.empty() ||
                         (!today_heap_.empty() && comes_later(today_sorted_.back(), today_heap_.front()));
  if (from_heap) {
    std::pop_heap(today_heap_.begin(), today_heap_.end(), comes_later);
    today_heap_.pop_back();
  } else {
    today_sorted_.pop_back();
  }
  --entry_count_;
  ++counters_.taken;
}

std::size_t CalendarQueue::memory_bytes() const {
  std::size_t entries = today_sorted_.capacity() + today_heap_.capacity() + beyond_.capacity();
  for (const Entries& day : days_) entries += day.capacity();
  return entries * sizeof(Entry) + days_.capacity() * sizeof(Entries) +
         serial_of_.capacity() * sizeof(std::uint32_t);
}

// Uses the leading part of the time alone: rounding then keeps the order of times, which the sum of both
// differences would not.
std::size_t CalendarQueue::day_of(const Time& time) const {
  const double day = (time.high - year_start_.high) * days_per_time_;
  return day >= static_cast<double>(day_count_) ? day_count_ : day > 0 ? static_cast<std::size_t>(day) : 0;
}

void CalendarQueue::file(const Entry& entry) {
  const std::size_t day = day_of(entry.scheduled.event.time);
  if (day >= day_count_) {
    beyond_.push_back(entry);
  } else if (day > today_) {
    days_[day].push_back(entry);
  } else {
    today_heap_.push_back(entry);
    std::push_heap(today_heap_.begin(), today_heap_.end(), comes_later);
  }
}

void CalendarQueue::drop_dead(Entries& entries) {
  const auto dead =
      std::remove_if(entries.begin(), entries.end(), [this](const Entry& entry) { return !is_live(entry); });
  entry_count_ -= static_cast<std::size_t>(entries.end() - dead);
  entries.erase(dead, entries.end());
}

void CalendarQueue::drop_dead_today() {
  while (!today_sorted_.empty() && !is_live(today_sorted_.back())) {
    today_sorted_.pop_back();
    --entry_count_;
    ++counters_.taken;
  }
  while (!today_heap_.empty() && !is_live(today_heap_.front())) {
    std::pop_heap(today_heap_.begin(), today_heap_.end(), comes_later);
    today_heap_.pop_back();
    --entry_count_;
    ++counters_.taken;
  }
}

void CalendarQueue::begin_day() {
  std::swap(today_sorted_, days_[today_]);
  days_[today_].clear();
  drop_dead(today_sorted_);
  std::sort(today_sorted_.begin(), today_sorted_.end(), comes_later);
}

// Lays out the year over the earlier part of the waiting entries; false if there are none.
bool CalendarQueue::begin_year() {
  drop_dead(beyond_);
  if (beyond_.empty()) return false;
  const auto by_time = [](const Entry& a, const Entry& b) {
    return a.scheduled.event.time < b.scheduled.event.time;
  };
  const std::size_t share = beyond_.size() / kYearShare;
  const auto middle = beyond_.begin() + static_cast<std::ptrdiff_t>(share);
  std::nth_element(beyond_.begin(), middle, beyond_.end(), by_time);
  const Time year_end = middle->scheduled.event.time;
  year_start_ = std::min_element(beyond_.begin(), std::next(middle), by_time)->scheduled.event.time;
  const double year = year_end.high - year_start_.high;
  // The last day is for the entry at year_end itself. A year without length holds one moment, and ends with
  // it.
  const std::size_t days = share / kEntriesPerDay + 1;
  days_per_time_ = std::min(static_cast<double>(days) / year, std::numeric_limits<double>::max());
  day_count_ = days + 1;
  if (days_.size() < day_count_) days_.resize(day_count_);
  today_ = 0;
  const auto later_years = std::partition(beyond_.begin(), beyond_.end(), [this](const Entry& entry) {
    return day_of(entry.scheduled.event.time) < day_count_;
  });
  for (auto entry = beyond_.begin(); entry != later_years; ++entry) {
    days_[day_of(entry->scheduled.event.time)].push_back(*entry);
  }
  beyond_.erase(beyond_.begin(), later_years);
  begin_day();
  return true;
}

void CalendarQueue::sweep() {
  for (std::size_t day = today_ + 1; day < day_count_; ++day) drop_dead(days_[day]);
  drop_dead(today_sorted_);
  drop_dead(today_heap_);
  std::make_heap(today_heap_.begin(), today_heap_.end(), comes_later);
  drop_dead(beyond_);
}

}  // namespace hardball
