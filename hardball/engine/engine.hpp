// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "hardball/broadphase/broad_phase.hpp"
#include "hardball/engine/run.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/events/event_queue.hpp"
#include "hardball/response/execute.hpp"

namespace hardball {

/// The event loop: take the least event, carry it out, predict anew.
///
/// The queue holds one entry per sphere: the earlier of its crossing (broad phase) and its prospect, the
/// earliest contact among its candidates. Of two candidates at least one has a prospect no later than their
/// contact: the one whose path or region changed last looked at the other. A prospect whose partner has
/// changed its path since is stale, and the sphere looks again. An engine is a value: it can be copied, and
/// many can live side by side.
template <EventQueue Queue, BroadPhase Phase, Response Respond>
class Engine {
 public:
  /// Takes over a world as it is at `now`. Precondition: no path begins later, no two spheres overlap.
  Engine(World world, Phase phase, Respond respond, const Time& now)
      : world_(std::move(world)), phase_(std::move(phase)), respond_(std::move(respond)) {
    rebuild(now);
  }

  const World& world() const { return world_; }
  const Phase& phase() const { return phase_; }
  Respond& response() { return respond_; }
  /// The time of the last event handled.
  const Time& now() const { return now_; }

  Counters counters() const {
    Counters counters = counters_;
    const QueueCounters queue = queue_.counters();
    counters.leave += phase_.left_count();
    counters.queue_operations += queue.scheduled + queue.taken;
    return counters;
  }

  std::size_t memory_bytes() const {
    return world_.memory_bytes() + phase_.memory_bytes() + queue_.memory_bytes() + guard_.memory_bytes() +
           prospects_.capacity() * sizeof(Prospect) + revisions_.capacity() * sizeof(std::uint32_t);
  }

  /// Handles events in order, calling observe(contact) after every collision and wall contact.
  /// Error: RunFailure on inelastic collapse; whatever the response or the observer throws. The event at
  /// which the response threw has not happened.
  template <class Observe>
  RunStatus run(const RunLimits& limits, Observe&& observe) {
    std::uint64_t contacts = 0;
    if (limits.contacts == 0) return RunStatus::contacts_reached;
    for (std::uint64_t step = 0;; ++step) {
      const std::optional<Scheduled> next = queue_.least();
      if (!next || next->event.time.high > limits.until.high) return RunStatus::time_reached;
      if (step == limits.steps) return RunStatus::steps_reached;
      if (handle_without_contact(*next)) continue;
      observe(carry_out(next->event));
      if constexpr (HARDBALL_VALIDATE) validate_now_and_then();
      if (++contacts == limits.contacts) return RunStatus::contacts_reached;
    }
  }

  /// The next collision or wall contact up to `until`, without carrying it out.
  std::optional<Event> next_contact(const Time& until) {
    for (;;) {
      const std::optional<Scheduled> next = queue_.least();
      if (!next || next->event.time.high > until.high) return std::nullopt;
      if (!handle_without_contact(*next)) return next->event;
    }
  }

  /// Changes a velocity at `moment`. Precondition: no event is left before it, none after it has been
  /// handled.
  void change_velocity(Slot slot, const Time& moment, const Vec3& velocity) {
    HARDBALL_CHECK(moment >= now_);
    const Image folded = world_.change_velocity(slot, moment, velocity);
    now_ = moment;
    note_new_path(slot, folded);
    predict(slot);
  }

  /// Forgets all predictions and regions and makes them anew, as of `now`, with another broad phase. The
  /// motion is not touched. Cost: O(n).
  void rebuild(const Time& now, Phase phase) {
    counters_ = counters();
    ++counters_.rebuilds;
    phase_ = std::move(phase);
    rebuild(now);
  }

  /// The world for editing between runs; `rebuild` must follow.
  World& world_to_edit() { return world_; }

  /// Checks every structure and that no contact is unknown; throws BrokenInvariant. Cost: O(candidates).
  void validate() const {
    phase_.validate(world_, now_);
    for (Slot slot = 0; slot < world_.size(); ++slot) {
      HARDBALL_CHECK(prospects_[slot].contact.time >= now_);
      phase_.for_each_candidate(world_, slot, [&](Slot other, const Image& image) {
        const Event contact = make_collision(contact_time(world_, slot, other, image), slot, other, image);
        HARDBALL_CHECK(prospects_[slot].contact <= contact || prospects_[other].contact <= contact);
      });
    }
  }

