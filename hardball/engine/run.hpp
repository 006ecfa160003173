// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "hardball/geometry/inlining.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/geometry/time.hpp"
#include "hardball/interaction/contact.hpp"
#include "hardball/memory/function.hpp"

namespace hardball {

/// The limits of a run, which stops at whichever comes first.
struct RunLimits {
  /// Events at exactly this time still happen: all whose time rounds to the same double.
  Time until = kNever;
  std::uint64_t contacts = std::numeric_limits<std::uint64_t>::max();
  /// Steps: all events, stale ones included, velocities changed by a thermostat, and samples of measures. A
  /// bound on the work.
  std::uint64_t steps = std::numeric_limits<std::uint64_t>::max();
  /// Whether to stop: asked by Simulation at the start and some hundred times a second, between events, in
  /// the thread that runs; if it throws, the run ends, too. A run that was stopped can be run on, to the same
  /// history. It may query the simulation, whose time() is up to date, but not edit it. A function and not a
  /// flag, as what to look at differs: an atomic variable, a std::stop_token, a signal that Python has to
  /// look up itself, a clock. Of several processes only the first is asked, and all stop; if it throws there,
  /// it throws in the first process alone.
  Function<bool()> stop = {};
};

/// Until when events happen in a run up to `until`: a run without end ends with the operating range. There,
/// by inelastic impacts, spheres may become slower and slower for ever.
inline Time within_range(const Time& until) {
  return std::min(until, Time(kLargestTime));
}

/// Why a run stopped.
enum class RunStatus {
  time_reached,      ///< No event remains up to RunLimits::until.
  contacts_reached,  ///< RunLimits::contacts have happened.
  steps_reached,     ///< RunLimits::steps have been taken.
  stopped,           ///< RunLimits::stop asked for it.
  observer_stopped,  ///< The observer asked for it.
  outdated,          ///< A sphere does not fit the structures of the engine, and `rebuild` must follow.
};

/// An observer of the contacts of a run, called in their order.
struct ContactObserver {
  /// Called with each contact; returns whether the run continues. Empty for no observer.
  Function<bool(const Contact&)> on_contact = {};
  /// Whether it may look at the world or at sums over contacts, or stop the run. If not, it is called when
  /// later contacts may have happened already, which costs less in several domains; if it throws, the run
  /// ends after those.
  bool looks_around = true;

  explicit operator bool() const { return static_cast<bool>(on_contact); }
  /// Whether there is an observer that may query the world.
  bool needs_world() const { return on_contact && looks_around; }
};

/// Calls an observer with a contact, and returns whether the run continues: an observer that returns a bool
/// decides.
template <class Observe>
HARDBALL_ALWAYS_INLINE bool notify(Observe& observe, const Contact& contact) {
  if constexpr (std::same_as<std::invoke_result_t<Observe&, const Contact&>, bool>) {
    return observe(contact);
  } else {
    observe(contact);
    return true;
  }
}

/// What an engine has done since its construction: the paper's n_c is collision + wall, its n_e is enter +
/// leave.
struct Counters {
  std::uint64_t collision = 0;
  std::uint64_t wall = 0;
  std::uint64_t enter = 0;
  std::uint64_t leave = 0;
  std::uint64_t stale = 0;                ///< Predictions made again because a partner's path had changed.
  std::uint64_t predictions = 0;          ///< Candidates bounded or computed, with repetitions and padding.
  std::uint64_t contact_predictions = 0;  ///< Predictions made after contacts.
  std::uint64_t enter_predictions = 0;    ///< Predictions made after crossings.
  std::uint64_t queue_operations = 0;     ///< Entries inserted into the queue or removed.
  std::uint64_t rebuilds = 0;             ///< How often all regions and predictions were rebuilt.

  std::uint64_t contacts() const { return collision + wall; }
  friend bool operator==(const Counters&, const Counters&) = default;
  friend Counters operator+(const Counters& a, const Counters& b) { return a - (Counters{} - b); }
  /// What has been done between two moments. Precondition: `before` is of the earlier one.
  friend Counters operator-(Counters after, const Counters& before) {
    after.collision -= before.collision;
    after.wall -= before.wall;
    after.enter -= before.enter;
    after.leave -= before.leave;
    after.stale -= before.stale;
    after.predictions -= before.predictions;
    after.contact_predictions -= before.contact_predictions;
    after.enter_predictions -= before.enter_predictions;
    after.queue_operations -= before.queue_operations;
    after.rebuilds -= before.rebuilds;
    return after;
  }
  static void persist(auto& archive, auto& self) {
    archive(self.collision, self.wall, self.enter, self.leave, self.stale, self.predictions,
            self.contact_predictions, self.enter_predictions, self.queue_operations, self.rebuilds);
  }
};

}  // namespace hardball
