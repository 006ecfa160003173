// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/domains/domain.hpp"

#include <algorithm>
#include <utility>

#include "hardball/standard/ranges.hpp"

namespace hardball {

double Domain::verify(std::span<const Outbox* const> inboxes, double until) {
  double bad = std::min(boundary_.far_since(), failed_at_);
  for (const Outbox* inbox : inboxes) {
    for (const NearPass& pass : inbox->near_passes) bad = std::min(bad, boundary_.time_within_guard(pass));
  }
  return std::min(bad, comparison_.compare(world(), ownership_, boundary_, ghost_records_, inboxes,
                                           begin_.high, until, outboxes_));
}

double Domain::in_conflict_since(std::span<const Outbox* const> inboxes) const {
  double bad = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < inboxes.size(); ++k) {
    bad = std::min(bad, time_of_conflict(world().box(), boundary_.halo(), outboxes_[k].conflicts,
                                         inboxes[k]->conflicts));
  }
  return bad;
}

void Domain::validate() const {
  for (Slot slot = 0; slot < world().size(); ++slot) {
    if (!ownership_.is_own(slot)) continue;
    const Time now = later(begin_, world().path(slot).time);
    const BoundaryWatch::Distances place = boundary_.distances(folded_state(slot, now).position);
    HARDBALL_CHECK(boundary_.fits(place, ownership_.holders(slot)));
  }
}

void Domain::undo() {
  engine_.rewind_to_begin();
  // What they were set for may not happen again, or something else sooner.
  for (const BoundaryWatch::Wakeup& wakeup : taken_) boundary_.set_wakeup({begin_.high, wakeup.slot, kNever});
  taken_.clear();
  touched_.clear();
}

void Domain::change_velocity(SphereId sphere, const Vec3& velocity, const Time& moment) {
  const std::optional<Slot> slot = world().find(sphere);
  if (!slot) return;
  const NewVelocity change{*slot, world().velocity(*slot, moment), velocity};
  engine_.change_velocities(moment, {&change, 1});
  begin_ = later(begin_, moment);
  if (ownership_.is_own(*slot)) set_wakeup(*slot);
}

void Domain::put(NewPlace place, const Time& moment) {
  const std::optional<Slot> slot = world().find(place.id);
  if (!slot) return;
  place.slot = *slot;
  engine_.put(moment, {&place, 1});
  begin_ = later(begin_, moment);
  if (ownership_.is_own(*slot)) set_wakeup(*slot);
}

void Domain::add(const SphereState& sphere, DomainNumber owner, const Time& moment) {
  const bool is_own = owner == number_;
  if (!is_own && boundary_.block().distance(sphere.path.position) > boundary_.halo().depth) return;
  begin_ = later(begin_, moment);
  engine_.upsert_spheres({&sphere, 1}, moment);
  if (is_own) {
    ownership_.add_own(boundary_.holders_at(sphere.path.position));
    set_wakeup(static_cast<Slot>(world().size() - 1));
  } else {
    ownership_.add_ghost(sphere.id, neighbor_number(owner));
  }
}

void Domain::watch(double horizon) {
  boundary_.restart(begin_.high, horizon);
  for (Slot slot = 0; slot < world().size(); ++slot) {
    if (!ownership_.is_own(slot)) continue;
    const Path& path = world().path(slot);
    const bool is_interior = ownership_.holders(slot) == 0 &&
                             boundary_.is_interior(path.position, 0, path.time.high,
                                                   largest_component(path.velocity), path.time.high);
    if (!is_interior) set_wakeup(slot);
  }
}

World Domain::spheres_of(const World& whole, std::span<const DomainNumber> owners, const Time& now) {
  std::vector<Slot> slots;
  for (Slot slot = 0; slot < whole.size(); ++slot) {
    const bool is_own = owners[slot] == number_;
    if (is_own || boundary_.block().distance(whole.position(slot, now)) <= boundary_.halo().depth)
      slots.push_back(slot);
  }
  World world = whole.without_spheres();
  world.insert_all(slots.size(), [&](std::size_t k) { return whole.state_of(slots[k]); });
  ownership_.reserve(slots.size());
  for (const Slot slot : slots) {
    if (owners[slot] == number_) {
      ownership_.add_own(boundary_.holders_at(whole.position(slot, now)));
    } else {
      ownership_.add_ghost(whole.id(slot), neighbor_number(owners[slot]));
    }
  }
  begin_ = now;
  return world;
}

void Domain::remove_at(Slot slot, const Time& moment) {
  begin_ = later(begin_, moment);
  engine_.remove_at(slot, moment);
  ownership_.erase(slot);
  // The sphere that is stored there from now on.
  if (slot < world().size() && ownership_.is_own(slot)) set_wakeup(slot);
}

std::uint32_t Domain::neighbor_number(DomainNumber domain) const {
  const auto found = ranges::lower_bound(neighbors(), domain);
  HARDBALL_CHECK(found != neighbors().end() && *found == domain);
  return static_cast<std::uint32_t>(found - neighbors().begin());
}

