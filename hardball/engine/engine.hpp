// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "hardball/broadphase/broad_phase.hpp"
#include "hardball/engine/predictor.hpp"
#include "hardball/engine/run.hpp"
#include "hardball/engine/standstill_guard.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/events/event_queue.hpp"
#include "hardball/memory/huge_pages.hpp"
#include "hardball/memory/prefetch.hpp"
#include "hardball/response/execute.hpp"
#include "hardball/world/progress.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// The event loop: take the least event, execute it, predict again.
///
/// The queue holds one event per sphere: the earlier of its crossing (broad phase) and its prospect, the
/// earliest contact with its candidates. Of two candidates at least one has a prospect no later than their
/// contact: the one whose path or region changed last predicted it. A prospect whose partner's path has
/// changed since is stale, and the sphere predicts again. An engine is a value: it can be copied, and many
/// can coexist.
template <EventQueue Queue, BroadPhase Phase, Response Respond>
class Engine {
 public:
  /// Takes over a world as it is at `now`. Precondition: no path starts later, no two spheres overlap.
  Engine(World world, Phase phase, Respond respond, const Time& now, Predictor predictor = Predictor(),
         const Progress& progress = {})
      : world_(std::move(world)),
        phase_(std::move(phase)),
        respond_(std::move(respond)),
        predictor_(std::move(predictor)) {
    rebuild(now, progress);
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
           plans_.capacity() * sizeof(Plan);
  }

  /// Handles events in order, calling observe(contact) after every collision and wall contact. The observer
  /// may call change_velocity; after any other edit it must stop the run by returning false, and `rebuild`
  /// must follow. Error: RunFailure on inelastic collapse; whatever the response or the observer throws. If
  /// the response throws, its event has not happened.
  template <class Observe>
  RunStatus run(const RunLimits& limits, Observe&& observe) {
    std::uint64_t contacts = 0;
    if (limits.contacts == 0) return RunStatus::contacts_reached;
    for (std::uint64_t step = 0;; ++step) {
      const Slot next = least_until(limits.until);
      if (next == kNoOwner) return RunStatus::time_reached;
      if (step == limits.steps) return RunStatus::steps_reached;
      prefetch_ahead();
      if (handle_without_contact(next)) continue;
      const bool goes_on = notify(observe, carry_out(next));
      if constexpr (HARDBALL_VALIDATE) {
        if (goes_on) validate_now_and_then();
      }
      if (++contacts == limits.contacts) return RunStatus::contacts_reached;
      if (!goes_on) return RunStatus::observer_stopped;
    }
  }

  /// The next collision or wall contact up to `until`, without carrying it out.
  std::optional<Event> next_contact(const Time& until) {
    for (;;) {
      const Slot next = least_until(until);
      if (next == kNoOwner) return std::nullopt;
      if (!handle_without_contact(next)) return contact_of(next);
    }
  }

  /// Changes a velocity at `moment`. Precondition: all events before it have been handled, and none after it.
  void change_velocity(Slot slot, const Time& moment, const Vec3& velocity) {
    HARDBALL_CHECK(moment >= now_);
    note_repeated_start(slot, moment);
    const Image folded = world_.change_velocity(slot, moment, velocity);
    now_ = moment;
    note_new_path(slot, folded);
    predict(slot);
  }

  /// Discards all predictions and regions and rebuilds them as of `now`, with another broad phase. The motion
  /// is not affected. Cost: O(n).
  void rebuild(const Time& now, Phase phase) {
    counters_ = counters();
    ++counters_.rebuilds;
    phase_ = std::move(phase);
    rebuild(now, Progress());
  }

  /// The world for editing between runs; `rebuild` must follow.
  World& world_to_edit() { return world_; }

  /// Checks every structure, and that every contact is predicted; throws BrokenInvariant. Cost:
  /// O(candidates).
  void validate() const {
    phase_.validate(world_, now_);
    Candidates candidates;
    for (Slot slot = 0; slot < world_.size(); ++slot) {
      HARDBALL_CHECK(plans_[slot].contact >= now_ && plans_[slot].crossing >= now_);
      phase_.collect(world_, slot, candidates);
      for (std::size_t i = 0; i < candidates.size(); ++i) {
        const Slot other = candidates.slot(i);
        const Image image =
            candidates.are_nearest() ? nearest_image(world_, slot, other, now_) : candidates.image(i);
        const Event contact = make_collision(contact_time(world_, slot, other, image), plans_[slot].id,
                                             plans_[other].id, image);
        const bool is_known = prospect_of(slot) <= contact || prospect_of(other) <= contact;
        HARDBALL_CHECK(is_known || !contact.happens());
      }
    }
  }