 private:
  // The earliest contact a sphere knows of, and which path of its partner it was reckoned with.
  struct Prospect {
    Event contact;
    std::uint32_t partner_revision = 0;
  };

  void rebuild(const Time& now) {
    now_ = now;
    phase_.build(world_, now_);
    queue_.reset(world_.size(), now_);
    prospects_.assign(world_.size(), Prospect{});
    revisions_.assign(world_.size(), 0);
    for (Slot slot = 0; slot < world_.size(); ++slot) predict(slot);
  }

  // Handles a crossing or a stale prospect; false if the entry is a contact that stands.
  bool handle_without_contact(const Scheduled& next) {
    HARDBALL_CHECK(next.event.time >= now_);
    if (next.event.kind == EventKind::enter) {
      now_ = next.event.time;
      ++counters_.enter;
      queue_.pop();
      const std::uint64_t predictions_before = counters_.predictions;
      phase_.cross(world_, next.owner, now_,
                   [&](Slot other, const Image& image) { consider(next.owner, other, image); });
      counters_.enter_predictions += counters_.predictions - predictions_before;
      schedule(next.owner);
      return true;
    }
    if (next.event.kind == EventKind::collision && is_stale(next)) {
      ++counters_.stale;
      queue_.pop();
      predict(next.owner);
      return true;
    }
    return false;
  }

  bool is_stale(const Scheduled& next) const {
    const Slot partner = next.event.first == next.owner ? next.event.second : next.event.first;
    return prospects_[next.owner].partner_revision != revisions_[partner];
  }

  Contact carry_out(const Event& event) {
    const bool is_collision = event.kind == EventKind::collision;
    const Executed done = execute(world_, guard_, event, respond_);
    now_ = event.time;
    ++(is_collision ? counters_.collision : counters_.wall);
    queue_.pop();
    note_new_path(event.first, done.folded[0]);
    if (is_collision) note_new_path(event.second, done.folded[1]);
    const std::uint64_t predictions_before = counters_.predictions;
    predict(event.first);
    if (is_collision) predict(event.second);
    counters_.contact_predictions += counters_.predictions - predictions_before;
    return done.contact;
  }

  void note_new_path(Slot slot, const Image& folded) {
    ++revisions_[slot];
    phase_.refresh(world_, slot, now_, folded);
  }

  // Looks at all candidates of a sphere and at the walls.
  void predict(Slot slot) {
    prospects_[slot] = {next_wall_event(world_, slot), 0};
    phase_.for_each_candidate(world_, slot,
                              [&](Slot other, const Image& image) { consider(slot, other, image); });
    schedule(slot);
  }

  void consider(Slot slot, Slot other, const Image& image) {
    ++counters_.predictions;
    Prospect& prospect = prospects_[slot];
    const Time time = contact_time(world_, slot, other, image);
    if (time > prospect.contact.time) return;
    const Event contact = make_collision(time, slot, other, image);
    if (contact < prospect.contact) prospect = {contact, revisions_[other]};
  }

  void schedule(Slot slot) {
    const Event crossing{phase_.next_crossing(slot), EventKind::enter, slot, 0, {}};
    const Event& contact = prospects_[slot].contact;
    queue_.schedule(slot, crossing < contact ? crossing : contact);
  }

  // Whole checks after contact 1, 2, 4, 8, ... keep a validating run from taking for ever.
  void validate_now_and_then() const {
    const std::uint64_t contacts = counters_.contacts();
    if ((contacts & (contacts - 1)) == 0) validate();
  }

  World world_;
  Phase phase_;
  Respond respond_;
  Queue queue_;
  CollapseGuard guard_;
  Time now_;
  std::vector<Prospect> prospects_;       // per slot
  std::vector<std::uint32_t> revisions_;  // per slot: how often its path has been rewritten
  Counters counters_;
};

}  // namespace hardball
