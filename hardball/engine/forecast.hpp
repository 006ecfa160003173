// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "hardball/bounds/compact_paths.hpp"
#include "hardball/broadphase/broad_phase.hpp"
#include "hardball/engine/bound_watch.hpp"
#include "hardball/engine/check_forecast.hpp"
#include "hardball/engine/owned_phase.hpp"
#include "hardball/engine/predictor.hpp"
#include "hardball/engine/run.hpp"
#include "hardball/events/event_queue.hpp"
#include "hardball/events/plan.hpp"
#include "hardball/geometry/inlining.hpp"
#include "hardball/memory/huge_pages.hpp"
#include "hardball/memory/prefetch.hpp"
#include "hardball/world/images.hpp"
#include "hardball/world/pair_event.hpp"
#include "hardball/world/progress.hpp"
#include "hardball/world/walls.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// A world, and what comes next for each of its spheres: the plans, which are also the event table of the
/// queue.
///
/// Whenever a path or region changes, that sphere predicts its contacts with all of its candidates again, so
/// the one of a pair that predicted last answers for their contact. A bound is refined, replaced
/// by the exact contact, when it is about to come; if its contact is not before the time until which all
/// others are excluded, all contacts of the sphere are computed exactly. A planned contact whose partner's
/// path has changed since is stale, and the sphere predicts again. Whoever changes a plan schedules the
/// sphere. Source: docs/bounds.md, with the proof.
class Forecast {
 public:
  /// Makes no regions or plans: `rebuild` must follow.
  Forecast(World world, const PhaseSettings& settings)
      : world_(std::move(world)),
        phase_(make_broad_phase(settings, world_)),
        predictor_(settings.instructions) {}

  const World& world() const { return world_; }
  World& world() { return world_; }
  const OwnedPhase& owned_phase() const { return phase_; }
  const BroadPhase& phase() const { return *phase_; }
  /// Replaces the broad phase; `rebuild` must follow.
  void replace_phase(const PhaseSettings& settings) {
    phase_ = OwnedPhase(make_broad_phase(settings, world_));
  }
  const CompactPaths& copies() const { return compact_; }
  const Plan& plan(Slot slot) const { return phase_.line(slot).plan; }
  SphereId id(Slot slot) const { return phase_.line(slot).id; }
  bool uses_minimum_image() const { return uses_minimum_image_; }
  /// The time up to which all events have been handled.
  const Time& now() const { return now_; }
  void advance(const Time& moment) { now_ = moment; }
  /// The counters of predictions, and no others.
  const Counters& counters() const { return counters_; }
  std::size_t memory_bytes() const {
    return world_.memory_bytes() + phase_->memory_bytes() + compact_.memory_bytes() +
           images_.capacity() * sizeof(Image);
  }

  /// Discards everything but the world, and makes new regions and plans as of `now`.
  void rebuild(const Time& now, const Progress& progress);

  /// Whether a sphere can be inserted without rebuilding.
  bool admits(Slot slot) const { return phase_->admits(world_, slot); }

  /// Makes a region for a sphere that has none, as of now. It remains to be predicted. Precondition:
  /// admits(slot).
  void insert(Slot slot);

  /// The sphere has no region any more, and nothing is planned for it, nor with it.
  void erase(Slot slot);

  /// Removes a sphere from the world. The one in the last slot takes its place, and is predicted anew.
  void remove(Slot slot);

  /// Every sphere that one may overlap, also deep inside.
  std::span<const Slot> overlapping(Slot slot);

  /// Chooses new units for the copies if speeds have changed, and returns whether it has done so. Calls
  /// reschedule(slot) for each sphere whose next event has become another.
  template <class Reschedule>
  bool keep_copies_good(Reschedule&& reschedule) {
    if (!compact_.are_outdated()) [[likely]]
      return false;
    compact_.renew(world_, now_);
    if (!uses_minimum_image_) return true;
    for (Slot slot = 0; slot < world_.size(); ++slot) {
      const double before = plan(slot).time();
      expire(slot);
      if (plan(slot).time() != before) reschedule(slot);
    }
    return true;
  }

  /// Whether the partner's path has changed since the prediction.
  bool is_stale(Slot slot) const {
    const Plan& own = plan(slot);
    return own.has_partner() && !own.has_seen(compact_.revision(own.partner()));
  }
  /// Whether all contacts must be predicted again when the planned contact comes.
  bool is_unknown(Slot slot) const { return plan(slot).is_unknown() || is_stale(slot); }

