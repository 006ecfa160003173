// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The future without interference.
#include <utility>

#include "hardball/geometry/range.hpp"
#include "hardball/run/engine_manager.hpp"
#include "hardball/run/run_schedule.hpp"
#include "hardball/simulation/simulation.hpp"

namespace hardball {

std::optional<NextContact> Simulation::next_contact(double until) {
  check_idle("next_contact");
  check_not_past(Time(until));
  check_driven();
  moving_.reset();
  manager_->make_ready(now_);
  EngineBase& engine = manager_->engine();
  const Time end(until);
  const Time action = actors_.next().next();
  const bool acts = action <= end && action < kNever;
  if (engine.post_contact_state().merged.empty()) {
    if (!setting().has_journal()) engine.begin_journal(later(now_, engine.now()));
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
  check_driven();
  // The listener runs in the middle of a run of the engine.
  if (!activity_.is_idle()) return Simulation(*this).contacts_within(duration, most);
  std::vector<Contact> contacts;
  look_ahead(until, most, [&contacts](const Contact& contact) { contacts.push_back(contact); });
  return contacts;
}

// Looks ahead with a copy of the simulation, at the cost of copying it.
void Simulation::look_ahead_in_copy(const Time& until, std::uint64_t most,
                                    const Function<void(const Contact&)>& observe) const {
  Simulation copy(*this);
  copy.observe({});
  copy.on_contact(observe);
  copy.run({.until = until, .contacts = most});
}

// Runs the engine ahead, up to a number of contacts, and rolls it back.
void Simulation::look_ahead(const Time& until, std::uint64_t most,
                            const Function<void(const Contact&)>& observe) {
  // A look-ahead does not keep such sums, nor undo what does not happen to spheres.
  if (actors_.depend_on_sums() || actors_.change_setting()) return look_ahead_in_copy(until, most, observe);
  const Activity::During running(activity_, Activity::Kind::running);
  moving_.reset();
  const Actors actors = actors_;
  const Counters before = counters();
  manager_->end_look_ahead(now_);
  manager_->make_ready(now_);
  manager_->engine().begin_journal(later(now_, manager_->engine().now()));
  const auto take_back = [&] {
    manager_->undo_look_ahead(before);
    actors_ = actors;
  };
  ContactSums unused = sums_.part();
  Time last_change = sums_.tally.last_change();
  const auto note = [&](const Contact& contact) {
    last_change = contact.time;
    if (contact.outcome == ContactOutcome::merge) is_rescheduled_ |= actors_.note_removed(contact.second);
    observe(contact);
    return !is_rescheduled_;
  };
  try {
    RunSchedule schedule({.until = until, .contacts = most}, now_);
    do {
      is_rescheduled_ = false;
      if (manager_->engine().needs_rebuild()) manager_->rebuild(later(now_, manager_->engine().now()));
      const RunSchedule::Item item = schedule.advance(*manager_, actors_.next().next(), kNever,
                                                      Actor::kAnyNumber, unused, {.on_contact = note});
      if (item == RunSchedule::Item::action) {
        last_change = later(schedule.reached(), last_change);
        carry_out(actors_.next().act(world(), unused.tally, last_change), last_change);
      }
    } while (!schedule.is_over());
  } catch (...) {
    take_back();
    throw;
  }
  take_back();
}

}  // namespace hardball
