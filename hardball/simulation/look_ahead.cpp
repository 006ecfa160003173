// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The future, if nobody interferes.
#include <utility>

#include "hardball/geometry/range.hpp"
#include "hardball/simulation/agenda.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/simulation/tuner.hpp"

namespace hardball {

std::optional<NextContact> Simulation::next_contact(double until) {
  check_idle("next_contact");
  check_not_past(Time(until));
  tuner_->make_ready(now_);
  AnyEngine& engine = tuner_->engine();
  const Time end(until);
  const Time action = next_action();
  const bool acts = action <= end && action < kNever;
  if (engine.aftermath().merged.empty()) {
    if (!world().has_journal()) engine.begin_journal(later(now_, engine.now()));
    const std::optional<Event> next = engine.next_contact(acts ? action : end);
    if (next) return NextContact{next->time.value(), next->kind, next->first, next->second};
    if (!acts) return std::nullopt;
  }
  std::optional<NextContact> first;
  look_ahead(end, 1, [&first](const Contact& contact) {
    first = {contact.time.value(), contact.kind, contact.first, contact.second};
  });
  return first;
}

std::vector<Contact> Simulation::contacts_within(double duration, std::uint64_t most) {
  if (activity_.kind() == Activity::Kind::running) check_idle("contacts_within");
  const Time until = after(now_, duration);
  check_not_past(until);
  check_moment(until, "duration");
  // The listener runs in the middle of a run of the engine.
  if (!activity_.is_idle()) return Simulation(*this).contacts_within(duration, most);
  std::vector<Contact> contacts;
  look_ahead(until, most, [&contacts](const Contact& contact) { contacts.push_back(contact); });
  return contacts;
}

// The same with a copy of the whole, at its cost.
void Simulation::look_ahead_in_copy(const Time& until, std::uint64_t most,
                                    const Function<void(const Contact&)>& observe) const {
  Simulation copy(*this);
  copy.log_ = {};
  copy.change_listener_ = {};
  copy.epoch_listener_ = {};
  copy.on_contact(observe);
  copy.run({.until = until, .contacts = most});
}

// Runs the engine ahead, up to so many contacts, and takes it back.
void Simulation::look_ahead(const Time& until, std::uint64_t most,
                            const Function<void(const Contact&)>& observe) {
  // Epochs of growth follow from sums that a look-ahead does not keep.
  if (growth_ && !growth_->is_over()) return look_ahead_in_copy(until, most, observe);
  const Activity::During running(activity_, Activity::Kind::running);
  const std::optional<Thermostat> thermostat = thermostat_;
  const Counters before = counters();
  tuner_->end_look_ahead(now_);
  tuner_->make_ready(now_);
  tuner_->engine().begin_journal(later(now_, tuner_->engine().now()));
  const auto take_back = [&] {
    tuner_->undo_look_ahead(before);
    thermostat_ = thermostat;
  };
  ContactSums unused = sums_.part();
  Time last_change = sums_.tally.last_change();
  const auto note = [&](const Contact& contact) {
    last_change = contact.time;
    if (contact.outcome == ContactOutcome::merge) forget_at_thermostat(contact.second);
    observe(contact);
    return !is_rescheduled_;
  };
  try {
    Agenda agenda({.until = until, .contacts = most}, now_);
    do {
      is_rescheduled_ = false;
      if (tuner_->engine().is_outdated()) tuner_->rebuild(later(now_, tuner_->engine().now()));
      const Agenda::Item item =
          agenda.advance(*tuner_, next_action(), kNever, contacts_of_epoch(), unused, {.note = note});
      if (item == Agenda::Item::action) {
        last_change = later(agenda.reached(), last_change);
        let_thermostat_act(last_change);
      }
    } while (!agenda.is_over());
  } catch (...) {
    take_back();
    throw;
  }
  take_back();
}

}  // namespace hardball
