// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/growth/growth_schedule.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "hardball/errors/error.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/world/totals.hpp"
#include "hardball/world/walls.hpp"
#include "support/gas.hpp"

namespace hardball::growth_schedule_test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(GrowthSchedule, RefusesRulesThatLeadNowhere) {
  EXPECT_NO_THROW(GrowthSchedule{GrowthRules()});
  EXPECT_THROW(GrowthSchedule(GrowthRules{.rate = 0}), Error);
  EXPECT_THROW(GrowthSchedule(GrowthRules{.rate = kInfinity}), Error);
  EXPECT_THROW(GrowthSchedule(GrowthRules{.rate = std::nan("")}), Error);
  EXPECT_THROW(GrowthSchedule(GrowthRules{.rate = -0.1}), Error);
  EXPECT_THROW(GrowthSchedule(GrowthRules{.until_packing_fraction = -0.1}), Error);
  EXPECT_THROW(GrowthSchedule(GrowthRules{.until_compressibility = 1}), Error);
}

// The mean diameter grows by the rate times sqrt(kT/m).
TEST(GrowthSchedule, TakesTheRateRelativeToTheThermalSpeed) {
  for (const double speed : {0.5, 1.0, 3.0}) {
    World world(Box::periodic({20, 20, 20}));
    // Diameters of 1 and 3, 2 on average; m v^2 = 3 kT.
    world.add({.position = {5, 5, 5}, .velocity = {speed * std::sqrt(3.0), 0, 0}, .radius = 0.5});
    world.add({.position = {15, 15, 15}, .velocity = {0, -speed * std::sqrt(3.0), 0}, .radius = 1.5});
    Tally tally;
    tally.begin(world, Time(0));
    GrowthSchedule schedule({.rate = 0.1, .until_packing_fraction = 0.3});
    // Of few spheres it is not known how dense they are.
    EXPECT_EQ(schedule.begin(world, tally, Time(0)).rate, 0);
    EXPECT_EQ(schedule.state(), GrowthSchedule::State::measuring);
    const Growth epoch = schedule.begin(world, tally, Time(0), 1.0);
    EXPECT_NEAR(2 * epoch.rate, 0.1 * speed, 1e-15);
    EXPECT_EQ(epoch.scale, 1);
    EXPECT_EQ(epoch.end, Time(schedule.next()));
    EXPECT_NEAR(epoch.scale_at(epoch.end), 1.02, 1e-12);
    EXPECT_GE(epoch.largest_scale(), epoch.scale_at(epoch.end));
  }
}

// Where spheres are dense, no epoch is so long that the energy more than doubles, and so they never jam in
// one.
TEST(GrowthSchedule, TakesSmallStepsWhereThePressureIsHigh) {
  Simulation simulation(support::make_gas({.count = 500, .packing_fraction = 0.3}));
  simulation.grow({.rate = 0.1, .until_compressibility = 1e5});
  double energy = kinetic_energy(simulation.world(), simulation.now());
  double scale = 1;
  while (!simulation.growth()->is_over()) {
    const Growth epoch = simulation.world().motion().growth();
    EXPECT_LE(epoch.scale_at(epoch.end) / scale, 1.02 + 1e-12);
    simulation.run({.until = Time(simulation.growth()->next()), .contacts = 1000000});
    const double now = kinetic_energy(simulation.world(), simulation.now());
    // The steepness is that of the epoch before. Halved velocities have a quarter of the energy.
    EXPECT_LT(now, 3 * energy);
    energy = now;
    scale = simulation.world().motion().scale_at(simulation.now());
  }
  EXPECT_EQ(simulation.growth()->state(), GrowthSchedule::State::over_pressure);
  EXPECT_GT(simulation.growth()->compressibility(), 1e5);
  EXPECT_LT(simulation.growth()->energy(), 0);
}

// From a start in which contacts come a thousand times as often as in a fluid, windows of constant size find
// that out before anything grows.
TEST(GrowthSchedule, MeasuresADenseStartFirst) {
  Simulation simulation(
      support::make_gas({.count = 500, .packing_fraction = 0.735, .start = support::Start::fcc}));
  simulation.grow({.rate = 0.1, .until_packing_fraction = 0.738});
  EXPECT_EQ(simulation.growth()->state(), GrowthSchedule::State::measuring);
  EXPECT_EQ(simulation.world().motion().growth().rate, 0);
  while (simulation.growth()->state() == GrowthSchedule::State::measuring)
    simulation.run_until(simulation.growth()->next());
  EXPECT_GT(simulation.growth()->compressibility(), 100);
  while (!simulation.growth()->is_over()) simulation.run_until(simulation.growth()->next());
  EXPECT_EQ(simulation.growth()->state(), GrowthSchedule::State::reached);
}

TEST(GrowthSchedule, NamesItsStates) {
  EXPECT_EQ(name_of(GrowthSchedule::State::measuring), "measuring");
  EXPECT_EQ(name_of(GrowthSchedule::State::no_room), "no_room");
}

}  // namespace
}  // namespace hardball::growth_schedule_test
