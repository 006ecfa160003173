// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The work of the cell grid compared with kinetic theory: from dilute gas to dense fluid, with cells from one
// diameter to ten.
#include "hardball/tuning/cell_counts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/theory/gas_statistics.hpp"
#include "support/discs.hpp"
#include "support/effort.hpp"
#include "support/gas.hpp"
#include "support/record.hpp"

namespace hardball::cell_counts_test {
namespace {

struct Counted {
  double enters = 0;  // in total
  double enter = 0;   // per sphere and time
  double collision = 0;
  double wall = 0;
  double after_contact = 0;
  double after_enter = 0;
};

// Runs until the number of rows of cells left behind is stationary, then counts.
Counted count(const World& world, double edge, const CellCounts& expected) {
  const auto spheres = static_cast<double>(world.size());
  Simulation simulation(world, {.cell_edge = edge});
  const double unchanged = 1 / (expected.enter + expected.collision);  // time between two changes of region
  simulation.run_until(simulation.time() + 6 * unchanged);
  const Counters before = simulation.counters();
  const double start = simulation.time();
  // Enough of each kind for a standard error of 1%, as far as the time for a test allows.
  constexpr double kEvents = 10000;
  const double wanted =
      std::max(kEvents / (spheres * expected.collision), kEvents / (spheres * expected.enter));
  constexpr double kMaxPredictions = 2e7;
  const double affordable = kMaxPredictions / (spheres * expected.predictions());
  simulation.run_until(start + std::min(wanted, affordable));
  const Counters done = simulation.counters() - before;
  const double span = spheres * (simulation.time() - start);
  Counted counted;
  counted.enters = static_cast<double>(done.enter);
  counted.enter = counted.enters / span;
  counted.collision = 2 * static_cast<double>(done.collision) / span;
  counted.wall = static_cast<double>(done.wall) / span;
  const double passes = (counted.collision + counted.wall) * span;
  counted.after_contact = static_cast<double>(done.contact_predictions) / passes;
  counted.after_enter = static_cast<double>(done.enter_predictions) / counted.enters;
  return counted;
}

double after_contact(const CellCounts& expected) {
  return (expected.collision * expected.candidates_after_collision +
          expected.wall * expected.candidates_after_wall) /
         (expected.collision + expected.wall);
}

// 5%, or four standard errors where so few events were counted that these are larger.
double tolerance(double number) {
  return std::max(0.05, 4 / std::sqrt(number));
}

void expect_counts(const World& world, double edge, const std::string& name) {
  const CellCounts expected = expected_counts(gas_statistics(world, Time(0)), edge);
  const Counted counted = count(world, edge, expected);
  support::record(name + "_enter", counted.enter / expected.enter);
  support::record(name + "_after_contact", counted.after_contact / after_contact(expected));
  support::record(name + "_after_enter", counted.after_enter / expected.candidates_after_enter);
  EXPECT_NEAR(counted.enter / expected.enter, 1, tolerance(counted.enters)) << name;
  EXPECT_NEAR(counted.after_contact / after_contact(expected), 1, 0.05) << name;
  // A crossing finds few candidates in a dilute gas: then their number limits the precision.
  const double found = counted.enters * std::min(1.0, counted.after_enter);
  // The candidates in a row are known less precisely: the spheres near the one that enters, and rows not yet
  // released.
  EXPECT_NEAR(counted.after_enter / expected.candidates_after_enter, 1, std::max(0.08, tolerance(found)))
      << name;
  EXPECT_NEAR(counted.collision / expected.collision, 1, 0.05) << name;
}

class CellCountsOfGas : public testing::TestWithParam<double> {};

TEST_P(CellCountsOfGas, AreThoseExpectedFromOneDiameterToTen) {
  const double packing_fraction = GetParam();
  const std::size_t spheres = 8000;
  const bool is_dense = packing_fraction > 0.3;
  const support::Gas gas{.count = spheres,
                         .packing_fraction = packing_fraction,
                         .seed = 301,
                         .start = is_dense ? support::Start::simple_cubic : support::Start::random};
  // A dense start is a lattice that has to melt; a dilute one is disordered from the start.
  const double collisions_per_sphere = is_dense ? 150 : packing_fraction < 0.05 ? 0.1 : 2;
  const World world = support::settled(support::make_gas(gas), collisions_per_sphere);
  const double box = support::cube_edge(spheres, packing_fraction);
  for (const double edge : {1.0, 1.5, 2.0, 3.0, 5.0, 10.0}) {
    if (edge > box / 2) continue;
    expect_counts(world, edge, "diameters_" + to_text(edge));
    if (support::kIsSlowBuild) break;
  }
}

INSTANTIATE_TEST_SUITE_P(Packing, CellCountsOfGas, testing::Values(0.001, 0.01, 0.05, 0.1, 0.25, 0.45),
                         [](const auto& each) {
                           return "Permille" + to_text(std::lround(1000 * each.param));
                         });

// Half of the spheres have half the diameter: the theory depends only on the statistics of the radii.
TEST(CellCounts, OfAMixtureAreThoseExpected) {
  const std::size_t spheres = 8000;
  std::vector<double> radii;
  for (std::size_t i = 0; i < spheres; ++i) radii.push_back(i % 2 == 0 ? 0.5 : 0.25);
  const double edge = support::cube_edge(spheres / 2, 0.1 * 8 / 9);
  const Vec3 size{edge, edge, edge};
  Random random(302);
  World world(Box::periodic(size));
  const std::vector<Vec3> centers = place_randomly(world.box(), {{}, size}, radii, random, "mixture");
  const std::vector<Vec3> velocities = support::thermal_velocities(std::vector<double>(spheres, 1), random);
  for (std::size_t i = 0; i < spheres; ++i) {
    world.add({.position = centers[i], .velocity = velocities[i], .radius = radii[i]});
  }
  world = support::settled(std::move(world), 1);
  expect_counts(world, 1.3, "narrow_cells");
  expect_counts(world, 3, "wide_cells");
}

class CellCountsOfDiscs : public testing::TestWithParam<double> {};

TEST_P(CellCountsOfDiscs, AreThoseExpectedFromOneDiameterToTen) {
  const double packing_fraction = GetParam();
  const World world =
      support::settled(support::make_discs(8000, packing_fraction, 304), packing_fraction < 0.05  ? 0.3
                                                                         : packing_fraction > 0.5 ? 150
                                                                                                  : 5);
  for (const double edge : {1.0, 1.5, 2.0, 3.0, 5.0, 10.0}) {
    expect_counts(world, edge, "diameters_" + to_text(edge));
    if (support::kIsSlowBuild) break;
  }
}

INSTANTIATE_TEST_SUITE_P(Packing, CellCountsOfDiscs, testing::Values(0.01, 0.1, 0.3, 0.6),
                         [](const auto& each) {
                           return "Permille" + to_text(std::lround(1000 * each.param));
                         });

// The effect of walls on spheres nearby is known to first order only.
TEST(CellCounts, BetweenWallsAreThoseExpected) {
  std::vector<World> worlds{support::settled(support::make_discs(8000, 0.05, 305, Boundary::wall), 2)};
  for (const double packing_fraction : {0.002, 0.02}) {
    worlds.push_back(support::settled(
        support::make_gas(
            {.count = 8000, .packing_fraction = packing_fraction, .seed = 303, .boundary = Boundary::wall}),
        1));
  }
  for (const World& world : worlds) {
    for (const double edge : {2.0, 8.0}) {
      const CellCounts expected = expected_counts(gas_statistics(world, Time(0)), edge);
      const Counted counted = count(world, edge, expected);
      EXPECT_NEAR(counted.enter / expected.enter, 1, 0.05);
      EXPECT_NEAR(counted.wall / expected.wall, 1, 0.08);
      EXPECT_NEAR(counted.after_contact / after_contact(expected), 1, 0.08);
      EXPECT_NEAR(counted.after_enter / expected.candidates_after_enter, 1, 0.08);
    }
  }
}

}  // namespace
}  // namespace hardball::cell_counts_test
