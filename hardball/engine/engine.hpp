// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "hardball/engine/check_forecast.hpp"
#include "hardball/engine/engine_journal.hpp"
#include "hardball/engine/forecast.hpp"
#include "hardball/engine/prefetching.hpp"
#include "hardball/engine/put.hpp"
#include "hardball/engine/rewind.hpp"
#include "hardball/engine/run.hpp"
#include "hardball/engine/standstill_guard.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/events/event_queue.hpp"
#include "hardball/execution/aftermath.hpp"
#include "hardball/execution/execute.hpp"
#include "hardball/geometry/inlining.hpp"
#include "hardball/world/audit.hpp"
#include "hardball/world/new_velocity.hpp"
#include "hardball/world/progress.hpp"

namespace hardball {

/// The event loop: take the least event, execute it, predict again.
///
/// The queue holds one event per sphere: the earlier of its crossing (broad phase) and its planned contact,
/// which the forecast knows. A planned contact is a contact computed exactly, or a bound of it; only exact
/// contacts are ever executed, so bounds affect the speed and not the history. An engine is a value: it can
/// be copied, and many can coexist.
template <EventQueue Queue, BroadPhase Phase>
class Engine {
 public:
  /// Takes over a world as it is at `now`. Precondition: no path starts later, no two spheres overlap.
  Engine(World world, Phase phase, const Time& now, InstructionSet instructions = widest_instruction_set(),
         const Progress& progress = {})
      : forecast_(std::move(world), std::move(phase), instructions) {
    rebuild(now, progress);
  }

  const World& world() const { return forecast_.world(); }
  const Phase& phase() const { return forecast_.phase(); }
  /// See BroadPhase.
  static bool supports(const World& world, double length) { return Phase::supports(world, length); }
  PhaseLengths lengths() const { return phase().lengths(); }
  const Aftermath& aftermath() const { return aftermath_; }
  /// Continues for another engine, or with an aftermath that has been edited between runs.
  void take_over(const Aftermath& aftermath) { aftermath_ = aftermath; }
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
    return forecast_.memory_bytes() + queue_.memory_bytes() + aftermath_.collapse.memory_bytes();
  }

  /// Handles events in order, calling observe(contact) after every collision and wall contact. Spheres that
  /// have merged merge at once with those that they overlap, if the response does so. The observer may call
  /// change_velocities, `add` and `remove`, and stops the run by returning false. Error: RunFailure on
  /// inelastic collapse; whatever the response or the observer throws. If the response throws, its event has
  /// not happened.
  template <class Observe>
  RunStatus run(const RunLimits& limits, Observe&& observe) {
    std::uint64_t contacts = 0;
    std::uint64_t steps = 0;
    if (limits.contacts == 0) return RunStatus::contacts_reached;
    const Time until = within_range(limits.until);
    for (;;) {
      if (is_outdated_) [[unlikely]]
        return RunStatus::outdated;
      if (!aftermath_.merged.empty() && steps == limits.steps) [[unlikely]]
        return RunStatus::steps_reached;
      if (aftermath_.merged.empty() || !coalesce()) [[likely]] {
        Slot next;
        do {
          keep_copies_good();
          next = least_until(until);
          if (next == kNoOwner) return RunStatus::time_reached;
          if (steps++ == limits.steps) return RunStatus::steps_reached;
          prefetching_.prefetch_ahead(forecast_, queue_, observe);
        } while (handle_without_contact(next));
        carry_out(next);
      } else {
        ++steps;
      }
      const bool continues = notify(observe, std::as_const(done_.contact));
      if constexpr (HARDBALL_VALIDATE) {
        if (continues) validate_now_and_then();
      }
      if (++contacts == limits.contacts) return RunStatus::contacts_reached;
      if (!continues) return RunStatus::observer_stopped;
    }
  }

  /// The next collision or wall contact up to `until`, without executing it, and without asking
  /// whether spheres that have just merged do so again. Precondition: not is_outdated().
  std::optional<Event> next_contact(const Time& until) {
    for (;;) {
      const Slot next = least_until(within_range(until));
      if (next == kNoOwner) return std::nullopt;
      if (!handle_without_contact(next)) return forecast_.contact_of(next);
    }
  }

  /// Whether anything is to come, if only a crossing.
  bool has_events() { return queue_.least(forecast_) != kNoOwner; }

  /// Changes velocities at `moment`, each of another sphere. Precondition: all events before it have been
  /// handled, and none after it. Cost: a prediction each.
  void change_velocities(const Time& moment, std::span<const NewVelocity> changes) {
    for (const NewVelocity& change : changes) {
      const Image folded = forecast_.world().change_velocity(change.slot, moment, change.after);
      if (is_outdated_) continue;
      HARDBALL_CHECK(moment >= now());
      forecast_.advance(moment);
      forecast_.note_new_path(change.slot, folded);
    }
    if (is_outdated_) return;
    for (const NewVelocity& change : changes) {
      forecast_.predict(change.slot);
      queue_.schedule(change.slot, forecast_);
    }
  }

