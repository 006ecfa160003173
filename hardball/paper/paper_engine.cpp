// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/paper/paper_engine.hpp"

#include <utility>

#include "hardball/engine/rewind.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/world/audit.hpp"
#include "hardball/world/pair_event.hpp"
#include "hardball/world/step_levels.hpp"
#include "hardball/world/walls.hpp"

namespace hardball {

PaperEngine::PaperEngine(World world, const PhaseSettings& settings, const Time& now)
    : world_(std::move(world)) {
  rebuild(now, settings);
}

std::size_t PaperEngine::memory_bytes() const {
  constexpr std::size_t kTreeLinks = 4 * sizeof(void*);
  std::size_t bytes = world_.memory_bytes() + post_contact_.collapse.memory_bytes();
  bytes += records_.capacity() * sizeof(SphereRecord);
  bytes += event_tree_.size() * (sizeof(Event) + kTreeLinks);
  for (const SphereRecord& record : records_)
    bytes += record.candidates.size() * (sizeof(Event) + kTreeLinks);
  for (const auto& [key, members] : subspace_tree_) {
    bytes += sizeof(key) + sizeof(members) + kTreeLinks + members.capacity() * sizeof(Member);
  }
  return bytes;
}

RunStatus PaperEngine::run(const RunLimits& limits, ContactSums& sums, const ContactObserver& observer) {
  const auto observe = [&](const Contact& contact) {
    sums.record(contact);
    return !observer || observer.on_contact(contact);
  };
  std::uint64_t contacts = 0;
  if (limits.contacts == 0) return RunStatus::contacts_reached;
  const Time until = within_range(limits.until);
  for (std::uint64_t step = 0;; ++step) {
    if (needs_rebuild_) return RunStatus::outdated;
    if (!post_contact_.merged.empty()) {
      if (step == limits.steps) return RunStatus::steps_reached;
      if (coalesce()) {
        const bool continues = observe(done_.contact);
        if (++contacts == limits.contacts) return RunStatus::contacts_reached;
        if (!continues) return RunStatus::observer_stopped;
        continue;
      }
    }
    if (event_tree_.empty() || event_tree_.begin()->time.high > until.high) return RunStatus::time_reached;
    if (step == limits.steps) return RunStatus::steps_reached;
    const Event event = *event_tree_.begin();
    if (handle_without_contact(event)) continue;
    const bool continues = observe(carry_out(event));
    if (++contacts == limits.contacts) return RunStatus::contacts_reached;
    if (!continues) return RunStatus::observer_stopped;
  }
}

std::optional<Event> PaperEngine::next_contact(const Time& until) {
  const double end = within_range(until).high;
  while (!event_tree_.empty() && event_tree_.begin()->time.high <= end) {
    const Event event = *event_tree_.begin();
    if (!handle_without_contact(event)) return event;
  }
  return std::nullopt;
}

void PaperEngine::change_velocities(const Time& moment, std::span<const NewVelocity> changes) {
  for (const NewVelocity& change : changes) {
    world_.change_velocity(change.slot, moment, change.after);
    if (needs_rebuild_) continue;
    HARDBALL_CHECK(moment >= now_);
    now_ = moment;
    remove_candidates(change.slot);
    relocate(change.slot);
    predict_all(change.slot);
  }
}

void PaperEngine::put(const Time& moment, std::span<const NewPlace> places) {
  for (const NewPlace& place : places) {
    world_.put(place.slot, moment, place.position, place.after);
    if (needs_rebuild_) continue;
    HARDBALL_CHECK(moment >= now_);
    now_ = moment;
    remove_candidates(place.slot);
    relocate(place.slot);
    predict_all(place.slot);
  }
}

SphereId PaperEngine::add(const Sphere& sphere, const Time& moment) {
  const SphereId id = world_.add(sphere, moment);
  const auto slot = static_cast<Slot>(world_.size() - 1);
  const bool is_admitted = !needs_rebuild_ && admits(slot);
  if (is_admitted) {
    HARDBALL_CHECK(moment >= now_);
    now_ = moment;
    insert(slot);
  }
  try {
    const std::vector<Slot> others = is_admitted ? nearby(slot) : all_slots(world_);
    require_room(world_, slot, others, moment);
    assign_levels(world_, slot, others, moment);
  } catch (const Error&) {
    if (is_admitted) erase(slot);
    world_.undo_add();
    throw;
  }
  needs_rebuild_ = !is_admitted;
  if (is_admitted) predict_all(slot);
  return id;
}

void PaperEngine::remove(SphereId id, const Time& moment) {
  const Slot slot = world_.slot_of(id);
  journal_.note_merged(moment, post_contact_.merged);
  post_contact_.merged.forget(id);
  if (needs_rebuild_) return world_.remove(id, moment);
  HARDBALL_CHECK(moment >= now_);
  now_ = moment;
  remove(slot);
}

void PaperEngine::begin_journal(const Time& moment) {
  HARDBALL_CHECK(moment >= now_);
  now_ = moment;
  journal_.begin(moment);
  world_.begin_journal();
  post_contact_.collapse.begin_journal();
}

void PaperEngine::end_journal() {
  journal_.end();
  world_.end_journal();
  post_contact_.collapse.end_journal();
}

void PaperEngine::rewind(const Time& moment) {
  if (now_ > moment) undo(moment, moment);
}

void PaperEngine::rebuild(const Time& now, const PhaseSettings& settings) {
  const double edge = settings.length;
  if (edge < least_edge(world_)) {
    throw Error("the cell edge " + to_text(edge) + " is less than the largest diameter", "cell edge",
                "the paper's engine needs at least " + to_text(least_edge(world_)));
  }
  now_ = now;
  needs_rebuild_ = false;
  subdivision_ = Subdivision(world_.box(), edge, kMaxSubspacesPerAxis);
  subspace_tree_.clear();
  event_tree_.clear();
  records_.assign(world_.size(), SphereRecord{});
  for (Slot slot = 0; slot < world_.size(); ++slot) insert(slot);
  for (Slot slot = 0; slot < world_.size(); ++slot) predict_all(slot);
}

void PaperEngine::validate() const {
  if (needs_rebuild_) return;
  for (Slot slot = 0; slot < world_.size(); ++slot) {
    const CellRange& range = records_[slot].subspaces;
    for_each_partner(slot, range, [&](Slot other, const Image& image) {
      const Event contact = collision_of(slot, other, image);
      HARDBALL_CHECK(!contact.happens() || event_tree_.contains(contact));
    });
    for (const Event& event : records_[slot].candidates) {
      HARDBALL_CHECK(event.time >= now_ && event_tree_.contains(event));
    }
  }
}

std::uint64_t PaperEngine::key(const CellIndex& folded) const {
  std::uint64_t key = 0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const std::int32_t first = subdivision_.period(axis) > 0 ? 0 : subdivision_.first(axis);
    key = key * kMaxSubspacesPerAxis + static_cast<std::uint64_t>(folded[axis] - first);
  }
  return key;
}