  /// The contact planned. Precondition: it is exact and not stale.
  Event contact_of(Slot slot) const {
    const Plan& own = plan(slot);
    if (!(own.contact() < kNever.high)) return {};
    if (own.meets_wall()) return {own.contact_time(), EventKind::wall, world_.id(slot), own.wall(), {}};
    return make_collision(own.contact_time(), world_.id(slot), world_.id(own.partner()),
                          image_of_partner(slot));
  }
  /// The image of the partner in events: none where the nearest is meant.
  Image image_in_event(Slot slot) const { return uses_minimum_image_ ? Image{} : images_[slot]; }

  /// Handles the crossing of a sphere, and plans its next.
  void cross(Slot slot) {
    compact_.copy(world_, slot, now_);
    if (!plan(slot).is_renewal()) {
      ++counters_.enter;
      phase_->cross(world_, slot, now_, compact_, candidates_);
      if (has_excluded_) exclude(candidates_, step_candidates_);
      counters_.predictions += candidates_.size();
      counters_.enter_predictions += candidates_.size();
      if (is_stale(slot) && plan(slot).is_bound()) postpone(slot);
      const bool is_changed = is_stale(slot);
      counters_.stale += is_changed ? 1 : 0;
      if (is_changed) return predict(slot);
      if (!uses_minimum_image_) {
        predict_new_exactly(slot);
      } else if (!predict_new(slot)) {
        return predict(slot);
      }
    }
    plan_crossing(slot);
  }

  /// Predicts for a sphere of which nothing is known.
  void predict_unknown(Slot slot) {
    ++counters_.stale;
    compact_.copy(world_, slot, now_);
    predict(slot);
  }

  /// Refines the bound of a sphere, or computes all its contacts if others may come before it.
  void refine_or_predict(Slot slot) {
    const Slot partner = plan(slot).partner();
    const Image image = nearest_image(world_, slot, partner, now_);
    if (mutable_plan(slot).refine(contact_time(world_, slot, partner, image))) return;
    bound_watch_.note_ambiguous();
    compact_.copy(world_, slot, now_);
    predict_exactly(slot);
  }

  /// Records that a sphere's path has changed, its center folded back by `folded` boxes.
  void note_new_path(Slot slot, const Image& folded) {
    phase_->refresh(world_, slot, now_, folded);
    note_revision(slot);
    compact_.copy(world_, slot, now_);
  }

  /// Records that a sphere is on another path, perhaps elsewhere. It is not predicted yet.
  void note_moved(Slot slot);

  /// Predicts a sphere's contacts with its candidates and the walls, and its crossing. Precondition: its path
  /// has been copied.
  void predict(Slot slot) {
    if (!uses_minimum_image_) return predict_exactly(slot);
    if (!bound_watch_.pays()) [[unlikely]] {
      bound_watch_.note_exact();
      return predict_exactly(slot);
    }
    collect(slot, candidates_, step_candidates_);
    counters_.predictions += candidates_.size();
    bound_watch_.note_bounded();
    const BoundedContacts found = predictor_.bound(compact_, candidates_, now_);
    check_bounds(*this, candidates_, found);
    plan_contacts(candidates_, found.least, found.second, found.partner);
    if (has_steps_) [[unlikely]]
      plan_bounded_pairs(step_candidates_);
    plan_crossing(slot);
  }

  /// Predicts two spheres as `predict` does one. Both are bounded first: the processor works on them at once.
  void predict_both(Slot a, Slot b) {
    if (!uses_minimum_image_ || !bound_watch_.pays()) [[unlikely]] {
      predict(a);
      return predict(b);
    }
    collect(a, candidates_, step_candidates_);
    collect(b, candidates_of_partner_, step_candidates_of_partner_);
    counters_.predictions += candidates_.size() + candidates_of_partner_.size();
    bound_watch_.note_bounded();
    bound_watch_.note_bounded();
    const auto [of_a, of_b] = predictor_.bound(compact_, candidates_, candidates_of_partner_, now_);
    check_bounds(*this, candidates_, of_a);
    check_bounds(*this, candidates_of_partner_, of_b);
    plan_contacts(candidates_, of_a.least, of_a.second, of_a.partner);
    plan_contacts(candidates_of_partner_, of_b.least, of_b.second, of_b.partner);
    if (has_steps_) [[unlikely]] {
      plan_bounded_pairs(step_candidates_of_partner_);
      plan_bounded_pairs(step_candidates_);
    }
    plan_crossing(a);
    plan_crossing(b);
  }