  /// Adds a sphere at `moment`, and returns its id. Precondition: as for change_velocities. Cost: as of a
  /// collision, amortized; O(large spheres) where some are much larger than cells. Error: see World::add and
  /// require_room.
  SphereId add(const Sphere& sphere, const Time& moment) {
    World& world = forecast_.world();
    const SphereId id = world.add(sphere, moment);
    const auto slot = static_cast<Slot>(world.size() - 1);
    const bool is_admitted = !is_outdated_ && forecast_.admits(slot);
    if (is_admitted) {
      HARDBALL_CHECK(moment >= now());
      forecast_.advance(moment);
      forecast_.insert(slot);
    }
    try {
      const std::vector<Slot> all = is_admitted ? std::vector<Slot>() : all_slots(world);
      const std::span<const Slot> others = is_admitted ? forecast_.overlapping(slot) : std::span(all);
      require_room(world, slot, others, moment);
      world.assign_levels(slot, others, moment);
    } catch (const Error&) {
      if (is_admitted) forecast_.erase(slot);
      world.undo_add();
      throw;
    }
    is_outdated_ = !is_admitted;
    if (is_outdated_) return id;
    queue_.add_owner(slot);
    forecast_.predict(slot);
    queue_.schedule(slot, forecast_);
    return id;
  }

  /// Removes a sphere at `moment`. Precondition: as for change_velocities. Cost: as of a collision. Error: no
  /// sphere has this id.
  void remove(SphereId id, const Time& moment) { remove_at(world().slot_of(id), moment); }
  /// The same of the sphere in a slot.
  void remove_at(Slot slot, const Time& moment) {
    journal_.note_merged(moment, aftermath_.merged);
    aftermath_.merged.forget(world().id(slot));
    if (is_outdated_) return forecast_.world().remove_at(slot, moment);
    HARDBALL_CHECK(moment >= now());
    forecast_.advance(moment);
    remove_from_forecast(slot);
  }

  /// See put.hpp. Precondition: as for change_velocities; there is no journal.
  void put(std::span<const SphereState> spheres, const Time& moment) {
    HARDBALL_CHECK(moment >= now());
    forecast_.advance(moment);
    std::vector<Slot> slots;
    is_outdated_ = !hardball::put(forecast_, spheres, !is_outdated_, slots);
    if (is_outdated_) return;
    for (const Slot slot : slots) queue_.add_owner(slot);
    predict_all(forecast_, queue_, slots);
  }

  /// See put.hpp. Precondition: likewise.
  void put_on_paths(std::span<const NewPath> paths, const Time& moment) {
    HARDBALL_CHECK(moment >= now());
    forecast_.advance(moment);
    std::vector<Slot> slots;
    hardball::put_on_paths(forecast_, paths, !is_outdated_, slots);
    if (!is_outdated_) predict_all(forecast_, queue_, slots);
  }

  /// Where the spheres of the last contact are stored. Precondition: they have not merged.
  const Participants& participants() const { return participants_; }

  /// Whether the broad phase does not fit the spheres, or is of a later time: `rebuild` must follow before
  /// the next run.
  bool is_outdated() const { return is_outdated_; }

  /// Starts to record what is needed to rewind to `moment` or a later one; discards earlier records.
  /// Precondition: as for change_velocities.
  void begin_journal(const Time& moment) {
    HARDBALL_CHECK(moment >= now());
    forecast_.advance(moment);
    journal_.begin(moment);
    forecast_.world().begin_journal();
    aftermath_.collapse.begin_journal();
  }
  void end_journal() {
    journal_.end();
    forecast_.world().end_journal();
    aftermath_.collapse.end_journal();
  }

  /// Goes back to `moment`, as if nothing had happened after it; only counters of work keep their values.
  /// Without a journal since then, nothing but crossings may have happened after it. Cost: as of what was
  /// done since; but where all has been rebuilt since, and without a journal, the engine is outdated
  /// afterwards.
  void rewind(const Time& moment) {
    if (!(now() > moment)) return;
    is_outdated_ |= !journal_.reaches(moment);
    undo(moment, moment);
  }
  /// Goes back to where the journal begins, before simultaneous events, too. Precondition: there is a
  /// journal. Cost: as of `rewind`.
  void rewind_to_begin() {
    is_outdated_ |= !journal_.reaches_begin();
    undo(EngineJournal::kLongAgo, journal_.begin_time());
  }

  /// Discards all predictions and regions and rebuilds them as of `now`, with a broad phase of these
  /// settings. The motion is not affected. Cost: O(n).
  void rebuild(const Time& now, const PhaseSettings& settings) {
    const QueueCounters queue = queue_.counters();
    counters_.leave += forecast_.phase().left_count();
    counters_.queue_operations += queue.scheduled + queue.taken;
    ++counters_.rebuilds;
    forecast_.replace(Phase(settings));
    rebuild(now, Progress());
  }

  /// The world for editing between runs; unless only the responses change, `rebuild` must follow.
  World& world_to_edit() { return forecast_.world(); }

