// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/run/make_engine.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "hardball/broadphase/large_sphere_grid.hpp"
#include "hardball/engine/engine.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/theory/gas_statistics.hpp"
#include "hardball/tuning/cell_edge.hpp"
#include "hardball/tuning/neighbor_counts.hpp"
#include "support/gas.hpp"

namespace hardball::make_engine_test {
namespace {

World gas(double packing_fraction) {
  return support::make_gas({.count = 500, .packing_fraction = packing_fraction, .seed = 501});
}

// One sphere of radius 4 among others of radius .2.
World mixture() {
  World world(Box::periodic({40, 40, 40}));
  world.add({{20, 20, 20}, {1, 0, 0}, 4, 1});
  for (int i = 0; i < 600; ++i) {
    world.add({{1.0 + i % 10, 1.0 + i / 10 % 10, 1.0 + i / 100}, {0, 1, 0}, 0.2, 1});
  }
  return world;
}

std::unique_ptr<EngineBase> make(const World& world, EngineKind kind, double length) {
  return make_engine(world, kind, {}, length, Time(0));
}

EngineKind choose(const World& world, const EngineOptions& options = {},
                  EngineKind current = EngineKind::automatic) {
  return choose_engine(world, gas_statistics(world, Time(0)), options, Time(0), current);
}

TEST(MakeEngine, ReportsTheLengthsThatItHas) {
  const World world = gas(0.1);
  const PhaseLengths cells = make(world, EngineKind::cells, 2)->lengths();
  EXPECT_GE(cells.cell_edges.x, 2);
  EXPECT_EQ(cells.skin, 0);
  const PhaseLengths lists = make(world, EngineKind::neighbors, 0.3)->lengths();
  EXPECT_EQ(lists.cell_edges, Vec3{});
  EXPECT_EQ(lists.skin, 0.3);
  const PhaseLengths pairs = make(world, EngineKind::all_pairs, 1)->lengths();
  EXPECT_EQ(pairs.cell_edges, Vec3{});
  EXPECT_EQ(pairs.skin, 0);
  EXPECT_GE(make(world, EngineKind::paper, 2)->lengths().cell_edges.x, 2);
}

TEST(MakeEngine, RebuildsWithAnotherLength) {
  const World world = gas(0.1);
  const auto cells = make(world, EngineKind::cells, 2);
  cells->rebuild(Time(0), {PhaseKind::cells, 3});
  EXPECT_GE(cells->lengths().cell_edges.x, 3);
  const auto lists = make(world, EngineKind::neighbors, 0.3);
  lists->rebuild(Time(0), {PhaseKind::neighbors, 0.2});
  EXPECT_EQ(lists->lengths().skin, 0.2);
  EXPECT_EQ(lists->counters().rebuilds, 1U);
}

// Cells in which a sphere is large, and others.
TEST(MakeEngine, RebuildsWithTheCellsThatSuitTheLength) {
  const auto has_approach_lists = [](const EngineBase& engine) {
    const auto& cells = dynamic_cast<const Engine<CalendarQueue>&>(engine);
    return dynamic_cast<const LargeSphereGrid*>(&cells.phase()) != nullptr;
  };
  const auto engine = make(mixture(), EngineKind::cells, 1);
  EXPECT_TRUE(has_approach_lists(*engine));
  engine->rebuild(Time(0), {PhaseKind::cells, 9});
  EXPECT_FALSE(has_approach_lists(*engine));
  engine->rebuild(Time(0), {PhaseKind::cells, 1});
  EXPECT_TRUE(has_approach_lists(*engine));
}

TEST(MakeEngine, RefusesSubspacesSmallerThanASphere) {
  const World equal = gas(0.1);
  const auto paper = make(equal, EngineKind::paper, 2);
  EXPECT_NO_THROW(paper->rebuild(Time(0), {PhaseKind::cells, 2 * equal.largest_radius()}));
  EXPECT_THROW(paper->rebuild(Time(0), {PhaseKind::cells, 1.98 * equal.largest_radius()}), Error);
}

TEST(MakeEngine, IsTheOneThatCostsLeast) {
  EXPECT_EQ(choose(gas(0.01)), EngineKind::cells);
  EXPECT_EQ(choose(gas(0.35)), EngineKind::neighbors);
  EXPECT_EQ(choose(gas(0.35), {.cell_edge = 2}), EngineKind::cells);
  for (const double packing_fraction : {0.1, 0.15, 0.2, 0.22, 0.25, 0.3}) {
    const World world = gas(packing_fraction);
    const GasStatistics statistics = gas_statistics(world, Time(0));
    const double cells = best_cell_edge(statistics, {}).cost;
    const double lists = best_skin(statistics, {}).cost;
    EXPECT_EQ(choose(world), lists < cells ? EngineKind::neighbors : EngineKind::cells);
    EXPECT_EQ(choose(world, {}, EngineKind::cells),
              lists < 0.9 * cells ? EngineKind::neighbors : EngineKind::cells);
    EXPECT_EQ(choose(world, {}, EngineKind::neighbors),
              cells < 0.9 * lists ? EngineKind::cells : EngineKind::neighbors);
  }
}

TEST(MakeEngine, StaysWhereNothingMoves) {
  World world(Box::periodic({40, 40, 40}));
  for (int i = 0; i < 10; ++i) world.add({{3.0 + 3 * i, 5, 5}, {}, 0.5, 1});
  for (const EngineKind kind : {EngineKind::cells, EngineKind::neighbors}) {
    EXPECT_EQ(choose(world, {}, kind), kind);
  }
}

TEST(MakeEngine, HasTheBestLengthOfItsKind) {
  const World world = gas(0.1);
  const GasStatistics statistics = gas_statistics(world, Time(0));
  EXPECT_EQ(choose_length(world, statistics, EngineKind::cells, {}, Time(0)), optimal_cell_edge(statistics));
  EXPECT_EQ(choose_length(world, statistics, EngineKind::neighbors, {}, Time(0)), optimal_skin(statistics));
  EXPECT_GE(choose_length(world, statistics, EngineKind::paper, {}, Time(0)), 2 * world.largest_radius());
  for (const EngineKind kind : {EngineKind::cells, EngineKind::paper}) {
    EXPECT_EQ(choose_length(world, statistics, kind, {.cell_edge = 7}, Time(0)), 7);
  }
  EXPECT_EQ(choose_length(world, statistics, EngineKind::neighbors, {.cell_edge = 7}, Time(0)),
            optimal_skin(statistics));
  EXPECT_EQ(allowed_cell_edge(world, EngineKind::cells, 0.1), 0.1);
  EXPECT_EQ(allowed_cell_edge(world, EngineKind::paper, 0.1), 2 * world.largest_radius());
}

TEST(MakeEngine, RefusesThePapersAlgorithmForCurvedPaths) {
  const World world(Box::open(), {0, 0, -1});
  EXPECT_THROW(check_features({.engine = EngineKind::paper}, one_process(), world.features()), Error);
  EXPECT_NO_THROW(check_features({.engine = EngineKind::cells}, one_process(), world.features()));
}

}  // namespace
}  // namespace hardball::make_engine_test
