// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/parallel/domain.hpp"

// How a domain takes a window as what has happened, and who owns and holds its spheres from then on.

namespace hardball {

template <class Engine, class Sums>
void Domain<Engine, Sums>::commit(const Time& moment) {
  engine_.end_journal();
  begin_ = later(moment, engine_.now());
  is_adding_ = false;
  keep_own_counts();
  for (Outbox& outbox : outboxes_) outbox.clear();
  // Those of a contact that is executed alone were set after the others were taken.
  take_alarms(moment.high, [&](const Frontier::Alarm& alarm) { touched_.push_back(alarm.slot); });
  taken_.clear();
  std::ranges::sort(touched_);
  touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
  for (std::size_t k = 0; k < touched_.size(); ++k) {
    constexpr std::size_t kAhead = 8;
    if (k + kAhead < touched_.size()) prefetch(touched_[k + kAhead]);
    review(touched_[k]);
  }
  touched_.clear();
}

template <class Engine, class Sums>
void Domain<Engine, Sums>::receive(std::span<const Outbox* const> inboxes) {
  for (const Outbox* inbox : inboxes) {
    for (const SphereId sphere : inbox->departures) {
      const std::uint32_t ghost = residents_.find_ghost(sphere);
      HARDBALL_CHECK(ghost != IdMap::kNone);
      remove_at(residents_.ghost(ghost).slot, begin_);
    }
  }
  correct();
  arriving_.clear();
  for (const Outbox* inbox : inboxes) {
    for (const Arrival& arrival : inbox->arrivals) {
      HARDBALL_CHECK(residents_.find_ghost(arrival.sphere.id) == IdMap::kNone);
      arriving_.push_back(arrival.sphere);
    }
  }
  engine_.put(arriving_, begin_);
  for (const Outbox* inbox : inboxes) {
    for (const Arrival& arrival : inbox->arrivals)
      residents_.add_ghost(arrival.sphere.id, neighbor_number(arrival.owner));
  }
  for (const Outbox* inbox : inboxes) {
    for (const NewOwner& change : inbox->new_owners) {
      const std::uint32_t ghost = residents_.find_ghost(change.sphere);
      HARDBALL_CHECK(ghost != IdMap::kNone);
      residents_.set_owner(ghost, neighbor_number(change.owner));
    }
  }
  for (const Outbox* inbox : inboxes) {
    for (const Handover& handover : inbox->handovers) take_over(handover);
  }
  HARDBALL_CHECK(residents_.size() == world().size());
}

template <class Engine, class Sums>
void Domain<Engine, Sums>::review(Slot slot) {
  if (!residents_.is_own(slot)) return;
  const State state = folded_state(slot, begin_);
  const Frontier::Distances place = frontier_.distances(state.position);
  const SphereId id = world().id(slot);
  const NeighborSet before = residents_.holders(slot);
  NeighborSet holders = frontier_.holders_at(place, before);
  const bool is_outside = place.own > 0;
  std::uint32_t owner = 0;
  if (is_outside) {
    owner = frontier_.nearest_neighbor(place);
    holders |= NeighborSet{1} << owner;
  }
  for (std::uint32_t neighbor = 0; neighbor < outboxes_.size(); ++neighbor) {
    const NeighborSet bit = NeighborSet{1} << neighbor;
    if ((before & bit) != 0 && (holders & bit) == 0) outboxes_[neighbor].departures.push_back(id);
    if ((before & bit) == 0 && (holders & bit) != 0) {
      outboxes_[neighbor].arrivals.push_back(
          {world().state_of(slot), is_outside && neighbor != owner ? neighbors()[owner] : number_});
    }
  }
  if (!is_outside) {
    residents_.set_holders(slot, holders);
    return frontier_.set_alarm(alarm_of(slot, state, place, begin_));
  }
  hand_over(slot, id, holders, owner);
}

template <class Engine, class Sums>
void Domain<Engine, Sums>::hand_over(Slot slot, SphereId id, NeighborSet holders, std::uint32_t owner) {
  Handover handover{world().state_of(slot), {number_}, engine_.aftermath().collapse.idle_contacts(id)};
  for (std::uint32_t neighbor = 0; neighbor < outboxes_.size(); ++neighbor) {
    if ((holders >> neighbor & 1) == 0 || neighbor == owner) continue;
    handover.holders.push_back(neighbors()[neighbor]);
    outboxes_[neighbor].new_owners.push_back({id, neighbors()[owner]});
  }
  outboxes_[owner].handovers.push_back(std::move(handover));
  residents_.make_ghost(slot, id, owner);
}

template <class Engine, class Sums>
void Domain<Engine, Sums>::take_over(const Handover& handover) {
  const std::uint32_t ghost = residents_.find_ghost(handover.sphere.id);
  HARDBALL_CHECK(ghost != IdMap::kNone);
  const Slot slot = residents_.ghost(ghost).slot;
  HARDBALL_CHECK(world().id(slot) == handover.sphere.id && world().path(slot) == handover.sphere.path);
  SphereEdit(engine_.world_to_edit(), begin_, slot).store(slot, handover.sphere);
  NeighborSet holders = 0;
  for (const DomainNumber holder : handover.holders) holders |= NeighborSet{1} << neighbor_number(holder);
  residents_.make_own(slot, holders);
  if (handover.idle_contacts > 0) {
    Aftermath aftermath = engine_.aftermath();
    aftermath.collapse.set_idle_contacts(handover.sphere.id, handover.idle_contacts);
    engine_.take_over(aftermath);
  }
  residents_.note_change(slot);
  set_alarm(slot);
}

template <class Engine, class Sums>
void Domain<Engine, Sums>::correct() {
  corrected_.clear();
  for (const Correction& correction : comparison_.corrections()) {
    const Residents::Ghost& ghost = residents_.ghost(correction.ghost);
    if (residents_.find_ghost(ghost.sphere) != correction.ghost) continue;  // gone
    const Slot slot = ghost.slot;
    if (world().path(slot) == correction.path && world().spin(slot) == correction.spin) continue;
    corrected_.push_back({slot, correction.path, correction.spin});
  }
  engine_.put_on_paths(corrected_, begin_);
}

}  // namespace hardball
