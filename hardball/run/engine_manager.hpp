// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

#include "hardball/domains/sphere_transfer.hpp"
#include "hardball/engine/engine_base.hpp"
#include "hardball/engine/run.hpp"
#include "hardball/memory/value_pointer.hpp"
#include "hardball/processes/processes.hpp"
#include "hardball/run/division_watch.hpp"
#include "hardball/run/make_engine.hpp"
#include "hardball/theory/gas_statistics.hpp"
#include "hardball/tuning/cell_edge.hpp"
#include "hardball/world/progress.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// Keeps the engine that suits the world: chooses its kind and the size of its cells or lists, and again when
/// the spheres have changed so much that others would be faster. In several processes all choose alike.
class EngineManager {
 public:
  /// `kind` and `counters` are those of an engine to be continued. Error: invalid options; see EngineOptions.
  explicit EngineManager(const EngineOptions& options, Processes& processes = one_process(),
                         EngineKind kind = EngineKind::automatic, const Counters& counters = {});

  /// Chooses the kind of engine, and puts the spheres into its order. Precondition: check_features accepts
  /// them.
  void prepare(World& world, const Time& now);
  /// Makes the engine for a world that has been prepared, and that all processes have whole.
  void start(World world, const Time& now, const Progress& progress = {});
  /// Makes the engine for a system of which each process brings some of the spheres, as they are at `now`;
  /// all are brought once. `empty`: the world without spheres. Error: the box is too small for this many
  /// processes.
  void start(World empty, SphereTransfers brought, const Time& now);

  EngineBase& engine() { return *engine_; }
  const EngineBase& engine() const { return *engine_; }
  /// The kind of the engine in use, never `automatic`.
  EngineKind kind() const { return kind_; }
  const EngineOptions& options() const { return options_; }
  Processes& processes() const { return *processes_; }
  /// The counters of all engines so far.
  Counters counters() const { return counters_before_ + engine_->counters(); }
  /// The windows of all engines so far.
  WindowCounters windows() const { return windows_before_ + engine_->windows(); }

  /// Brings an engine that has looked ahead back to `moment`.
  void end_look_ahead(const Time& moment);
  /// Undoes all since the engine began its journal, when these were the counters.
  void undo_look_ahead(const Counters& before);

  /// To be called when a run begins.
  void begin_run();
  /// To be called before the engine runs on at `now`: rebuilds it if a sphere does not fit it, or if it was
  /// chosen for far more or fewer.
  void make_ready(const Time& now);
  /// To be called now and then during a run: every few events for each sphere, rebuilds the engine if another
  /// size of cells or another kind would be faster.
  void review_if_due(const Time& now);
  /// Rebuilds all regions and predictions as of `moment`, with the engine that suits the world best.
  void rebuild(const Time& moment);
  /// Replaces the engine by one with this many threads; see EngineOptions::threads.
  void set_threads(std::size_t threads, const Time& now);

 private:
  void begin(double length, const Time& now);
  void review_division(const Time& now);
  void review_skin(const GasStatistics& statistics, const Time& moment);
  void replace_as_divided(const Time& now);
  EngineOptions options_in_use() const;
  void replace(EngineKind kind, double length, const Time& moment);
  void note_choice(double length, const Time& moment);

  EngineOptions options_;
  Processes* processes_;
  EngineKind kind_;
  ValuePointer<EngineBase> engine_;
  Counters counters_before_;  // of engines replaced
  WindowCounters windows_before_;
  CellEdgeWatch watch_;
  DivisionWatch division_watch_;
  std::size_t spheres_at_choice_ = 0;  // when engine and cells were last chosen
  std::uint64_t next_review_ = 0;      // at this number of crossings and contacts
  Time last_review_;
  GasStatistics reviewed_;      // for which the kind of engine was last reviewed
  Counters reviewed_counters_;  // when lists were last reviewed
};

}  // namespace hardball
