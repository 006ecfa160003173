// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "hardball/broadphase/broad_phase.hpp"
#include "hardball/engine/bound_watch.hpp"
#include "hardball/engine/predictor.hpp"
#include "hardball/engine/run.hpp"
#include "hardball/engine/standstill_guard.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/events/event_queue.hpp"
#include "hardball/geometry/inlining.hpp"
#include "hardball/memory/huge_pages.hpp"
#include "hardball/memory/prefetch.hpp"
#include "hardball/response/execute.hpp"
#include "hardball/world/compact_paths.hpp"
#include "hardball/world/new_velocity.hpp"
#include "hardball/world/progress.hpp"
#include "hardball/world/walls.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// The event loop: take the least event, execute it, predict again.
///
/// The queue holds one event per sphere: the earlier of its crossing (broad phase) and its prospect. A
/// prospect is a contact computed exactly, or a bound: a time before which the sphere meets none of the
/// candidates that it answers for, and a limit before which it meets none but one of them. Of any two
/// candidates, the one that predicted last answers for their contact. A bound is refined, replaced by the
/// exact contact, when it is about to come; if its contact is not before its limit, all contacts of the
/// sphere are computed exactly. A prospect whose partner's path has changed since is stale, and the sphere
/// predicts again. Only exact contacts are ever executed, so that bounds affect the speed and not the
/// history. An engine is a value: it can be copied, and many can coexist. Source: docs/bounds.md, with the
/// proof.
template <EventQueue Queue, BroadPhase Phase, Response Respond>
class Engine {
 public:
  /// Takes over a world as it is at `now`. Precondition: no path starts later, no two spheres overlap.
  Engine(World world, Phase phase, Respond respond, const Time& now,
         InstructionSet instructions = widest_instruction_set(), const Progress& progress = {})
      : world_(std::move(world)),
        phase_(std::move(phase)),
        respond_(std::move(respond)),
        predictor_(instructions) {
    rebuild(now, progress);
  }

  const World& world() const { return world_; }
  const Phase& phase() const { return phase_; }
  Respond& response() { return respond_; }
  CollapseGuard& collapse_guard() { return guard_; }
  const CollapseGuard& collapse_guard() const { return guard_; }
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
           compact_.memory_bytes() + images_.capacity() * sizeof(Image);
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
      if (compact_.are_outdated()) [[unlikely]]
        renew_copies();
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

  /// Merges two spheres that overlap now, which is no event of the engine, if the response does so; then
  /// `rebuild` must follow. Error: as for `run`.
  std::optional<Contact> merge_besides(const Event& overlap) {
    if (!merge_if_decided(world_, overlap, respond_, done_)) return std::nullopt;
    ++counters_.collision;
    return done_.contact;
  }

  /// The next collision or wall contact up to `until`, without carrying it out.
  std::optional<Event> next_contact(const Time& until) {
    for (;;) {
      const Slot next = least_until(until);
      if (next == kNoOwner) return std::nullopt;
      if (!handle_without_contact(next)) return contact_of(next);
    }
  }

  /// Changes velocities at `moment`, each of another sphere. Precondition: all events before it have been
  /// handled, and none after it. Cost: a prediction each.
  void change_velocities(const Time& moment, std::span<const NewVelocity> changes) {
    HARDBALL_CHECK(moment >= now_);
    now_ = moment;
    for (const NewVelocity& change : changes) {
      note_new_path(change.slot, world_.change_velocity(change.slot, moment, change.after));
    }
    for (const NewVelocity& change : changes) predict(change.slot);
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
    phase_.validate(world_, now_, compact_);
    Candidates candidates;
    for (Slot slot = 0; slot < world_.size(); ++slot) {
      HARDBALL_CHECK(phase_.lines()[slot].id == world_.id(slot));
      HARDBALL_CHECK(plan_of(slot).time() >= rounded_down(now_));
      collect(slot, candidates);
      for (std::size_t i = 0; i < candidates.size(); ++i) {
        const Event contact = contact_with(candidates, i);
        const Slot other = candidates.slot(i);
        if (!phase_.are_candidates(slot, other)) continue;
        HARDBALL_CHECK(!contact.happens() || covers(slot, contact, other) || covers(other, contact, slot) ||
                       is_found_in_time(other, contact, slot));
      }
    }
  }