  // The event table; see EventTable.

  double time(Slot slot) const { return plan(slot).time(); }
  // What is not known exactly comes first among the events of one double: it may be the earliest.
  Event event(Slot slot) const {
    const Plan& own = plan(slot);
    if (own.crosses_first() || own.is_bound() || is_stale(slot)) {
      return {{own.time(), -std::numeric_limits<double>::infinity()}, EventKind::enter, id(slot), 0, {}};
    }
    return contact_of(slot);
  }
  // Two spheres that will collide with each other; if one plan is stale, that is found when it is handled.
  bool share_event(Slot a, Slot b) const {
    const Plan& one = plan(a);
    const Plan& other = plan(b);
    return uses_minimum_image_ && one.meets_first() && other.meets_first() && !one.is_bound() &&
           !other.is_bound() && one.partner() == b && other.partner() == a &&
           one.contact_time() == other.contact_time();
  }
  bool is_cached() const { return is_cached_; }
  void prefetch_event(Slot slot) const { prefetch(&plan(slot)); }
  void prefetch_refinement(Slot slot) const {
    world_.prefetch(slot);
    const Plan& own = plan(slot);
    if (!own.meets_first()) return;
    world_.prefetch(own.partner());
    compact_.prefetch(own.partner());
  }
  // Refines the bounds of a whole bucket, which takes less than one by one.
  HARDBALL_ALWAYS_INLINE void refine(std::span<QueueEntry> entries) {
    if (!uses_minimum_image_) return;
    pairs_.begin(entries.size());
    for (const QueueEntry& entry : entries) {
      const Slot slot = entry.owner;
      const Plan& own = plan(slot);
      const bool is_due = own.is_bounded_pair() & !own.crosses_first();
      const bool is_outdated = is_due & is_stale(slot);
      pairs_.add(slot, own.partner(), is_due & !is_outdated);
      if (is_outdated) postpone(slot);
    }
    predictor_.compute(world_, now_, pairs_);
    for (std::size_t i = 0; i < pairs_.count; ++i) mutable_plan(pairs_.first[i]).refine(pairs_.time(i));
    for (QueueEntry& entry : entries) entry.time = plan(entry.owner).time();
  }

  /// Prefetches a sphere's own data.
  void prefetch_sphere(Slot slot) const {
    world_.prefetch(slot);
    if (!are_alike_) world_.prefetch_size(slot);
    compact_.prefetch(slot);
    phase_->prefetch_line(slot);
    prefetch_clear_ball(slot);
    if (phase_->has_more_data()) phase_.visit([&](const auto& phase) { phase.prefetch_more(slot); });
  }

  /// The spheres that one may meet, without those that are inside of a step with it.
  void collect(Slot slot, Candidates& candidates) const {
    StepCandidates pairs;
    collect(slot, candidates, pairs);
  }

 private:
  static_assert(CompactPaths::kRevision == Plan::kRevision);

  Plan& mutable_plan(Slot slot) { return phase_.line(slot).plan; }

  // The image of the partner that is met. Precondition: the planned contact is a collision, not stale.
  Image image_of_partner(Slot slot) const {
    const Plan& own = plan(slot);
    return uses_minimum_image_ ? nearest_image(world_, slot, own.partner(), own.contact_time())
                               : images_[slot];
  }

  // Collects the candidates of a sphere, and apart from them those that are inside of a step with it.
  HARDBALL_ALWAYS_INLINE void collect(Slot slot, Candidates& candidates, StepCandidates& pairs) const {
    prefetch_clear_ball(slot);
    phase_.visit([&](const auto& phase) { phase.collect(world_, slot, candidates); });
    if (has_excluded_) [[unlikely]]
      exclude(candidates, pairs);
  }
  void exclude(Candidates& candidates, StepCandidates& pairs) const;
  void plan_bounded_pairs(StepCandidates& pairs);
  void plan_pairs(StepCandidates& pairs);
  void plan_if_first(Slot slot, const Event& event, Slot partner);
  PairLevel first_in_order(Slot slot) const;
  void note_exclusions();

  // Predicts contacts with new candidates, which come with their images, and keeps the planned contact if it
  // is earlier. Precondition: the planned contact is known.
  void predict_new_exactly(Slot slot) {
    Plan& own = mutable_plan(slot);
    const PredictedContact found = predictor_.earliest(world_, candidates_, now_);
    if (!found.happens() || found.time > own.contact_time()) return;
    const Event before = contact_of(slot);
    const Plan kept = own;
    const Image kept_image = images_[slot];
    take(slot, found);
    if (contact_of(slot) < before) return;
    own = kept;
    images_[slot] = kept_image;
  }

