// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "hardball/broadphase/broad_phase.hpp"
#include "hardball/engine/run.hpp"
#include "hardball/engine/window_counters.hpp"
#include "hardball/execution/post_contact_state.hpp"
#include "hardball/measure/contact_sums.hpp"
#include "hardball/memory/for_each.hpp"
#include "hardball/memory/function.hpp"
#include "hardball/queries/sphere_search.hpp"
#include "hardball/theory/gas_statistics.hpp"
#include "hardball/world/audit.hpp"
#include "hardball/world/block.hpp"
#include "hardball/world/new_place.hpp"
#include "hardball/world/new_velocity.hpp"
#include "hardball/world/totals.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// What every engine does: it owns a world, and lets contacts happen to it, exactly and in order. All engines
/// let the same contacts happen.
///
/// Its members are called once for each stretch of a run, and not for each event. An engine that spans
/// several processes has a part in each; all its members are called in all of them at once, with the same
/// arguments, and return the same in each, unless they say otherwise.
class EngineBase {
 public:
  virtual ~EngineBase() = default;
  /// An independent copy.
  virtual std::unique_ptr<EngineBase> clone() const = 0;

  /// The world with all its spheres. In several domains they are gathered when this is called. Cost, then:
  /// O(contacts since the last call), at first O(n); memory for all spheres.
  virtual const World& world() const = 0;
  /// The world for editing between runs; unless only the responses change, `rebuild` must follow.
  virtual World& mutable_world() = 0;
  /// The world with its box, walls, interactions and motion; its spheres may be missing or out of date.
  virtual const World& setting() const { return world(); }
  virtual std::size_t size() const { return world().size(); }
  /// The time up to which events have been handled.
  virtual Time now() const = 0;
  virtual Counters counters() const = 0;
  virtual WindowCounters windows() const { return {}; }
  /// The memory of all processes [bytes].
  virtual std::size_t memory_bytes() const = 0;
  virtual PhaseLengths lengths() const = 0;
  /// The parts of the box in which domains are; one, all of the box, without domains.
  virtual std::vector<Block> blocks() const { return {Block(setting().box())}; }
  /// Whether its threads have lately waited for one that other programs kept from running.
  virtual bool are_threads_hindered() const { return false; }
  /// The statistics of the spheres as they are at `moment`. Cost: O(n).
  virtual GasStatistics statistics(const Time& moment) const { return gas_statistics(world(), moment); }
  /// Sums over the spheres as they are at `moment`. Cost: O(n).
  virtual Totals totals(const Time& moment) const { return totals_of(world(), moment); }
  /// A check of all spheres at `moment`; see audit. Cost: O(n).
  virtual Audit audit(const Time& moment) const { return hardball::audit(world(), moment); }
  /// The last contact of spheres that passed through each other; see World.
  virtual const Event& last_passage() const { return world().last_passage(); }
  /// Whether spheres have spun, as far as this process knows; see World::has_spins.
  virtual bool has_spins() const { return world().has_spins(); }
  /// Calls visit(world, slot) for each sphere of this process, in the world of its domain.
  virtual void for_each_sphere(const Function<void(const World&, Slot)>& visit) const {
    for (Slot slot = 0; slot < world().size(); ++slot) visit(world(), slot);
  }
  /// Where queries find the spheres of all processes as they are at `moment`, in cells; empty if the engine
  /// does not know them, or has looked ahead. Precondition: events up to `moment` have been handled.
  virtual std::vector<SphereSearch::Part> search_parts(const Time& /*moment*/) const { return {}; }
  /// A world with all spheres, or with some that have the whole range of radii and are spread as all are: of
  /// which the choice of engine and lengths depends.
  virtual const World& sample() const { return world(); }
  /// Calls work(k) for each k below `count`, in the threads of the engine, and returns when all have
  /// returned. Precondition: `work` does not throw.
  virtual void for_each(std::size_t count, const Function<void(std::size_t)>& work) {
    one_by_one(count, work);
  }

  /// Handles events in order up to the first of the limits, adds all contacts to `sums`, and calls the
  /// observer, if there is one. Spheres that have merged merge at once with those that they overlap, if the
  /// response does so. The observer may call change_velocities, `add` and `remove`, and stops the run by
  /// returning false. Error: RunFailure on inelastic collapse; whatever the response or the observer throws.
  /// If the response throws, its event has not happened.
  virtual RunStatus run(const RunLimits& limits, ContactSums& sums, const ContactObserver& observer) = 0;
  /// The next collision or wall contact up to `until`, without executing it, and without asking whether
  /// spheres that have just merged do so again. Precondition: not needs_rebuild().
  virtual std::optional<Event> next_contact(const Time& until) = 0;

  /// Changes velocities at `moment`, each of another sphere. Precondition: all events before it have been
  /// handled, and none after it. Cost: a prediction each.
  virtual void change_velocities(const Time& moment, std::span<const NewVelocity> changes) = 0;
  /// Gives spheres new paths at `moment` that begin where the old ones lead, up to rounding, each of another
  /// sphere. Precondition and cost: as for change_velocities.
  virtual void put(const Time& moment, std::span<const NewPlace> places) = 0;
  /// Adds a sphere at `moment`, and returns its id. Precondition: as for change_velocities. Cost: as of a
  /// collision, amortized; O(large spheres) where some are much larger than cells; O(n) in several domains.
  /// Error: see World::add and require_room.
  virtual SphereId add(const Sphere& sphere, const Time& moment) = 0;
  /// Removes a sphere at `moment`. Precondition: as for change_velocities. Cost: as of a collision. Error: no
  /// sphere has this id.
  virtual void remove(SphereId id, const Time& moment) = 0;

  /// Whether the broad phase does not fit the spheres, or is of a later time: `rebuild` must follow before
  /// the next run.
  virtual bool needs_rebuild() const = 0;
  /// Discards all predictions and regions and rebuilds them as of `now`, with a broad phase of these
  /// settings. The motion is not affected. Cost: O(n).
  virtual void rebuild(const Time& now, const PhaseSettings& settings) = 0;

  /// Starts to record what is needed to rewind to `moment` or a later one; discards earlier records.
  /// Precondition: as for change_velocities.
  virtual void begin_journal(const Time& moment) = 0;
  virtual void end_journal() = 0;
  /// Goes back to `moment`, as if nothing had happened after it; only counters of work keep their values.
  /// Without a journal since then, nothing but crossings may have happened after it. Cost: as of what was
  /// done since; but the engine may be outdated afterwards.
  virtual void rewind(const Time& moment) = 0;
  /// Goes back to where the journal begins, before simultaneous events, too. Precondition: there is a
  /// journal. Cost: as of `rewind`.
  virtual void rewind_to_begin() = 0;

  virtual PostContactState post_contact_state() const = 0;
  /// Continues for another engine, or with what contacts left behind, edited between runs.
  virtual void take_over(const PostContactState& post_contact_state) = 0;

  /// Checks every structure, and that every contact is predicted; throws BrokenInvariant. Cost:
  /// O(candidates).
  virtual void validate() const = 0;
};

}  // namespace hardball
