// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "hardball/broadphase/broad_phase.hpp"
#include "hardball/engine/run.hpp"
#include "hardball/execution/aftermath.hpp"
#include "hardball/interaction/contact.hpp"
#include "hardball/memory/function.hpp"
#include "hardball/parallel/block.hpp"
#include "hardball/parallel/window_counters.hpp"
#include "hardball/simulation/contact_sums.hpp"
#include "hardball/simulation/engine_options.hpp"
#include "hardball/theory/gas_statistics.hpp"
#include "hardball/world/new_velocity.hpp"
#include "hardball/world/progress.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// The interface that all engines share; see Engine for what its members do.
class AnyEngine {
 public:
  virtual ~AnyEngine() = default;
  virtual std::unique_ptr<AnyEngine> clone() const = 0;
  virtual const World& world() const = 0;
  virtual World& world_to_edit() = 0;
  /// How many spheres there are, and what happens when they touch. In several domains, the world as a whole
  /// costs O(contacts since it was last asked for).
  virtual std::size_t size() const = 0;
  virtual const Interactions& interactions() const = 0;
  virtual Time now() const = 0;
  virtual Counters counters() const = 0;
  virtual std::size_t memory_bytes() const = 0;
  virtual PhaseLengths lengths() const = 0;
  /// Those of the domains; one, all of the box, without them.
  virtual std::vector<Block> blocks() const = 0;
  /// Of the world as it is at `moment`. Precondition: not is_outdated(). Cost: O(n).
  virtual GasStatistics statistics(const Time& moment) const = 0;
  virtual WindowCounters windows() const = 0;
  /// Calls work(k) for each k below `count`, in the threads of the engine, and returns when all have
  /// returned. Precondition: `work` does not throw.
  virtual void for_each(std::size_t count, const Function<void(std::size_t)>& work) = 0;
  /// Adds all contacts to `sums`, and tells the observer, if there is one.
  virtual RunStatus run(const RunLimits& limits, ContactSums& sums, const ContactObserver& observer) = 0;
  virtual std::optional<Event> next_contact(const Time& until) = 0;
  virtual void change_velocities(const Time& moment, std::span<const NewVelocity> changes) = 0;
  virtual SphereId add(const Sphere& sphere, const Time& moment) = 0;
  virtual void remove(SphereId id, const Time& moment) = 0;
  virtual bool is_outdated() const = 0;
  virtual void begin_journal(const Time& moment) = 0;
  virtual void end_journal() = 0;
  virtual void rewind(const Time& moment) = 0;
  virtual void rewind_to_begin() = 0;
  /// Whether `rebuild` with this length would make what make_engine makes for the world as it is.
  virtual bool supports(double length) const = 0;
  /// Rebuilds all regions and predictions, with this cell edge or skin [L] where there is one.
  virtual void rebuild(const Time& now, double length) = 0;
  virtual Aftermath aftermath() const = 0;
  virtual void take_over(const Aftermath& aftermath) = 0;
  virtual void validate() const = 0;
};

/// Makes an engine with the length [L] that choose_length has chosen for it. Precondition: `engine` is one
/// that choose_engine has chosen.
std::unique_ptr<AnyEngine> make_engine(World world, EngineKind engine, const EngineOptions& options,
                                       double length, const Time& now, const Progress& progress = {});

/// The engine for a world as it is at `moment`, with these statistics: the one that the options fix, if it
/// suits the world, or the one that kinetic theory predicts to be the fastest; never `automatic`. `current`
/// is the one in use; another must be cheaper by a tenth to replace it. The world may be a sample of that
/// which the statistics describe.
EngineKind choose_engine(const World& world, const GasStatistics& statistics, const EngineOptions& options,
                         const Time& moment, EngineKind current = EngineKind::automatic);

/// The length [L] for such an engine: the cell edge that the options fix, or the best one; for neighbor
/// lists, the skin; for all pairs, any.
double choose_length(const World& world, const GasStatistics& statistics, EngineKind engine,
                     const EngineOptions& options, const Time& moment);

/// A proposed edge [L], for the paper's engine raised to the largest diameter if it is smaller.
double allowed_cell_edge(const World& world, EngineKind engine, double edge);

}  // namespace hardball
