// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <utility>

#include "hardball/engine/check_forecast.hpp"
#include "hardball/engine/forecast.hpp"
#include "hardball/engine/prefetching.hpp"
#include "hardball/engine/run.hpp"
#include "hardball/engine/standstill_guard.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/events/event_queue.hpp"
#include "hardball/response/execute.hpp"
#include "hardball/world/new_velocity.hpp"
#include "hardball/world/progress.hpp"

namespace hardball {

/// The event loop: take the least event, execute it, predict again.
///
/// The queue holds one event per sphere: the earlier of its crossing (broad phase) and its prospect, which
/// the forecast knows. A prospect is a contact computed exactly, or a bound of it; only exact contacts are
/// ever executed, so that bounds affect the speed and not the history. An engine is a value: it can be
/// copied, and many can coexist.
template <EventQueue Queue, BroadPhase Phase, Response Respond>
class Engine {
 public:
  /// Takes over a world as it is at `now`. Precondition: no path starts later, no two spheres overlap.
  Engine(World world, Phase phase, Respond respond, const Time& now,
         InstructionSet instructions = widest_instruction_set(), const Progress& progress = {})
      : forecast_(std::move(world), std::move(phase), instructions), respond_(std::move(respond)) {
    rebuild(now, progress);
  }

  const World& world() const { return forecast_.world(); }
  const Phase& phase() const { return forecast_.phase(); }
  Respond& response() { return respond_; }
  CollapseGuard& collapse_guard() { return guard_; }
  const CollapseGuard& collapse_guard() const { return guard_; }
  /// The time of the last event handled.
  const Time& now() const { return forecast_.now(); }

  Counters counters() const {
    Counters counters = counters_ + forecast_.counters();
    const QueueCounters queue = queue_.counters();
    counters.leave += forecast_.phase().left_count();
    counters.queue_operations += queue.scheduled + queue.taken;
    return counters;
  }

  std::size_t memory_bytes() const {
    return forecast_.memory_bytes() + queue_.memory_bytes() + guard_.memory_bytes();
  }

  /// Handles events in order, calling observe(contact) after every collision and wall contact. The observer
  /// may call change_velocities; after any other edit, and if two spheres have merged, it must stop the run
  /// by returning false, and `rebuild` must follow. Error: RunFailure on inelastic collapse; whatever the
  /// response or the observer throws. If the response throws, its event has not happened.
  template <class Observe>
  RunStatus run(const RunLimits& limits, Observe&& observe) {
    std::uint64_t contacts = 0;
    if (limits.contacts == 0) return RunStatus::contacts_reached;
    for (std::uint64_t step = 0;; ++step) {
      forecast_.keep_copies_good([this](Slot slot) { queue_.schedule(slot, forecast_); });
      const Slot next = least_until(limits.until);
      if (next == kNoOwner) return RunStatus::time_reached;
      if (step == limits.steps) return RunStatus::steps_reached;
      prefetching_.prefetch_ahead(forecast_, queue_);
      if (handle_without_contact(next)) continue;
      const bool goes_on = notify(observe, carry_out(next));
      if constexpr (HARDBALL_VALIDATE) {
        if (goes_on) validate_now_and_then();
      }
      if (++contacts == limits.contacts) return RunStatus::contacts_reached;
      if (!goes_on) return RunStatus::observer_stopped;
    }
  }

  /// Merges two spheres that overlap now, which the engine has not scheduled, if the response does so; then
  /// `rebuild` must follow. Error: as for `run`.
  std::optional<Contact> merge_besides(const Event& overlap) {
    if (!merge_if_decided(forecast_.world(), overlap, respond_, done_)) return std::nullopt;
    ++counters_.collision;
    return done_.contact;
  }

  /// The next collision or wall contact up to `until`, without carrying it out.
  std::optional<Event> next_contact(const Time& until) {
    for (;;) {
      const Slot next = least_until(until);
      if (next == kNoOwner) return std::nullopt;
      if (!handle_without_contact(next)) return forecast_.contact_of(next);
    }
  }

  /// Changes velocities at `moment`, each of another sphere. Precondition: all events before it have been
  /// handled, and none after it. Cost: a prediction each.
  void change_velocities(const Time& moment, std::span<const NewVelocity> changes) {
    HARDBALL_CHECK(moment >= now());
    forecast_.advance(moment);
    for (const NewVelocity& change : changes) {
      forecast_.note_new_path(change.slot,
                              forecast_.world().change_velocity(change.slot, moment, change.after));
    }
    for (const NewVelocity& change : changes) {
      forecast_.predict(change.slot);
      queue_.schedule(change.slot, forecast_);
    }
  }