Event PaperEngine::collision_of(Slot slot, Slot other, const Image& image) const {
  return make_collision(contact_time(world_, slot, other, image), world_.id(slot), world_.id(other), image);
}

CellRange PaperEngine::range_now(Slot slot) const {
  return subdivision_.range_at(world_.unfolded_position(slot, now_), world_.bounding_radius(slot));
}

void PaperEngine::add_to(const CellRange& subspaces, Slot slot) {
  subspaces.for_each([&](CellIndex subspace) {
    const Image boxes = subdivision_.fold(subspace);
    subspace_tree_[key(subspace)].push_back({slot, boxes});
  });
}

void PaperEngine::remove_from(const CellRange& subspaces, Slot slot) {
  subspaces.for_each([&](CellIndex subspace) {
    const Image boxes = subdivision_.fold(subspace);
    const auto found = subspace_tree_.find(key(subspace));
    HARDBALL_CHECK(found != subspace_tree_.end());
    std::erase(found->second, Member{slot, boxes});
    if (found->second.empty()) subspace_tree_.erase(found);
  });
}

template <class Visit>
void PaperEngine::for_each_partner(Slot slot, const CellRange& subspaces, Visit&& visit) const {
  subspaces.for_each([&](CellIndex subspace) {
    const Image boxes = subdivision_.fold(subspace);
    const auto found = subspace_tree_.find(key(subspace));
    if (found == subspace_tree_.end()) return;
    for (const Member& member : found->second) {
      const Image image = boxes - member.boxes;
      if (member.slot == slot || is_inside_step(slot, member.slot) || have_passed(slot, member.slot, image))
        continue;
      visit(member.slot, image);
    }
  });
}

bool PaperEngine::have_passed(Slot slot, Slot other, const Image& image) const {
  return has_passing_pairs(world_) && pass(world_, slot, other) && are_passing(world_, slot, other, image);
}

bool PaperEngine::is_inside_step(Slot slot, Slot other) const {
  return world_.pair_levels().find(slot, other) != nullptr;
}