 private:
  // The data of this many spheres stays in cache by itself.
  static constexpr std::size_t kCachedSpheres = 10000;

  // What comes next for a sphere: its crossing, and its prospect, the earliest contact predicted for it. One
  // cache line.
  struct alignas(64) Plan {
    Time crossing = kNever;  // or any time after the contact
    Time contact = kNever;
    double partner_since = 0;   // start of the partner's path
    std::uint32_t partner = 0;  // a slot, or a face of the box
    Image image;                // of the partner
    SphereId id = 0;            // of the sphere itself
    EventKind kind = EventKind::wall;
    bool is_nearest_image = false;  // the partner's image is the nearest one at contact

    bool crosses_first() const { return crossing <= contact; }
    // A sphere at rest may have neither crossing nor contact.
    bool will_cross_first() const { return crosses_first() && crossing < kNever; }
    bool meets_first() const { return !crosses_first() && kind == EventKind::collision; }
  };

  // The plans as the queue's event table.
  struct Plans {
    const Engine& engine;
    Time time(Slot slot) const {
      const Plan& plan = engine.plans_[slot];
      return plan.crosses_first() ? plan.crossing : plan.contact;
    }
    // Two spheres that will collide with each other; if one plan is stale, that is found when it is handled.
    bool share_event(Slot a, Slot b) const {
      const Plan& one = engine.plans_[a];
      const Plan& other = engine.plans_[b];
      return one.meets_first() && other.meets_first() && one.partner == b && other.partner == a &&
             one.contact == other.contact && one.is_nearest_image && other.is_nearest_image;
    }
    bool is_cached() const { return engine.is_cached_; }
    void prefetch_event(Slot slot) const { prefetch(&engine.plans_[slot]); }
    Event event(Slot slot) const {
      const Plan& plan = engine.plans_[slot];
      if (!plan.crosses_first()) return engine.prospect_of(slot);
      return {plan.crossing, EventKind::enter, plan.id, 0, {}};
    }
  };

  Plans plans() const { return {*this}; }

  // Whether the partner's path has changed since the prospect was computed. Paths rewritten more than once at
  // one time have the same start: then the contact time decides, a function of both paths.
  bool is_stale(Slot slot) const {
    const Plan& plan = plans_[slot];
    if (plan.kind != EventKind::collision) return false;
    if (world_.path(plan.partner).time.high != plan.partner_since) return true;
    if (!has_repeated_starts_) return false;
    return contact_time(world_, slot, plan.partner, image_of_partner(slot)) != plan.contact;
  }

  // The prospect as an event. If it is stale, the partner's old path is gone, and the image with it: it then
  // precedes all contacts at its time, so that the sphere merely predicts again early.
  Event prospect_of(Slot slot) const {
    const Plan& plan = plans_[slot];
    if (is_stale(slot)) return {plan.contact, EventKind::enter, plan.id, 0, {}};
    return contact_of(slot);
  }

  // Precondition: the prospect is a collision.
  Image image_of_partner(Slot slot) const {
    const Plan& plan = plans_[slot];
    if (!plan.is_nearest_image || !(plan.contact < kNever)) return plan.image;
    return nearest_image(world_, slot, plan.partner, plan.contact);
  }

  // Precondition: the prospect is not stale.
  Event contact_of(Slot slot) const {
    const Plan& plan = plans_[slot];
    if (plan.kind == EventKind::wall) return {plan.contact, plan.kind, plan.id, plan.partner, {}};
    return make_collision(plan.contact, plan.id, plans_[plan.partner].id, image_of_partner(slot));
  }

