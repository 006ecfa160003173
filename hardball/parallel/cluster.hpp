// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "hardball/engine/run.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/memory/for_each.hpp"
#include "hardball/parallel/domain.hpp"
#include "hardball/parallel/exchange.hpp"
#include "hardball/parallel/load.hpp"
#include "hardball/parallel/merged_log.hpp"
#include "hardball/parallel/window_counters.hpp"
#include "hardball/parallel/window_settings.hpp"
#include "hardball/processes/bytes.hpp"

namespace hardball {

/// Domains that together are one system: in windows of time they run apart, compare, and go back where they
/// were wrong, so that the contacts are those of one engine to the last bit. Source: docs/parallel.md.
///
/// A window is opened, which finds what happens in it, and then either committed or cut short.
///
/// Some of the domains may be in other processes, each with a cluster of its own: their members are called in
/// all at once, with the same arguments, and return the same.
template <class Engine, class Sums>
class Cluster {
 public:
  using Member = Domain<Engine, Sums>;
  /// What becomes of the contacts of a window.
  struct Kept {
    bool log = false;  ///< They are kept in a log.
    bool sums = true;  ///< They are added up when it is committed.
  };

  /// Takes over domains that together, with those that `exchange` reaches, hold a world as it is at `now`.
  Cluster(std::vector<std::unique_ptr<Member>> domains, const Time& now, const WindowSettings& settings,
          ForEach for_each, Exchange exchange = Exchange())
      : domains_(std::move(domains)),
        exchange_(std::move(exchange)),
        settings_(settings),
        for_each_(std::move(for_each)),
        committed_(now.high),
        window_(settings.first) {
    connect();
  }
  /// A copy that works in its own way. Precondition: all domains are in this process.
  Cluster(const Cluster& other, ForEach for_each)
      : settings_(other.settings_),
        for_each_(std::move(for_each)),
        committed_(other.committed_),
        is_complete_(other.is_complete_),
        window_(other.window_),
        steps_in_a_row_(other.steps_in_a_row_),
        horizon_(other.horizon_),
        done_(other.done_),
        counted_(other.counted_),
        window_counters_(other.window_counters_) {
    for (const auto& domain : other.domains_) domains_.push_back(std::make_unique<Member>(*domain));
    connect();
  }

  /// How many domains are in this process, and these.
  std::size_t size() const { return domains_.size(); }
  const Member& domain(std::size_t number) const { return *domains_[number]; }
  Member& domain(std::size_t number) { return *domains_[number]; }
  const WindowCounters& window_counters() const { return window_counters_; }

  /// How many collisions and contacts with walls have been committed.
  const Counters& counted() const { return counted_; }
  /// How many contacts the open window has.
  std::uint64_t open_contacts() const { return open_.contacts.contacts(); }
  /// What has been done since the start, by all domains. Cost: a message to each process.
  Load load() const {
    Load load{{}, window_counters_};
    for (const std::string& part : processes().gather(bytes_of(done_))) append_bytes(part, load.contacts);
    return load;
  }
  /// Up to which all has happened [T].
  double committed() const { return committed_; }
  /// The same, with the last of the events that round to it. Cost: O(domains), and a message to each process.
  Time now() const {
    Time now = domains_.front()->begin();
    for (const auto& domain : domains_) now = later(now, domain->begin());
    for (const Time& other : processes().gather(now)) now = later(now, other);
    return now;
  }
  /// Whether all events that round to committed() have happened, too.
  bool is_complete() const { return is_complete_; }