  /// Discards all predictions and regions and rebuilds them as of `now`, with another broad phase. The motion
  /// is not affected. Cost: O(n).
  void rebuild(const Time& now, Phase phase) {
    const QueueCounters queue = queue_.counters();
    counters_.leave += forecast_.phase().left_count();
    counters_.queue_operations += queue.scheduled + queue.taken;
    ++counters_.rebuilds;
    forecast_.replace(std::move(phase));
    rebuild(now, Progress());
  }

  /// The world for editing between runs; `rebuild` must follow.
  World& world_to_edit() { return forecast_.world(); }

  /// Checks every structure, and that every contact is predicted; throws BrokenInvariant. Cost:
  /// O(candidates).
  void validate() const { hardball::validate(forecast_); }

 private:
  void rebuild(const Time& now, const Progress& progress) {
    forecast_.rebuild(now, progress);
    queue_.reset(world().size(), now);
    for (Slot slot = 0; slot < world().size(); ++slot) queue_.schedule(slot, forecast_);
  }

  // Whose event is the least, if it comes no later than `until`; otherwise kNoOwner.
  Slot least_until(const Time& until) {
    const Slot next = queue_.least(forecast_);
    return next == kNoOwner || forecast_.time(next) > until.high ? kNoOwner : next;
  }

  // Handles what is no contact, or not yet known to be one; false if the sphere's event is a valid contact.
  bool handle_without_contact(Slot slot) {
    const Plan& plan = forecast_.plan(slot);
    const double time = plan.time();
    HARDBALL_CHECK(time >= rounded_down(now()));
    const bool is_crossing = plan.crosses_first();
    const bool is_unknown = !is_crossing && forecast_.is_unknown(slot);
    if (!is_crossing && !is_unknown && !plan.is_bound()) return false;
    // No contact has been missed up to the double before.
    advance(later(now(), Time(double_before(time))));
    queue_.pop();
    if (is_crossing) {
      forecast_.cross(slot);
    } else if (is_unknown) {
      forecast_.predict_unknown(slot);
    } else {
      forecast_.refine_or_predict(slot);
    }
    queue_.schedule(slot, forecast_);
    return true;
  }

  const Contact& carry_out(Slot slot) {
    const Plan& plan = forecast_.plan(slot);
    const bool is_collision = plan.has_partner();
    const Slot partner = is_collision ? plan.partner() : slot;
    const SphereId id = forecast_.id(slot);
    const SphereId partner_id = forecast_.id(partner);
    // Branchless: which id is lower is unpredictable.
    const Slot exchange = (slot ^ partner) & (Slot{0} - static_cast<Slot>(partner_id < id));
    const Participants participants{slot ^ exchange, partner ^ exchange, forecast_.uses_minimum_image()};
    const Event event = is_collision
                            ? make_collision(plan.moment(), id, partner_id, forecast_.image_in_event(slot))
                            : Event{plan.moment(), EventKind::wall, id, plan.wall(), {}};
    standstill_guard_.note_event(now(), event.time, world().size());
    execute(forecast_.world(), guard_, event, participants, respond_, done_);
    forecast_.advance(event.time);
    ++(is_collision ? counters_.collision : counters_.wall);
    queue_.pop();
    if (done_.contact.fate == Fate::merge) [[unlikely]]
      return done_.contact;
    const std::uint64_t predictions_before = forecast_.counters().predictions;
    forecast_.note_new_path(participants.first, done_.folded[0]);
    if (is_collision) {
      forecast_.note_new_path(participants.second, done_.folded[1]);
      forecast_.predict_both(participants.first, participants.second);
    } else {
      forecast_.predict(participants.first);
    }
    counters_.contact_predictions += forecast_.counters().predictions - predictions_before;
    queue_.schedule(participants.first, forecast_);
    if (is_collision) queue_.schedule(participants.second, forecast_);
    return done_.contact;
  }

  void advance(const Time& moment) {
    standstill_guard_.note_event(now(), moment, world().size());
    forecast_.advance(moment);
  }

  // Full checks after contacts 1, 2, 4, 8, ... only, to keep validating runs affordable.
  void validate_now_and_then() const {
    const std::uint64_t contacts = counters_.contacts();
    if ((contacts & (contacts - 1)) == 0) validate();
  }

  Forecast<Phase> forecast_;
  Queue queue_;
  Respond respond_;
  CollapseGuard guard_;
  StandstillGuard standstill_guard_;
  Prefetching prefetching_;
  Executed done_;  // the last contact
  Counters counters_;
};

}  // namespace hardball
