// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "hardball/engine/check_forecast.hpp"
#include "hardball/engine/engine_base.hpp"
#include "hardball/engine/engine_journal.hpp"
#include "hardball/engine/forecast.hpp"
#include "hardball/engine/prefetching.hpp"
#include "hardball/engine/rewind.hpp"
#include "hardball/engine/run.hpp"
#include "hardball/engine/standstill_guard.hpp"
#include "hardball/engine/upsert.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/events/calendar_queue.hpp"
#include "hardball/events/event_queue.hpp"
#include "hardball/execution/execute.hpp"
#include "hardball/execution/post_contact_state.hpp"
#include "hardball/geometry/inlining.hpp"
#include "hardball/world/audit.hpp"
#include "hardball/world/curve_order.hpp"
#include "hardball/world/new_velocity.hpp"
#include "hardball/world/progress.hpp"
#include "hardball/world/step_levels.hpp"

namespace hardball {

/// The event loop: take the least event, execute it, predict again.
///
/// The queue holds one event per sphere: the earlier of its crossing (broad phase) and its planned contact,
/// which the forecast knows. A planned contact is a contact computed exactly, or a bound of it; only exact
/// contacts are ever executed, so bounds affect the speed and not the history. An engine is a value: it can
/// be copied, and many can coexist.
template <EventQueue Queue>
class Engine final : public EngineBase {
 public:
  /// Takes over a world as it is at `now`, with a broad phase of these settings. Precondition: no path starts
  /// later, no two spheres overlap.
  Engine(World world, const PhaseSettings& settings, const Time& now, const Progress& progress = {})
      : forecast_(std::move(world), settings) {
    rebuild(now, progress);
  }
  std::unique_ptr<EngineBase> clone() const override { return std::make_unique<Engine>(*this); }

  const World& world() const override { return forecast_.world(); }
  World& mutable_world() override { return forecast_.world(); }
  const BroadPhase& phase() const { return forecast_.phase(); }
  PhaseLengths lengths() const override { return phase().lengths(); }
  PostContactState post_contact_state() const override { return post_contact_; }
  void take_over(const PostContactState& post_contact_state) override { post_contact_ = post_contact_state; }
  /// What contacts left behind that domains divide among them.
  const CollapseGuard& collapse_guard() const { return post_contact_.collapse; }
  Time now() const override { return forecast_.now(); }

  Counters counters() const override {
    Counters counters = counters_ + forecast_.counters();
    const QueueCounters queue = queue_.counters();
    counters.leave += forecast_.phase().left_count();
    counters.queue_operations += queue.scheduled + queue.taken;
    return counters;
  }

  std::vector<SphereSearch::Part> search_parts(const Time& moment) const override {
    if (needs_rebuild_ || now() > moment) return {};
    return {{&world(), &phase()}};
  }

  std::size_t memory_bytes() const override {
    return forecast_.memory_bytes() + queue_.memory_bytes() + post_contact_.collapse.memory_bytes();
  }

