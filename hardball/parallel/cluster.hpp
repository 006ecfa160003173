// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "hardball/memory/function.hpp"
#include "hardball/parallel/domain.hpp"

namespace hardball {

/// Calls work(k) for each k below a count, perhaps for several at once, and returns when all have returned.
using ForEach = Function<void(std::size_t count, const Function<void(std::size_t)>& work)>;

/// How long windows are.
struct WindowSettings {
  double contacts = 1000;  ///< So many are aimed at in a window, by all domains.
  double first = 1;        ///< The length of the first window [T].
};

/// What a cluster has done to run windows.
struct WindowCounters {
  std::uint64_t windows = 0;  ///< Committed, single steps included.
  std::uint64_t failed = 0;   ///< Undone, as a domain was wrong.
  std::uint64_t steps = 0;    ///< Of at most one contact, where no window was short enough.
};

/// Domains that together are one system: in windows of time they run apart, compare, and go back where they
/// were wrong, so that the contacts are those of one engine to the last bit. Source: docs/parallel.md.
template <class Engine, class Sums>
class Cluster {
 public:
  using Member = Domain<Engine, Sums>;

  Cluster(std::vector<std::unique_ptr<Member>> domains, const Time& now, const WindowSettings& settings,
          const PhaseSettings& phase, ForEach for_each)
      : domains_(std::move(domains)),
        inboxes_(domains_.size()),
        bad_(domains_.size()),
        peeked_(domains_.size()),
        settings_(settings),
        phase_(phase),
        for_each_(std::move(for_each)),
        committed_(now.high),
        window_(settings.first) {
    for (std::size_t domain = 0; domain < size(); ++domain) {
      for (const DomainNumber neighbor : domains_[domain]->neighbors())
        inboxes_[domain].push_back(&domains_[neighbor]->outbox_to(static_cast<DomainNumber>(domain)));
    }
  }

  std::size_t size() const { return domains_.size(); }
  const Member& domain(std::size_t number) const { return *domains_[number]; }
  Member& domain(std::size_t number) { return *domains_[number]; }
  const WindowCounters& window_counters() const { return window_counters_; }
  /// Up to which all has happened [T].
  double committed() const { return committed_; }

  /// Runs all domains until every event whose time rounds to `until` or earlier has happened, or so many
  /// contacts have; returns how many were left. Precondition: `until` is finite.
  std::uint64_t run(double until, std::uint64_t contacts) {
    while (contacts > 0) {
      watch_if_due();
      const double end = std::min({until, committed_ + window_, horizon_});
      keep_logs(static_cast<double>(contacts) < 4 * settings_.contacts);
      std::uint64_t done = 0;
      if (!run_window(end, contacts, done)) continue;
      contacts -= done;
      if (committed_ == until && !was_step_) break;
    }
    return contacts;
  }

 private:
  template <class Work>
  void each(Work&& work) {
    for_each_(size(), [&](std::size_t domain) { work(*domains_[domain], domain); });
  }

  void keep_logs(bool is_kept) {
    for (auto& domain : domains_) domain->keep_log(is_kept);
    are_logs_kept_ = is_kept;
  }

  void watch_if_due() {
    if (committed_ < horizon_) return;
    constexpr double kWindows = 64;
    horizon_ = committed_ + kWindows * window_;
    each([&](Member& domain, std::size_t) { domain.watch(horizon_); });
  }

  std::uint64_t count() const {
    std::uint64_t contacts = 0;
    for (const auto& domain : domains_) contacts += domain->counted().contacts();
    return contacts;
  }

  // A time before which what the domains did up to `until` is right; infinity if all is.
  double compare(double until) {
    each([&](Member& domain, std::size_t k) { bad_[k] = domain.verify(inboxes_[k], until); });
    each([&](Member& domain, std::size_t k) { bad_[k] = std::min(bad_[k], domain.doubtful_since(inboxes_[k])); });
    return *std::ranges::min_element(bad_);
  }

  void commit(double until) {
    each([&](Member& domain, std::size_t) { domain.commit(until); });
    each([&](Member& domain, std::size_t k) {
      domain.receive(inboxes_[k]);
      domain.make_ready(phase_);
    });
    committed_ = until;
    ++window_counters_.windows;
  }

