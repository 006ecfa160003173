// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/run/make_engine.hpp"

#include <algorithm>
#include <utility>

#include "hardball/broadphase/neighbor_list.hpp"
#include "hardball/broadphase/sheared_cells.hpp"
#include "hardball/domains/make_domains_engine.hpp"
#include "hardball/domains/processors.hpp"
#include "hardball/engine/engine.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/paper/paper_engine.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/theory/gas_statistics.hpp"
#include "hardball/tuning/cell_edge.hpp"
#include "hardball/tuning/neighbor_counts.hpp"
#include "hardball/tuning/size_classes.hpp"

namespace hardball {
namespace {

// An engine to choose.
struct Choice {
  EngineKind kind;
  PhaseKind phase;
  // The best length for a world with these statistics, and its predicted cost.
  BestLength (*best)(const World&, const Time&, const GasStatistics&, const UnitCosts&);
  bool has_cells;
};

// All engines.
constexpr Choice kChoices[] = {
    {EngineKind::cells, PhaseKind::cells, best_edge, true},
    {EngineKind::neighbors, PhaseKind::neighbors,
     [](const World&, const Time&, const GasStatistics& statistics, const UnitCosts& costs) {
       return best_skin(statistics, costs);
     },
     false},
    {EngineKind::all_pairs, PhaseKind::all_pairs,
     [](const World&, const Time&, const GasStatistics&, const UnitCosts&) { return BestLength(); }, false},
    {EngineKind::paper, PhaseKind::cells,
     [](const World&, const Time&, const GasStatistics& statistics, const UnitCosts& costs) {
       return best_cell_edge(statistics, costs);
     },
     true},
};

// Precondition: not automatic.
const Choice& choice(EngineKind kind) {
  return *ranges::find(kChoices, kind, &Choice::kind);
}

// With fewer spheres, or in two threads, a run with measures may gain nothing: docs/parallel.md.
Division as_pays(std::size_t spheres) {
  constexpr std::size_t kFewestSpheres = 1'000'000;
  constexpr std::size_t kSpheresPerThread = 125'000;
  constexpr std::size_t kFewestThreads = 4;
  if (spheres < kFewestSpheres) return {};
  // Found out once: later the load of the machine contains that of this process.
  static const std::size_t free = free_processors();
  const std::size_t threads = std::min(free, spheres / kSpheresPerThread);
  if (threads < kFewestThreads) return {};
  return {.domains = threads, .threads = threads};
}

}  // namespace

Division choose_division(const World& world, const EngineOptions& options) {
  if (!goes_with(Feature::threads, world.features())) return {};
  if (options.division) return *options.division;
  if (options.threads == 0) return has_domains() ? as_pays(world.size()) : Division();
  return {.domains = options.threads, .threads = options.threads};
}

PhaseSettings phase_settings(EngineKind engine, const EngineOptions& options, double length) {
  return {choice(engine).phase, length, options.instructions.value_or(fastest_instruction_set())};
}

std::unique_ptr<EngineBase> make_engine(World world, EngineKind engine, const EngineOptions& options,
                                        double length, const Time& now, Processes& processes,
                                        const Progress& progress) {
  const PhaseSettings settings = phase_settings(engine, options, length);
  if (engine == EngineKind::paper) return std::make_unique<PaperEngine>(std::move(world), settings, now);
  const Division division = choose_division(world, options);
  const bool is_divided = division.domains > 1 && engine != EngineKind::all_pairs;
  if (is_divided || processes.size() > 1)
    return make_domains_engine(std::move(world), settings, division, now, processes);
  return std::make_unique<Engine<CalendarQueue>>(std::move(world), settings, now, progress);
}

bool must_be_replaced(const EngineBase& engine) {
  return engine.blocks().size() > 1 && !goes_with(Feature::threads, engine.setting().features());
}

void check(const EngineOptions& options) {
  if (!are_meaningful(options.unit_costs)) {
    throw Error("a cost is negative or not finite, or predictions or crossings cost nothing", "unit costs",
                "give those of measure_unit_costs, or leave them out");
  }
  if (options.cell_edge) check_positive(*options.cell_edge, "the cell edge", "cell edge");
}

void check_features(const EngineOptions& options, const Processes& processes, Features features) {
  constexpr std::size_t kMostThreads = 1024;
  if (options.threads > kMostThreads) {
    throw Error("there are to be " + to_text(options.threads) + " threads", "threads",
                "give at most " + to_text(kMostThreads) + ", and no more than there are processors");
  }
  if (options.threads > 1 && !has_domains()) {
    throw Error("there are to be " + to_text(options.threads) + " threads, and this library has none",
                "threads", "give one, or configure the library with HARDBALL_DOMAINS=ON");
  }
  features.add(Feature::threads, options.threads > 1);
  features.add(Feature::processes, processes.size() > 1);
  features.add(Feature::all_pairs, options.engine == EngineKind::all_pairs);
  features.add(Feature::paper, options.engine == EngineKind::paper);
  check_exclusions(features);
}

EngineKind choose_engine(const World& world, const GasStatistics& statistics, const EngineOptions& options,
                         const Time& moment, EngineKind current) {
  const bool has_lists = NeighborList::supports(world);
  if (has_lists && options.engine == EngineKind::neighbors) return options.engine;
  if (options.engine == EngineKind::all_pairs || options.engine == EngineKind::paper) return options.engine;
  if (world.box().is_sheared() &&
      !ShearedCells::supports(world, options.cell_edge.value_or(world.largest_radius()))) {
    return has_lists && options.engine != EngineKind::cells ? EngineKind::neighbors : EngineKind::all_pairs;
  }
  if (options.engine != EngineKind::automatic || options.cell_edge || !has_lists) return EngineKind::cells;
  const auto cost_of = [&](EngineKind kind) {
    // Cells that slide cost more than those at rest, which the models are of; measured: docs/theory.md.
    constexpr double kCostOfSlidingCells = 1.05;
    const bool slides = kind == EngineKind::cells && world.box().is_sheared();
    return (slides ? kCostOfSlidingCells : 1) *
           choice(kind).best(world, moment, statistics, options.unit_costs).cost;
  };
  const EngineKind used = current == EngineKind::neighbors ? EngineKind::neighbors : EngineKind::cells;
  const EngineKind other = used == EngineKind::cells ? EngineKind::neighbors : EngineKind::cells;
  const double surpass = current == EngineKind::automatic ? 1 : 0.9;
  return cost_of(other) < surpass * cost_of(used) ? other : used;
}

double choose_length(const World& world, const GasStatistics& statistics, EngineKind engine,
                     const EngineOptions& options, const Time& moment) {
  const Choice& chosen = choice(engine);
  if (chosen.has_cells && options.cell_edge) return *options.cell_edge;
  const BestLength best = chosen.best(world, moment, statistics, options.unit_costs);
  return allowed_cell_edge(world, engine, best.length);
}

double allowed_cell_edge(const World& world, EngineKind engine, double edge) {
  return engine == EngineKind::paper ? std::max(edge, PaperEngine::least_edge(world)) : edge;
}

}  // namespace hardball