  // Predicts contacts with new candidates, which mean nearest images, by bounds; false if all candidates must
  // be considered again.
  bool predict_new(Slot slot) {
    Plan& own = mutable_plan(slot);
    const BoundedContacts found = predictor_.bound(compact_, candidates_, now_);
    check_bounds(*this, candidates_, found);
    // The partner may be among those called new: what is known of it is better.
    const bool is_known = found.happens() && own.has_partner() && found.partner == own.partner();
    if (is_known && found.second <= own.contact()) return false;
    if (is_known) {
      if (own.is_bound()) own.lower_safe_until(found.second);
    } else if (found.least < own.contact()) {
      own.set_bound(found.least, std::min(found.second, own.contact()), found.partner,
                    compact_.revision(found.partner));
    } else if (own.is_bound()) {
      own.lower_safe_until(found.least);
    } else if (found.least == own.contact() && found.least < kNever.high) {
      // The bound does not decide which is earlier.
      own.set_bound(found.least, found.least, found.partner, compact_.revision(found.partner));
    }
    return true;
  }

  // Takes numbers: structures of this size are passed in memory, which had a call wait for its own arguments.
  void plan_contacts(const Candidates& candidates, double least, double second, Slot partner) {
    const Slot slot = candidates.self();
    Plan& own = mutable_plan(slot);
    own.set_bound(least, second, partner, compact_.revision(partner));
    if (has_walls_ && may_meet_wall(world_, slot, own.safe_until(), now_)) {
      const Event wall = next_wall_event(world_, slot, now_);
      if (wall.time.high < own.contact()) {
        own.set_wall(wall.time, wall.second);
      } else {
        own.lower_safe_until(wall.time.high);
      }
    }
  }

  // Predicts all contacts of a sphere exactly, where bounds do not decide which is the first.
  void predict_exactly(Slot slot) {
    collect(slot, candidates_, step_candidates_);
    counters_.predictions += candidates_.size();
    take(slot, uses_minimum_image_ ? predictor_.earliest(world_, compact_, candidates_, now_)
                                   : predictor_.earliest(world_, candidates_, now_));
    // A wall may be earlier in the low part of its time, too.
    const double later = std::nextafter(plan(slot).contact(), kNever.high);
    if (has_walls_ && may_meet_wall(world_, slot, later, now_)) {
      const Event wall = next_wall_event(world_, slot, now_);
      if (wall.happens() && wall.time < plan(slot).contact_time())
        mutable_plan(slot).set_wall(wall.time, wall.second);
    }
    if (has_steps_) [[unlikely]]
      plan_pairs(step_candidates_);
    plan_crossing(slot);
  }

  // Plans the contact with a solid, if one comes first before the sphere crosses: then this is done
  // again.
  void plan_solid(Slot slot) {
    Plan& own = mutable_plan(slot);
    const double first = own.is_bound() ? own.safe_until() : own.contact();
    const double until = std::min(first, own.crossing());
    if (do_solids_rest_ && is_clear_of_solids(slot, until)) return check_clear(*this, slot, until);
    const Event met = next_solid_event(world_, slot, now_, until);
    if (!met.happens()) return;
    if (own.is_bound() ? met.time.high < own.contact() : met < contact_of(slot)) {
      own.set_wall(met.time, met.second);
    } else if (own.is_bound()) {
      own.lower_safe_until(met.time.high);
    }
  }

  void prefetch_clear_ball(Slot slot) const {
    if (slot < clear_balls_.size()) prefetch(&clear_balls_[slot]);
  }
  // Whether a sphere certainly touches no solid until another time, as the ball around it that is clear of
  // them says. A ball is renewed when the sphere has moved on.
  bool is_clear_of_solids(Slot slot, double until) {
    if (slot >= clear_balls_.size()) clear_balls_.resize(world_.size());
    ClearBall& ball = clear_balls_[slot];
    const State state = world_.motion().state_at(world_.path(slot), now_);
    const double elapsed = std::max(0.0, until - rounded_down(now_));
    const double radius = world_.base_radius(slot) * world_.motion().largest_scale();
    const double pull = world_.motion().is_straight() ? 0 : length(world_.motion().gravity());
    const double way = elapsed * (length(state.velocity) + 0.5 * elapsed * pull);
    const Vec3& at = state.position;
    // More than all of these are rounded by.
    const double margin =
        solid_rounding_ + 0x1p-40 * (std::fabs(at.x) + std::fabs(at.y) + std::fabs(at.z) + way + radius);
    const double reach = way + radius + margin;
    const Vec3 moved = at - ball.center;
    const double room = ball.distance - reach;
    if (room > 0 && dot(moved, moved) < room * room) return true;
    // Near a solid, looking for one costs less than looking around.
    constexpr double kFarthest = 4.0 / 3;  // where a solid is, over the clearance
    const double distance = length(moved);
    if (distance < 0.5 * radius || distance + kFarthest * ball.distance < reach) return false;
    // Farther away, it costs less to look again.
    constexpr double kEnough = 3;  // reaches
    ball = {at, clearance_of_solids(world_, at, kEnough * reach)};
    return reach < ball.distance;
  }

