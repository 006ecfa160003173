// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "hardball/broadphase/broad_phase.hpp"
#include "hardball/broadphase/subdivision.hpp"
#include "hardball/engine/engine_base.hpp"
#include "hardball/engine/engine_journal.hpp"
#include "hardball/engine/run.hpp"
#include "hardball/engine/standstill_guard.hpp"
#include "hardball/execution/execute.hpp"
#include "hardball/execution/post_contact_state.hpp"
#include "hardball/world/new_velocity.hpp"

namespace hardball {

/// The algorithm of Kim, Guibas and Shin (1997), section 2, to the letter, to be read alongside the paper.
///
/// The non-empty subspaces are in a balanced tree, ordered by the key of equation 2. All candidate events are
/// in another, ordered by time, and at equal times by event type and sphere labels. Every sphere knows the
/// subspaces that intersect it and its own candidate events. Each event updates both trees; the least
/// candidate is always the next event. Not in the paper: mixed radii and masses, periodic and open axes, and
/// subspaces that admit a sphere slightly early and release it slightly late. Cost: O(log n) per event.
class PaperEngine final : public EngineBase {
 public:
  /// The length is the wanted edge of the subspaces. Error: it is less than least_edge. Precondition: the
  /// features of the world go with Feature::paper.
  PaperEngine(World world, const PhaseSettings& settings, const Time& now);
  std::unique_ptr<EngineBase> clone() const override { return std::make_unique<PaperEngine>(*this); }

  /// The largest diameter [L]: in smaller subspaces a sphere could intersect more than eight.
  static double least_edge(const World& world) { return 2 * world.largest_bounding_radius(); }

  const World& world() const override { return world_; }
  World& mutable_world() override { return world_; }
  PostContactState post_contact_state() const override { return post_contact_; }
  void take_over(const PostContactState& post_contact_state) override { post_contact_ = post_contact_state; }
  Time now() const override { return now_; }
  Counters counters() const override { return counters_; }
  PhaseLengths lengths() const override { return {.cell_edges = subdivision_.edges()}; }

  std::size_t memory_bytes() const override;
  RunStatus run(const RunLimits& limits, ContactSums& sums, const ContactObserver& observer) override;
  std::optional<Event> next_contact(const Time& until) override;
  void change_velocities(const Time& moment, std::span<const NewVelocity> changes) override;
  void put(const Time& moment, std::span<const NewPlace> places) override;
  SphereId add(const Sphere& sphere, const Time& moment) override;
  void remove(SphereId id, const Time& moment) override;
  bool needs_rebuild() const override { return needs_rebuild_; }

  void begin_journal(const Time& moment) override;
  void end_journal() override;
  void rewind(const Time& moment) override;
  void rewind_to_begin() override { undo(EngineJournal::kLongAgo, journal_.begin_time()); }

  void rebuild(const Time& now, const PhaseSettings& settings) override;

  // Checks that spheres are in the subspaces that intersect them and that no candidate is missing; throws
  // BrokenInvariant.
  void validate() const override;

 private:
  // What the paper keeps for every sphere.
  struct SphereRecord {
    CellRange subspaces;         // those intersecting it
    std::set<Event> candidates;  // its events in the event tree
  };
  // A sphere in a subspace. Its range may cross the edge of a periodic box: `boxes` is its displacement from
  // here in boxes.
  struct Member {
    Slot slot = 0;
    Image boxes;
    friend bool operator==(const Member&, const Member&) = default;
  };
  using Members = std::vector<Member>;

  // Keys stay below 2^60.
  static constexpr std::int32_t kMaxSubspacesPerAxis = 1 << 20;

  // Equation 2, u_x m^2 + u_y m + u_z, for the indices of a subspace folded into the box.
  std::uint64_t key(const CellIndex& folded) const;
  SphereRecord& record(SphereId id) { return records_[world_.slot_of(id)]; }
  const SphereRecord& record(SphereId id) const { return records_[world_.slot_of(id)]; }

  Event collision_of(Slot slot, Slot other, const Image& image) const;
  CellRange range_now(Slot slot) const;
  void add_to(const CellRange& subspaces, Slot slot);
  void remove_from(const CellRange& subspaces, Slot slot);

  // Calls visit(other, image) for all members of these subspaces other than the sphere itself.
  template <class Visit>
  void for_each_partner(Slot slot, const CellRange& subspaces, Visit&& visit) const;

  // Whether two spheres are passing through each other, or have just begun to.
  bool have_passed(Slot slot, Slot other, const Image& image) const;

  // Whether the next event of two spheres is known from their levels, not from subspaces.
  bool is_inside_step(Slot slot, Slot other) const;
  bool share_a_subspace(const Event& collision) const;

  // A pair sharing several subspaces has the same candidate in each; the tree holds it once.
  void add_candidate(const Event& event);
  void remove_candidate(const Event& event);

  template <class Condition>
  void remove_candidates_if(Slot slot, Condition&& condition);
  void remove_candidates(Slot slot);
  void predict_collisions(Slot slot, const CellRange& subspaces);

  // With the spheres that are inside of a step with it.
  void predict_pairs(Slot slot);

  // Recomputes the candidates for entering and leaving.
  void predict_crossings(Slot slot);
  void predict_all(Slot slot);

  // Whether a sphere intersects no more than eight subspaces.
  bool admits(Slot slot) const;

  // Puts a sphere into the subspaces that intersect it; its events remain to be predicted.
  void insert(Slot slot);
  void erase(Slot slot);

  // Removes a sphere from the world; the one in the last slot takes its place.
  void remove(Slot slot);

  // The spheres in the subspaces of one.
  std::vector<Slot> nearby(Slot slot) const;

  // As Engine does.
  bool coalesce();
  void undo(const Time& last_kept, const Time& moment);

  // The first of two spheres that have merged takes the place of both.
  void absorb(const Participants& participants);

  // A new path may have been folded back into a periodic box, and with it the subspace indices.
  void relocate(Slot slot);

  // The outermost subspaces of a range in the direction of a face.
  static CellRange row(CellRange range, Face face);
  void enter(const Event& event);
  void leave(const Event& event);
  bool handle_without_contact(const Event& event);
  const Contact& carry_out(const Event& event);

  World world_;
  Subdivision subdivision_;
  std::map<std::uint64_t, Members> subspace_tree_;
  std::set<Event> event_tree_;
  std::vector<SphereRecord> records_;  // per slot
  PostContactState post_contact_;
  bool needs_rebuild_ = false;
  Executed done_;  // the last contact
  StandstillGuard standstill_guard_;
  EngineJournal journal_;
  Time now_;
  Counters counters_;
};

}  // namespace hardball
