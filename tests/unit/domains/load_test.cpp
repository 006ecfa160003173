// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/domains/load.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "hardball/simulation/simulation.hpp"
#include "support/gas.hpp"
#include "support/random_centers.hpp"

namespace hardball::load_test {
namespace {

TEST(Load, IsUnevenWhereDomainsWait) {
  EXPECT_EQ((Load{{100, 100, 100}, {}}.waited()), 0U);
  EXPECT_EQ((Load{{100, 300, 200}, {}}.waited()), 300U);
  EXPECT_FALSE((Load{{0, 400}, {}}.is_uneven(100)));
  EXPECT_TRUE((Load{{0, 401}, {}}.is_uneven(100)));
}

TEST(Load, HasShallowHalosWhereManyWindowsFail) {
  EXPECT_FALSE((Load{{1, 1}, {.windows = 320, .failed = 10}}.has_shallow_halos()));
  EXPECT_TRUE((Load{{1, 1}, {.windows = 320, .failed = 11}}.has_shallow_halos()));
}

// The blocks that are made have the same load, if spheres of a domain are alike.
TEST(Load, MovesCutsToWhereContactsAre) {
  const Box box = Box::periodic({20, 10, 10});
  const std::vector<Vec3> centers = support::random_centers(20000, {20, 10, 10});
  const Partition before = Partition::bisection(box, 2, centers);
  ASSERT_NEAR(before.block(0).high(0), 10, 0.2);
  const Partition after =
      Partition::bisection(box, 2, centers_by_load(centers, before, {{30000, 10000}, {}}));
  // Three quarters of the contacts are below 10, evenly: half of all are below 20 / 3.
  EXPECT_NEAR(after.block(0).high(0), 20.0 / 3, 0.2);
  const Partition same = Partition::bisection(box, 2, centers_by_load(centers, before, {{20000, 20000}, {}}));
  EXPECT_NEAR(same.block(0).high(0), before.block(0).high(0), 0.2);
}

// Fast spheres on one side, slow ones on the other.
TEST(Load, HasSystemsDividedAnew) {
  World world = support::make_gas({.count = 2000, .packing_fraction = 0.3, .seed = 11});
  const double middle = world.box().size().x / 2;
  for (Slot slot = 0; slot < world.size(); ++slot) {
    if (world.path(slot).position.x > middle)
      world.change_velocity(slot, Time(0), 0.01 * world.velocity(slot, Time(0)));
  }
  Simulation expected(world);
  Simulation divided(world, {.division = Division{.domains = 4, .window = 0.5}});
  const auto cuts = [&] {
    std::vector<double> places;
    for (const Block& block : divided.blocks()) {
      for (std::size_t axis = 0; axis < kAxes; ++axis) places.push_back(block.low(axis));
    }
    return places;
  };
  const std::vector<double> cuts_before = cuts();
  expected.run_contacts(60000);
  divided.run_contacts(60000);
  EXPECT_EQ(divided.event_log_hash(), expected.event_log_hash());
  EXPECT_EQ(divided.positions(), expected.positions());
  EXPECT_EQ(divided.tally().virial(), expected.tally().virial());
  EXPECT_NE(cuts(), cuts_before);
  EXPECT_EQ(expected.counters().collision, divided.counters().collision);
}

}  // namespace
}  // namespace hardball::load_test