 private:
  // The plans as the queue's event table.
  struct Plans {
    Engine& engine;
    double time(Slot slot) const { return engine.plan_of(slot).time(); }
    // Two spheres that will collide with each other; if one plan is stale, that is found when it is handled.
    bool share_event(Slot a, Slot b) const {
      const Plan& one = engine.plan_of(a);
      const Plan& other = engine.plan_of(b);
      return engine.are_nearest_ && one.meets_first() && other.meets_first() && !one.is_bound() &&
             !other.is_bound() && one.partner == b && other.partner == a && one.moment() == other.moment();
    }
    bool is_cached() const { return engine.is_cached_; }
    void prefetch_event(Slot slot) const { prefetch(&engine.plan_of(slot)); }
    void prefetch_refinement(Slot slot) const { engine.prefetch_refinement(slot); }
    void refine(std::span<QueueEntry> entries) const { engine.refine(entries); }
    // What is not known exactly comes first among the events of one double: its exact time may be earlier
    // than theirs.
    Event event(Slot slot) const {
      const Plan& plan = engine.plan_of(slot);
      if (plan.crosses_first() || plan.is_bound() || engine.is_stale(slot)) {
        return {{plan.time(), -std::numeric_limits<double>::infinity()},
                EventKind::enter,
                engine.world_.id(slot),
                0,
                {}};
      }
      return engine.contact_of(slot);
    }
  };

  Plans plans() { return {*this}; }

  static_assert(CompactPaths::kRevision == Plan::kRevision);
  Plan& plan_of(Slot slot) { return phase_.lines()[slot].plan; }
  const Plan& plan_of(Slot slot) const { return phase_.lines()[slot].plan; }

  // Whether the partner's path has changed since the prediction.
  bool is_stale(Slot slot) const {
    const Plan& plan = plan_of(slot);
    return !plan.is_wall() && !plan.has_seen(compact_.revision(plan.partner));
  }

  // The image of the partner that is met. Precondition: the prospect is a collision, not stale.
  Image image_of_partner(Slot slot) const {
    const Plan& plan = plan_of(slot);
    return are_nearest_ ? nearest_image(world_, slot, plan.partner, plan.moment()) : images_[slot];
  }

  // Precondition: the prospect is exact and not stale.
  Event contact_of(Slot slot) const {
    const Plan& plan = plan_of(slot);
    if (plan.is_wall()) return {plan.moment(), EventKind::wall, world_.id(slot), plan.partner, {}};
    if (!(plan.contact < kNever.high)) return {};
    return make_collision(plan.moment(), world_.id(slot), world_.id(plan.partner), image_of_partner(slot));
  }

  // The contact with a candidate.
  Event contact_with(const Candidates& candidates, std::size_t i) const {
    const Slot slot = candidates.self();
    const Slot other = candidates.slot(i);
    const Image image =
        candidates.are_nearest() ? nearest_image(world_, slot, other, now_) : candidates.image(i);
    return make_collision(contact_time(world_, slot, other, image), world_.id(slot), world_.id(other), image);
  }

  // Whether a sphere answers for its contact with another: the contact cannot come before the prospect.
  bool covers(Slot slot, const Event& contact, Slot other) const {
    const Plan& plan = plan_of(slot);
    if (is_stale(slot)) return plan.contact <= contact.time.high;
    if (!plan.is_bound()) return contact_of(slot) <= contact;
    return (plan.partner == other ? plan.contact : plan.limit_or_low) <= contact.time.high;
  }

