// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/domains/domain_group.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/processes/bytes.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/world/pair_event.hpp"

namespace hardball {

DomainGroup::DomainGroup(std::vector<std::unique_ptr<Domain>> domains, const Time& now,
                         const WindowSettings& settings, ForEach for_each, Exchange exchange)
    : domains_(std::move(domains)),
      exchange_(std::move(exchange)),
      settings_(settings),
      for_each_(std::move(for_each)),
      committed_(now.high),
      window_(settings.first) {
  connect();
}

DomainGroup::DomainGroup(const DomainGroup& other, ForEach for_each)
    : exchange_(other.exchange_.processes(), other.exchange_.domains()),
      settings_(other.settings_),
      for_each_(std::move(for_each)),
      committed_(other.committed_),
      is_complete_(other.is_complete_),
      window_(other.window_),
      steps_in_a_row_(other.steps_in_a_row_),
      horizon_(other.horizon_),
      done_(other.done_),
      counted_(other.counted_),
      window_counters_(other.window_counters_) {
  for (const auto& domain : other.domains_) domains_.push_back(std::make_unique<Domain>(*domain));
  connect();
}

Load DomainGroup::load() const {
  Load load{{}, window_counters_};
  for (const std::string& part : processes().gather(bytes_of(done_))) append_bytes(part, load.contacts);
  return load;
}

Time DomainGroup::now() const {
  Time now = domains_.front()->begin();
  for (const auto& domain : domains_) now = later(now, domain->begin());
  for (const Time& other : processes().gather(now)) now = later(now, other);
  return now;
}

std::uint64_t DomainGroup::open_window(double end, std::uint64_t most, const Kept& kept) {
  watch_if_due();
  const double begin = committed_;
  const bool may_be_cut = static_cast<double>(most) < 4 * settings_.contacts;
  keep({.log = kept.log || may_be_cut, .sums = kept.sums});
  // Few contacts need only a part of a window.
  const double part = std::min(1.0, static_cast<double>(most) / settings_.contacts);
  wanted_ = std::max(part * window_, least_window());
  for (double until = std::min({end, begin + wanted_, horizon_});;) {
    each_or_undo([&](Domain& domain, std::size_t) { domain.run(until, most_contacts()); });
    const Findings found = compare(until);
    const bool is_wrong = found.bad <= until;
    // With the last of the contacts wanted, the window ends: that takes a step.
    if (!is_wrong && found.counted.contacts() < most) {
      open_ = {Time(until), found.counted, found.has_passing, false};
      return open_contacts();
    }
    const bool is_cut = is_wrong || are_logs_kept_;
    const double cut = is_wrong ? double_before(found.bad) : is_cut ? time_before(most) : until;
    undo();
    if (is_wrong) note_failure(until - begin);
    if (!is_cut) keep({.log = true, .sums = kept.sums});
    if (cut <= begin) {
      step(std::min(end, horizon_), true);
      return open_contacts();
    }
    until = cut;
  }
}

MergedLog DomainGroup::merged_log() {
  std::vector<std::span<const LoggedContact>> logs;
  if (processes().size() == 1) {
    for (const auto& domain : domains_) logs.push_back(domain->log());
    return MergedLog(std::move(logs));
  }
  logs_.assign(processes().size() * size(), {});
  for (std::size_t k = 0; k < size(); ++k) {
    std::size_t domain = k;
    for (const std::string& log : processes().gather(bytes_of(domains_[k]->log()))) {
      append_bytes(log, logs_[domain]);
      domain += size();
    }
  }
  return MergedLog({logs_.begin(), logs_.end()});
}

void DomainGroup::commit_window() {
  const double length = open_.end.high - committed_;
  commit();
  steps_in_a_row_ = open_.is_step ? steps_in_a_row_ + 1 : 0;
  if (!open_.is_step) adapt(length, open_contacts());
}

void DomainGroup::cut_window(std::uint64_t contacts) {
  if (open_.is_step && contacts == open_contacts()) return commit_window();
  const double end = open_.end.high;
  undo();
  while (contacts > 0) {
    contacts -= open_window(end, contacts, {.log = true, .sums = false});
    commit_window();
  }
}

Event DomainGroup::next_contact(double end) {
  for (;;) {
    watch_if_due();
    const Event next = step(std::min(end, horizon_), false);
    if (next.happens()) return next;
    commit();
    if (committed_ == end) return {};
  }
}

bool DomainGroup::has_events() const {
  const bool own = ranges::any_of(domains_, [](const auto& domain) { return domain->engine().has_events(); });
  return ranges::max(processes().gather(own ? 1 : 0)) == 1;
}

void DomainGroup::connect() {
  bad_.resize(size());
  done_.resize(size());
  peeked_.resize(size());
  std::vector<Exchange::Member> members;
  for (const auto& domain : domains_) {
    members.push_back(
        {domain->number(), domain->neighbors(),
         [&domain = *domain](DomainNumber to) -> const Outbox& { return domain.outbox_to(to); }});
  }
  exchange_.connect(members);
}

void DomainGroup::keep(const Kept& kept) {
  for (auto& domain : domains_) domain->keep_log(kept.log, kept.sums);
  are_logs_kept_ = kept.log;
}

std::uint64_t DomainGroup::most_contacts() const {
  constexpr double kWindows = 16;
  constexpr double kAlways = 256;
  constexpr std::uint64_t kFewest = 4;
  const auto usual = static_cast<std::uint64_t>(kAlways + kWindows * settings_.contacts);
  return std::max(usual >> std::min<std::uint64_t>(steps_in_a_row_, 63), kFewest);
}

void DomainGroup::watch_if_due() {
  if (committed_ < horizon_) return;
  // A near horizon has all spheres looked at often, and up to a far one many need wakeups. By a diameter the
  // spheres that need one are few.
  constexpr double kFewestWindows = 64;
  constexpr double kMostWindows = 1024;
  // As long as windows will be: a horizon nearer than one of them would keep them from growing.
  const double window = std::max(window_, least_window());
  horizon_ = committed_ + std::clamp(settings_.flight, kFewestWindows * window, kMostWindows * window);
  each([&](Domain& domain, std::size_t) { domain.watch(horizon_); });
}

DomainGroup::Findings DomainGroup::compare(double until) {
  exchange_.carry_out(Exchange::Round::window);
  each([&](Domain& domain, std::size_t k) { bad_[k] = domain.verify(exchange_.inboxes(k), until); });
  exchange_.carry_out(Exchange::Round::conflicts);
  each([&](Domain& domain, std::size_t k) {
    bad_[k] = std::min(bad_[k], domain.in_conflict_since(exchange_.inboxes(k)));
  });
  Findings own;
  for (std::size_t k = 0; k < size(); ++k)
    own.add({bad_[k], domains_[k]->counted(), has_passing_pairs(domains_[k]->world())});
  Findings all;
  for (const Findings& found : processes().gather(own)) all.add(found);
  return all;
}

void DomainGroup::commit() {
  counted_ = counted_ + open_.contacts;
  for (std::size_t k = 0; k < size(); ++k) done_[k] += domains_[k]->counted().contacts();
  each([&](Domain& domain, std::size_t) { domain.commit(open_.end); });
  exchange_.carry_out(Exchange::Round::arrivals);
  // Before anything is predicted again.
  if (open_.has_passing) share_last_passage();
  each([&](Domain& domain, std::size_t k) {
    domain.receive(exchange_.inboxes(k));
    domain.make_ready();
  });
  committed_ = open_.end.high;
  is_complete_ = !open_.is_step;
  ++window_counters_.windows;
  if constexpr (HARDBALL_VALIDATE) {
    constexpr std::uint64_t kEvery = 8;
    if (window_counters_.windows % kEvery == 0)
      each([](const Domain& domain, std::size_t) { domain.validate(); });
  }
}

void DomainGroup::share_last_passage() {
  Event last = domains_.front()->world().last_passage();
  for (const auto& domain : domains_) {
    if (last < domain->world().last_passage()) last = domain->world().last_passage();
  }
  for (const Event& other : processes().gather(last)) {
    if (last < other) last = other;
  }
  for (auto& domain : domains_) domain->set_last_passage(last);
}

void DomainGroup::undo() {
  each([&](Domain& domain, std::size_t) {
    domain.undo();
    domain.make_ready();
  });
}

double DomainGroup::time_before(std::uint64_t contacts) {
  std::vector<double> own;
  for (const auto& domain : domains_) {
    for (const LoggedContact& logged : domain->log()) {
      if (logged.counts) own.push_back(logged.contact.time.high);
    }
  }
  std::vector<double> times;
  for (const std::string& part : processes().gather(bytes_of(own))) append_bytes(part, times);
  const auto last = times.begin() + static_cast<std::ptrdiff_t>(contacts - 1);
  ranges::nth_element(times, last);
  return double_before(*last);
}

Event DomainGroup::step(double end, bool executes) {
  const double begin = committed_;
  for (double until = end;;) {
    each_or_undo([&](Domain& domain, std::size_t k) { peeked_[k] = domain.peek(until); });
    const Event next = earliest_peeked();
    const double to = next.happens() ? next.time.high : until;
    each([&](Domain& domain, std::size_t) { domain.end_peek(to); });
    const Findings found = compare(to);
    const bool is_known = found.bad > to;
    const double cut = is_known ? to : double_before(found.bad);
    const bool acts = is_known && next.happens();
    if ((!is_known && cut <= begin) || (acts && !executes)) {
      undo();
      if (acts) return next;
      // Not even that far: a shorter way shows less.
      until = std::max(begin + (to - begin) / 16, std::nextafter(begin, kNever.high));
      continue;
    }
    if (acts) execute(next);
    const Time moment = acts ? next.time : Time(cut);
    each([&](Domain& domain, std::size_t) { domain.end_step(later(moment, domain.begin())); });
    const Findings done = compare(cut);
    open_ = {moment, done.counted, done.has_passing, true};
    HARDBALL_CHECK(open_contacts() == (acts ? 1U : 0U));
    ++window_counters_.steps;
    return acts ? next : Event();
  }
}

Event DomainGroup::earliest_peeked() {
  Event earliest = *ranges::min_element(peeked_, std::less<Event>());
  for (const Event& other : processes().gather(earliest)) earliest = std::min(earliest, other);
  return earliest;
}

void DomainGroup::execute(const Event& next) {
  std::vector<Failure> failures(size());
  each_or_undo([&](Domain& domain, std::size_t k) {
    try {
      domain.execute_if_next(peeked_[k], next);
    } catch (const RunFailure& failure) {
      failures[k] = {failure.what(), std::current_exception()};
    } catch (const Error& error) {
      failures[k] = {error.what(), std::current_exception()};
    }
  });
  Failure own;
  bool owns_first = false;
  for (std::size_t k = 0; k < size() && !owns_first; ++k) {
    if (!failures[k].exception) continue;
    owns_first = domains_[k]->owns(next.first);
    if (!own.exception || owns_first) own = failures[k];
  }
  const std::vector<std::string> all = processes().gather(own.message);
  if (ranges::all_of(all, &std::string::empty)) return;
  const std::vector<char> own_first = processes().gather(static_cast<char>(owns_first));
  undo();
  if (all.size() == 1) std::rethrow_exception(own.exception);
  auto told = ranges::find(own_first, 1) - own_first.begin();
  if (told == std::ssize(all)) told = ranges::find_if_not(all, &std::string::empty) - all.begin();
  throw RunFailure(all[static_cast<std::size_t>(told)]);
}

void DomainGroup::note_failure(double length) {
  ++window_counters_.failed;
  window_ = std::max(std::max(window_, length) / 2, least_window());
}

void DomainGroup::adapt(double length, std::uint64_t contacts) {
  constexpr double kMost = 1.5;
  // Of the flight by a diameter: beyond that, more windows fail because spheres fly out of the halos.
  constexpr double kShortFlight = 0.1;
  const double most = kMost * window_;
  if (contacts == 0) {
    if (length >= 0.5 * wanted_) window_ = most;  // unless it was cut short
  } else {
    const double per_contact = length / static_cast<double>(contacts);
    const double wanted = std::clamp(kShortFlight * settings_.flight, per_contact * settings_.contacts,
                                     per_contact * settings_.more_contacts);
    window_ = std::max(std::clamp(wanted, window_ / kMost, most), least_window());
  }
}

}  // namespace hardball
