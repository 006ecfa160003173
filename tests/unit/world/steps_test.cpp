// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The levels of pairs in a world: where they come from, and how they follow spheres that come and go.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "hardball/archive/archive.hpp"
#include "hardball/errors/error.hpp"
#include "hardball/interaction/merging.hpp"
#include "hardball/interaction/passing.hpp"
#include "hardball/world/step_levels.hpp"
#include "hardball/world/totals.hpp"
#include "hardball/world/world.hpp"
#include "support/interacting.hpp"
#include "support/refusal.hpp"

namespace hardball::world_steps_test {
namespace {

constexpr double kDiameter = 1;

// Spheres on the x axis.
World row(const std::vector<double>& places, const std::vector<double>& velocities = {}) {
  World world(Box::open());
  for (std::size_t k = 0; k < places.size(); ++k) {
    const double velocity = velocities.empty() ? 0 : velocities[k];
    world.add({.position = {places[k], 0, 0}, .velocity = {velocity, 0, 0}, .radius = kDiameter / 2});
  }
  return world;
}

int level(const World& world, Slot a, Slot b) {
  const PairLevel* const pair = world.pair_levels().find(a, b);
  const PairLevel* const mirrored = world.pair_levels().find(b, a);
  EXPECT_EQ(pair == nullptr, mirrored == nullptr);
  if (!pair || !mirrored) return 0;
  EXPECT_EQ(pair->level, mirrored->level);
  return pair->level;
}

std::string error_of(World world) {
  return support::refusal_of([&] { assign_levels(world, Time(0)); });
}

TEST(Levels, FollowFromDistances) {
  World world = row({0, 1.1, 2.7, 6});
  world.set_interactions(support::stepping({.steps = {{1.25, -2}, {1.75, -1}}}));
  assign_levels(world, Time(0));
  EXPECT_EQ(level(world, 0, 1), 2);
  EXPECT_EQ(level(world, 1, 2), 1);
  EXPECT_EQ(level(world, 0, 2), 0);
  EXPECT_EQ(level(world, 2, 3), 0);
  EXPECT_EQ(world.pair_levels().size(), 2U);
  EXPECT_EQ(step_energy(world), -3);
  EXPECT_EQ(step_energy(world, 1), -1.5);
  EXPECT_EQ(energy(world, Time(0)), -3);
}

TEST(Levels, AtAStepAreInsideOfThoseThatApproach) {
  const Interactions well = support::stepping({.steps = {{1.5, -1}}});
  for (const double velocity : {-1.0, 0.0, 1.0}) {
    World world = row({0, 1.5}, {0, velocity});
    world.set_interactions(well);
    assign_levels(world, Time(0));
    EXPECT_EQ(level(world, 0, 1), velocity < 0 ? 1 : 0) << velocity;
  }
  // Half a unit in the last place nearer.
  World world = row({0x1p-54, 1.5}, {0, 1});
  world.set_interactions(well);
  assign_levels(world, Time(0));
  EXPECT_EQ(level(world, 0, 1), 0) << "the separation is rounded to the step";
}

TEST(Levels, ThroughPeriodicBoundaries) {
  World world({{Boundary::periodic, Boundary::wall, Boundary::wall}, {4, 4, 4}});
  world.add({.position = {0.25, 2, 2}, .radius = 0.5});
  world.add({.position = {3.5, 2, 2}, .radius = 0.5});
  world.set_interactions(support::stepping({.steps = {{1.5, -1}}}));
  assign_levels(world, Time(0));
  EXPECT_EQ(level(world, 0, 1), 1);
}

TEST(Levels, OfStepsThatReachToHalfOfTheBoxAreRefused) {
  World world({{Boundary::periodic, Boundary::wall, Boundary::wall}, {3, 4, 4}});
  world.add({.position = {0.5, 2, 2}, .radius = 0.5});
  world.set_interactions(support::stepping({.steps = {{1.5, -1}}}));
  EXPECT_NE(error_of(world).find("half of the periodic box"), std::string::npos);
  world.set_interactions(support::stepping({.steps = {{1.49, -1}}}));
  EXPECT_EQ(error_of(world), "");
}

TEST(Levels, OfBondsAreCheckedAtTheStart) {
  World world = row({0, 1.25});
  Interactions interactions;
  StepTable table;
  const StepTable::Number bond =
      table.add_bond(StepPotential({.steps = {{1.2, 0}}, .core = 0.9, .is_tether = true}));
  interactions.set_steps(table);
  world.set_interactions(interactions);
  EXPECT_THROW(add_bond(world, 0, 0, bond), Error);
  EXPECT_THROW(add_bond(world, 0, 5, bond), Error);
  EXPECT_THROW(add_bond(world, 0, 1, bond + 1), Error);
  add_bond(world, 1, 0, bond);
  EXPECT_THROW(add_bond(world, 0, 1, bond), Error) << "twice";
  EXPECT_NE(error_of(world).find("spheres 0 and 1 are tied"), std::string::npos);
  ASSERT_EQ(bonds_of(world).size(), 1U);
  EXPECT_EQ(bonds_of(world)[0], (Bond{0, 1, bond}));
  EXPECT_EQ(core_ratio(world, 0, 1), 0.9);
  World near = row({0, 0.95});
  near.set_interactions(interactions);
  add_bond(near, 0, 1, bond);
  assign_levels(near, Time(0));
  EXPECT_EQ(level(near, 0, 1), 1);
}

TEST(Levels, FollowSpheresThatAreRemovedAndReordered) {
  World world = row({0, 1.2, 2.4, 3.6});
  world.set_interactions(support::stepping({.steps = {{1.5, -1}}}));
  assign_levels(world, Time(0));
  const World before = world;
  world.begin_journal();
  world.remove(1, Time(1));
  EXPECT_EQ(world.pair_levels().size(), 1U);
  EXPECT_EQ(level(world, world.slot_of(2), world.slot_of(3)), 1);
  EXPECT_EQ(level(world, world.slot_of(0), world.slot_of(2)), 0);
  while (!world.journal().empty()) world.undo();
  world.end_journal();
  EXPECT_EQ(world.pair_levels().in_order(), before.pair_levels().in_order());
  const std::vector<Slot> order{2, 0, 3, 1};
  world.reorder(order);
  for (SphereId id = 0; id < 3; ++id) EXPECT_EQ(level(world, world.slot_of(id), world.slot_of(id + 1)), 1);
  EXPECT_EQ(world.pair_levels().size(), 3U);
}

TEST(Levels, AreSaved) {
  World world = row({0, 1.2, 2.4});
  world.set_interactions(support::stepping({.steps = {{1.5, -1}}}));
  assign_levels(world, Time(0));
  World loaded(Box::open());
  restore(archived(world), "test", loaded);
  EXPECT_EQ(loaded.pair_levels().in_order(), world.pair_levels().in_order());
  EXPECT_EQ(step_energy(loaded), -2);
  EXPECT_EQ(loaded.bounding_radius(0), 0.75);
}

TEST(Steps, ReachIntoRegions) {
  World world = row({0, 1.2});
  EXPECT_EQ(world.largest_bounding_radius(), 0.5);
  world.set_interactions(support::stepping({.steps = {{1.5, -1}}}));
  EXPECT_EQ(world.bounding_radius(0), 0.75);
  EXPECT_EQ(world.largest_bounding_radius(), 0.75);
  EXPECT_EQ(world.largest_radius(), 0.5);
}

TEST(Steps, ExcludeWhatTheyDoNotGoWith) {
  const StepRules well{.steps = {{1.5, -1}}};
  const auto refused = [](World world, const Interactions& interactions) -> std::string {
    return support::problem_of([&] { world.set_interactions(interactions); });
  };
  EXPECT_NE(refused(World(Box::open(), {0, 0, -1}), support::stepping(well)).find("gravity"),
            std::string::npos);
  ResponseTable merging{Merging()};
  Interactions merge(merging);
  merge.set_steps(support::stepping(well).steps());
  EXPECT_NE(refused(World(Box::open()), merge).find("merge"), std::string::npos);
  ResponseTable table;
  table.set(0, 1, Passing());
  Interactions pass(table);
  pass.set_steps(support::stepping(well).steps());
  EXPECT_NE(refused(World(Box::open()), pass).find("pass through"), std::string::npos);
  StepTable other;
  other.set(0, 0, StepPotential(well));
  pass.set_steps(other);
  EXPECT_EQ(refused(World(Box::open()), pass), "") << "of other species";
  World growing = row({0, 3});
  growing.set_interactions(support::stepping(well));
  EXPECT_THROW(growing.set_growth({Time(0), Time(1), 1, 0.1}), Error);
}

}  // namespace
}  // namespace hardball::world_steps_test
