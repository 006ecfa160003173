// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "hardball/broadphase/broad_phase.hpp"
#include "hardball/domains/boundary_watch.hpp"
#include "hardball/domains/comparison.hpp"
#include "hardball/domains/messages.hpp"
#include "hardball/domains/ownership_map.hpp"
#include "hardball/engine/engine.hpp"
#include "hardball/engine/run.hpp"
#include "hardball/engine/upsert.hpp"
#include "hardball/execution/execute.hpp"
#include "hardball/execution/post_contact_state.hpp"
#include "hardball/interaction/contact.hpp"
#include "hardball/measure/contact_sums.hpp"
#include "hardball/world/new_velocity.hpp"
#include "hardball/world/sphere_edit.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// A contact of an own sphere.
struct LoggedContact {
  static constexpr std::uint32_t kNobody = std::numeric_limits<std::uint32_t>::max();

  Contact contact;
  bool counts = true;                  ///< Whether this domain counts the contact; if not, another one does.
  DomainNumber other_owner = kNobody;  ///< Owner of the other sphere, if a ghost; logs the contact, too.
};

/// The spheres in and around a block of the box, with an engine of their own, which runs ahead through a
/// window of time as if no sphere came from farther away.
///
/// All domains do the same at once, a step at a time: `run`, then `verify`, then `in_conflict_since`; if what
/// happened is right, `commit` and `receive`, otherwise `undo`. They exchange messages in outboxes.
class Domain {
 public:
  using Engine = hardball::Engine<CalendarQueue>;

  /// The domain of a world whose spheres have these owners at `now`, with a broad phase of these settings.
  /// Spheres are expected in the block and its halo.
  Domain(const World& whole, std::span<const DomainNumber> owners, const Time& now,
         const Partition& partition, DomainNumber number, const Halo& halo, const PhaseSettings& phase)
      : number_(number),
        boundary_(partition, number, halo, whole.motion()),
        phase_(phase.within(boundary_.block().surroundings(halo.outer()))),
        outboxes_(boundary_.neighbors().size()),
        engine_(spheres_of(whole, owners, now), phase_, now) {}

  DomainNumber number() const { return number_; }
  /// The begin of the window, or of the next.
  const Time& begin() const { return begin_; }
  const std::vector<DomainNumber>& neighbors() const { return boundary_.neighbors(); }
  const Engine& engine() const { return engine_; }
  Engine& engine() { return engine_; }
  const World& world() const { return engine_.world(); }
  const OwnershipMap& ownership() const { return ownership_; }
  bool owns(SphereId sphere) const {
    const std::optional<Slot> slot = world().find(sphere);
    return slot && ownership_.is_own(*slot);
  }
  const BoundaryWatch& boundary() const { return boundary_; }
  /// Continues for other engines.
  void take_over(const PostContactState& post_contact_state) {
    engine_.take_over(post_contact_state);
    keep_own_counts();
  }
  std::size_t memory_bytes() const {
    return engine_.memory_bytes() + ownership_.memory_bytes() + boundary_.memory_bytes() +
           log_.capacity() * sizeof(LoggedContact) + ghost_records_.capacity() * sizeof(GhostRecord);
  }
  /// The messages for a neighbor, by the number of the domain.
  const Outbox& outbox_to(DomainNumber neighbor) const { return outboxes_[neighbor_number(neighbor)]; }

  /// Sums over this domain's own contacts in all windows committed since clear_sums(), if they are added up.
  const ContactSums& sums() const { return is_adding_ ? sums_before_ : sums_; }
  /// Begins to add up with empty sums.
  void clear_sums(const ContactSums& empty) {
    sums_ = empty;
    is_adding_ = false;
  }
  /// The contacts of own spheres in this window, if they are kept.
  std::span<const LoggedContact> log() const { return log_; }
  /// What becomes of the contacts of the next windows: whether they are kept in a log, and added up.
  void keep_log(bool is_kept, bool is_summed) {
    is_log_kept_ = is_kept;
    is_summed_ = is_summed;
  }
  /// Calls visit(slot) for every own sphere whose state has changed since the last call, perhaps for others,
  /// in the order of slots.
  template <class Visit>
  void take_changed(Visit&& visit) {
    ownership_.take_changes(visit);
  }
  /// Calls visit(slot) for every own sphere.
  template <class Visit>
  void for_each_own(Visit&& visit) const {
    for (Slot slot = 0; slot < world().size(); ++slot) {
      if (ownership_.is_own(slot)) visit(slot);
    }
  }
  /// How many contacts count in this window: collisions, and contacts with walls.
  const Counters& counted() const { return counted_; }