  void rebuild(const Time& now, const Progress& progress) {
    now_ = now;
    phase_.build(world_, now_);
    queue_.reset(world_.size(), now_);
    plans_.assign(world_.size(), Plan{});
    for (Slot slot = 0; slot < world_.size(); ++slot) plans_[slot].id = world_.id(slot);
    has_repeated_starts_ = false;
    is_cached_ = world_.size() <= kCachedSpheres;
    const Box& box = world_.box();
    has_walls_ = box.is_wall(0) || box.is_wall(1) || box.is_wall(2);
    for (Slot slot = 0; slot < world_.size(); ++slot) {
      progress.note(slot, world_.size());
      predict(slot);
    }
  }

  // Whose event is the least, if it comes no later than `until`; otherwise kNoOwner.
  Slot least_until(const Time& until) {
    const Slot next = queue_.least(plans());
    return next == kNoOwner || plans().time(next).high > until.high ? kNoOwner : next;
  }

  // The calendar knows which spheres come next: prefetches their data.
  void prefetch_ahead() {
    if constexpr (requires { queue_.upcoming(0); }) {
      if (is_cached_) {
        prefetch_regions_ahead();
      } else {
        prefetch_in_stages();
      }
    }
  }

  // Even with few spheres, regions may have been evicted from L1.
  void prefetch_regions_ahead() {
    constexpr std::size_t kAhead = 2;
    constexpr std::size_t kPlan = 5;
    if (const Slot later = queue_.upcoming(kPlan); later != kNoOwner) prefetch(&plans_[later]);
    const Slot slot = queue_.upcoming(kAhead);
    if (slot == kNoOwner) return;
    const Plan& plan = plans_[slot];
    const Slot partner = plan.kind == EventKind::collision ? plan.partner : slot;
    prefetch_regions(slot);
    prefetch_regions(partner);
    prefetch(&plans_[partner]);
  }

  // Each stage runs a few events before the next, whose addresses it loads.
  void prefetch_in_stages() {
    constexpr std::size_t kPlan = 9;
    constexpr std::size_t kRegion = 6;
    constexpr std::size_t kLists = 4;
    constexpr std::size_t kPaths = 2;
    if (const Slot slot = queue_.upcoming(kPlan); slot != kNoOwner) {
      prefetch(&plans_[slot]);
      prefetch_regions(slot);
    }
    if (const Slot slot = queue_.upcoming(kRegion); slot != kNoOwner) {
      if (const Plan& plan = plans_[slot]; plan.meets_first()) {
        prefetch(&plans_[plan.partner]);
        prefetch_regions(plan.partner);
      }
    }
    if (const Slot slot = queue_.upcoming(kLists); slot != kNoOwner) {
      const Plan& plan = plans_[slot];
      phase_.prefetch_lists(slot, plan.will_cross_first());
      if (plan.meets_first()) phase_.prefetch_lists(plan.partner, false);
    }
    if (const Slot slot = queue_.upcoming(kPaths); slot != kNoOwner) {
      const auto prefetch_path = [this](Slot other) { prefetch(&world_.path(other)); };
      const Plan& plan = plans_[slot];
      phase_.for_each_prefetched(slot, plan.will_cross_first(), prefetch_path);
      if (plan.meets_first()) phase_.for_each_prefetched(plan.partner, false, prefetch_path);
    }
  }

  void prefetch_regions(Slot slot) const {
    prefetch(&world_.path(slot));
    phase_.prefetch_region(slot);
  }

  // Handles a crossing or a stale prospect; false if the sphere's event is a valid contact.
  bool handle_without_contact(Slot slot) {
    const Plan& plan = plans_[slot];
    const bool is_crossing = plan.crosses_first();
    HARDBALL_CHECK((is_crossing ? plan.crossing : plan.contact) >= now_);
    if (is_crossing) {
      standstill_guard_.note_event(now_, plan.crossing, world_.size());
      queue_.pop();
      cross(slot);
      return true;
    }
    if (is_stale(slot)) {
      ++counters_.stale;
      queue_.pop();
      predict(slot);
      return true;
    }
    return false;
  }

