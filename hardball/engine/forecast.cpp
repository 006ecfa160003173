// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/engine/forecast.hpp"
#include "hardball/world/images.hpp"
#include "hardball/world/pair_event.hpp"

#include "hardball/standard/ranges.hpp"

// How a forecast follows spheres that come, go, and pass through each other.

namespace hardball {
namespace {

// Whether there are meshes that take the place in the caches which small worlds have to themselves.
bool has_large_meshes(const Setting& setting) {
  constexpr std::size_t kLarge = std::size_t{1} << 18;
  return ranges::any_of(setting.meshes(), [&](std::uint32_t number) {
    return setting.surface(number).mesh()->mesh().memory_bytes() > kLarge;
  });
}

}  // namespace

void Forecast::rebuild(const Time& now, const Progress& progress) {
  now_ = now;
  phase_->build(world_, now_, compact_);
  phase_.find_lines();
  uses_minimum_image_ = phase_->uses_minimum_image();
  images_.assign(uses_minimum_image_ ? 0 : world_.size(), Image{});
  are_alike_ = world_.are_alike();
  has_walls_ = world_.box().is_any(Boundary::wall) || !world_.other_surfaces().empty();
  has_solids_ = world_.has_solids();
  is_cached_ = world_.size() <= phase_->cached_spheres() && !has_large_meshes(world_);
  do_solids_rest_ = has_solids_ && world_.do_solids_rest();
  solid_rounding_ = do_solids_rest_ ? rounding_near_solids(world_) : 0;
  clear_balls_.assign(do_solids_rest_ ? world_.size() : 0, ClearBall());
  note_exclusions();
  for (Slot slot = 0; slot < world_.size(); ++slot) {
    progress.record(slot, world_.size());
    predict(slot);
  }
}

void Forecast::insert(Slot slot) {
  compact_.insert(world_, slot, now_);
  phase_->insert(world_, slot, now_, compact_);
  phase_.find_lines();
  if (!uses_minimum_image_) images_.resize(std::max(images_.size(), world_.size()));
  are_alike_ = world_.are_alike();
  note_exclusions();
}

void Forecast::erase(Slot slot) {
  phase_->erase(slot);
  note_revision(slot);
  phase_.line(slot).plan = Plan();
}

void Forecast::note_moved(Slot slot) {
  compact_.copy(world_, slot, now_);
  if (phase_->keeps(world_, slot, now_, compact_)) {
    phase_->refresh(world_, slot, now_, Image());
    return note_revision(slot);
  }
  erase(slot);
  insert(slot);
}

void Forecast::remove(Slot slot) {
  const auto last = static_cast<Slot>(world_.size() - 1);
  erase(slot);
  world_.remove_at(slot, now_);
  if (slot == last) return;
  phase_->move(last, slot);
  compact_.move(last, slot);
  if (!uses_minimum_image_) images_[slot] = images_[last];
  phase_.line(last).plan = Plan();
  note_revision(last);
  compact_.copy(world_, slot, now_);
  predict(slot);
}

std::span<const Slot> Forecast::overlapping(Slot slot) {
  phase_->collect_overlapping(world_, slot, candidates_);
  return {candidates_.slots(), candidates_.size()};
}

void Forecast::note_exclusions() {
  has_passing_pairs_ = has_passing_pairs(world_);
  has_steps_ = world_.has_steps();
  has_excluded_ = has_passing_pairs_ || has_steps_;
  are_steps_bounded_ = true;
  const StepTable& steps = world_.interactions().steps();
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double reach = 2 * world_.largest_radius() * steps[static_cast<StepTable::Number>(i)].range();
    are_steps_bounded_ &= reach <= compact_.farthest();
  }
}