  /// Runs through a window, from where it is to all events whose time rounds to `until` or earlier. With more
  /// than `most` contacts, those of ghosts included, the window is too long, and not right to its end.
  void run(double until, std::uint64_t most) {
    begin_window();
    // Wrong ghosts may be the only reason for either error: a single step will show.
    try {
      const RunStatus status = engine_.run({.until = Time(until), .contacts = most}, Notes{*this});
      if (status == RunStatus::time_reached) return end_legs(until);
    } catch (const RunFailure&) {
    } catch (const Error&) {
    }
    failed_at_ = engine_.now().high;
  }

  /// The next contact up to `until`, without executing it; at a window's start.
  Event peek(double until) {
    begin_window();
    return engine_.next_contact(Time(until)).value_or(Event());
  }
  /// Executes the contact that `peek` has returned, if it is this one.
  void execute_if_next(const Event& peeked, const Event& next) {
    if (peeked == next) engine_.run({.until = next.time, .contacts = 1}, Notes{*this});
  }
  /// Watches spheres on up to `until`, in a window without contacts.
  void end_peek(double until) { end_legs(until); }
  /// Goes back to `moment`, after which nothing but crossings has been handled.
  void end_step(const Time& moment) { engine_.rewind(moment); }

  /// Compares the window with the neighbors', and returns a time before which it is right; see Comparison.
  double verify(std::span<const Outbox* const> inboxes, double until);
  /// A time before which the window is right with respect to spheres that may be wrong both here and in a
  /// neighbor. Precondition: all have verified.
  double in_conflict_since(std::span<const Outbox* const> inboxes) const;

  /// Checks the owner and the holders of each own sphere; throws BrokenInvariant. Precondition: no window is
  /// under way. Cost: O(n).
  void validate() const;

  /// Goes back to the start of the window.
  void undo();

  /// Commits the window up to `moment`. Decides which domains own and hold its spheres from then on, and
  /// sends that to the neighbors.
  void commit(const Time& moment);

  /// Makes the ghosts what their owners say, and lets spheres come and go. Precondition: all have committed.
  void receive(std::span<const Outbox* const> inboxes);

  /// Rebuilds the engine where spheres do not fit it. Precondition: no window is under way.
  void make_ready() {
    if (engine_.needs_rebuild()) engine_.rebuild_in_place(begin_, phase_);
  }

  /// Changes the velocities of spheres that it holds, at `moment`. Precondition: no window is under way; all
  /// events before it have been handled, and none after it.
  void change_velocity(SphereId sphere, const Vec3& velocity, const Time& moment);
  /// Gives a sphere a new path, if it holds it, see EngineBase::put; the slot of the place is that elsewhere.
  /// Precondition: as for change_velocity.
  void put(NewPlace place, const Time& moment);
  /// Removes a sphere if it holds it. Precondition: as for change_velocity.
  void remove(SphereId sphere, const Time& moment) {
    if (const std::optional<Slot> slot = world().find(sphere)) remove_at(*slot, moment);
  }
  /// Holds a sphere that is new to the whole world, if it is near enough. Precondition: as for
  /// change_velocity.
  void add(const SphereState& sphere, DomainNumber owner, const Time& moment);
  /// The last passage of all domains; see World::last_passage.
  void set_last_passage(const Event& passage) {
    if (world().last_passage() < passage) engine_.mutable_world().note_passage(passage);
  }

  /// Watches the boundary anew, up to a time. Cost: O(n).
  void watch(double horizon);

 private:
  // Records contacts as they happen.
  struct Notes {
    Domain& domain;
    void operator()(const Contact& contact) const { domain.record(contact); }
    void prefetch(Slot slot) const {
      if (!domain.ownership_.is_shared(slot)) return;
      domain.ownership_.prefetch(slot);
      domain.boundary_.prefetch_wakeup(slot);
    }
  };

  World spheres_of(const World& whole, std::span<const DomainNumber> owners, const Time& now);

  void remove_at(Slot slot, const Time& moment);

  std::uint32_t neighbor_number(DomainNumber domain) const;

  void begin_window();

  HARDBALL_ALWAYS_INLINE void record(const Contact& contact) {
    const Participants& participants = engine_.participants();
    const bool is_collision = contact.is_collision();
    const bool owns_first = ownership_.is_own(participants.first);
    const bool owns_second = is_collision && ownership_.is_own(participants.second);
    if (owns_first) {
      if (is_summed_) sums_.record(contact);
      ++(is_collision ? counted_.collision : counted_.wall);
    }
    if (is_log_kept_ && (owns_first || owns_second)) log(contact, owns_first, owns_second);
    const bool turns = contact.outcome == ContactOutcome::bounce;
    if (owns_first) {
      note_own(participants.first, contact.first, contact.position, contact.before.first, contact.after.first,
               contact.first_since, contact, is_collision ? participants.second : participants.first);
    } else if (turns || owns_second) {
      note_ghost(participants.first, contact.first, contact,
                 is_collision ? participants.second : participants.first, contact.spins_before.first);
    }
    if (!is_collision) return;
    if (owns_second) {
      note_own(participants.second, contact.second, contact.second_position, contact.before.second,
               contact.after.second, contact.second_since, contact, participants.first);
    } else if (turns || owns_first) {
      note_ghost(participants.second, contact.second, contact, participants.first,
                 contact.spins_before.second);
    }
  }

