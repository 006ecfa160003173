// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/simulation/any_engine.hpp"

#include <algorithm>
#include <thread>
#include <utility>

#include "hardball/broadphase/all_pairs.hpp"
#include "hardball/broadphase/cell_grid.hpp"
#include "hardball/broadphase/large_sphere_grid.hpp"
#include "hardball/broadphase/neighbor_list.hpp"
#include "hardball/engine/engine.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/events/calendar_queue.hpp"
#include "hardball/events/ordered_queue.hpp"
#include "hardball/geometry/range.hpp"
#include "hardball/paper/paper_engine.hpp"
#include "hardball/parallel/parallel_engine.hpp"
#include "hardball/theory/gas_statistics.hpp"
#include "hardball/tuning/cell_edge.hpp"
#include "hardball/tuning/neighbor_counts.hpp"
#include "hardball/tuning/size_classes.hpp"

namespace hardball {
namespace {

// How a world is divided among threads.
Division choose_division(const World& world, const EngineOptions& options) {
  if (world.interactions().may_merge()) return {};
  if (options.division) return *options.division;
  constexpr std::size_t kSpheresPerThread = 50000;
  const std::size_t most = std::max<std::size_t>(std::thread::hardware_concurrency(), 1);
  const std::size_t wanted =
      options.threads > 0 ? options.threads : std::min(most, world.size() / kSpheresPerThread);
  const std::size_t threads = std::max<std::size_t>(wanted, 1);
  return {.domains = threads, .threads = threads};
}

// Gives any engine the common interface. The preferred ones take its place in worlds that they support.
template <class Wrapped, class... Preferred>
class EngineModel final : public AnyEngine {
 public:
  EngineModel(Wrapped engine, const PhaseSettings& settings)
      : engine_(std::move(engine)), settings_(settings) {}

  std::unique_ptr<AnyEngine> clone() const override { return std::make_unique<EngineModel>(*this); }
  const World& world() const override { return engine_.world(); }
  World& world_to_edit() override { return engine_.world_to_edit(); }
  Time now() const override { return engine_.now(); }
  Counters counters() const override { return engine_.counters(); }
  std::size_t memory_bytes() const override { return engine_.memory_bytes(); }
  PhaseLengths lengths() const override { return engine_.lengths(); }
  RunStatus run(const RunLimits& limits, ContactSums& sums, const Observe& observe) override {
    if constexpr (requires { engine_.run(limits, sums, observe); }) {
      return engine_.run(limits, sums, observe);
    } else {
      return engine_.run(limits, [&](const Contact& contact) {
        sums.note(contact);
        return !observe || observe(contact);
      });
    }
  }
  std::optional<Event> next_contact(const Time& until) override { return engine_.next_contact(until); }
  void change_velocities(const Time& moment, std::span<const NewVelocity> changes) override {
    engine_.change_velocities(moment, changes);
  }
  SphereId add(const Sphere& sphere, const Time& moment) override { return engine_.add(sphere, moment); }
  void remove(SphereId id, const Time& moment) override { engine_.remove(id, moment); }
  bool is_outdated() const override { return engine_.is_outdated(); }
  void begin_journal(const Time& moment) override { engine_.begin_journal(moment); }
  void end_journal() override { engine_.end_journal(); }
  void rewind(const Time& moment) override { engine_.rewind(moment); }
  void rewind_to_begin() override { engine_.rewind_to_begin(); }
  bool supports(double length) const override {
    return !(Preferred::supports(world(), length) || ...) && Wrapped::supports(world(), length);
  }
  void rebuild(const Time& now, double length) override {
    settings_.length = length;
    engine_.rebuild(now, settings_);
  }
  Aftermath aftermath() const override { return engine_.aftermath(); }
  void take_over(const Aftermath& aftermath) override { engine_.take_over(aftermath); }
  void validate() const override { engine_.validate(); }

