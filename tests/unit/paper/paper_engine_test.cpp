// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/paper/paper_engine.hpp"

#include <gtest/gtest.h>

#include "support/run_engine.hpp"

namespace hardball::paper_engine_test {
namespace {

TEST(PaperEngine, CountsEveryEnterAndLeave) {
  World world;
  world.add({{0.75, 0.75, 0.75}, {1, 0, 0}, 0.25, 1});
  PaperEngine engine(world, 1.5, Time(0));
  support::run(engine, {.until = Time(30)}, [](const Contact&) {});
  // It moves from 0.75 to 30.75: its front passes 1.5, 3, ... 30 and its back 1.5, ... 30.
  EXPECT_EQ(engine.counters().enter, 20U);
  EXPECT_EQ(engine.counters().leave, 20U);
}

TEST(PaperEngine, RemovesCandidatesThatNoLongerShareASubspace) {
  // Two spheres that will meet far away share a subspace for a while, part, and share another when they meet.
  World world;
  world.add({{0.5, 0.5, 0.5}, {1, 0, 0}, 0.25, 1});
  world.add({{0.625, 1.5, 0.5}, {1, -0.0625, 0}, 0.25, 1});
  PaperEngine engine(world, 2, Time(0));
  const auto contacts_met = [&] { return engine.counters().contacts(); };
  while (contacts_met() == 0) {
    ASSERT_EQ(support::run(engine, {.until = Time(100), .steps = 1}, [](const Contact&) {}),
              RunStatus::steps_reached);
    engine.validate();
  }
  EXPECT_GT(engine.counters().leave, 2U);
}

TEST(PaperEngine, RefusesSubspacesSmallerThanASphere) {
  World world;
  world.add({{0, 0, 0}, {1, 0, 0}, 1, 1});
  EXPECT_THROW(PaperEngine(world, 1.99, Time(0)), Error);
  EXPECT_NO_THROW(PaperEngine(world, 2, Time(0)));
}

}  // namespace
}  // namespace hardball::paper_engine_test