bool PaperEngine::share_a_subspace(const Event& collision) const {
  const CellRange& first = record(collision.first).subspaces;
  const CellRange& second = record(collision.second).subspaces;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const std::int32_t beyond = subdivision_.cells_beyond(axis, collision.image);
    if (second.low[axis] + beyond > first.high[axis] || second.high[axis] + beyond < first.low[axis])
      return false;
  }
  return true;
}

void PaperEngine::add_candidate(const Event& event) {
  if (!event.happens() || !event_tree_.insert(event).second) return;
  ++counters_.queue_operations;
  record(event.first).candidates.insert(event);
  if (event.kind == EventKind::collision) record(event.second).candidates.insert(event);
}

void PaperEngine::remove_candidate(const Event& event) {
  event_tree_.erase(event);
  ++counters_.queue_operations;
  record(event.first).candidates.erase(event);
  if (event.kind == EventKind::collision) record(event.second).candidates.erase(event);
}

template <class Condition>
void PaperEngine::remove_candidates_if(Slot slot, Condition&& condition) {
  const std::set<Event> candidates = records_[slot].candidates;
  for (const Event& event : candidates) {
    if (condition(event)) remove_candidate(event);
  }
}

void PaperEngine::remove_candidates(Slot slot) {
  remove_candidates_if(slot, [](const Event&) { return true; });
}

void PaperEngine::predict_collisions(Slot slot, const CellRange& subspaces) {
  for_each_partner(slot, subspaces, [&](Slot other, const Image& image) {
    ++counters_.predictions;
    add_candidate(collision_of(slot, other, image));
  });
}

void PaperEngine::predict_pairs(Slot slot) {
  for (const PairLevel& pair : world_.pair_levels().of(slot)) {
    ++counters_.predictions;
    add_candidate(collision_of(slot, pair.partner, nearest_image(world_, slot, pair.partner, now_)));
  }
}

void PaperEngine::predict_crossings(Slot slot) {
  remove_candidates_if(slot, [](const Event& event) {
    return event.kind == EventKind::enter || event.kind == EventKind::leave;
  });
  const Path& path = world_.path(slot);
  const double radius = world_.bounding_radius(slot);
  const CellRange& subspaces = records_[slot].subspaces;
  const CellCrossing enter = subdivision_.next_enter(path.position, path.velocity, {}, radius, subspaces);
  const CellCrossing leave = subdivision_.next_leave(path, radius, subspaces);
  const auto moment = [&](const CellCrossing& crossing) {
    return later(now_, after(path.time, crossing.wait));
  };
  add_candidate({moment(enter), EventKind::enter, world_.id(slot), face_of(enter.axis, enter.up), {}});
  add_candidate({moment(leave), EventKind::leave, world_.id(slot), face_of(leave.axis, leave.up), {}});
}

void PaperEngine::predict_all(Slot slot) {
  predict_collisions(slot, records_[slot].subspaces);
  predict_pairs(slot);
  const Event wall = next_wall_event(world_, slot, now_);
  add_candidate(std::min(wall, next_solid_event(world_, slot, now_, wall.time.high)));
  predict_crossings(slot);
}

bool PaperEngine::admits(Slot slot) const {
  const double diameter = 2 * world_.bounding_radius(slot);
  const Vec3 edges = subdivision_.edges();
  return diameter <= edges.x && diameter <= edges.y && diameter <= edges.z;
}

void PaperEngine::insert(Slot slot) {
  if (slot == records_.size()) records_.emplace_back();
  records_[slot].subspaces = range_now(slot);
  add_to(records_[slot].subspaces, slot);
}

void PaperEngine::erase(Slot slot) {
  remove_candidates(slot);
  remove_from(records_[slot].subspaces, slot);
}

void PaperEngine::remove(Slot slot) {
  const auto last = static_cast<Slot>(world_.size() - 1);
  erase(slot);
  if (slot != last) {
    remove_from(records_[last].subspaces, last);
    add_to(records_[last].subspaces, slot);
    records_[slot] = std::move(records_[last]);
  }
  records_.pop_back();
  world_.remove(world_.id(slot), now_);
}

std::vector<Slot> PaperEngine::nearby(Slot slot) const {
  std::vector<Slot> others;
  for_each_partner(slot, records_[slot].subspaces,
                   [&](Slot other, const Image&) { others.push_back(other); });
  return others;
}

