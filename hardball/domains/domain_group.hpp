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

#include "hardball/domains/domain.hpp"
#include "hardball/domains/exchange.hpp"
#include "hardball/domains/load.hpp"
#include "hardball/domains/merged_log.hpp"
#include "hardball/domains/window_settings.hpp"
#include "hardball/engine/run.hpp"
#include "hardball/engine/window_counters.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/memory/for_each.hpp"
#include "hardball/processes/bytes.hpp"

namespace hardball {

/// Domains that together are one system: in windows of time they run apart, compare, and go back where they
/// were wrong, so that the contacts are those of one engine to the last bit. Source: docs/parallel.md.
///
/// A window is opened, which finds what happens in it, and then either committed or cut short.
///
/// Some of the domains may be in other processes, each with a cluster of its own: their members are called in
/// all at once, with the same arguments, and return the same.
class DomainGroup {
 public:
  /// What becomes of the contacts of a window.
  struct Kept {
    bool log = false;  ///< Contacts are kept in a log.
    bool sums = true;  ///< Contacts are added up when the window is committed.
  };

  /// Takes over domains that together, with those that `exchange` reaches, hold a world as it is at `now`.
  DomainGroup(std::vector<std::unique_ptr<Domain>> domains, const Time& now, const WindowSettings& settings,
              ForEach for_each, Exchange exchange);
  /// A copy that works in its own way.
  DomainGroup(const DomainGroup& other, ForEach for_each);

  /// How many domains are in this process, and these.
  std::size_t size() const { return domains_.size(); }
  const Domain& domain(std::size_t number) const { return *domains_[number]; }
  Domain& domain(std::size_t number) { return *domains_[number]; }
  const WindowCounters& window_counters() const { return window_counters_; }

  /// How many collisions and contacts with walls have been committed.
  const Counters& counted() const { return counted_; }
  /// How many contacts the open window has.
  std::uint64_t open_contacts() const { return open_.contacts.contacts(); }
  /// What has been done since the start, by all domains. Cost: a message to each process.
  Load load() const;
  /// Up to which all has happened [T].
  double committed() const { return committed_; }
  /// The time of the last event, which rounds to committed(). Cost: O(domains), and a message to each
  /// process.
  Time now() const;
  /// Whether all events that round to committed() have happened, too.
  bool is_complete() const { return is_complete_; }

  /// Opens a window that ends no later than `end` and has at most `most` contacts, and returns their number.
  /// Precondition: `end` is not before committed() nor after kLargestTime; `most` is not zero; no window is
  /// open. Error: what engines throw; then all before it has been committed, and no window is open.
  std::uint64_t open_window(double end, std::uint64_t most, const Kept& kept);
  /// The contacts of the open window in all processes, if its log is kept; refers to this cluster until the
  /// next window.
  MergedLog merged_log();
  /// Takes the open window as what has happened.
  void commit_window();
  /// Ends the open window after the first `contacts` of its contacts. Precondition: it has that many, and
  /// they are kept in a log and not added up.
  void cut_window(std::uint64_t contacts);

  /// The next contact up to `end`, without executing it: only crossings happen. Precondition: as for
  /// open_window.
  Event next_contact(double end);

  /// Watches all boundaries anew before the next window, as paths have been edited.
  void watch_anew() { horizon_ = -std::numeric_limits<double>::infinity(); }

  /// Whether any event will ever happen.
  bool has_events() const;

  /// Lets the domains in this process begin to add up contacts, each with an empty part of `sums`.
  void clear_sums(const ContactSums& sums) {
    each([part = sums.part()](Domain& domain, std::size_t) { domain.clear_sums(part); });
  }
  /// Adds what they have added up since then.
  void add_sums_to(ContactSums& sums) const {
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

  void connect();

  Processes& processes() const { return exchange_.processes(); }

  void keep(const Kept& kept);

  // Of a domain in a window. If it has many more than are aimed at, the window is much too long: the spheres
  // have become fast, perhaps only because ghosts are wrong. Where single steps follow one another, as in a
  // collapse, the window between two of them is tried for ever fewer contacts.
  std::uint64_t most_contacts() const;

  void watch_if_due();

  // What the domains did up to `until`.
  Findings compare(double until);

  void commit();

  void share_last_passage();

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

  void undo();

  // The double before the time of the last of these contacts.
  double time_before(std::uint64_t contacts);

  // Opens a window that ends with the next contact of all, if that is to be executed, or as far ahead as
  // domains know what their spheres touch. Returns the next contact, if it is known; if it is not to be
  // executed, no window is open then.
  Event step(double end, bool executes);

  Event earliest_peeked();

  // Error: that of the domain in which it fails; if it fails in two, of the one that owns the first sphere,
  // as a single engine would. In several processes, a RunFailure.
  void execute(const Event& next);

  void note_failure(double length);

  // Long enough to get on.
  double least_window() const { return std::max(0x1p-20 * settings_.first, 0x1p-44 * std::fabs(committed_)); }

  // Lets the next window have as many contacts as are aimed at.
  void adapt(double length, std::uint64_t contacts);

  std::vector<std::unique_ptr<Domain>> domains_;
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
  std::vector<std::vector<LoggedContact>> logs_;  // of the open window in all processes, by domain
  std::vector<std::uint64_t> done_;               // contacts that have been committed, by domain
  Counters counted_;
  WindowCounters window_counters_;
};

}  // namespace hardball
