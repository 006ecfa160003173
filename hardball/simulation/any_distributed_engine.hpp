// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "hardball/broadphase/broad_phase.hpp"
#include "hardball/engine/run.hpp"
#include "hardball/memory/function.hpp"
#include "hardball/parallel/division.hpp"
#include "hardball/parallel/traveler.hpp"
#include "hardball/parallel/window_counters.hpp"
#include "hardball/processes/processes.hpp"
#include "hardball/simulation/contact_sums.hpp"
#include "hardball/simulation/engine_options.hpp"
#include "hardball/world/velocity_edit.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// The interface that all distributed engines share; see DistributedEngine for what its members do.
class AnyDistributedEngine {
 public:
  using Observe = Function<void(const Contact&)>;

  virtual ~AnyDistributedEngine() = default;
  virtual RunStatus run(const RunLimits& limits, ContactSums& sums, bool is_observed,
                        const Observe& observe) = 0;
  virtual void change_velocities(const Time& moment, std::span<const VelocityEdit> edits) = 0;
  virtual Time now() const = 0;
  virtual Counters counters() const = 0;
  virtual WindowCounters window_counters() const = 0;
  virtual const Event& last_passage() const = 0;
  virtual PhaseLengths lengths() const = 0;
  virtual std::size_t memory_bytes() const = 0;
  virtual void for_each_own(const Function<void(const World&, Slot, std::uint32_t)>& visit) const = 0;
  virtual void for_each_domain(const Function<void(const World&)>& visit) const = 0;
  virtual void validate() const = 0;
};

/// What a distributed engine is made of; see DistributedEngine.
struct DistributedStart {
  World empty;
  Travelers brought;
  Division division;
  Time now;
  Processes* processes = nullptr;
};

/// Makes a distributed engine with the length [L] that choose_length has chosen for it. Precondition:
/// `engine` uses cells or lists of neighbors. `has_large`: some spheres are much larger than a cell.
std::unique_ptr<AnyDistributedEngine> make_distributed(DistributedStart start, EngineKind engine,
                                                       const PhaseSettings& settings, bool has_large);

}  // namespace hardball