  RunStatus run(const RunLimits& limits, ContactSums& sums, const ContactObserver& observer) override {
    return run(limits, [&](const Contact& contact) {
      sums.record(contact);
      return !observer || observer.on_contact(contact);
    });
  }
  /// Runs as the other, and calls observe(contact) after every contact. If that returns a bool, it says
  /// whether to continue.
  template <class Observe>
  RunStatus run(const RunLimits& limits, Observe&& observe) {
    std::uint64_t contacts = 0;
    std::uint64_t steps = 0;
    if (limits.contacts == 0) return RunStatus::contacts_reached;
    const Time until = within_range(limits.until);
    for (;;) {
      if (needs_rebuild_) [[unlikely]]
        return RunStatus::outdated;
      if (!post_contact_.merged.empty() && steps == limits.steps) [[unlikely]]
        return RunStatus::steps_reached;
      if (post_contact_.merged.empty() || !coalesce()) [[likely]] {
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

  std::optional<Event> next_contact(const Time& until) override {
    for (;;) {
      const Slot next = least_until(within_range(until));
      if (next == kNoOwner) return std::nullopt;
      if (!handle_without_contact(next)) return forecast_.contact_of(next);
    }
  }

  /// Whether anything is to come, if only a crossing.
  bool has_events() { return queue_.least(forecast_) != kNoOwner; }

  void change_velocities(const Time& moment, std::span<const NewVelocity> changes) override {
    const std::vector<std::uint32_t> order = by_slot(changes);
    for (const std::uint32_t i : order) {
      const auto& [slot, before, after] = changes[i];
      const Image folded = forecast_.world().change_velocity(slot, moment, after);
      if (needs_rebuild_) continue;
      HARDBALL_CHECK(moment >= now());
      forecast_.advance(moment);
      forecast_.note_new_path(slot, folded);
    }
    if (needs_rebuild_) return;
    for (const std::uint32_t i : order) {
      forecast_.predict(changes[i].slot);
      queue_.schedule(changes[i].slot, forecast_);
    }
  }

  void put(const Time& moment, std::span<const NewPlace> places) override {
    std::vector<Slot> slots;
    for (const NewPlace& place : places) {
      const Image folded = forecast_.world().put(place.slot, moment, place.position, place.after);
      if (needs_rebuild_) continue;
      HARDBALL_CHECK(moment >= now());
      forecast_.advance(moment);
      forecast_.note_new_path(place.slot, folded);
      slots.push_back(place.slot);
    }
    if (!needs_rebuild_) predict_all(forecast_, queue_, slots);
  }

  SphereId add(const Sphere& sphere, const Time& moment) override {
    World& world = forecast_.world();
    const SphereId id = world.add(sphere, moment);
    const auto slot = static_cast<Slot>(world.size() - 1);
    const bool is_admitted = !needs_rebuild_ && forecast_.admits(slot);
    if (is_admitted) {
      HARDBALL_CHECK(moment >= now());
      forecast_.advance(moment);
      forecast_.insert(slot);
    }
    try {
      const std::vector<Slot> all = is_admitted ? std::vector<Slot>() : all_slots(world);
      const std::span<const Slot> others = is_admitted ? forecast_.overlapping(slot) : std::span(all);
      require_room(world, slot, others, moment);
      assign_levels(world, slot, others, moment);
    } catch (const Error&) {
      if (is_admitted) forecast_.erase(slot);
      world.undo_add();
      throw;
    }
    needs_rebuild_ = !is_admitted;
    if (needs_rebuild_) return id;
    queue_.add_owner(slot);
    forecast_.predict(slot);
    queue_.schedule(slot, forecast_);
    return id;
  }

  void remove(SphereId id, const Time& moment) override { remove_at(world().slot_of(id), moment); }
  /// Removes the sphere in a slot. Precondition: as for `remove`.
  void remove_at(Slot slot, const Time& moment) {
    journal_.note_merged(moment, post_contact_.merged);
    post_contact_.merged.forget(world().id(slot));
    if (needs_rebuild_) return forecast_.world().remove_at(slot, moment);
    HARDBALL_CHECK(moment >= now());
    forecast_.advance(moment);
    remove_from_forecast(slot);
  }

  /// See upsert.hpp. Precondition: as for change_velocities; there is no journal.
  void upsert_spheres(std::span<const SphereState> spheres, const Time& moment) {
    HARDBALL_CHECK(moment >= now());
    forecast_.advance(moment);
    std::vector<Slot> slots;
    needs_rebuild_ = !hardball::upsert_spheres(forecast_, spheres, !needs_rebuild_, slots);
    if (needs_rebuild_) return;
    for (const Slot slot : slots) queue_.add_owner(slot);
    predict_all(forecast_, queue_, slots);
  }

  /// See upsert.hpp. Precondition: as for upsert_spheres.
  void replace_paths(std::span<const NewPath> paths, const Time& moment) {
    HARDBALL_CHECK(moment >= now());
    forecast_.advance(moment);
    std::vector<Slot> slots;
    hardball::replace_paths(forecast_, paths, !needs_rebuild_, slots);
    if (!needs_rebuild_) predict_all(forecast_, queue_, slots);
  }

  /// The slots of the spheres of the last contact. Precondition: they have not merged.
  const Participants& participants() const { return participants_; }

  bool needs_rebuild() const override { return needs_rebuild_; }

  void begin_journal(const Time& moment) override {
    HARDBALL_CHECK(moment >= now());
    forecast_.advance(moment);
    journal_.begin(moment);
    forecast_.world().begin_journal();
    post_contact_.collapse.begin_journal();
  }
  void end_journal() override {
    journal_.end();
    forecast_.world().end_journal();
    post_contact_.collapse.end_journal();
  }

  void rewind(const Time& moment) override {
    if (!(now() > moment)) return;
    needs_rebuild_ |= !journal_.reaches(moment);
    undo(moment, moment);
  }
  void rewind_to_begin() override {
    needs_rebuild_ |= !journal_.reaches_begin();
    undo(EngineJournal::kLongAgo, journal_.begin_time());
  }

  /// Rebuilds the engine (see EngineBase), and puts spheres into an order that is good for caches.
  void rebuild(const Time& now, const PhaseSettings& settings) override {
    if (settings.kind != PhaseKind::all_pairs) put_in_order(forecast_.world(), now);
    rebuild_in_place(now, settings);
  }
  /// Rebuilds everything, and leaves spheres in their slots.
  void rebuild_in_place(const Time& now, const PhaseSettings& settings) {
    const QueueCounters queue = queue_.counters();
    counters_.leave += forecast_.phase().left_count();
    counters_.queue_operations += queue.scheduled + queue.taken;
    ++counters_.rebuilds;
    forecast_.replace_phase(settings);
    rebuild(now, Progress());
  }

  void validate() const override {
    if (!needs_rebuild_) hardball::validate(forecast_);
  }

 private:
  void rebuild(const Time& now, const Progress& progress) {
    needs_rebuild_ = false;
    journal_.note_rebuild(now);
    forecast_.rebuild(now, progress);
    queue_.reset(world().size(), now);
    for (Slot slot = 0; slot < world().size(); ++slot) queue_.schedule(slot, forecast_);
  }

  // The indices of changes in an order that is good for caches: by slot, if there are many.
  std::vector<std::uint32_t> by_slot(std::span<const NewVelocity> changes) const {
    std::vector<std::uint32_t> order(changes.size());
    std::iota(order.begin(), order.end(), 0U);
    if (changes.size() < world().size() / 4) return order;
    constexpr std::uint32_t kNone = UINT32_MAX;
    std::vector<std::uint32_t> of_slot(world().size(), kNone);
    for (const std::uint32_t i : order) {
      if (std::exchange(of_slot[changes[i].slot], i) != kNone) return order;
    }
    order.clear();
    for (const std::uint32_t i : of_slot) {
      if (i != kNone) order.push_back(i);
    }
    return order;
  }

  // The owner of the least event, if it comes no later than `until`; otherwise kNoOwner.
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
    execute(forecast_.world(), post_contact_.collapse, event, participants, done_);
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
    journal_.note_merged(now(), post_contact_.merged);
    const auto overlaps = [this](Slot slot) {
      return overlaps_of(world(), slot, forecast_.overlapping(slot), now());
    };
    return post_contact_.merged.coalesce(world(), overlaps, [this](const Event& overlap) {
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
    journal_.note_merged(now(), post_contact_.merged);
    post_contact_.merged.record(done_.contact.first);
    post_contact_.merged.forget(done_.contact.second);
    needs_rebuild_ = !forecast_.admits(participants.first);
    if (needs_rebuild_) return forecast_.world().remove(done_.contact.second, now());
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
    post_contact_.collapse.rewind(last_kept);
    const std::vector<StoredSphere> handled =
        journal_.undo_events(last_kept, counters_, post_contact_.merged);
    if (needs_rebuild_) {
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

  Forecast forecast_;
  Queue queue_;
  StandstillGuard standstill_guard_;
  Prefetching prefetching_;
  bool needs_rebuild_ = false;
  Executed done_;  // the last contact
  Participants participants_;
  Counters counters_;
  PostContactState post_contact_;
  EngineJournal journal_;
};

extern template class Engine<CalendarQueue>;

}  // namespace hardball