  void plan_crossing(Slot slot) {
    prefetch_clear_ball(slot);
    phase_.visit([&](auto& phase) {
      mutable_plan(slot).set_crossing(phase.next_crossing(world_, slot, now_, compact_));
    });
    if (has_solids_) [[unlikely]]
      plan_solid(slot);
    if (uses_minimum_image_) expire(slot);
  }

  // Lets a sphere's crossing come before its copy ceases to be good.
  void expire(Slot slot) {
    const double expiry = rounded_down(now_) + compact_.longest_age();
    if (!(expiry < plan(slot).crossing())) [[likely]]
      return;
    expire_soon(slot);
  }

  // The copy of a sphere at rest stays good, unless it falls.
  HARDBALL_NEVER_INLINE void expire_soon(Slot slot) {
    if (compact_.is_good_for(slot, plan(slot).crossing() - rounded_down(now_))) return;
    const double expiry = rounded_down(now_) + compact_.longest_age(slot);
    if (!(expiry < plan(slot).crossing())) return;
    // In a sheared box it may be the cells that move.
    const bool rests =
        world_.motion().is_straight() && !world_.box().is_sheared() && world_.path(slot).velocity == Vec3{};
    mutable_plan(slot).set_renewal(rests ? kNever.high : expiry);
  }

  // Plans made with the path that was in the slot are stale.
  HARDBALL_ALWAYS_INLINE void note_revision(Slot slot) {
    if (compact_.note_change(slot) == 0) [[unlikely]]
      outdate_plans_with(slot);
  }

  void outdate_plans_with(Slot slot);

  void take(Slot slot, const PredictedContact& found) {
    if (!found.happens()) return mutable_plan(slot).set_unknown(kNever.high);
    mutable_plan(slot).set_collision(found.time, found.partner, compact_.revision(found.partner));
    if (!uses_minimum_image_) images_[slot] = found.image;
  }

  // The partner answers for their contact, having predicted last: what remains comes after that time, and is
  // predicted then. Precondition: a stale bound.
  void postpone(Slot slot) { mutable_plan(slot).set_unknown(plan(slot).safe_until()); }

  World world_;
  OwnedPhase phase_;
  Predictor predictor_;
  CompactPaths compact_;
  BoundWatch bound_watch_;
  Time now_;
  LargeVector<Image> images_;  // per slot, of the partner; none where nearest images are meant
  bool uses_minimum_image_ = true;
  bool is_cached_ = true;  // prefetching all data ahead does not pay
  bool are_alike_ = true;  // all spheres, in radius and mass
  bool has_walls_ = false;
  // A point, and how far from it there is no solid [L]: true of any sphere. Nothing is known of a point that
  // is infinitely far away.
  struct alignas(32) ClearBall {  // in one cache line
    Vec3 center{kNever.high, 0, 0};
    double distance = 0;
  };
  bool do_solids_rest_ = false;
  double solid_rounding_ = 0;
  std::vector<ClearBall> clear_balls_;  // by slot
  bool has_solids_ = false;             // obstacles at rest, meshes
  bool has_passing_pairs_ = false;
  bool has_steps_ = false;            // of potentials
  bool are_steps_bounded_ = false;    // no farther than candidates are apart
  bool has_excluded_ = false;         // some candidates must be left out: one of the two above
  Candidates candidates_;             // of the current sphere
  Candidates candidates_of_partner_;  // of the sphere that it meets
  PairContacts pairs_;                // of the current bucket
  StepCandidates step_candidates_;    // of the current sphere
  StepCandidates step_candidates_of_partner_;
  Counters counters_;
};

}  // namespace hardball