void Domain::begin_window() {
  begin_ = later(begin_, engine_.now());
  engine_.begin_journal(begin_);
  boundary_.begin(begin_.high);
  for (Outbox& outbox : outboxes_) outbox.clear();
  if (is_adding_) {
    sums_ = sums_before_;  // the last one was undone, or threw
  } else if (is_summed_) {
    sums_before_ = sums_;
  }
  is_adding_ = is_summed_;
  counted_ = {};
  failed_at_ = std::numeric_limits<double>::infinity();
  log_.clear();
  ghost_records_.clear();
}

HARDBALL_NEVER_INLINE void Domain::log(const Contact& contact, bool owns_first, bool owns_second) {
  LoggedContact logged{contact, owns_first};
  if (contact.is_collision() && owns_first != owns_second) {
    const Slot ghost = owns_first ? engine_.participants().second : engine_.participants().first;
    logged.other_owner = neighbors()[ownership_.ghost(ownership_.ghost_number(ghost)).owner];
  }
  log_.push_back(logged);
}

PathRecord Domain::record_of(Slot slot, SphereId id, const Contact& contact) const {
  const SphereId partner = id == contact.first ? contact.second : contact.first;
  return {world().path(slot), world().spin(slot), contact.time, id,
          contact.is_collision() ? partner : PathRecord::kWall};
}

HARDBALL_NEVER_INLINE void Domain::note_near_boundary(Slot slot, SphereId id, const Leg& leg,
                                                      const Vec3& after, const Contact& contact,
                                                      Slot partner) {
  const NeighborSet holders = ownership_.holders(slot);
  const BoundaryWatch::Distances place = boundary_.distances(leg.end_position);
  boundary_.record(leg, place, holders, outboxes_);
  boundary_.set_wakeup(
      {boundary_.time_of_change(place, holders, after, leg.end), slot, world().path(slot).time});
  if (holders == 0) return;
  PathRecord record = record_of(slot, id, contact);
  const bool turns = contact.outcome == ContactOutcome::bounce;
  const std::size_t owner = owner_of(partner);
  for (std::size_t neighbor = 0; neighbor < outboxes_.size(); ++neighbor) {
    if ((holders >> neighbor & 1) == 0) continue;
    record.is_partner_own = owner == neighbor;
    // Spheres that pass through each other concern their owners alone.
    if (turns || record.is_partner_own) append_ahead(outboxes_[neighbor].records, record);
  }
}

HARDBALL_NEVER_INLINE void Domain::note_ghost(Slot slot, SphereId id, const Contact& contact, Slot partner,
                                              const Vec3& spin_before) {
  const bool turns = contact.outcome == ContactOutcome::bounce;
  GhostRecord noted{record_of(slot, id, contact),
                    turns ? world().journal().path_before(slot) : world().path(slot), spin_before,
                    ownership_.ghost_number(slot)};
  noted.record.is_partner_own = partner != slot && ownership_.is_own(partner);
  append_ahead(ghost_records_, noted);
}

void Domain::keep_own_counts() {
  if (engine_.collapse_guard().is_empty()) return;
  PostContactState post_contact_state = engine_.post_contact_state();
  post_contact_state.collapse.keep_only([this](SphereId sphere) {
    return world().contains(sphere) && ownership_.is_own(world().slot_of(sphere));
  });
  engine_.take_over(post_contact_state);
}

State Domain::folded_state(Slot slot, const Time& moment) const {
  State state = world().motion().state_at(world().path(slot), moment);
  world().box().fold(state.position);
  return state;
}

BoundaryWatch::Wakeup Domain::wakeup_of(Slot slot, const State& state, const BoundaryWatch::Distances& place,
                                        const Time& moment) const {
  return {boundary_.time_of_change(place, ownership_.holders(slot), state.velocity, moment.high), slot,
          world().path(slot).time};
}

BoundaryWatch::Wakeup Domain::wakeup_since(Slot slot, const Time& moment) const {
  const Time now = later(moment, world().path(slot).time);
  const State state = folded_state(slot, now);
  return wakeup_of(slot, state, boundary_.distances(state.position), now);
}

void Domain::end_legs(double until) {
  take_wakeups(until, [&](const BoundaryWatch::Wakeup& wakeup) {
    const Slot slot = wakeup.slot;
    if (wakeup.path != world().path(slot).time) {
      const BoundaryWatch::Wakeup next = wakeup_since(slot, begin_);
      if (next.time > until) return boundary_.set_wakeup(next);
    }
    touched_.push_back(slot);
    const Time& since = world().path(slot).time;
    const State state = folded_state(slot, later(Time(until), since));
    boundary_.record({since.high, until, state.position, state.velocity}, boundary_.distances(state.position),
                     ownership_.holders(slot), outboxes_);
  });
}

// How a domain commits a window, and which domains own and hold its spheres from then on.

