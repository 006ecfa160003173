// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/engine/forecast.hpp"

// How a forecast follows spheres that come, go, and pass through each other.

namespace hardball {

template <BroadPhase Phase>
void Forecast<Phase>::rebuild(const Time& now, const Progress& progress) {
  now_ = now;
  phase_.build(world_, now_, compact_);
  uses_minimum_image_ = phase_.uses_minimum_image();
  images_.assign(uses_minimum_image_ ? 0 : world_.size(), Image{});
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

template <BroadPhase Phase>
void Forecast<Phase>::insert(Slot slot) {
  compact_.insert(world_, slot, now_);
  phase_.insert(world_, slot, now_, compact_);
  if (!uses_minimum_image_) images_.resize(std::max(images_.size(), world_.size()));
  are_alike_ = world_.are_alike();
  has_passing_pairs_ = world_.has_passing_pairs();
}

template <BroadPhase Phase>
void Forecast<Phase>::erase(Slot slot) {
  phase_.erase(slot);
  note_revision(slot);
  phase_.lines()[slot].plan = Plan();
}

template <BroadPhase Phase>
void Forecast<Phase>::note_moved(Slot slot) {
  compact_.copy(world_, slot, now_);
  if (phase_.keeps(world_, slot, now_, compact_)) {
    phase_.refresh(world_, slot, now_, Image());
    return note_revision(slot);
  }
  erase(slot);
  insert(slot);
}

template <BroadPhase Phase>
void Forecast<Phase>::remove(Slot slot) {
  const auto last = static_cast<Slot>(world_.size() - 1);
  erase(slot);
  world_.remove(world_.id(slot), now_);
  if (slot == last) return;
  phase_.move(last, slot);
  compact_.move(last, slot);
  if (!uses_minimum_image_) images_[slot] = images_[last];
  phase_.lines()[last].plan = Plan();
  note_revision(last);
  compact_.copy(world_, slot, now_);
  predict(slot);
}

template <BroadPhase Phase>
std::span<const Slot> Forecast<Phase>::overlapping(Slot slot) {
  phase_.collect_overlapping(world_, slot, candidates_);
  return {candidates_.slots(), candidates_.size()};
}

// Leaves out the candidates that a sphere is passing through, or has just begun to.
template <BroadPhase Phase>
HARDBALL_NEVER_INLINE void Forecast<Phase>::exclude_passing(Candidates& candidates) const {
  const Slot slot = candidates.self();
  candidates.keep_if([&](std::size_t i) {
    const Slot other = candidates.slot(i);
    if (!world_.pass(slot, other)) return true;
    const Image image =
        candidates.uses_minimum_image() ? nearest_image(world_, slot, other, now_) : candidates.image(i);
    return !are_passing(world_, slot, other, image);
  });
}

// The counter of revisions has wrapped around: old revisions must not pass for new ones.
template <BroadPhase Phase>
void Forecast<Phase>::outdate_plans_with(Slot slot) {
  for (auto& line : phase_.lines()) {
    Plan& other = line.plan;
    if (other.has_partner() && other.partner() == slot && other.has_seen(0)) other.forget_revision();
  }
}

}  // namespace hardball