  HARDBALL_NEVER_INLINE void log(const Contact& contact, bool owns_first, bool owns_second);

  // What a contact did to one of its spheres.
  PathRecord record_of(Slot slot, SphereId id, const Contact& contact) const;

  // An own sphere has had a contact; `partner` is where the other one is stored, itself at a wall.
  HARDBALL_ALWAYS_INLINE void note_own(Slot slot, SphereId id, const Vec3& position, const Vec3& before,
                                       const Vec3& after, const Time& since, const Contact& contact,
                                       Slot partner) {
    ownership_.note_change(slot);
    const NeighborSet holders = ownership_.holders(slot);
    const double now = contact.time.high;
    if (holders == 0 && boundary_.is_interior(position, largest_component(before), since.high,
                                              largest_component(after), now)) [[likely]]
      return;
    note_near_boundary(slot, id, {since.high, now, position, before}, after, contact, partner);
  }

  HARDBALL_NEVER_INLINE void note_near_boundary(Slot slot, SphereId id, const Leg& leg, const Vec3& after,
                                                const Contact& contact, Slot partner);

  // The number of the neighbor that owns a ghost.
  std::size_t owner_of(Slot slot) const {
    return ownership_.is_own(slot) ? outboxes_.size() : ownership_.ghost(ownership_.ghost_number(slot)).owner;
  }

  // `partner` is where the other sphere is stored, itself at a wall.
  HARDBALL_NEVER_INLINE void note_ghost(Slot slot, SphereId id, const Contact& contact, Slot partner,
                                        const Vec3& spin_before);

  void keep_own_counts();

  // Where a sphere is at a moment, inside the box.
  State folded_state(Slot slot, const Time& moment) const;

  // The wakeup that an own sphere needs from a moment on.
  BoundaryWatch::Wakeup wakeup_of(Slot slot, const State& state, const BoundaryWatch::Distances& place,
                                  const Time& moment) const;
  BoundaryWatch::Wakeup wakeup_since(Slot slot, const Time& moment) const;
  void set_wakeup(Slot slot) { boundary_.set_wakeup(wakeup_since(slot, later(begin_, engine_.now()))); }

  // The last legs of spheres whose owner or holders may change in the window. Others whose wakeup is due are
  // on another path than that for which it was set, and get another.
  void end_legs(double until);

  // Calls visit(wakeup) for those up to a time, where own spheres are stored.
  template <class Visit>
  void take_wakeups(double until, Visit&& visit) {
    constexpr std::size_t kAhead = 8;
    const std::size_t first = taken_.size();
    boundary_.take_wakeups(until, taken_);
    for (std::size_t k = first; k < std::min(first + kAhead, taken_.size()); ++k) prefetch(taken_[k].slot);
    for (std::size_t k = first; k < taken_.size(); ++k) {
      if (k + kAhead < taken_.size()) prefetch(taken_[k + kAhead].slot);
      const BoundaryWatch::Wakeup& wakeup = taken_[k];
      if (wakeup.slot < world().size() && ownership_.is_own(wakeup.slot)) visit(wakeup);
    }
  }

  // The slot need not be in use.
  void prefetch(Slot slot) const {
    world().prefetch(slot);
    ownership_.prefetch(slot);
  }

  // Decides which domains own and hold an own sphere.
  void review(Slot slot);
  void hand_over(Slot slot, SphereId id, NeighborSet holders, std::uint32_t owner);
  void take_over(const Handover& handover);
  // Puts ghosts that are not what their owners say on the right paths.
  void correct();

  DomainNumber number_;
  BoundaryWatch boundary_;
  PhaseSettings phase_;
  OwnershipMap ownership_;
  std::vector<Outbox> outboxes_;  // by neighbor
  Time begin_;                    // of the window
  Engine engine_;
  Comparison comparison_;
  ContactSums sums_;
  // While a window adds to them, what they were before: a copy takes less than to add up each window apart.
  ContactSums sums_before_;
  bool is_adding_ = false;
  // Of the window:
  Counters counted_;
  double failed_at_ = std::numeric_limits<double>::infinity();  // where the run ended too early [T]
  bool is_log_kept_ = false;
  bool is_summed_ = true;
  std::vector<LoggedContact> log_;
  std::vector<GhostRecord> ghost_records_;
  std::vector<BoundaryWatch::Wakeup> taken_;  // wakeups
  std::vector<Slot> touched_;                 // own spheres whose owner or holders may change
  std::vector<NewPath> corrected_;
  std::vector<SphereState> arriving_;
};

}  // namespace hardball