void Domain::commit(const Time& moment) {
  engine_.end_journal();
  begin_ = later(moment, engine_.now());
  is_adding_ = false;
  keep_own_counts();
  for (Outbox& outbox : outboxes_) outbox.clear();
  // Those of a contact that is executed alone were set after the others were taken.
  take_wakeups(moment.high, [&](const BoundaryWatch::Wakeup& wakeup) { touched_.push_back(wakeup.slot); });
  taken_.clear();
  ranges::sort(touched_);
  touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
  for (std::size_t k = 0; k < touched_.size(); ++k) {
    constexpr std::size_t kAhead = 8;
    if (k + kAhead < touched_.size()) prefetch(touched_[k + kAhead]);
    review(touched_[k]);
  }
  touched_.clear();
}

void Domain::receive(std::span<const Outbox* const> inboxes) {
  for (const Outbox* inbox : inboxes) {
    for (const SphereId sphere : inbox->departures) {
      const std::uint32_t ghost = ownership_.find_ghost(sphere);
      HARDBALL_CHECK(ghost != IdMap::kNone);
      remove_at(ownership_.ghost(ghost).slot, begin_);
    }
  }
  correct();
  arriving_.clear();
  for (const Outbox* inbox : inboxes) {
    for (const Arrival& arrival : inbox->arrivals) {
      HARDBALL_CHECK(ownership_.find_ghost(arrival.sphere.id) == IdMap::kNone);
      arriving_.push_back(arrival.sphere);
    }
  }
  engine_.upsert_spheres(arriving_, begin_);
  for (const Outbox* inbox : inboxes) {
    for (const Arrival& arrival : inbox->arrivals)
      ownership_.add_ghost(arrival.sphere.id, neighbor_number(arrival.owner));
  }
  for (const Outbox* inbox : inboxes) {
    for (const NewOwner& change : inbox->new_owners) {
      const std::uint32_t ghost = ownership_.find_ghost(change.sphere);
      HARDBALL_CHECK(ghost != IdMap::kNone);
      ownership_.set_owner(ghost, neighbor_number(change.owner));
    }
  }
  for (const Outbox* inbox : inboxes) {
    for (const Handover& handover : inbox->handovers) take_over(handover);
  }
  HARDBALL_CHECK(ownership_.size() == world().size());
}

void Domain::review(Slot slot) {
  if (!ownership_.is_own(slot)) return;
  const State state = folded_state(slot, begin_);
  const BoundaryWatch::Distances place = boundary_.distances(state.position);
  const SphereId id = world().id(slot);
  const NeighborSet before = ownership_.holders(slot);
  NeighborSet holders = boundary_.holders_at(place, before);
  const bool is_outside = place.own > 0;
  std::uint32_t owner = 0;
  if (is_outside) {
    owner = boundary_.nearest_neighbor(place);
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
    ownership_.set_holders(slot, holders);
    return boundary_.set_wakeup(wakeup_of(slot, state, place, begin_));
  }
  hand_over(slot, id, holders, owner);
}

void Domain::hand_over(Slot slot, SphereId id, NeighborSet holders, std::uint32_t owner) {
  Handover handover{world().state_of(slot), {number_}, engine_.collapse_guard().idle_contacts(id)};
  for (std::uint32_t neighbor = 0; neighbor < outboxes_.size(); ++neighbor) {
    if ((holders >> neighbor & 1) == 0 || neighbor == owner) continue;
    handover.holders.push_back(neighbors()[neighbor]);
    outboxes_[neighbor].new_owners.push_back({id, neighbors()[owner]});
  }
  outboxes_[owner].handovers.push_back(std::move(handover));
  ownership_.make_ghost(slot, id, owner);
}

void Domain::take_over(const Handover& handover) {
  const std::uint32_t ghost = ownership_.find_ghost(handover.sphere.id);
  HARDBALL_CHECK(ghost != IdMap::kNone);
  const Slot slot = ownership_.ghost(ghost).slot;
  HARDBALL_CHECK(world().id(slot) == handover.sphere.id && world().path(slot) == handover.sphere.path);
  SphereEdit(engine_.mutable_world(), begin_, slot).store(slot, handover.sphere);
  NeighborSet holders = 0;
  for (const DomainNumber holder : handover.holders) holders |= NeighborSet{1} << neighbor_number(holder);
  ownership_.make_own(slot, holders);
  if (handover.idle_contacts > 0) {
    PostContactState post_contact_state = engine_.post_contact_state();
    post_contact_state.collapse.set_idle_contacts(handover.sphere.id, handover.idle_contacts);
    engine_.take_over(post_contact_state);
  }
  ownership_.note_change(slot);
  set_wakeup(slot);
}

void Domain::correct() {
  corrected_.clear();
  for (const Correction& correction : comparison_.corrections()) {
    const OwnershipMap::Ghost& ghost = ownership_.ghost(correction.ghost);
    if (ownership_.find_ghost(ghost.sphere) != correction.ghost) continue;  // gone
    const Slot slot = ghost.slot;
    if (world().path(slot) == correction.path && world().spin(slot) == correction.spin) continue;
    corrected_.push_back({slot, correction.path, correction.spin});
  }
  engine_.replace_paths(corrected_, begin_);
}

}  // namespace hardball
