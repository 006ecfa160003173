// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/theory/fluid_theory.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "hardball/theory/gas_statistics.hpp"
#include "hardball/theory/kinetic_theory.hpp"
#include "hardball/tuning/cell_axes.hpp"
#include "hardball/tuning/cell_edge.hpp"
#include "hardball/tuning/neighbor_counts.hpp"
#include "support/gas.hpp"
#include "support/interacting.hpp"

namespace hardball::fluid_theory_test {
namespace {

using namespace support;

World dense_gas(std::size_t count, double packing_fraction, double diameter, Boundary boundary) {
  const double edge = diameter * cube_edge(count, packing_fraction);
  const Box box({boundary, boundary, boundary}, {edge, edge, edge});
  World world(box);
  for (std::size_t i = 0; i < count; ++i) {
    world.add({.position = {edge / 2, edge / 2, edge / 2}, .radius = diameter / 2, .mass = 2});
  }
  return world;
}

FluidTheory theory_of(const World& world) {
  return {world, SpeciesList(world)};
}

// So many that it does not matter that their number and energy are fixed.
constexpr std::size_t kMany = 200000;

// Monte Carlo results of Wu and Sadus, AIChE J. 51 (2005) 309, at densities of 0.6 and 0.75, and rows of the
// table of Heyes et al.'s coefficients.
TEST(FluidTheory, HasTheCompressibilityOfSimulations) {
  EXPECT_NEAR(fluid_compressibility(0.6 * std::numbers::pi / 6), 4.2952, 4e-4);
  EXPECT_NEAR(fluid_compressibility(0.75 * std::numbers::pi / 6), 6.6566, 2e-3);
  EXPECT_NEAR(fluid_compressibility(0.2), 2.40940, 1e-5);
  EXPECT_NEAR(fluid_compressibility(0.494), 12.50009, 1e-5);
  // The second virial coefficient is four times the volume of a sphere.
  EXPECT_NEAR((fluid_compressibility(1e-6) - 1) / 1e-6, 4, 1e-4);
}

TEST(FluidTheory, ScalesWithTheUnits) {
  constexpr double kDiameter = 3;
  constexpr double kMass = 2;
  constexpr double kTemperature = 5;
  const FluidTheory theory = theory_of(dense_gas(kMany, 0.2, kDiameter, Boundary::periodic));
  const double speed = std::sqrt(kTemperature / kMass);
  EXPECT_NEAR(theory.compressibility(), 2.40940, 1e-5);
  EXPECT_NEAR(theory.collision_rate(kTemperature) * kDiameter / speed, 4.77102, 1e-4);
  EXPECT_NEAR(theory.mean_speed(kTemperature), std::sqrt(8 / std::numbers::pi) * speed, 1e-5 * speed);
  EXPECT_NEAR(theory.enskog_diffusion(kTemperature) / (kDiameter * speed), 0.3204, 1e-3);
  const FluidTheory of_speedy = theory_of(dense_gas(500, 0.2, kDiameter, Boundary::periodic));
  EXPECT_NEAR(of_speedy.diffusion(kTemperature) / (kDiameter * speed), 0.3744, 1e-4);
}

// Means of 12 runs of 2000 mean free times each, of spheres without total momentum and with 3 n / 2 as their
// energy; each is known to three units of the last digit or better.
// tests/statistics/measures_at_defaults_test.cpp has more of them.
TEST(FluidTheory, HoldsForFewSpheres) {
  const auto expect = [](std::size_t count, double packing_fraction, double rate, double speed, double z) {
    const FluidTheory theory = theory_of([&] {
      World world(Box::periodic(cube_edge(count, packing_fraction) * Vec3{1, 1, 1}));
      for (std::size_t i = 0; i < count; ++i) world.add({.position = {}, .radius = 0.5, .mass = 1});
      return world;
    }());
    const auto n = static_cast<double>(count);
    const double temperature = n / (n - 1);
    EXPECT_NEAR(theory.collision_rate(temperature), rate, 1e-3 * rate + theory.tolerance() * rate);
    EXPECT_NEAR(theory.mean_speed(temperature), speed, 5e-4 * speed);
    EXPECT_NEAR(theory.compressibility() - 1, z - 1, 3e-3 * (z - 1) + theory.tolerance() * (z - 1));
  };
  expect(100, 0.02, 0.2835, 1.5973, 1.0841);
  expect(100, 0.1, 1.7624, 1.5975, 1.5224);
  expect(100, 0.3, 10.118, 1.5974, 3.9997);
  expect(125, 0.49, 38.27, 1.5968, 12.341);
  expect(500, 0.02, 0.28462, 1.59599, 1.08416);
  expect(500, 0.1, 1.76454, 1.59593, 1.5219);
}

TEST(FluidTheory, DiffusionGrowsWithTheBox) {
  // The same runs, at a temperature of n / (n - 1).
  const auto expect = [](std::size_t count, double packing_fraction, double constant) {
    World world(Box::periodic(cube_edge(count, packing_fraction) * Vec3{1, 1, 1}));
    for (std::size_t i = 0; i < count; ++i) world.add({.position = {}, .radius = 0.5, .mass = 1});
    const auto n = static_cast<double>(count);
    EXPECT_NEAR(theory_of(world).diffusion(n / (n - 1)) / constant, 1, 0.03) << count;
  };
  expect(100, 0.1, 0.895);
  expect(100, 0.3, 0.1704);
  expect(125, 0.49, 0.0214);
  expect(4000, 0.3, 0.1937);
  expect(4096, 0.49, 0.0250);
}

// A collision rate, too, where every sphere has its own radius.
TEST(FluidTheory, HasARateForAnyRadii) {
  World many(Box::periodic({30, 30, 30}));
  World one(Box::periodic({30, 30, 30}));
  for (int i = 0; i < 1000; ++i) {
    many.add({.position = {}, .radius = 0.5 * (1 + 1e-9 * i), .mass = 1});
    one.add({.position = {}, .radius = 0.5, .mass = 1});
  }
  const double rate = theory_of(one).collision_rate(1);
  EXPECT_NEAR(theory_of(many).collision_rate(1) / rate, 1, 1e-3) << "up to the equations of state";
  EXPECT_NEAR(theory_of(many).mean_speed(1) / theory_of(one).mean_speed(1), 1, 1e-12);
}

TEST(FluidTheory, HoldsNeitherBetweenWallsNorInACrystal) {
  EXPECT_TRUE(theory_of(dense_gas(200, 0.49, 1, Boundary::periodic)).holds());
  for (const World& world :
       {dense_gas(200, 0.2, 1, Boundary::wall), dense_gas(200, 0.5, 1, Boundary::periodic), World()}) {
    const FluidTheory theory = theory_of(world);
    EXPECT_FALSE(theory.holds());
    EXPECT_TRUE(std::isnan(theory.compressibility()));
    EXPECT_TRUE(std::isnan(theory.diffusion(1)));
    EXPECT_TRUE(std::isnan(theory.mean_speed(1)));
  }
}

TEST(FluidTheory, OfSpheresThatAllPassThroughEachOtherIsThatOfAnIdealGas) {
  constexpr double kCount = 200;
  for (const double packing_fraction : {0.2, 0.6}) {
    const World fluid = dense_gas(200, packing_fraction, 1, Boundary::periodic);
    const World gas = interacting(fluid, passing({{0, 0}}));
    const FluidTheory theory = theory_of(gas);
    EXPECT_TRUE(theory.is_ideal());
    EXPECT_TRUE(theory.holds());
    EXPECT_EQ(theory.compressibility(), 1);
    EXPECT_NEAR(theory.contact_value(0, 0), 1 - 1 / kCount, 1e-12);
    EXPECT_TRUE(std::isnan(theory.diffusion(1)));
    EXPECT_TRUE(std::isnan(theory.enskog_diffusion(1)));
    EXPECT_FALSE(theory_of(fluid).is_ideal());
  }
}

TEST(FluidTheory, HoldsNotWhereSomePassAndWhereSomeAreKinematic) {
  World some = dense_gas(200, 0.2, 1, Boundary::periodic);
  some.add({.position = {1, 1, 1}, .radius = 0.5, .mass = 2, .species = 1});
  EXPECT_FALSE(theory_of(interacting(some, passing({{0, 1}}))).holds());
  EXPECT_FALSE(theory_of(interacting(some, passing({{0, 0}}))).holds());
  EXPECT_TRUE(theory_of(interacting(some, passing({{0, 0}, {0, 1}, {1, 1}}))).is_ideal());
  EXPECT_TRUE(theory_of(interacting(some, passing({{2, 3}}))).holds()) << "there are none";
  World heavy = dense_gas(200, 0.2, 1, Boundary::periodic);
  heavy.add({.position = {1, 1, 1}, .radius = 0.5, .mass = std::numeric_limits<double>::infinity()});
  EXPECT_FALSE(theory_of(heavy).holds());
}

// A mixture of almost equal spheres is a fluid of equal ones, within the difference of the two equations.
TEST(FluidTheory, OfAMixtureOfAlmostEqualSpheresIsThatOfEqualOnes) {
  World world = dense_gas(kMany / 2, 0.1, 1, Boundary::periodic);
  for (std::size_t i = 0; i < kMany / 2; ++i)
    world.add({.position = {1, 1, 1}, .radius = 0.5000001, .mass = 2});
  const FluidTheory theory = theory_of(world);
  const FluidTheory equal = theory_of(dense_gas(kMany, 0.2, 1, Boundary::periodic));
  EXPECT_NEAR(theory.compressibility(), 2.40625, 2e-5) << "Carnahan and Starling";
  EXPECT_NEAR(theory.contact_value(0, 1), (2.40625 - 1) / 0.8, 1e-5);
  EXPECT_NEAR(theory.collision_rate(2) / equal.collision_rate(2), 1, 4e-3);
  EXPECT_NEAR(theory.collision_rate(0, 1, 2) / theory.collision_rate(2), 0.5, 1e-6);
  EXPECT_TRUE(std::isnan(theory.diffusion(1)));
}

TEST(SpeciesList, AreKindsInTheOrderOfIds) {
  World world;
  world.add({.position = {0, 0, 0}, .radius = 2, .mass = 1});
  world.add({.position = {9, 0, 0}, .radius = 1, .mass = 1});
  world.add({.position = {18, 0, 0}, .radius = 2, .mass = 1});
  world.add({.position = {27, 0, 0}, .radius = 2, .mass = 3});
  const SpeciesList species(world);
  ASSERT_EQ(species.size(), 3U);
  EXPECT_EQ(species.of(2), 0U);
  EXPECT_EQ(species.of(1), 1U);
  EXPECT_EQ(species.of(3), 2U);
  EXPECT_EQ(species.count(0), 2U);
  EXPECT_EQ(species.radius(0), 2);
  EXPECT_EQ(species.mass(2), 3);
  EXPECT_EQ(species.fraction(0), 0.5);
  EXPECT_EQ(species.suffix(2), "_3");
  EXPECT_FALSE(species.is_one_kind());
}

TEST(SpeciesList, OfTooManyKindsAreOne) {
  World world;
  for (int i = 0; i < 9; ++i) world.add({.position = {50.0 * i, 0, 0}, .radius = 1.0 + i});
  const SpeciesList species(world);
  EXPECT_EQ(species.size(), 1U);
  EXPECT_EQ(species.count(0), 9U);
  EXPECT_EQ(species.of(8), 0U);
  EXPECT_TRUE(std::isnan(species.radius(0)));
  EXPECT_EQ(species.suffix(0), "");
  EXPECT_FALSE(species.is_one_kind());
}

// Kinetic theory and the choice of cells in two dimensions.

constexpr double kPi = std::numbers::pi;

// Equal discs of diameter one at mean speed one in a square.
GasStatistics statistics_of_discs(double packing_fraction, Boundary boundary = Boundary::periodic) {
  GasStatistics statistics;
  statistics.spheres = 10000;
  double power = 1;
  for (double& mean : statistics.radius_power) {
    mean = power;
    power /= 2;
  }
  statistics.largest_radius = 0.5;
  statistics.mean_speed = 1;
  const double edge = std::sqrt(10000 * kPi / 4 / packing_fraction);
  statistics.box = Box({boundary, boundary, Boundary::flat}, {edge, edge, 0});
  statistics.extent = statistics.box.size();
  return statistics;
}

// Source: Kolafa and Rottner, Mol. Phys. 104 (2006) 3435, table 1, by molecular dynamics.
TEST(TheoryOfDiscs, AgreesWithPublishedSimulations) {
  const std::array<std::pair<double, double>, 6> kTable = {{{0.4, 2.1514393},
                                                            {0.5, 2.7601235},
                                                            {0.6, 3.663691},
                                                            {0.7, 5.082362},
                                                            {0.8, 7.476491},
                                                            {0.88, 10.2309}}};
  for (const auto& [density, tabulated] : kTable) {
    const double packing = kPi / 4 * density;
    EXPECT_NEAR(fluid_compressibility_of_discs(packing), tabulated, 4e-5 * tabulated);
    const GasStatistics statistics = statistics_of_discs(packing);
    EXPECT_NEAR(statistics.packing_fraction(), packing, 1e-12);
    EXPECT_NEAR(compressibility(statistics), tabulated, 4e-5 * tabulated);
    const double contact = (tabulated - 1) / (2 * packing);
    // w = 2 sqrt(pi) n sigma chi sqrt(kT / m), and the mean speed is sqrt(pi / 2 kT / m).
    const double rate = 2 * std::sqrt(2.0) * density * contact;
    EXPECT_NEAR(mean_free_time(statistics), 1 / rate, 1e-4 / rate);
  }
}

// Of B3 to B5: Clisby and McCoy, J. Stat. Phys. 122 (2006) 15.
TEST(TheoryOfDiscs, HasThePublishedVirialCoefficients) {
  const double x = 0.01;
  const double series =
      1 + 2 * x * (1 + 0.7820044 * 2 * x + 0.5322318 * 4 * x * x + 0.3335560 * 8 * x * x * x);
  EXPECT_NEAR(fluid_compressibility_of_discs(x), series, 1e-8);
}

// A disc excludes others from four times its area, and a touching pair, at contact 1.5636 times as likely per
// packing fraction, from 4 + 4 - 25/16.
TEST(TheoryOfDiscs, ExcessAboutADiscIsTheAreaItExcludes) {
  const double packing = 1e-5;
  const GasStatistics statistics = statistics_of_discs(packing);
  EXPECT_NEAR(excess_about_sphere(statistics), -4 * packing, 1e-8);
  EXPECT_NEAR(excess_about_pair(statistics) - 1, -(8 - 25.0 / 16) * packing, 1e-8);
  EXPECT_NEAR(excess_about_sphere(statistics_of_discs(0.69)), -1, 0.03);
}

TEST(TheoryOfDiscs, WallRateIsThatOfTwoPairsOfWalls) {
  const GasStatistics points = statistics_of_discs(1e-12, Boundary::wall);
  EXPECT_NEAR(wall_rate(points) * points.extent.x, 4 / kPi, 1e-4);
  // The accessible length is less by a diameter, the density at the wall higher by 2 phi.
  const GasStatistics dilute = statistics_of_discs(1e-3, Boundary::wall);
  EXPECT_NEAR(wall_rate(dilute) * (dilute.extent.x - 1), 4 / kPi * (1 + 2e-3), 1e-4);
}

// A rough count of the same: crossings per time, and squares in place of cubes.
TEST(TheoryOfDiscs, CountsCellsInOneLayer) {
  const GasStatistics statistics = statistics_of_discs(1e-4);
  const double edge = statistics.extent.x / 50;
  const CellCounts counts = expected_counts(statistics, edge * (1 - 1e-9));
  EXPECT_NEAR(counts.enter, 2 * (2 / kPi) / edge, 1e-9);
  EXPECT_NEAR(counts.cells, (1 + 1 / edge) * (1 + 1 / edge), 0.01);
  EXPECT_NEAR(counts.cells_entered, 1 + 1 / edge, 0.01);
  // Itself, its partner, and four per cell held late or not.
  EXPECT_GT(counts.candidates_after_collision, 2 + 4);
  EXPECT_LT(counts.candidates_after_collision, 2 + 4 * 5);
}

TEST(TheoryOfDiscs, ChoosesCellsAboutAsLargeAsTheSpacing) {
  for (const double packing : {0.001, 0.1, 0.5}) {
    const GasStatistics statistics = statistics_of_discs(packing);
    const double spacing = std::sqrt(kPi / 4 / packing);
    const double edge = optimal_cell_edge(statistics);
    EXPECT_GT(edge, spacing) << packing;
    EXPECT_LT(edge, 6 * spacing) << packing;
    EXPECT_GT(paper_cell_edge(statistics), 0);
    // The root of the paper's equation in two dimensions.
    const double l = paper_cell_edge(statistics);
    const double n = statistics.number_density();
    const UnitCosts costs;
    EXPECT_NEAR(n * (l + 1) * costs.prediction * (n * l * l + (l - 1)), costs.enter + costs.cell,
                1e-6 * costs.enter);
    EXPECT_GT(optimal_skin(statistics), 0);
  }
}

TEST(TheoryOfDiscs, CountsNeighborsInARing) {
  const GasStatistics statistics = statistics_of_discs(0.3);
  const double expected = statistics.number_density() * kPi * 4 + excess_about_sphere(statistics);
  EXPECT_NEAR(expected_neighbor_counts(statistics, 0.5).neighbors, expected, 1e-9);
}

}  // namespace
}  // namespace hardball::fluid_theory_test
