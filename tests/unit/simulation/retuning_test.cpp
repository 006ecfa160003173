// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Cells adapt to the spheres: when they are rebuilt, how often, and that nothing else changes.
#include <gtest/gtest.h>

#include <cmath>

#include "hardball/interaction/bounce.hpp"
#include "hardball/interaction/restitution.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/world/totals.hpp"
#include "support/gas.hpp"
#include "support/interacting.hpp"

namespace hardball::retuning_test {
namespace {

World burst() {
  return support::make_gas({.count = 600, .packing_fraction = 0.2, .seed = 401, .boundary = Boundary::open});
}

TEST(Retuning, CellsGrowWithACloudThatFliesApart) {
  Simulation simulation(burst());
  const double edge = simulation.cell_edge();
  simulation.run_until(1000);
  // The fastest are at a distance of about 4000, a thousand times the initial extent; most at half of that.
  EXPECT_GT(simulation.cell_edge(), 50 * edge);
  EXPECT_GE(simulation.counters().rebuilds, 3U);
  EXPECT_LE(simulation.counters().rebuilds, 40U) << "each lasts until the cloud has grown considerably";
  // With cells of the initial size, a sphere would make 1500 crossings along each axis.
  EXPECT_LT(simulation.counters().enter, 600U * 300U);
}

TEST(Retuning, ChangesNoContact) {
  Simulation tuned(burst());
  Simulation fixed(burst(), {.cell_edge = 3});
  tuned.run_until(100);
  fixed.run_until(100);
  EXPECT_GT(tuned.counters().rebuilds, 0U);
  EXPECT_EQ(fixed.counters().rebuilds, 0U);
  EXPECT_EQ(fixed.cell_edge(), 3);
  EXPECT_EQ(tuned.event_log_hash(), fixed.event_log_hash());
}

// The choice does not depend on speeds, and the density in a closed box is constant.
TEST(Retuning, DoesNotRebuildForAGasThatOnlyCools) {
  const World world = support::make_gas({.count = 500, .packing_fraction = 0.1, .seed = 402});
  Simulation simulation(support::interacting(world, Restitution(0.7)));
  simulation.run_contacts(20000);
  EXPECT_LT(kinetic_energy(simulation.world(), simulation.now()), 1e-3 * kinetic_energy(world, Time(0)));
  EXPECT_EQ(simulation.counters().rebuilds, 0U);
}

// Neighbor lists are best for a dense cloud, cells for a dilute one. The user's response is kept.
TEST(Retuning, ChangesTheEngineWhenADenseCloudFliesApart) {
  const auto dense = [] {
    return support::make_gas({.count = 800,
                              .packing_fraction = 0.45,
                              .seed = 405,
                              .boundary = Boundary::open,
                              .start = support::Start::simple_cubic});
  };
  Simulation chosen(dense());
  EXPECT_EQ(chosen.engine(), EngineKind::neighbors);
  EXPECT_GT(chosen.skin(), 0);
  EXPECT_EQ(chosen.cell_edge(), 0);
  Simulation cells(dense(), {.engine = EngineKind::cells});
  std::uint64_t asked = 0;
  for (Simulation* simulation : {&chosen, &cells}) {
    simulation->respond_with([&asked](const Contact& contact) {
      ++asked;
      return Restitution(0.95)(contact);
    });
    simulation->run_until(300);
  }
  EXPECT_EQ(chosen.engine(), EngineKind::cells);
  EXPECT_EQ(chosen.skin(), 0);
  EXPECT_GT(chosen.cell_edge(), 0);
  EXPECT_GT(chosen.counters().rebuilds, 0U);
  EXPECT_EQ(chosen.event_log_hash(), cells.event_log_hash());
  EXPECT_EQ(chosen.counters().contacts(), cells.counters().contacts()) << "those of both engines are counted";
  EXPECT_EQ(asked, chosen.counters().contacts() + cells.counters().contacts());
}

World shower() {
  const World gas =
      support::make_gas({.count = 500, .packing_fraction = 0.15, .seed = 406, .boundary = Boundary::wall});
  World world(gas.box(), {0, 0, -1});
  for (Slot slot = 0; slot < gas.size(); ++slot) {
    world.add(
        {gas.position(slot, Time(0)), gas.velocity(slot, Time(0)), gas.base_radius(slot), gas.mass(slot)});
  }
  return support::interacting(
      world, ResponseTable(Bounce({.restitution = ConstantRestitution{0.7}, .elastic_below = 0.05})));
}

TEST(Retuning, ListsShortenWhereSpheresHeapUp) {
  Simulation lists(shower(), {.engine = EngineKind::neighbors});
  Simulation cells(shower(), {.engine = EngineKind::cells});
  const double skin = lists.skin();
  for (Simulation* simulation : {&lists, &cells}) simulation->run_until(12);
  EXPECT_LT(lists.skin(), skin / 1.5);
  EXPECT_LE(lists.counters().rebuilds, 5U);
  EXPECT_EQ(lists.event_log_hash(), cells.event_log_hash());
}

TEST(Retuning, KeepsTheListsOfAFluid) {
  for (const double packing_fraction : {0.25, 0.35, 0.45}) {
    Simulation simulation(support::make_gas({.count = 512,
                                             .packing_fraction = packing_fraction,
                                             .seed = 407,
                                             .start = support::Start::simple_cubic}));
    simulation.run_contacts(20000);
    EXPECT_EQ(simulation.engine(), EngineKind::neighbors);
    EXPECT_EQ(simulation.counters().rebuilds, 0U) << packing_fraction;
  }
}

TEST(Retuning, TakesCellsWhereABoxIsTooSmallForLists) {
  World world(Box::periodic({3, 3, 3}));
  world.add({{0.5, 0.5, 0.5}, {1, 0.3, 0.2}, 0.5, 1});
  world.add({{2, 2, 2}, {-1, 0.1, 0.7}, 0.5, 1});
  const Simulation simulation(world, {.engine = EngineKind::neighbors});
  EXPECT_EQ(simulation.engine(), EngineKind::cells);
}

TEST(Retuning, IsForEnginesWithCells) {
  const World world = support::make_gas({.count = 30, .packing_fraction = 0.001, .seed = 404});
  Simulation simulation(world, {.engine = EngineKind::all_pairs});
  simulation.run_until(2000);
  EXPECT_GT(simulation.counters().enter, 8U * 30U) << "it has regions to leave too";
  EXPECT_EQ(simulation.counters().rebuilds, 0U);
}

TEST(Retuning, FollowsSpheresThatAreAddedAndRemoved) {
  Simulation simulation(support::make_gas({.count = 1000, .packing_fraction = 0.2, .seed = 403}));
  const double edge = simulation.cell_edge();
  for (SphereId id = 0; id < 990; ++id) simulation.remove(id);
  simulation.run_contacts(10, 100);
  EXPECT_GT(simulation.cell_edge(), 1.5 * edge);
}

}  // namespace
}  // namespace hardball::retuning_test