  // Whether a sphere has no such candidate yet, but crosses before their contact.
  bool is_found_in_time(Slot slot, const Event& contact, Slot other) const {
    Candidates candidates;
    phase_.collect(world_, slot, candidates);
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (candidates.slot(i) == other) return false;
    }
    return plan_of(slot).crossing <= contact.time.high;
  }

  void rebuild(const Time& now, const Progress& progress) {
    now_ = now;
    phase_.build(world_, now_, compact_);
    queue_.reset(world_.size(), now_);
    are_nearest_ = phase_.has_nearest_images();
    images_.assign(are_nearest_ ? 0 : world_.size(), Image{});
    is_cached_ = world_.size() <= Phase::kCachedSpheres;
    are_alike_ = world_.are_alike();
    has_walls_ = has_walls(world_);
    has_images_of_obstacles_ = has_images_of_obstacles(world_);
    has_passing_pairs_ = world_.has_passing_pairs();
    for (Slot slot = 0; slot < world_.size(); ++slot) {
      progress.note(slot, world_.size());
      predict(slot);
    }
  }

  // Whose event is the least, if it comes no later than `until`; otherwise kNoOwner.
  Slot least_until(const Time& until) {
    const Slot next = queue_.least(plans());
    return next == kNoOwner || plan_of(next).time() > until.high ? kNoOwner : next;
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
    if (const Slot later = queue_.upcoming(kPlan); later != kNoOwner) prefetch(&plan_of(later));
    const Slot slot = queue_.upcoming(kAhead);
    if (slot == kNoOwner) return;
    const Plan& plan = plan_of(slot);
    const Slot partner = plan.is_wall() ? slot : plan.partner;
    prefetch_regions(slot);
    prefetch_regions(partner);
  }

  // Each stage runs a few events before the next, whose addresses it loads.
  void prefetch_in_stages() {
    constexpr std::size_t kPlan = 9;
    constexpr std::size_t kRegion = 6;
    constexpr std::size_t kLists = 4;
    constexpr std::size_t kCandidates = 2;
    const bool is_new = bucket_seen_ != queue_.current_bucket();
    bucket_seen_ = queue_.current_bucket();
    for_upcoming(kPlan, is_new, [this](Slot slot) { prefetch_regions(slot); });
    for_upcoming(kRegion, is_new, [this](Slot slot) {
      const Plan& plan = plan_of(slot);
      if (!plan.meets_first()) return;
      prefetch_regions(plan.partner);
    });
    for_upcoming(kLists, is_new, [this](Slot slot) {
      const Plan& plan = plan_of(slot);
      phase_.prefetch_lists(slot, plan.will_cross_first());
      if (plan.meets_first()) phase_.prefetch_lists(plan.partner, false);
    });
    for_upcoming(kCandidates, is_new, [this](Slot slot) {
      const Plan& plan = plan_of(slot);
      phase_.prefetch_candidates(slot, plan.will_cross_first(), compact_);
      if (plan.meets_first()) phase_.prefetch_candidates(plan.partner, false, compact_);
    });
  }

  // Calls visit(slot) for the sphere whose event comes `ahead` events after the next; of a bucket just
  // opened, for all up to that one.
  template <class Visit>
  void for_upcoming(std::size_t ahead, bool is_new, Visit&& visit) const {
    for (std::size_t i = is_new ? 0 : ahead; i <= ahead; ++i) {
      if (const Slot slot = queue_.upcoming(i); slot != kNoOwner) visit(slot);
    }
  }

  void prefetch_regions(Slot slot) const {
    world_.prefetch(slot);
    if (!are_alike_) world_.prefetch_size(slot);
    compact_.prefetch(slot);
    phase_.prefetch_region(slot);
  }

  // Handles what is no contact, or not yet known to be one; false if the sphere's event is a valid contact.
  bool handle_without_contact(Slot slot) {
    const Plan& plan = plan_of(slot);
    const double time = plan.time();
    HARDBALL_CHECK(time >= rounded_down(now_));
    const bool is_crossing = plan.crosses_first();
    const bool is_unknown = !is_crossing && (plan.partner == slot || is_stale(slot)) && !plan.is_wall();
    if (!is_crossing && !is_unknown && !plan.is_bound()) return false;
    // No contact has been missed up to the double before.
    const Time moment = later(now_, Time(double_before(time)));
    standstill_guard_.note_event(now_, moment, world_.size());
    now_ = moment;
    queue_.pop();
    if (is_crossing) {
      cross(slot);
    } else if (is_unknown) {
      ++counters_.stale;
      compact_.copy(world_, slot, now_);
      predict(slot);
    } else if (refine(slot)) {
      queue_.schedule(slot, plans());
    } else {
      bound_watch_.note_ambiguous();
      compact_.copy(world_, slot, now_);
      predict_exactly(slot);
    }
    return true;
  }

  void cross(Slot slot) {
    Plan& plan = plan_of(slot);
    compact_.copy(world_, slot, now_);
    if (!plan.is_renewal()) {
      ++counters_.enter;
      phase_.cross(world_, slot, now_, compact_, candidates_);
      if (has_passing_pairs_) leave_out_met(candidates_);
      counters_.predictions += candidates_.size();
      counters_.enter_predictions += candidates_.size();
      if (is_stale(slot) && plan.is_bound()) postpone(slot);
      const bool is_changed = is_stale(slot);
      counters_.stale += is_changed ? 1 : 0;
      if (is_changed || has_images_of_obstacles_) return predict(slot);
      if (!are_nearest_) {
        predict_new_exactly(slot);
      } else if (!predict_new(slot)) {
        return predict(slot);
      }
    }
    schedule(slot);
  }

  // Predicts contacts with new candidates, which come with their images, and keeps the prospect if it is
  // earlier. Precondition: the prospect is not stale.
  void predict_new_exactly(Slot slot) {
    Plan& plan = plan_of(slot);
    const Prospect found = predictor_.earliest(world_, candidates_, now_);
    if (!found.happens() || found.time > plan.moment()) return;
    const Event before = contact_of(slot);
    const Plan kept = plan;
    const Image kept_image = images_[slot];
    take(slot, found);
    if (contact_of(slot) < before) return;
    plan = kept;
    images_[slot] = kept_image;
  }

  // The same where nearest images are meant, by bounds; false if all candidates must be considered again.
  bool predict_new(Slot slot) {
    Plan& plan = plan_of(slot);
    const BoundedContacts found = predictor_.bound(compact_, candidates_, now_);
    check_bounds(candidates_, found);
    // The partner may be among those called new: what is known of it is better.
    const bool is_known = found.partner == plan.partner && found.partner != slot && !plan.is_wall();
    if (is_known && found.second <= plan.contact) return false;
    if (is_known) {
      if (plan.is_bound()) plan.limit_or_low = std::min(plan.limit_or_low, found.second);
    } else if (found.least < plan.contact) {
      plan.set_bound(found.least, std::min(found.second, plan.contact), found.partner,
                     compact_.revision(found.partner));
    } else if (plan.is_bound()) {
      plan.limit_or_low = std::min(plan.limit_or_low, found.least);
    } else if (found.least == plan.contact && found.least < kNever.high) {
      // Which is earlier the bound cannot tell.
      plan.set_bound(found.least, found.least, found.partner, compact_.revision(found.partner));
    }
    return true;
  }

  const Contact& carry_out(Slot slot) {
    const Plan& plan = plan_of(slot);
    const bool is_collision = !plan.is_wall();
    const Slot partner = is_collision ? plan.partner : slot;
    const SphereId id = phase_.lines()[slot].id;
    const SphereId partner_id = phase_.lines()[partner].id;
    // Branchless: which id is lower is unpredictable.
    const Slot exchange = (slot ^ partner) & (Slot{0} - static_cast<Slot>(partner_id < id));
    const Participants participants{slot ^ exchange, partner ^ exchange, are_nearest_};
    const Event event =
        is_collision ? make_collision(plan.moment(), id, partner_id, are_nearest_ ? Image{} : images_[slot])
                     : Event{plan.moment(), EventKind::wall, id, plan.partner, {}};
    standstill_guard_.note_event(now_, event.time, world_.size());
    execute(world_, guard_, event, participants, respond_, done_);
    now_ = event.time;
    ++(is_collision ? counters_.collision : counters_.wall);
    queue_.pop();
    if (done_.contact.fate == Fate::merge) [[unlikely]]
      return done_.contact;
    const std::uint64_t predictions_before = counters_.predictions;
    note_new_path(participants.first, done_.folded[0]);
    if (is_collision) note_new_path(participants.second, done_.folded[1]);
    if (is_collision && are_nearest_ && bound_watch_.pays()) {
      predict_both(participants.first, participants.second);
    } else {
      predict(participants.first);
      if (is_collision) predict(participants.second);
    }
    counters_.contact_predictions += counters_.predictions - predictions_before;
    return done_.contact;
  }

  // New units may shorten the time for which copies are good.
  void renew_copies() {
    compact_.renew(world_, now_);
    if (!are_nearest_) return;
    for (Slot slot = 0; slot < world_.size(); ++slot) {
      const double before = plan_of(slot).time();
      expire(slot);
      if (plan_of(slot).time() != before) queue_.schedule(slot, plans());
    }
  }

  // Lets a sphere's crossing come before its copy ceases to be good.
  void expire(Slot slot) {
    const double expiry = rounded_down(now_) + compact_.longest_age();
    if (!(expiry < plan_of(slot).crossing)) [[likely]]
      return;
    expire_soon(slot);
  }

  // The copy of a sphere at rest stays good, unless it falls.
  HARDBALL_NEVER_INLINE void expire_soon(Slot slot) {
    Plan& plan = plan_of(slot);
    const double expiry = rounded_down(now_) + compact_.longest_age(slot);
    if (!(expiry < plan.crossing)) return;
    const bool rests = world_.motion().is_straight() && world_.path(slot).velocity == Vec3{};
    plan.crossing = rests ? kNever.high : expiry;
    plan.tag |= Plan::kRenewal;
  }

  void note_new_path(Slot slot, const Image& folded) {
    phase_.refresh(world_, slot, now_, folded);
    if (compact_.note_change(slot) == 0) [[unlikely]]
      outdate_plans_with(slot);
    compact_.copy(world_, slot, now_);
  }

  // The counter of revisions has wrapped around: old revisions must not pass for new ones.
  void outdate_plans_with(Slot slot) {
    for (auto& line : phase_.lines()) {
      Plan& plan = line.plan;
      if (plan.partner == slot && !plan.is_wall() && plan.has_seen(0)) plan.tag ^= Plan::kRevision;
    }
  }

  // Predicts a sphere's contacts with its candidates and the walls. Precondition: its path has been copied.
  void predict(Slot slot) {
    if (!are_nearest_) return predict_exactly(slot);
    if (!bound_watch_.pays()) [[unlikely]] {
      bound_watch_.note_exact();
      return predict_exactly(slot);
    }
    const BoundedContacts found = bound(slot);
    plan_contacts(slot, found.least, found.second, found.partner);
  }

  // Both are bounded first: the processor works on them at once.
  void predict_both(Slot a, Slot b) {
    collect(a, candidates_);
    collect(b, candidates_of_partner_);
    counters_.predictions += candidates_.size() + candidates_of_partner_.size();
    bound_watch_.note_bounded();
    bound_watch_.note_bounded();
    const auto [of_a, of_b] = predictor_.bound(compact_, candidates_, candidates_of_partner_, now_);
    check_bounds(candidates_, of_a);
    check_bounds(candidates_of_partner_, of_b);
    plan_contacts(a, of_a.least, of_a.second, of_a.partner);
    plan_contacts(b, of_b.least, of_b.second, of_b.partner);
  }

  // The spheres that one may meet.
  void collect(Slot slot, Candidates& candidates) const {
    phase_.collect(world_, slot, candidates);
    if (has_passing_pairs_) [[unlikely]]
      leave_out_met(candidates);
  }

  // Leaves out the candidates that the sphere is passing through, or has just begun to.
  HARDBALL_NEVER_INLINE void leave_out_met(Candidates& candidates) const {
    const Slot slot = candidates.self();
    candidates.keep_if([&](std::size_t i) {
      const Slot other = candidates.slot(i);
      if (!world_.pass(slot, other)) return true;
      const Image image =
          candidates.are_nearest() ? nearest_image(world_, slot, other, now_) : candidates.image(i);
      return !have_met(world_, slot, other, image);
    });
  }

  // Bounds a sphere's contacts with its candidates.
  BoundedContacts bound(Slot slot) {
    collect(slot, candidates_);
    counters_.predictions += candidates_.size();
    bound_watch_.note_bounded();
    const BoundedContacts found = predictor_.bound(compact_, candidates_, now_);
    check_bounds(candidates_, found);
    return found;
  }

  // Takes numbers: structures of this size are passed in memory, which had a call wait for its own arguments.
  void plan_contacts(Slot slot, double least, double second, Slot partner) {
    Plan& plan = plan_of(slot);
    plan.set_bound(least, second, partner, compact_.revision(partner));
    if (has_walls_ && may_meet_wall(world_, slot, plan.limit_or_low, now_, obstacle_range())) {
      const Event wall = next_wall_event(world_, slot, now_, obstacle_range());
      if (wall.time.high < plan.contact) {
        plan.set_wall(wall.time, wall.second);
      } else {
        plan.limit_or_low = std::min(plan.limit_or_low, wall.time.high);
      }
    }
    schedule(slot);
  }

  // The same, where bounds do not tell which contact is the first. Precondition: likewise.
  void predict_exactly(Slot slot) {
    collect(slot, candidates_);
    counters_.predictions += candidates_.size();
    take(slot, predictor_.earliest(world_, candidates_, now_));
    if (has_walls_) {
      const Event wall = next_wall_event(world_, slot, now_, obstacle_range());
      if (wall.time < plan_of(slot).moment()) {
        plan_of(slot).set_wall(wall.time, wall.second);
      }
    }
    schedule(slot);
  }

  // How many box lengths a sphere covers at most between two crossings.
  double obstacle_range() const { return are_nearest_ ? 0.5 : 2; }

  void schedule(Slot slot) {
    Plan& plan = plan_of(slot);
    plan.crossing = phase_.next_crossing(world_, slot, now_, compact_);
    plan.tag &= ~Plan::kRenewal;
    if (are_nearest_) expire(slot);
    queue_.schedule(slot, plans());
  }

  void take(Slot slot, const Prospect& prospect) {
    const Slot partner = prospect.happens() ? prospect.partner : slot;
    plan_of(slot).set_collision(prospect.time, partner, compact_.revision(partner));
    if (!are_nearest_) images_[slot] = prospect.image;
  }

  // Replaces a bound by the exact contact; false if it may not be the earliest. Precondition: not stale.
  bool refine(Slot slot) {
    const Slot partner = plan_of(slot).partner;
    return replace_bound(slot,
                         contact_time(world_, slot, partner, nearest_image(world_, slot, partner, now_)));
  }

  // The same, given the contact with the partner.
  bool replace_bound(Slot slot, const Time& contact) {
    Plan& plan = plan_of(slot);
    if (!(contact.high < plan.limit_or_low)) return false;
    plan.contact = contact.high;
    plan.limit_or_low = contact.low;
    plan.tag |= Plan::kExact;
    return true;
  }

  // The partner answers for their contact, having predicted last: what remains comes after the limit, and is
  // predicted then. Until then, the sphere itself stands for the partner. Precondition: a stale bound.
  void postpone(Slot slot) {
    Plan& plan = plan_of(slot);
    const std::uint32_t renewal = plan.tag & Plan::kRenewal;
    plan.set_bound(plan.limit_or_low, plan.limit_or_low, slot, compact_.revision(slot) | renewal);
  }

  // Refines the bounds of a whole bucket, which takes less than one by one.
  void refine(std::span<QueueEntry> entries) {
    if (!are_nearest_) return;
    pairs_.begin(entries.size());
    for (const QueueEntry& entry : entries) {
      const Slot slot = entry.owner;
      const Plan& plan = plan_of(slot);
      const bool is_bounded_pair = plan.is_bound() & !plan.crosses_first() & (plan.partner != slot);
      const bool is_outdated = is_bounded_pair & is_stale(slot);
      pairs_.add(slot, plan.partner, is_bounded_pair & !is_outdated);
      if (is_outdated) postpone(slot);
    }
    predictor_.compute(world_, now_, pairs_);
    for (std::size_t i = 0; i < pairs_.count; ++i) replace_bound(pairs_.first[i], pairs_.time(i));
    for (QueueEntry& entry : entries) entry.time = plan_of(entry.owner).time();
  }

  void prefetch_refinement(Slot slot) const {
    prefetch(&world_.path(slot));
    const Plan& plan = plan_of(slot);
    if (!plan.meets_first()) return;
    prefetch(&world_.path(plan.partner));
    compact_.prefetch(plan.partner);
  }

  // Compares the bounds of all candidates with the exact contact times, in validating builds.
  void check_bounds([[maybe_unused]] const Candidates& candidates,
                    [[maybe_unused]] const BoundedContacts& found) const {
    if constexpr (HARDBALL_VALIDATE) {
      for (std::size_t i = 0; i < candidates.size(); ++i) {
        const Event contact = contact_with(candidates, i);
        if (!phase_.are_candidates(candidates.self(), candidates.slot(i))) continue;
        const bool is_partner = candidates.slot(i) == found.partner;
        HARDBALL_CHECK((is_partner ? found.least : found.second) <= contact.time.high);
      }
    }
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
  CompactPaths compact_;
  Queue queue_;
  CollapseGuard guard_;
  StandstillGuard standstill_guard_;
  BoundWatch bound_watch_;
  Time now_;
  std::vector<Image> images_;  // per slot, of the partner; none where nearest images are meant
  bool are_nearest_ = true;
  bool is_cached_ = true;          // prefetching all data ahead does not pay
  std::int64_t bucket_seen_ = -1;  // the last for which data has been prefetched
  bool are_alike_ = true;          // all spheres, in radius and mass
  bool has_walls_ = false;
  bool has_images_of_obstacles_ = false;
  bool has_passing_pairs_ = false;
  Candidates candidates_;             // of the current sphere
  Candidates candidates_of_partner_;  // of the sphere that it meets
  PairContacts pairs_;                // of the current bucket
  Executed done_;                     // the last contact
  Counters counters_;
};

}  // namespace hardball