  void cross(Slot slot) {
    Plan& plan = plans_[slot];
    now_ = plan.crossing;
    ++counters_.enter;
    phase_.cross(world_, slot, now_, candidates_);
    counters_.predictions += candidates_.size();
    counters_.enter_predictions += candidates_.size();
    const Prospect found = predictor_.earliest(world_, candidates_, now_, plan.contact);
    if (found.time < plan.contact) {
      take(plan, found);
    } else if (found.time == plan.contact && found.happens()) [[unlikely]] {
      const Event before = prospect_of(slot);
      const Plan kept = plan;
      take(plan, found);
      if (!(contact_of(slot) < before)) plan = kept;
    }
    schedule(slot);
  }

  const Contact& carry_out(Slot slot) {
    const Plan& plan = plans_[slot];
    const bool is_collision = plan.kind == EventKind::collision;
    const Slot partner = is_collision ? plan.partner : slot;
    const SphereId partner_id = plans_[partner].id;
    // Branchless: which id is lower is unpredictable.
    const Slot exchange = (slot ^ partner) & (Slot{0} - static_cast<Slot>(partner_id < plan.id));
    const Participants participants{slot ^ exchange, partner ^ exchange, plan.is_nearest_image};
    const Event event = is_collision ? make_collision(plan.contact, plan.id, partner_id, plan.image)
                                     : Event{plan.contact, EventKind::wall, plan.id, plan.partner, {}};
    standstill_guard_.note_event(now_, event.time, world_.size());
    note_repeated_start(participants.first, event.time);
    if (is_collision) note_repeated_start(participants.second, event.time);
    execute(world_, guard_, event, participants, respond_, done_);
    now_ = event.time;
    ++(is_collision ? counters_.collision : counters_.wall);
    queue_.pop();
    const std::uint64_t predictions_before = counters_.predictions;
    note_new_path(participants.first, done_.folded[0]);
    if (is_collision) note_new_path(participants.second, done_.folded[1]);
    predict(participants.first);
    if (is_collision) predict(participants.second);
    counters_.contact_predictions += counters_.predictions - predictions_before;
    return done_.contact;
  }

  void note_repeated_start(Slot slot, const Time& moment) {
    if (world_.path(slot).time.high == moment.high) has_repeated_starts_ = true;
  }

  void note_new_path(Slot slot, const Image& folded) { phase_.refresh(world_, slot, now_, folded); }

  // Predicts a sphere's earliest contact with its candidates and the walls.
  void predict(Slot slot) {
    phase_.collect(world_, slot, candidates_);
    counters_.predictions += candidates_.size();
    Plan& plan = plans_[slot];
    take(plan, predictor_.earliest(world_, candidates_, now_));
    if (has_walls_) predict_wall(slot, plan);
    schedule(slot);
  }

  void predict_wall(Slot slot, Plan& plan) const {
    const Event wall = next_wall_event(world_, slot);
    if (!(wall.time < plan.contact)) return;
    plan.contact = wall.time;
    plan.kind = EventKind::wall;
    plan.partner = wall.second;
  }

  // A crossing matters only if it comes before the contact.
  void schedule(Slot slot) {
    Plan& plan = plans_[slot];
    plan.crossing = phase_.next_crossing(world_, slot, now_, plan.contact);
    queue_.schedule(slot, plans());
  }

  void take(Plan& plan, const Prospect& prospect) {
    plan.contact = prospect.time;
    plan.kind = EventKind::collision;
    plan.partner = prospect.partner;
    plan.image = prospect.image;
    plan.is_nearest_image = candidates_.are_nearest();
    plan.partner_since = world_.path(prospect.partner).time.high;
  }

  // Full checks after contacts 1, 2, 4, 8, ... only, to keep validating runs affordable.
  void validate_now_and_then() const {
    const std::uint64_t contacts = counters_.contacts();
    if ((contacts & (contacts - 1)) == 0) validate();
  }

  World world_;
  Phase phase_;
  Respond respond_;
  Predictor predictor_;
  Queue queue_;
  CollapseGuard guard_;
  StandstillGuard standstill_guard_;
  Time now_;
  LargeVector<Plan> plans_;  // per slot
  bool has_repeated_starts_ = false;
  bool is_cached_ = true;  // the data of all spheres stays in cache by itself
  bool has_walls_ = false;
  Candidates candidates_;  // of the current sphere
  Executed done_;          // the last contact
  Counters counters_;
};

}  // namespace hardball
