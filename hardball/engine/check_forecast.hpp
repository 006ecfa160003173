// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "hardball/engine/predictor.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/events/plan.hpp"
#include "hardball/world/images.hpp"
#include "hardball/world/pair_event.hpp"
#include "hardball/world/walls.hpp"

namespace hardball {

// A forecast compared with the exact times of all contacts, one by one.

/// Compares the bounds of a sphere's contacts with its candidates, in validating builds; throws
/// BrokenInvariant.
template <class Forecast>
void check_bounds([[maybe_unused]] const Forecast& forecast, [[maybe_unused]] const Candidates& candidates,
                  [[maybe_unused]] const BoundedContacts& found) {
  if constexpr (HARDBALL_VALIDATE) {
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const Event contact = contact_with(forecast.world(), candidates, i, forecast.now());
      if (!forecast.phase().are_candidates(candidates.self(), candidates.slot(i))) continue;
      const bool is_partner = candidates.slot(i) == found.partner;
      HARDBALL_CHECK((is_partner ? found.least : found.second) <= contact.time.high);
    }
  }
}

/// Compares the bounds of a sphere's events with those that are inside of a step with it, in validating
/// builds; throws BrokenInvariant.
template <class Forecast>
void check_bounds([[maybe_unused]] const Forecast& forecast, [[maybe_unused]] const StepCandidates& pairs,
                  [[maybe_unused]] const BoundedContacts& found) {
  if constexpr (HARDBALL_VALIDATE) {
    const World& world = forecast.world();
    for (const PairLevel& pair : pairs.pairs()) {
      const Image image = nearest_image(world, pairs.self(), pair.partner, forecast.now());
      const Time time = next_pair_event(world, pairs.self(), pair, image).time;
      HARDBALL_CHECK((pair.partner == found.partner ? found.least : found.second) <= time.high);
    }
  }
}

/// Checks that a sphere touches no solid before another time [T], in validating builds; throws
/// BrokenInvariant.
template <class Forecast>
void check_clear([[maybe_unused]] const Forecast& forecast, [[maybe_unused]] Slot slot,
                 [[maybe_unused]] double until) {
  if constexpr (HARDBALL_VALIDATE) {
    // What is predicted beyond an epoch of growth does not happen.
    const double end = std::min(until, forecast.world().motion().growth().end.high);
    HARDBALL_CHECK(!(next_solid_event(forecast.world(), slot, forecast.now(), end).time.high < end));
  }
}

/// Whether a sphere answers for its contact with another: the contact cannot come before what it has planned.
template <class Forecast>
bool covers(const Forecast& forecast, Slot slot, const Event& contact, Slot other) {
  const Plan& plan = forecast.plan(slot);
  if (forecast.is_unknown(slot)) return plan.contact() <= contact.time.high;
  if (!plan.is_bound()) return forecast.contact_of(slot) <= contact;
  return (plan.partner() == other ? plan.contact() : plan.safe_until()) <= contact.time.high;
}

/// Whether a sphere has no such candidate yet, but crosses before their contact.
template <class Forecast>
bool is_found_in_time(const Forecast& forecast, Slot slot, const Event& contact, Slot other) {
  Candidates candidates;
  forecast.phase().collect(forecast.world(), slot, candidates);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (candidates.slot(i) == other) return false;
  }
  return forecast.plan(slot).crossing() <= contact.time.high;
}

/// Checks every structure, and that every contact is predicted; throws BrokenInvariant. Cost: O(candidates).
template <class Forecast>
void validate(const Forecast& forecast) {
  const World& world = forecast.world();
  forecast.phase().validate(world, forecast.now(), forecast.copies());
  Candidates candidates;
  for (Slot slot = 0; slot < world.size(); ++slot) {
    HARDBALL_CHECK(forecast.id(slot) == world.id(slot));
    HARDBALL_CHECK(forecast.plan(slot).time() >= rounded_down(forecast.now()));
    forecast.collect(slot, candidates);
    const auto check = [&](const Event& contact, Slot other) {
      if (!contact.happens() || !forecast.phase().are_candidates(slot, other)) return;
      HARDBALL_CHECK(covers(forecast, slot, contact, other) || covers(forecast, other, contact, slot) ||
                     is_found_in_time(forecast, other, contact, slot));
    };
    for (std::size_t i = 0; i < candidates.size(); ++i)
      check(contact_with(world, candidates, i, forecast.now()), candidates.slot(i));
    for (const PairLevel& pair : world.pair_levels().of(slot)) {
      const Image image = nearest_image(world, slot, pair.partner, forecast.now());
      const Event event = make_collision(next_pair_event(world, slot, pair, image).time, world.id(slot),
                                         world.id(pair.partner), image);
      HARDBALL_CHECK(!event.happens() || covers(forecast, slot, event, pair.partner) ||
                     covers(forecast, pair.partner, event, slot));
    }
  }
}

}  // namespace hardball
