// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/simulation/any_engine.hpp"

#include <algorithm>
#include <concepts>
#include <type_traits>
#include <utility>
#include <vector>

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
#include "hardball/theory/moments.hpp"
#include "hardball/tuning/cell_counts.hpp"
#include "hardball/tuning/neighbor_counts.hpp"
#include "hardball/tuning/size_classes.hpp"

namespace hardball {
namespace {

template <class Model>
Vec3 edges_of(const Model& cells) {
  return {cells.edge(0), cells.edge(1), cells.edge(2)};
}

// Gives any engine the common interface.
template <class Wrapped>
class EngineModel final : public AnyEngine {
 public:
  explicit EngineModel(Wrapped engine) : engine_(std::move(engine)) {}

  std::unique_ptr<AnyEngine> clone() const override { return std::make_unique<EngineModel>(*this); }
  const World& world() const override { return engine_.world(); }
  World& world_to_edit() override { return engine_.world_to_edit(); }
  const Time& now() const override { return engine_.now(); }
  Counters counters() const override { return engine_.counters(); }
  std::size_t memory_bytes() const override { return engine_.memory_bytes(); }
  RunStatus run(const RunLimits& limits, const Observe& observe) override {
    return engine_.run(limits, observe);
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
  const Aftermath& aftermath() const override { return engine_.aftermath(); }
  void take_over(const Aftermath& aftermath) override { engine_.take_over(aftermath); }
  void validate() const override { engine_.validate(); }

  bool supports(double length) const override {
    if constexpr (requires { engine_.phase(); }) {
      using Phase = std::remove_cvref_t<decltype(engine_.phase())>;
      if constexpr (std::same_as<Phase, NeighborList>) return NeighborList::supports(world());
      if constexpr (std::same_as<Phase, CellGrid>) return !LargeSphereGrid::supports(world(), length);
      if constexpr (std::same_as<Phase, LargeSphereGrid>) return LargeSphereGrid::supports(world(), length);
    } else {
      return length >= 2 * world().largest_radius();
    }
    return true;
  }

  Vec3 cell_edges() const override {
    if constexpr (requires { engine_.phase().edge(0); }) return edges_of(engine_.phase());
    if constexpr (requires { engine_.edge(0); }) return edges_of(engine_);
    return {};
  }

  double skin() const override {
    if constexpr (requires { engine_.phase().skin(); }) return engine_.phase().skin();
    return 0;
  }

  void rebuild(const Time& now, double length) override {
    if constexpr (requires { engine_.rebuild(now, AllPairs()); }) {
      engine_.rebuild(now, AllPairs());
    } else if constexpr (requires { engine_.rebuild(now, NeighborList(length)); }) {
      engine_.rebuild(now, NeighborList(length, engine_.phase().instructions()));
    } else if constexpr (requires { engine_.rebuild(now, CellGrid(length)); }) {
      engine_.rebuild(now, CellGrid(length));
    } else if constexpr (requires { engine_.rebuild(now, LargeSphereGrid(length)); }) {
      engine_.rebuild(now, LargeSphereGrid(length));
    } else {
      engine_.rebuild(now, length);
    }
  }

 private:
  Wrapped engine_;
};

template <class Wrapped, class... Arguments>
std::unique_ptr<AnyEngine> make_model(Arguments&&... arguments) {
  return std::make_unique<EngineModel<Wrapped>>(Wrapped(std::forward<Arguments>(arguments)...));
}

template <EventQueue Queue>
std::unique_ptr<AnyEngine> make_queued(World world, EngineKind engine, const EngineOptions& options,
                                       double length, const Time& now, const Progress& progress) {
  const InstructionSet instructions = options.instructions.value_or(widest_instruction_set());
  if (engine == EngineKind::all_pairs) {
    return make_model<Engine<Queue, AllPairs>>(std::move(world), AllPairs(), now, instructions, progress);
  }
  if (engine == EngineKind::neighbors) {
    return make_model<Engine<Queue, NeighborList>>(std::move(world), NeighborList(length, instructions), now,
                                                   instructions, progress);
  }
  if (LargeSphereGrid::supports(world, length)) {
    return make_model<Engine<Queue, LargeSphereGrid>>(std::move(world), LargeSphereGrid(length), now,
                                                      instructions, progress);
  }
  return make_model<Engine<Queue, CellGrid>>(std::move(world), CellGrid(length), now, instructions, progress);
}

// The edge of the best cells, and what they cost per sphere and time.
struct BestCells {
  double edge;
  double cost;
};

BestCells best_cells(const World& world, const Moments& moments, const UnitCosts& costs, const Time& moment) {
  if (are_sizes_spread(moments)) {
    const std::vector<SizeClass> classes = size_classes(world, moment);
    // In a small box, candidates must come from smaller cells to be nearest images.
    constexpr double kStep = 1.15;
    constexpr int kSteps = 20;
    double edge = optimal_edge_by_class(moments, classes, costs);
    for (int i = 0; i < kSteps; ++i, edge /= kStep) {
      const bool has_large = edge < moments.largest_radius / LargeSphereGrid::kLargestInGrid;
      if (!has_large || LargeSphereGrid::supports(world, edge)) {
        return {edge, cost_rate_by_class(moments, classes, edge, costs)};
      }
    }
  }
  const double edge = optimal_cell_edge(moments, costs);
  return {edge, cost_rate(expected_counts(moments, edge), costs)};
}

}  // namespace

std::unique_ptr<AnyEngine> make_engine(World world, EngineKind engine, const EngineOptions& options,
                                       double length, const Time& now, const Progress& progress) {
  if (engine == EngineKind::paper) {
    return make_model<PaperEngine>(std::move(world), length, now);
  }
  if (options.queue == QueueKind::ordered) {
    return make_queued<OrderedQueue>(std::move(world), engine, options, length, now, progress);
  }
  return make_queued<CalendarQueue>(std::move(world), engine, options, length, now, progress);
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
  const Moments moments = moments_of(world, moment);
  const UnitCosts& costs = options.unit_costs;
  const double cells = best_cells(world, moments, costs, moment).cost;
  const double neighbors = cost_rate(expected_neighbor_counts(moments, optimal_skin(moments, costs)), costs);
  constexpr double kSurpass = 0.9;
  if (current == EngineKind::cells) return neighbors < kSurpass * cells ? EngineKind::neighbors : current;
  if (current == EngineKind::neighbors) return cells < kSurpass * neighbors ? EngineKind::cells : current;
  return neighbors < cells ? EngineKind::neighbors : EngineKind::cells;
}

double choose_length(const World& world, EngineKind engine, const EngineOptions& options,
                     const Time& moment) {
  if (engine == EngineKind::all_pairs) return 1;
  if (engine == EngineKind::neighbors) return optimal_skin(moments_of(world, moment), options.unit_costs);
  if (options.cell_edge) return *options.cell_edge;
  const Moments moments = moments_of(world, moment);
  const double edge = engine == EngineKind::cells
                          ? best_cells(world, moments, options.unit_costs, moment).edge
                          : optimal_cell_edge(moments, options.unit_costs);
  return allowed_cell_edge(world, engine, edge);
}

double allowed_cell_edge(const World& world, EngineKind engine, double edge) {
  return engine == EngineKind::paper ? std::max(edge, 2 * world.largest_radius()) : edge;
}

}  // namespace hardball