// Leaves out the candidates that a sphere is passing through, or has just begun to, and those that are inside
// of a step with it, which it knows by its pairs.
HARDBALL_NEVER_INLINE void Forecast::exclude(Candidates& candidates, StepCandidates& pairs) const {
  const Slot slot = candidates.self();
  if (has_steps_) {
    pairs.collect(world_, slot);
    if (candidates.uses_minimum_image() && pairs.size() > 0) {
      predictor_.exclude(candidates, {pairs.slots(), pairs.size()});
    } else if (pairs.size() > 0) {
      candidates.keep_if([&](std::size_t i) { return !world_.pair_levels().find(slot, candidates.slot(i)); });
    }
  }
  if (!has_passing_pairs_) return;
  candidates.keep_if([&](std::size_t i) {
    const Slot other = candidates.slot(i);
    if (!pass(world_, slot, other)) return true;
    const Image image =
        candidates.uses_minimum_image() ? nearest_image(world_, slot, other, now_) : candidates.image(i);
    return !are_passing(world_, slot, other, image);
  });
}

// Plans a contact of a sphere whose time is known, unless it comes after a contact that is planned.
void Forecast::plan_if_first(Slot slot, const Event& event, Slot partner) {
  Plan& own = mutable_plan(slot);
  if (!own.is_bound() && contact_of(slot) < event) return;
  own.set_collision(event.time, partner, compact_.revision(partner));
  if (!uses_minimum_image_) images_[slot] = id(slot) < id(partner) ? event.image : -event.image;
}

// Lowers the bounds that are planned for a sphere by those of its events with the spheres that are inside of
// a step with it.
HARDBALL_NEVER_INLINE void Forecast::plan_bounded_pairs(StepCandidates& pairs) {
  const Slot slot = pairs.self();
  const bool can_be_bounded =
      are_steps_bounded_ && compact_.is_bounded(slot) && pairs.size() <= BoundKeys::kMax;
  if (!can_be_bounded || !plan(slot).is_bound()) return plan_pairs(pairs);
  if (pairs.size() == 0) return;
  counters_.predictions += pairs.size();
  pairs.find_distances_for_bounds(world_, compact_);
  const BoundedContacts found = predictor_.bound_steps(compact_, pairs, now_);
  check_bounds(*this, pairs, found);
  if (!found.happens()) return;
  Plan& own = mutable_plan(slot);
  if (own.contact() <= found.least) return own.lower_safe_until(found.least);
  own.set_bound(found.least, std::min(found.second, own.contact()), found.partner,
                compact_.revision(found.partner));
}

// Plans the next event of a sphere with those that are inside of a step with it, if it comes before what is
// planned.
HARDBALL_NEVER_INLINE void Forecast::plan_pairs(StepCandidates& pairs) {
  const Slot slot = pairs.self();
  counters_.predictions += pairs.size();
  pairs.find_distances(world_);
  const EarliestContact found = predictor_.earliest_step(world_, pairs, now_);
  if (!(found.high < kNever.high)) return;
  Plan& own = mutable_plan(slot);
  if (own.is_bound() && own.contact() <= found.high) return own.lower_safe_until(found.high);
  const PairLevel first = found.is_tied ? first_in_order(slot) : pairs.pairs()[found.index];
  const Image image = nearest_image(world_, slot, first.partner, now_);
  const Time time =
      found.is_tied ? next_pair_event(world_, slot, first, image).time : Time{found.high, found.low};
  plan_if_first(slot, make_collision(time, id(slot), id(first.partner), image), first.partner);
}

// Of the pairs of a sphere the one whose event comes first in the order of events. Precondition: there is
// one.
PairLevel Forecast::first_in_order(Slot slot) const {
  Event first;
  PairLevel found;
  for (const PairLevel& pair : world_.pair_levels().of(slot)) {
    const Image image = nearest_image(world_, slot, pair.partner, now_);
    const Event event =
        make_collision(next_pair_event(world_, slot, pair, image).time, id(slot), id(pair.partner), image);
    if (!(event < first)) continue;
    first = event;
    found = pair;
  }
  return found;
}

// The counter of revisions has wrapped around: old revisions must not pass for new ones.
void Forecast::outdate_plans_with(Slot slot) {
  for (SphereLine& line : phase_->lines()) {
    Plan& other = line.plan;
    if (other.has_partner() && other.partner() == slot && other.has_seen(0)) other.forget_revision();
  }
}

}  // namespace hardball
