// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/pressure.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hardball/simulation/simulation.hpp"
#include "support/gas.hpp"
#include "support/interacting.hpp"
#include "support/measurement.hpp"

namespace hardball::pressure_test {
namespace {

using support::has_quantity;
using support::quantity;

// Two spheres of diameter 1 and mass 2 meet head-on at relative speed 4, at 1, 3.25 and 5.5.
TEST(Pressure, OfAHeadOnPairInAPeriodicBoxMatchesAHandCalculation) {
  World world(Box::periodic({10, 10, 10}));
  world.add({{1, 5, 5}, {3, 0, 0}, 0.5, 2});
  world.add({{6, 5, 5}, {-1, 0, 0}, 0.5, 2});
  Simulation simulation(world);
  Pressure pressure({simulation.world(), simulation.now()});
  simulation.on_contact([&](const Contact& contact) { pressure.note(contact); });
  simulation.run_until(6);
  const Measurement found = pressure.result({simulation.world(), simulation.now()});
  // Relative to the drift of 1 both move at 2: sum m v v = 16. Each collision gives the impulse 8 over the
  // distance 1, three in 6 units of time.
  EXPECT_DOUBLE_EQ(quantity(found, "pressure_xx").value, (16 + 24.0 / 6) / 1000);
  EXPECT_DOUBLE_EQ(quantity(found, "pressure").value, (16 + 24.0 / 6) / 3000);
  EXPECT_DOUBLE_EQ(quantity(found, "compressibility").value, 1 + 4.0 / 16);
  for (const char* name : {"pressure_yy", "pressure_zz", "pressure_xy", "pressure_xz", "pressure_yz"}) {
    EXPECT_NEAR(quantity(found, name).value, 0, 1e-15) << name;
  }
  EXPECT_FALSE(has_quantity(found, "wall_pressure"));
}

// A sphere at 2 meets one at rest, and stops: relative to the drift of 1 at the start both move at 1, before
// and after. The impulse is 2 over the distance 1, once in 4 units of time.
TEST(Pressure, DoesNotAssumeConservedMomentum) {
  World world(Box::periodic({10, 10, 10}));
  world.add({{1, 5, 5}, {2, 0, 0}, 0.5});
  world.add({{4, 5, 5}, {}, 0.5});
  Simulation simulation(world);
  simulation.respond_with([](const Contact&) { return Velocities{}; });
  Pressure pressure({simulation.world(), simulation.now()});
  simulation.on_contact([&](const Contact& contact) { pressure.note(contact); });
  simulation.run_until(4);
  const Measurement found = pressure.result({simulation.world(), simulation.now()});
  EXPECT_DOUBLE_EQ(quantity(found, "pressure_xx").value, (2 + 2.0 / 4) / 1000);
}

// Head-on along the diagonal of the xy plane: all four components of that plane are equal.
TEST(Pressure, HasOffDiagonalComponents) {
  const double a = std::sqrt(0.5);
  World world(Box::periodic({10, 10, 10}));
  world.add({{3, 3, 5}, {a, a, 0}, 0.5});
  world.add({{5, 5, 5}, {-a, -a, 0}, 0.5});
  Simulation simulation(world);
  Pressure pressure({simulation.world(), simulation.now()});
  simulation.on_contact([&](const Contact& contact) { pressure.note(contact); });
  simulation.run_until(4);
  const Measurement found = pressure.result({simulation.world(), simulation.now()});
  // sum m v v = 1 in each component; one collision of impulse 2 over distance 1, half of it in each.
  const double expected = (1 + 1.0 / 4) / 1000;
  for (const char* name : {"pressure_xx", "pressure_yy", "pressure_xy"}) {
    EXPECT_NEAR(quantity(found, name).value, expected, 1e-15) << name;
  }
  EXPECT_NEAR(quantity(found, "pressure_xz").value, 0, 1e-15);
  EXPECT_NEAR(quantity(found, "compressibility").value, 1.25, 1e-12);
}

// A sphere that bounces back and forth over a length of 9 at speed 3 hits each wall every 6 units of time
// with the impulse 6.
TEST(Pressure, OfOneSphereOnWallsIsItsImpulse) {
  World world(Box::walls({10, 20, 20}));
  world.add({{5, 5, 5}, {3, 0, 0}, 0.5});
  Simulation simulation(world);
  Pressure pressure({simulation.world(), simulation.now()});
  simulation.on_contact([&](const Contact& contact) { pressure.note(contact); });
  simulation.run_until(60);
  const Measurement found = pressure.result({simulation.world(), simulation.now()});
  for (const char* name : {"wall_pressure_x_min", "wall_pressure_x_max"}) {
    EXPECT_NEAR(quantity(found, name).value, 1.0 / 400, 1e-15) << name;
    EXPECT_NEAR(quantity(found, name).theory, 1.0 / 400, 1e-15) << name;
  }
  EXPECT_EQ(quantity(found, "wall_pressure_y_min").value, 0);
  EXPECT_NEAR(quantity(found, "wall_pressure").value, 1.0 / (400 + 200 + 200), 1e-15);
  EXPECT_NEAR(quantity(found, "compressibility_from_walls").value, 1, 1e-12);
  EXPECT_NEAR(quantity(found, "compressibility").value, 1, 1e-12);
}

TEST(Pressure, AgreesWithTheTallyOfTheRun) {
  for (const Boundary boundary : {Boundary::periodic, Boundary::wall}) {
    Simulation simulation(
        support::make_gas({.count = 200, .packing_fraction = 0.2, .seed = 6, .boundary = boundary}));
    Pressure pressure({simulation.world(), simulation.now()});
    simulation.on_contact([&](const Contact& contact) { pressure.note(contact); });
    simulation.run_contacts(5000);
    const Measurement found = pressure.result({simulation.world(), simulation.now()});
    ASSERT_EQ(found.transient, 0) << "the tally counts all of the run";
    const Tally& tally = simulation.tally();
    EXPECT_NEAR(quantity(found, "compressibility").value, tally.compressibility(simulation.now()), 1e-12);
    if (boundary == Boundary::periodic) continue;
    EXPECT_NEAR(quantity(found, "wall_pressure").value,
                tally.wall_pressure(simulation.world().box(), simulation.now()), 1e-12);
  }
}

TEST(Pressure, HasNoTheoryWhereEnergyIsLost) {
  Simulation simulation(support::interacting(
      support::make_gas({.count = 100, .packing_fraction = 0.2, .seed = 6}), Restitution(0.9)));
  Pressure pressure({simulation.world(), simulation.now()});
  EXPECT_GT(quantity(pressure.result({simulation.world(), simulation.now()}), "compressibility").theory, 2);
  simulation.on_contact([&](const Contact& contact) { pressure.note(contact); });
  simulation.run_contacts(100);
  EXPECT_TRUE(std::isnan(
      quantity(pressure.result({simulation.world(), simulation.now()}), "compressibility").theory));
}

TEST(Pressure, HasNoMeaningInOpenSpace) {
  const World world = support::make_gas({.count = 10, .boundary = Boundary::open});
  const Pressure pressure({world, Time(0)});
  EXPECT_TRUE(pressure.result({world, Time(1)}).quantities.empty());
}

}  // namespace
}  // namespace hardball::pressure_test
