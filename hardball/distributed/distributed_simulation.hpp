// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "hardball/engine/run.hpp"
#include "hardball/geometry/extent.hpp"
#include "hardball/memory/function.hpp"
#include "hardball/parallel/traveler.hpp"
#include "hardball/processes/processes.hpp"
#include "hardball/simulation/any_distributed_engine.hpp"
#include "hardball/simulation/contact_sums.hpp"
#include "hardball/simulation/engine_options.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/thermostats/thermostat.hpp"
#include "hardball/world/audit.hpp"
#include "hardball/world/totals.hpp"
#include "hardball/world/velocity_change.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// One simulation that several processes run together, each with the spheres in a part of the box: to the
/// same contacts as Simulation.
///
/// All members but size() and time() are called in all processes at once, and return the same in each, unless
/// they say otherwise.
class DistributedSimulation {
 public:
  /// Spheres whose ids are from k * kBlock on, before (k + 1) * kBlock, are the k-th block. The process k %
  /// Processes::size() saves it and writes it to trajectories.
  static constexpr std::size_t kBlock = std::size_t{1} << 16;

  /// Starts with spheres of which each process brings some, with their ids; all are brought once. `empty`:
  /// the world without spheres. `options`: threads are those of each process. Error: in all processes; as for
  /// Simulation; spheres merge, grow or have potentials of steps; the response is a function; the box is
  /// sheared, or too small for so many processes; the engine cannot be distributed.
  DistributedSimulation(Processes& processes, World empty, Travelers brought, const EngineOptions& options);
  DistributedSimulation(DistributedSimulation&& other) noexcept;
  ~DistributedSimulation();

  /// The same, of which each process brings a share of a world that all of them have whole.
  static DistributedSimulation of(Processes& processes, const World& whole, const EngineOptions& options);

  /// Has the first process hold all spheres, too, and let the contacts happen to them that it is told of,
  /// from now on. Cost: O(n), and at each contact.
  void follow_in_first();
  /// All spheres as they are, in the first process if it follows; otherwise null.
  const World* whole() const { return whole_ ? &*whole_ : nullptr; }

  /// When a contact or the thermostat last changed a velocity: in the first process if it follows.
  const Time& last_change() const { return last_change_; }

  /// As Simulation::set_thermostat. The first process follows.
  void set_thermostat(Thermostat thermostat);
  /// In the first process as it is; in others as it was when it was set.
  const std::optional<Thermostat>& thermostat() const { return thermostat_; }
  /// As Simulation::on_velocity_change; called in the first process.
  void on_velocity_change(Function<void(const VelocityChange&)> listener) {
    change_listener_ = std::move(listener);
  }

  /// Runs until the first of the limits is reached; the number of steps is none of them, and the first
  /// process is asked whether to stop. If contacts are observed, the first process tells `observe` of all of
  /// them, in order, when it has let them happen. Error: as for Simulation::run.
  RunStatus run(const RunLimits& limits, bool is_observed = false,
                const Function<void(const Contact&)>& observe = {});

  Processes& processes() const { return processes_; }
  double time() const { return now_.value(); }  ///< [T]
  const Time& now() const { return now_; }
  std::size_t size() const { return spheres_; }
  const Box& box() const { return empty_.box(); }
  /// The world without spheres.
  const World& empty_world() const { return empty_; }
  EngineKind engine() const { return kind_; }
  double cell_edge() const;

  Counters counters() const;
  /// Of all contacts so far.
  ContactSums sums() const;
  /// Sums over the spheres as they are.
  Totals totals() const;
  /// The box that holds all spheres; from 0 to 1 if there are none [L].
  Extent extent() const;
  /// A check of all spheres; see audit.
  Audit audit() const;
  /// How many spheres each species has, up to the highest one.
  std::vector<std::size_t> species_counts() const;
  /// Whether some spheres have spun; see World::has_spins.
  bool has_spins() const;
  /// Of all processes [bytes].
  std::size_t memory_bytes() const;
  /// How many domains there are in all processes.
  std::size_t domains() const;
  /// Of windows of time in which they have run apart.
  WindowCounters window_counters() const;
  /// Checks all structures; throws BrokenInvariant.
  void validate() const;

  /// The number of blocks of ids.
  std::size_t blocks() const { return (next_id_ + kBlock - 1) / kBlock; }
  /// The spheres of the blocks of this process, each block in the order of ids. Cost: O(n / processes), and
  /// all spheres are sent.
  std::vector<std::vector<Traveler>> own_blocks() const;

  /// What is needed to continue, besides the spheres.
  std::string save() const;
  /// A block of spheres as bytes.
  static std::string saved_block(const std::vector<Traveler>& block);
  /// Continues from what `save` has returned, and from blocks of which each process brings some, whatever it
  /// was that saved them; `where` names the bytes in errors. Error: they are damaged; as for the constructor.
  static DistributedSimulation load(Processes& processes, std::string_view saved,
                                    const std::vector<std::string>& blocks, std::size_t threads,
                                    const std::string& where);
  /// Continues a simulation that all processes have loaded whole. Error: as for the constructor.
  static DistributedSimulation of(Processes& processes, const Simulation& whole, std::size_t threads);
  /// A simulation of one process from all blocks.
  static Simulation load_whole(std::string_view saved, const std::vector<std::string>& blocks,
                               const std::string& where);

 private:
  struct State;
  DistributedSimulation(Processes& processes, State state, Travelers brought, const EngineOptions& options);
  RunStatus run_to_action(const RunLimits& limits, bool is_observed,
                          const Function<void(const Contact&)>& observe);
  void act(const Time& moment);
  /// The value of the first process.
  template <class T>
  T of_first(const T& own) const {
    return processes_.gather(own).front();
  }

  Processes& processes_;
  World empty_;
  SphereId next_id_ = 0;
  std::size_t spheres_ = 0;
  EngineOptions options_;
  EngineKind kind_ = EngineKind::automatic;
  Time now_;
  Counters counters_before_;
  ContactSums before_;  // with all contacts before this process started
  ContactSums own_;     // counted here since then
  std::optional<Thermostat> thermostat_;
  Function<void(const VelocityChange&)> change_listener_;
  std::optional<World> whole_;
  Time last_change_;  // in the first process, if it follows: of a contact or by the thermostat
  std::unique_ptr<AnyDistributedEngine> engine_;
};

}  // namespace hardball
