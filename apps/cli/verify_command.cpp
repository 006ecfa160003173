// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "apps/cli/commands.hpp"
#include "apps/cli/interruption.hpp"
#include "apps/cli/results.hpp"
#include "apps/cli/start.hpp"
#include "apps/cli/terminal.hpp"
#include "hardball/error.hpp"
#include "hardball/run/make_engine.hpp"
#include "hardball/scenario.hpp"
#include "hardball/theory.hpp"
#include "hardball/world.hpp"

namespace hardball::cli {
namespace {

// What a run must have in common with all others, and its own figures.
struct VerifiedRun {
  std::uint64_t hash = 0;
  std::vector<Path> paths;
  double max_overlap = 0;
  bool is_sound = false;
  Counters counters;
  std::uint64_t changes = 0;  // of velocities, by the thermostat
  double cell_edge = 0;
  double seconds = 0;
};

bool is_same(const Path& a, const Path& b) {
  using Bits = std::array<std::uint64_t, sizeof(Path) / sizeof(std::uint64_t)>;
  return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

bool is_same(const VerifiedRun& a, const VerifiedRun& b) {
  return a.hash == b.hash && std::equal(a.paths.begin(), a.paths.end(), b.paths.begin(), b.paths.end(),
                                        [](const Path& p, const Path& q) { return is_same(p, q); });
}

VerifiedRun run_with(const Scenario& scenario, const World& start, const EngineOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  Simulation simulation = start_simulation(scenario, start, options);
  VerifiedRun outcome;
  outcome.cell_edge = simulation.cell_edge();
  simulation.observe({.change = [&](const VelocityChange&) { ++outcome.changes; }});
  if (simulation.run({.until = Time(*scenario.run.until), .stop = is_interrupted}) == RunStatus::stopped)
    throw RunFailure("interrupted");
  outcome.hash = simulation.event_log_hash();
  simulation.world().for_each_by_id(
      [&](Slot slot) { outcome.paths.push_back(simulation.world().path(slot)); });
  const Audit found = simulation.audit();
  outcome.max_overlap = std::max({simulation.tally().max_overlap(), found.max_overlap, found.max_escape});
  // A merged sphere may reach into walls, and into spheres that it does not merge with.
  outcome.is_sound = scenario.features().has(Feature::merging)
                         ? found.not_finite == 0
                         : found.is_sound() && outcome.max_overlap <= kOverlapTolerance;
  outcome.counters = simulation.counters();
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return outcome;
}

// Runs a scenario in several ways, and compares each with the first.
class Comparison {
 public:
  Comparison(const Scenario& scenario, World start, const Function<void(const VerifiedWay&)>& take)
      : scenario_(scenario), start_(std::move(start)), take_(take) {}

  /// Error: the options are invalid for this scenario.
  void run(const std::string& name, const EngineOptions& options) {
    const VerifiedRun outcome = run_with(scenario_, start_, options);
    if (!first_) first_ = outcome;
    const bool same = is_same(outcome, *first_);
    is_good_ = is_good_ && same && outcome.is_sound;
    take_({.name = name,
           .hash = outcome.hash,
           .collisions = outcome.counters.collision,
           .max_overlap = outcome.max_overlap,
           .is_same = same,
           .is_sound = outcome.is_sound,
           .seconds = outcome.seconds});
  }

  void leave_out(const std::string& name, const std::string& reason) {
    take_({.name = name, .skipped = reason});
  }

  const World& start() const { return start_; }
  /// The outcome of the first run. Precondition: there is one.
  const VerifiedRun& first() const { return *first_; }
  /// Whether all runs were the same and sound.
  bool is_good() const { return is_good_; }

 private:
  const Scenario& scenario_;
  World start_;
  const Function<void(const VerifiedWay&)>& take_;
  std::optional<VerifiedRun> first_;
  bool is_good_ = true;
};

void run_or_leave_out(Comparison& comparison, const std::string& name, const EngineOptions& options) {
  try {
    comparison.run(name, options);
  } catch (const Error& error) {
    comparison.leave_out(name, error.problem());
  }
}

void compare_cell_edges(Comparison& comparison, const EngineOptions& options) {
  for (const double factor : {0.6, 1.3, 3.0}) {
    EngineOptions with_edge = options;
    with_edge.cell_edge = factor * comparison.first().cell_edge;
    run_or_leave_out(comparison, fmt::format("cells, edge {:.4g}", *with_edge.cell_edge), with_edge);
  }
}

void compare_instruction_sets(Comparison& comparison, EngineOptions options) {
  constexpr std::array kSets{std::pair{InstructionSet::portable, "cells, portable"},
                             std::pair{InstructionSet::avx2, "cells, AVX2"},
                             std::pair{InstructionSet::avx512, "cells, AVX-512"}};
  for (const auto& [instructions, name] : kSets) {
    options.instructions = instructions;
    if (is_available(instructions)) {
      comparison.run(name, options);
    } else {
      comparison.leave_out(name, "this machine does not support them");
    }
  }
}

// Roughly how many pairs the all-pairs engine would have to predict.
double all_pairs_work(const Comparison& comparison, double until) {
  const World& world = comparison.start();
  const Counters& counters = comparison.first().counters;
  const double mean_speed = gas_statistics(world, Time(0)).mean_speed;
  const auto spheres = static_cast<double>(world.size());
  double images = 1;
  double passes_per_sphere = 1;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!world.box().is_periodic(axis)) continue;
    images *= 2;
    // A sphere's contacts are predicted again after each quarter of the box; half the mean speed is the mean
    // along an axis.
    passes_per_sphere += until * mean_speed / 2 / (world.box().size()[axis] / 4);
  }
  const double after_changes = 2 * static_cast<double>(counters.collision) +
                               static_cast<double>(counters.wall) +
                               static_cast<double>(comparison.first().changes);
  return (spheres * passes_per_sphere + after_changes) * spheres * images;
}

}  // namespace