bool PaperEngine::coalesce() {
  journal_.note_merged(now_, post_contact_.merged);
  const auto overlaps = [this](Slot slot) { return overlaps_of(world_, slot, nearby(slot), now_); };
  return post_contact_.merged.coalesce(world_, overlaps, [this](const Event& overlap) {
    const Participants participants = participants_of(world_, overlap);
    if (!merge_if_decided(world_, overlap, participants, done_)) return false;
    ++counters_.collision;
    journal_.note_event(EngineJournal::Kind::collision, now_, {overlap.first, participants.first},
                        {overlap.second, participants.second});
    absorb(participants);
    return true;
  });
}

void PaperEngine::undo(const Time& last_kept, const Time& moment) {
  standstill_guard_ = {};
  journal_.undo_events(last_kept, counters_, post_contact_.merged);
  post_contact_.collapse.rewind(last_kept);
  undo_changes(world_, last_kept);
  now_ = moment;
  needs_rebuild_ = true;
}

void PaperEngine::absorb(const Participants& participants) {
  journal_.note_merged(now_, post_contact_.merged);
  post_contact_.merged.record(done_.contact.first);
  post_contact_.merged.forget(done_.contact.second);
  needs_rebuild_ = !admits(participants.first);
  if (needs_rebuild_) return world_.remove(done_.contact.second, now_);
  erase(participants.first);
  insert(participants.first);
  remove(participants.second);
  predict_all(world_.slot_of(done_.contact.first));
}

void PaperEngine::relocate(Slot slot) {
  remove_from(records_[slot].subspaces, slot);
  records_[slot].subspaces = range_now(slot);
  add_to(records_[slot].subspaces, slot);
}

CellRange PaperEngine::row(CellRange range, Face face) {
  const std::size_t axis = axis_of(face);
  (is_upper(face) ? range.low : range.high)[axis] = (is_upper(face) ? range.high : range.low)[axis];
  return range;
}

void PaperEngine::enter(const Event& event) {
  ++counters_.enter;
  const Slot slot = world_.slot_of(event.first);
  const std::size_t axis = axis_of(event.second);
  CellRange& subspaces = records_[slot].subspaces;
  if (is_upper(event.second)) {
    ++subspaces.high[axis];
  } else {
    --subspaces.low[axis];
  }
  const CellRange entered = row(subspaces, event.second);
  const std::uint64_t predictions_before = counters_.predictions;
  predict_collisions(slot, entered);
  counters_.enter_predictions += counters_.predictions - predictions_before;
  add_to(entered, slot);
  predict_crossings(slot);
}

void PaperEngine::leave(const Event& event) {
  ++counters_.leave;
  const Slot slot = world_.slot_of(event.first);
  const std::size_t axis = axis_of(event.second);
  CellRange& subspaces = records_[slot].subspaces;
  const Face behind = face_of(axis, !is_upper(event.second));
  remove_from(row(subspaces, behind), slot);
  if (is_upper(event.second)) {
    ++subspaces.low[axis];
  } else {
    --subspaces.high[axis];
  }
  remove_candidates_if(slot, [this](const Event& candidate) {
    return candidate.kind == EventKind::collision && !share_a_subspace(candidate) &&
           !is_inside_step(world_.slot_of(candidate.first), world_.slot_of(candidate.second));
  });
  predict_crossings(slot);
}

bool PaperEngine::handle_without_contact(const Event& event) {
  HARDBALL_CHECK(event.time >= now_);
  if (event.kind != EventKind::enter && event.kind != EventKind::leave) return false;
  standstill_guard_.note_event(now_, event.time, world_.size());
  now_ = event.time;
  if (event.kind == EventKind::enter) {
    enter(event);
  } else {
    leave(event);
  }
  return true;
}

const Contact& PaperEngine::carry_out(const Event& event) {
  const bool is_collision = event.kind == EventKind::collision;
  standstill_guard_.note_event(now_, event.time, world_.size());
  const Participants participants = participants_of(world_, event);
  execute(world_, post_contact_.collapse, event, participants, done_);
  now_ = event.time;
  ++(is_collision ? counters_.collision : counters_.wall);
  journal_.note_event(is_collision ? EngineJournal::Kind::collision : EngineJournal::Kind::wall, now_,
                      {event.first, participants.first}, {event.first, participants.first});
  if (done_.contact.outcome == ContactOutcome::merge) {
    absorb(participants);
    return done_.contact;
  }
  const std::uint64_t predictions_before = counters_.predictions;
  remove_candidates(participants.first);
  relocate(participants.first);
  if (is_collision) {
    remove_candidates(participants.second);
    relocate(participants.second);
    predict_all(participants.second);
  }
  predict_all(participants.first);
  counters_.contact_predictions += counters_.predictions - predictions_before;
  return done_.contact;
}

}  // namespace hardball
