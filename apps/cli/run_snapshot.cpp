// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "apps/cli/run_snapshot.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "hardball/archive/archive.hpp"
#include "hardball/error.hpp"
#include "hardball/processes.hpp"
#include "hardball/processes/bytes.hpp"
#include "hardball/trajectory.hpp"

namespace hardball::cli {
namespace {

using Blocks = std::vector<std::vector<SphereTransfer>>;

// Whether spheres can be written to such a file block by block.
bool takes_parts(SnapshotFormat format) {
  return format == SnapshotFormat::extended_xyz || format == SnapshotFormat::extended_xyz_zst ||
         format == SnapshotFormat::lammps;
}

// The spheres on their way to the first process, one block after the other.
class BlocksInFirst {
 public:
  // `own`: those of this process; outlives it.
  BlocksInFirst(const Simulation& simulation, const Blocks& own)
      : processes_(simulation.processes()), own_(own), blocks_(simulation.blocks_of_spheres()) {}

  // In the first process, the next block in the order of ids; nothing at the end.
  std::optional<std::vector<SphereTransfer>> next() {
    if (taken_ == blocks_) return std::nullopt;
    const std::size_t block = taken_++;
    const std::size_t holder = block % processes_.size();
    if (holder == processes_.rank()) return own_[block / processes_.size()];
    const std::string nothing;
    std::vector<SphereTransfer> spheres;
    append_bytes(processes_.exchange({&holder, 1}, {&nothing, 1}).front(), spheres);
    return spheres;
  }
  // In the first process takes all that are left, in others sends theirs. To be called in all.
  void complete() {
    if (processes_.is_first()) {
      while (next()) continue;
      return;
    }
    const std::size_t first = 0;
    for (const std::vector<SphereTransfer>& block : own_) {
      const std::string bytes = bytes_of(block);
      processes_.exchange({&first, 1}, {&bytes, 1});
    }
  }

 private:
  Processes& processes_;
  const Blocks& own_;
  std::size_t blocks_;
  std::size_t taken_ = 0;
};

SphereTypes types_of_all(Processes& processes, const Blocks& own) {
  SphereTypes types;
  for (const std::vector<SphereTransfer>& block : own) {
    for (const auto& [state, contacts] : block) types.add(state.species, state.radius, state.mass);
  }
  SphereTypes all;
  for (const std::string& bytes : processes.gather(archived(types))) {
    SphereTypes of_process;
    restore(bytes, "types of spheres", of_process);
    all.add(of_process);
  }
  return all;
}

// All but the spheres.
Snapshot head_of_snapshot(const Simulation& simulation, double time) {
  Snapshot head = snapshot_of(simulation.setting().without_spheres(), simulation.now());
  head.has_spins = simulation.has_spins();
  head.time = time;
  const Extent extent = simulation.extent();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (simulation.setting().box().is_bounded(axis)) continue;
    head.box->low[axis] = extent.low[axis];
    head.box->size[axis] = extent.high[axis] - extent.low[axis];
  }
  return head;
}

void write_in_parts(StartedRun& run, double time) {
  const Simulation& simulation = run.simulation;
  const Snapshot head = head_of_snapshot(simulation, time);
  const Blocks own = simulation.own_blocks();
  const SphereTypes types = types_of_all(run.processes(), own);
  const World empty = simulation.setting().without_spheres();
  for (std::size_t k = 0; k < run.scenario.output.trajectory.size(); ++k) {
    BlocksInFirst blocks(simulation, own);
    const auto next = [&]() -> std::optional<Snapshot> {
      const std::optional<std::vector<SphereTransfer>> block = blocks.next();
      if (!block) return std::nullopt;
      World world = empty;
      for (const SphereTransfer& transfer : *block) world.insert(transfer.state);
      Snapshot part = snapshot_of(world, simulation.now());
      part.has_spins = head.has_spins;
      part.time = time;
      return part;
    };
    in_all(run.processes(), [&] {
      try {
        if (run.files) run.files->write_snapshot(k, {head, simulation.size(), types, next});
      } catch (const RunFailure&) {
        blocks.complete();
        throw;
      }
      blocks.complete();
    });
  }
}

// Whether this process holds all spheres anyway.
bool holds_all(const StartedRun& run) {
  return run.processes().size() == 1 || run.measures.is_any_wanted() || run.scenario.output.recording ||
         run.simulation.thermostat() || run.simulation.growth();
}

}  // namespace

void write_snapshot(StartedRun& run, double time) {
  if (run.scenario.output.trajectory.empty()) return;
  if (!holds_all(run) && std::ranges::all_of(run.scenario.output.trajectory, takes_parts))
    return write_in_parts(run, time);
  static_cast<void>(run.simulation.world());
  in_first(run.processes(), [&] { run.files->write_snapshot(run.simulation, time); });
}

}  // namespace hardball::cli