  void undo() {
    each([&](Member& domain, std::size_t) {
      domain.undo();
      domain.make_ready(phase_);
    });
  }

  // Runs a window of at most so many contacts, which may be cut short; false if it was undone.
  bool run_window(double end, std::uint64_t most, std::uint64_t& done) {
    was_step_ = false;
    const double begin = committed_;
    for (double until = end;;) {
      each([&](Member& domain, std::size_t) { domain.run(until); });
      const double bad = compare(until);
      done = count();
      if (bad > until && done <= most) {
        commit(until);
        adapt(until - begin, done);
        return true;
      }
      const bool is_wrong = bad <= until;
      const bool is_cut = is_wrong || are_logs_kept_;
      const double cut = is_wrong ? double_before(bad) : is_cut ? time_before(most) : until;
      undo();
      if (is_wrong) {
        ++window_counters_.failed;
        window_ = std::max(window_ / 2, (until - begin) / 2);
      }
      if (!is_cut) keep_logs(true);
      if (cut <= begin) return step(end, done);
      until = cut;
    }
  }

  // The double before the last of so many contacts.
  double time_before(std::uint64_t contacts) const {
    std::vector<double> times;
    for (const auto& domain : domains_) {
      for (const LoggedContact& logged : domain->log()) {
        if (logged.counts) times.push_back(logged.contact.time.high);
      }
    }
    const auto last = times.begin() + static_cast<std::ptrdiff_t>(contacts - 1);
    std::ranges::nth_element(times, last);
    return double_before(*last);
  }

  // Executes the next contact of all, or moves on as far as domains know whom their spheres meet.
  bool step(double end, std::uint64_t& done) {
    was_step_ = true;
    const double begin = committed_;
    for (double until = end;;) {
      each([&](Member& domain, std::size_t k) { peeked_[k] = domain.peek(until); });
      const Event next = *std::ranges::min_element(peeked_);
      const double to = next.happens() ? next.time.high : until;
      each([&](Member& domain, std::size_t k) {
        domain.end_peek(to);
        bad_[k] = domain.verify(inboxes_[k], to);
      });
      const double bad = *std::ranges::min_element(bad_);
      const bool is_known = bad > to;
      const double cut = is_known ? to : double_before(bad);
      if (cut < begin || (cut == begin && !is_known)) {
        // Not even that far: a shorter way shows less.
        undo();
        until = std::max(begin + (to - begin) / 16, std::nextafter(begin, end));
        continue;
      }
      const bool acts = is_known && next.happens();
      if (acts) {
        each([&](Member& domain, std::size_t k) { domain.execute_if_next(peeked_[k], next); });
        HARDBALL_CHECK(count() == 1);
      }
      const Time moment = acts ? later(Time(cut), next.time) : Time(cut);
      each([&](Member& domain, std::size_t) { domain.end_step(later(moment, domain.begin())); });
      compare(cut);
      done = acts ? 1 : 0;
      commit(cut);
      ++window_counters_.steps;
      return true;
    }
  }

  // Lets the next window have as many contacts as are aimed at.
  void adapt(double length, std::uint64_t contacts) {
    constexpr double kMost = 1.5;
    const double most = kMost * window_;
    if (contacts == 0) {
      if (length >= window_) window_ = most;
    } else {
      const double wanted = length * settings_.contacts / static_cast<double>(contacts);
      window_ = std::clamp(wanted, window_ / kMost, most);
    }
  }

  std::vector<std::unique_ptr<Member>> domains_;
  std::vector<std::vector<const Outbox*>> inboxes_;  // by domain and neighbor
  std::vector<double> bad_;
  std::vector<Event> peeked_;
  WindowSettings settings_;
  PhaseSettings phase_;
  ForEach for_each_;
  double committed_;
  double window_;
  double horizon_ = -std::numeric_limits<double>::infinity();
  bool are_logs_kept_ = false;
  bool was_step_ = false;
  WindowCounters window_counters_;
};

}  // namespace hardball