  /// Checks every structure, and that every contact is predicted; throws BrokenInvariant. Cost:
  /// O(candidates).
  void validate() const {
    if (!is_outdated_) hardball::validate(forecast_);
  }

 private:
  void rebuild(const Time& now, const Progress& progress) {
    is_outdated_ = false;
    journal_.note_rebuild(now);
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
    const StoredSphere sphere{forecast_.id(slot), slot};
    journal_.note_event(EngineJournal::Kind::no_contact, now(), sphere, sphere);
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

  void keep_copies_good() {
    if (forecast_.keep_copies_good([this](Slot slot) { queue_.schedule(slot, forecast_); })) [[unlikely]]
      journal_.note_rebuild(now());
  }

  HARDBALL_ALWAYS_INLINE void carry_out(Slot slot) {
    const Plan& plan = forecast_.plan(slot);
    const bool is_collision = plan.has_partner();
    const Slot partner = is_collision ? plan.partner() : slot;
    const SphereId id = forecast_.id(slot);
    const SphereId partner_id = forecast_.id(partner);
    // Branchless: which id is lower is unpredictable.
    const Slot exchange = (slot ^ partner) & (Slot{0} - static_cast<Slot>(partner_id < id));
    // One by one: as a whole they would be copied before the processor has stored them.
    participants_.first = slot ^ exchange;
    participants_.second = partner ^ exchange;
    participants_.nearest = forecast_.uses_minimum_image();
    const Participants& participants = participants_;
    const Event event =
        is_collision ? make_collision(plan.contact_time(), id, partner_id, forecast_.image_in_event(slot))
                     : Event{plan.contact_time(), EventKind::wall, id, plan.wall(), {}};
    standstill_guard_.note_event(now(), event.time, world().size());
    execute(forecast_.world(), aftermath_.collapse, event, participants, done_);
    forecast_.advance(event.time);
    ++(is_collision ? counters_.collision : counters_.wall);
    journal_.note_event(is_collision ? EngineJournal::Kind::collision : EngineJournal::Kind::wall, now(),
                        {id, slot}, {partner_id, partner});
    queue_.pop();
    if (done_.contact.outcome == ContactOutcome::merge) [[unlikely]] {
      return absorb(participants);
    }
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
  }

  // Merges spheres that overlap since others have merged, if the response does so; false if none do.
  HARDBALL_NEVER_INLINE bool coalesce() {
    journal_.note_merged(now(), aftermath_.merged);
    const auto overlaps = [this](Slot slot) {
      return overlaps_of(world(), slot, forecast_.overlapping(slot), now());
    };
    return aftermath_.merged.coalesce(world(), overlaps, [this](const Event& overlap) {
      const Participants participants = participants_of(world(), overlap);
      if (!merge_if_decided(forecast_.world(), overlap, participants, done_)) return false;
      ++counters_.collision;
      journal_.note_event(EngineJournal::Kind::collision, now(), {overlap.first, participants.first},
                          {overlap.second, participants.second});
      absorb(participants);
      return true;
    });
  }

  // The first of two spheres that have merged takes the place of both.
  HARDBALL_NEVER_INLINE void absorb(const Participants& participants) {
    journal_.note_merged(now(), aftermath_.merged);
    aftermath_.merged.note(done_.contact.first);
    aftermath_.merged.forget(done_.contact.second);
    is_outdated_ = !forecast_.admits(participants.first);
    if (is_outdated_) return forecast_.world().remove(done_.contact.second, now());
    forecast_.erase(participants.first);
    forecast_.insert(participants.first);
    remove_from_forecast(participants.second);
    const Slot slot = world().slot_of(done_.contact.first);
    forecast_.predict(slot);
    queue_.schedule(slot, forecast_);
  }

  // What happened up to `last_kept` stays.
  void undo(const Time& last_kept, const Time& moment) {
    standstill_guard_ = {};
    aftermath_.collapse.rewind(last_kept);
    const std::vector<StoredSphere> handled = journal_.undo_events(last_kept, counters_, aftermath_.merged);
    if (is_outdated_) {
      undo_changes(forecast_.world(), last_kept);
      return forecast_.advance(moment);
    }
    const std::vector<Slot> changed = hardball::rewind(forecast_, last_kept, moment, handled);
    if constexpr (requires { queue_.go_back(moment.high, forecast_); })
      queue_.go_back(moment.high, forecast_);
    for (const Slot slot : changed) queue_.schedule(slot, forecast_);
  }

  void remove_from_forecast(Slot slot) {
    const auto last = static_cast<Slot>(world().size() - 1);
    forecast_.remove(slot);
    queue_.schedule(last, forecast_);
    if (slot != last) queue_.schedule(slot, forecast_);
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
  StandstillGuard standstill_guard_;
  Prefetching prefetching_;
  bool is_outdated_ = false;
  Executed done_;  // the last contact
  Participants participants_;
  Counters counters_;
  Aftermath aftermath_;
  EngineJournal journal_;
};

}  // namespace hardball