 private:
  Wrapped engine_;
  PhaseSettings settings_;
};

template <EventQueue Queue, BroadPhase Phase, BroadPhase... Preferred>
std::unique_ptr<AnyEngine> make_queued(World world, const PhaseSettings& settings, const Time& now,
                                       const Progress& progress) {
  return std::make_unique<EngineModel<Engine<Queue, Phase>, Preferred...>>(
      Engine<Queue, Phase>(std::move(world), Phase(settings), now, settings.instructions, progress),
      settings);
}

template <BroadPhase Phase, BroadPhase... Preferred>
std::unique_ptr<AnyEngine> make(World world, const EngineOptions& options, const PhaseSettings& settings,
                                const Time& now, const Progress& progress) {
  const auto make_it = options.queue == QueueKind::ordered ? make_queued<OrderedQueue, Phase, Preferred...>
                                                           : make_queued<CalendarQueue, Phase, Preferred...>;
  return make_it(std::move(world), settings, now, progress);
}

// The same, in several domains where these pay.
template <BroadPhase Phase, BroadPhase... Preferred>
std::unique_ptr<AnyEngine> make_divided(World world, const EngineOptions& options,
                                        const PhaseSettings& settings, const Time& now,
                                        const Progress& progress) {
  const Division division = choose_division(world, options);
  if (division.domains == 1)
    return make<Phase, Preferred...>(std::move(world), options, settings, now, progress);
  using Divided = ParallelEngine<CalendarQueue, Phase, ContactSums>;
  return std::make_unique<EngineModel<Divided, Preferred...>>(
      Divided(std::move(world), settings, division, now), settings);
}

std::unique_ptr<AnyEngine> make_cells(World world, const EngineOptions& options,
                                      const PhaseSettings& settings, const Time& now,
                                      const Progress& progress) {
  const auto make_it = LargeSphereGrid::supports(world, settings.length)
                           ? make_divided<LargeSphereGrid>
                           : make_divided<CellGrid, LargeSphereGrid>;
  return make_it(std::move(world), options, settings, now, progress);
}

std::unique_ptr<AnyEngine> make_paper(World world, const EngineOptions&, const PhaseSettings& settings,
                                      const Time& now, const Progress&) {
  return std::make_unique<EngineModel<PaperEngine>>(PaperEngine(std::move(world), settings, now), settings);
}

// An engine to choose.
struct Choice {
  EngineKind kind;
  std::unique_ptr<AnyEngine> (*make)(World, const EngineOptions&, const PhaseSettings&, const Time&,
                                     const Progress&);
  // The best length for a world with these statistics, and its predicted cost.
  BestLength (*best)(const World&, const Time&, const GasStatistics&, const UnitCosts&);
  bool has_cells;
};

// All engines.
constexpr Choice kChoices[] = {
    {EngineKind::cells, make_cells, best_edge, true},
    {EngineKind::neighbors, make_divided<NeighborList>,
     [](const World&, const Time&, const GasStatistics& statistics, const UnitCosts& costs) {
       return best_skin(statistics, costs);
     },
     false},
    {EngineKind::all_pairs, make<AllPairs>,
     [](const World&, const Time&, const GasStatistics&, const UnitCosts&) { return BestLength(); }, false},
    {EngineKind::paper, make_paper,
     [](const World&, const Time&, const GasStatistics& statistics, const UnitCosts& costs) {
       return best_cell_edge(statistics, costs);
     },
     true},
};

// Precondition: not automatic.
const Choice& choice(EngineKind kind) {
  return *std::ranges::find(kChoices, kind, &Choice::kind);
}

}  // namespace

std::unique_ptr<AnyEngine> make_engine(World world, EngineKind engine, const EngineOptions& options,
                                       double length, const Time& now, const Progress& progress) {
  const PhaseSettings settings{length, options.instructions.value_or(widest_instruction_set())};
  return choice(engine).make(std::move(world), options, settings, now, progress);
}

void check(const EngineOptions& options) {
  if (!are_meaningful(options.unit_costs)) {
    throw Error("a cost is negative or not finite, or predictions or crossings cost nothing", "unit costs",
                "give those of measure_unit_costs, or leave them out");
  }
  if (options.cell_edge) check_positive(*options.cell_edge, "the cell edge", "cell edge");
}

EngineKind choose_engine(const World& world, const EngineOptions& options, const Time& moment,
                         EngineKind current) {
  if (options.engine == EngineKind::paper && !PaperEngine::supports(world)) {
    throw Error("the paper's engine knows only straight paths, and no images of obstacles", "engine",
                "use another engine");
  }
  if (options.engine == EngineKind::neighbors && !NeighborList::supports(world)) return EngineKind::cells;
  if (options.engine != EngineKind::automatic) return options.engine;
  if (options.cell_edge || !NeighborList::supports(world)) return EngineKind::cells;
  const GasStatistics statistics = gas_statistics(world, moment);
  const auto cost_of = [&](EngineKind kind) {
    return choice(kind).best(world, moment, statistics, options.unit_costs).cost;
  };
  const bool has_lists = current == EngineKind::neighbors;
  const EngineKind used = has_lists ? EngineKind::neighbors : EngineKind::cells;
  const EngineKind other = has_lists ? EngineKind::cells : EngineKind::neighbors;
  const double surpass = current == EngineKind::automatic ? 1 : 0.9;
  return cost_of(other) < surpass * cost_of(used) ? other : used;
}

double choose_length(const World& world, EngineKind engine, const EngineOptions& options,
                     const Time& moment) {
  const Choice& chosen = choice(engine);
  if (chosen.has_cells && options.cell_edge) return *options.cell_edge;
  const BestLength best = chosen.best(world, moment, gas_statistics(world, moment), options.unit_costs);
  return allowed_cell_edge(world, engine, best.length);
}

double allowed_cell_edge(const World& world, EngineKind engine, double edge) {
  return engine == EngineKind::paper ? std::max(edge, PaperEngine::least_edge(world)) : edge;
}

}  // namespace hardball