bool verify_ways(const VerifyOptions& options, const Function<void(const VerifiedWay&)>& take) {
  const Scenario scenario = read_scenario(options.scenario);
  EngineOptions engine_options;
  std::vector<std::string> notes;
  Comparison comparison(
      scenario, make_world(scenario, {}, [&](const std::string& note) { notes.push_back(note); }), take);
  write_notes(notes, options.quiet);

  engine_options.engine = EngineKind::cells;
  comparison.run("cells", engine_options);
  compare_cell_edges(comparison, engine_options);

  EngineOptions divided = engine_options;
  divided.threads = 2;
  divided.division = Division{.domains = 3, .threads = 2};
  run_or_leave_out(comparison, "cells, in three domains", divided);

  engine_options.engine = EngineKind::neighbors;
  const GasStatistics statistics = gas_statistics(comparison.start(), Time(0));
  if (choose_engine(comparison.start(), statistics, engine_options, Time(0)) == EngineKind::neighbors) {
    comparison.run("neighbors", engine_options);
  } else {
    comparison.leave_out("neighbors", "the box is too small for neighbor lists");
  }
  engine_options.engine = EngineKind::cells;
  compare_instruction_sets(comparison, engine_options);

  constexpr std::uint64_t kMaxPaperChanges = 1'000'000;
  const std::uint64_t changes = comparison.first().counters.contacts() + comparison.first().changes;
  engine_options.engine = EngineKind::paper;
  if (changes <= kMaxPaperChanges) {
    run_or_leave_out(comparison, "paper", engine_options);
  } else {
    comparison.leave_out(
        "paper", fmt::format("{} contacts and other changes of velocity would take too long", changes));
  }

  constexpr double kMaxPairs = 5e8;
  const double pairs = all_pairs_work(comparison, *scenario.run.until);
  engine_options.engine = EngineKind::all_pairs;
  if (pairs <= kMaxPairs) {
    comparison.run("all-pairs", engine_options);
  } else {
    comparison.leave_out("all-pairs", fmt::format("{:.1g} predictions would take too long", pairs));
  }
  return comparison.is_good();
}

ExitCode verify(const VerifyOptions& options) {
  bool is_first = true;
  const bool is_good = verify_ways(options, [&](const VerifiedWay& way) {
    if (is_first) {
      write_output(fmt::format("{:<24}{:>16}{:>12}{:>9}{:>13}{:>9}\n", "run", "event log hash", "collisions",
                               "overlap", "final state", "seconds"));
    }
    if (!way.skipped.empty()) return write_output(fmt::format("{:<24}skipped: {}\n", way.name, way.skipped));
    const std::string state = std::exchange(is_first, false) ? "" : way.is_same ? "same" : "DIFFERENT";
    write_output(fmt::format("{:<24}{:016x}{:>12}{:>9.1e}{:>13}{:>9.2f}\n", way.name, way.hash,
                             way.collisions, way.max_overlap, state, way.seconds));
  });
  write_output(is_good ? "all runs are the same\n" : "THE RUNS DIFFER, OR SPHERES OVERLAP\n");
  return is_good ? ExitCode::done : ExitCode::failed;
}

}  // namespace hardball::cli