  /// Opens a window that ends no later than `end` and has at most so many contacts, of which it returns the
  /// number. Precondition: `end` is not before committed() nor after kLargestTime; `most` is not zero; no
  /// window is open. Error: what engines throw; then all before it has been committed, and no window is open.
  std::uint64_t open_window(double end, std::uint64_t most, const Kept& kept) {
    watch_if_due();
    const double begin = committed_;
    const bool may_be_cut = static_cast<double>(most) < 4 * settings_.contacts;
    keep({.log = kept.log || may_be_cut, .sums = kept.sums});
    // Few contacts need only a part of a window.
    const double part = std::min(1.0, static_cast<double>(most) / settings_.contacts);
    wanted_ = std::max(part * window_, least_window());
    for (double until = std::min({end, begin + wanted_, horizon_});;) {
      each_or_undo([&](Member& domain, std::size_t) { domain.run(until, most_contacts()); });
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
  /// The contacts of the open window, if its log is kept. Precondition: all domains are in this process.
  MergedLog merged_log() const {
    std::vector<std::span<const LoggedContact>> logs;
    for (const auto& domain : domains_) logs.push_back(domain->log());
    return MergedLog(std::move(logs));
  }
  /// Takes the open window as what has happened.
  void commit_window() {
    const double length = open_.end.high - committed_;
    commit();
    steps_in_a_row_ = open_.is_step ? steps_in_a_row_ + 1 : 0;
    if (!open_.is_step) adapt(length, open_contacts());
  }
  /// Ends the open window with the first of its contacts, so many. Precondition: it has as many, and they are
  /// kept in a log and not added up.
  void cut_window(std::uint64_t contacts) {
    if (open_.is_step && contacts == open_contacts()) return commit_window();
    const double end = open_.end.high;
    undo();
    while (contacts > 0) {
      contacts -= open_window(end, contacts, {.log = true, .sums = false});
      commit_window();
    }
  }

  /// The next contact up to `end`, without executing it: only crossings happen. Precondition: as for
  /// open_window.
  Event next_contact(double end) {
    for (;;) {
      watch_if_due();
      const Event next = step(std::min(end, horizon_), false);
      if (next.happens()) return next;
      commit();
      if (committed_ == end) return {};
    }
  }

  /// Watches all frontiers anew before the next window, as paths have been edited.
  void watch_anew() { horizon_ = -std::numeric_limits<double>::infinity(); }

  /// Whether any event will ever happen.
  bool has_events() const {
    const bool own =
        std::ranges::any_of(domains_, [](const auto& domain) { return domain->engine().has_events(); });
    return std::ranges::max(processes().gather(own ? 1 : 0)) == 1;
  }

  /// Lets the domains in this process begin to add up contacts, each with an empty part of `sums`.
  void clear_sums(const Sums& sums) {
    each([part = sums.part()](Member& domain, std::size_t) { domain.clear_sums(part); });
  }
  /// Adds what they have added up since then.
  void add_sums_to(Sums& sums) const {
    for (const auto& domain : domains_) sums.add(domain->sums());
  }

  /// Works on all domains, on several at once. Error: of the first that throws.
  template <class Work>
  void each(Work&& work) {
    for_each_or_throw(for_each_, size(), [&](std::size_t domain) { work(*domains_[domain], domain); });
  }

 private:
  struct OpenWindow {
    Time end;
    Counters contacts;
    bool has_passing = false;  // somewhere, spheres pass through each other
    bool is_step = false;      // then more may happen in the same double
  };
  // Of a contact that cannot be executed.
  struct Failure {
    std::string message;
    std::exception_ptr exception;
  };
  // What domains find when they compare, all together.
  struct Findings {
    double bad = std::numeric_limits<double>::infinity();  // before this time all is right [T]
    Counters counted;
    bool has_passing = false;

    void add(const Findings& other) {
      bad = std::min(bad, other.bad);
      counted = counted + other.counted;
      has_passing |= other.has_passing;
    }
  };

  void connect() {
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

  Processes& processes() const { return exchange_.processes(); }

  void keep(const Kept& kept) {
    for (auto& domain : domains_) domain->keep_log(kept.log, kept.sums);
    are_logs_kept_ = kept.log;
  }

  // Of a domain in a window. If it has many more than are aimed at, the window is much too long: the spheres
  // have become fast, perhaps only because ghosts are wrong. Where single steps follow one another, as in a
  // collapse, the window between two of them is tried for ever fewer contacts.
  std::uint64_t most_contacts() const {
    constexpr double kWindows = 16;
    constexpr double kAlways = 256;
    constexpr std::uint64_t kFewest = 4;
    const auto usual = static_cast<std::uint64_t>(kAlways + kWindows * settings_.contacts);
    return std::max(usual >> std::min<std::uint64_t>(steps_in_a_row_, 63), kFewest);
  }

  void watch_if_due() {
    if (committed_ < horizon_) return;
    // A near horizon has all spheres looked at often, and up to a far one many need alarms. By a diameter the
    // spheres that need one are few.
    constexpr double kFewestWindows = 64;
    constexpr double kMostWindows = 1024;
    // As long as windows will be: a horizon nearer than one of them would keep them from growing.
    const double window = std::max(window_, least_window());
    horizon_ = committed_ + std::clamp(settings_.flight, kFewestWindows * window, kMostWindows * window);
    each([&](Member& domain, std::size_t) { domain.watch(horizon_); });
  }

  // What the domains did up to `until`.
  Findings compare(double until) {
    exchange_.carry_out(Exchange::Round::window);
    each([&](Member& domain, std::size_t k) { bad_[k] = domain.verify(exchange_.inboxes(k), until); });
    exchange_.carry_out(Exchange::Round::doubts);
    each([&](Member& domain, std::size_t k) {
      bad_[k] = std::min(bad_[k], domain.doubtful_since(exchange_.inboxes(k)));
    });
    Findings own;
    for (std::size_t k = 0; k < size(); ++k)
      own.add({bad_[k], domains_[k]->counted(), domains_[k]->world().has_passing_pairs()});
    Findings all;
    for (const Findings& found : processes().gather(own)) all.add(found);
    return all;
  }

  void commit() {
    counted_ = counted_ + open_.contacts;
    for (std::size_t k = 0; k < size(); ++k) done_[k] += domains_[k]->counted().contacts();
    each([&](Member& domain, std::size_t) { domain.commit(open_.end); });
    exchange_.carry_out(Exchange::Round::arrivals);
    // Before anything is predicted again.
    if (open_.has_passing) share_last_passage();
    each([&](Member& domain, std::size_t k) {
      domain.receive(exchange_.inboxes(k));
      domain.make_ready();
    });
    committed_ = open_.end.high;
    is_complete_ = !open_.is_step;
    ++window_counters_.windows;
    if constexpr (HARDBALL_VALIDATE) {
      constexpr std::uint64_t kEvery = 8;
      if (window_counters_.windows % kEvery == 0)
        each([](const Member& domain, std::size_t) { domain.validate(); });
    }
  }

  void share_last_passage() {
    Event last = domains_.front()->world().last_passage();
    for (const auto& domain : domains_) {
      if (last < domain->world().last_passage()) last = domain->world().last_passage();
    }
    for (const Event& other : processes().gather(last)) {
      if (last < other) last = other;
    }
    for (auto& domain : domains_) domain->set_last_passage(last);
  }

  // Works on all domains in a window. Error: as of `each`; then the window is undone.
  template <class Work>
  void each_or_undo(Work&& work) {
    try {
      each(work);
    } catch (...) {
      undo();
      throw;
    }
  }

  void undo() {
    each([&](Member& domain, std::size_t) {
      domain.undo();
      domain.make_ready();
    });
  }

  // The double before the last of so many contacts.
  double time_before(std::uint64_t contacts) {
    std::vector<double> own;
    for (const auto& domain : domains_) {
      for (const LoggedContact& logged : domain->log()) {
        if (logged.counts) own.push_back(logged.contact.time.high);
      }
    }
    std::vector<double> times;
    for (const std::string& part : processes().gather(bytes_of(own))) append_bytes(part, times);
    const auto last = times.begin() + static_cast<std::ptrdiff_t>(contacts - 1);
    std::ranges::nth_element(times, last);
    return double_before(*last);
  }

  // Opens a window that ends with the next contact of all, if that is to be executed, or as far on as domains
  // know whom their spheres meet. Returns the next contact, if it is known; if it is not to be executed, no
  // window is open then.
  Event step(double end, bool executes) {
    const double begin = committed_;
    for (double until = end;;) {
      each_or_undo([&](Member& domain, std::size_t k) { peeked_[k] = domain.peek(until); });
      const Event next = earliest_peeked();
      const double to = next.happens() ? next.time.high : until;
      each([&](Member& domain, std::size_t) { domain.end_peek(to); });
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
      each([&](Member& domain, std::size_t) { domain.end_step(later(moment, domain.begin())); });
      const Findings done = compare(cut);
      open_ = {moment, done.counted, done.has_passing, true};
      HARDBALL_CHECK(open_contacts() == (acts ? 1U : 0U));
      ++window_counters_.steps;
      return acts ? next : Event();
    }
  }

  Event earliest_peeked() {
    Event earliest = *std::ranges::min_element(peeked_, std::less<Event>());
    for (const Event& other : processes().gather(earliest)) earliest = std::min(earliest, other);
    return earliest;
  }

  // Error: that of the domain in which it fails; if it fails in two, of the one that owns the first sphere,
  // as a single engine would tell. In several processes, a RunFailure.
  void execute(const Event& next) {
    std::vector<Failure> failures(size());
    each_or_undo([&](Member& domain, std::size_t k) {
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
    if (std::ranges::all_of(all, &std::string::empty)) return;
    const std::vector<char> own_first = processes().gather(static_cast<char>(owns_first));
    undo();
    if (all.size() == 1) std::rethrow_exception(own.exception);
    auto told = std::ranges::find(own_first, 1) - own_first.begin();
    if (told == std::ssize(all)) told = std::ranges::find_if_not(all, &std::string::empty) - all.begin();
    throw RunFailure(all[static_cast<std::size_t>(told)]);
  }

  void note_failure(double length) {
    ++window_counters_.failed;
    window_ = std::max(std::max(window_, length) / 2, least_window());
  }

  // Long enough to get on.
  double least_window() const { return std::max(0x1p-20 * settings_.first, 0x1p-44 * std::fabs(committed_)); }

  // Lets the next window have as many contacts as are aimed at.
  void adapt(double length, std::uint64_t contacts) {
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

  std::vector<std::unique_ptr<Member>> domains_;
  Exchange exchange_;
  std::vector<double> bad_;
  std::vector<Event> peeked_;
  WindowSettings settings_;
  ForEach for_each_;
  double committed_;
  bool is_complete_ = false;
  double window_;
  std::uint64_t steps_in_a_row_ = 0;
  double wanted_ = 0;  // the length of the open window, unless it fails or something ends it
  double horizon_ = -std::numeric_limits<double>::infinity();
  bool are_logs_kept_ = false;
  OpenWindow open_;
  std::vector<std::uint64_t> done_;  // contacts that have been committed, by domain
  Counters counted_;
  WindowCounters window_counters_;
};

}  // namespace hardball
