// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Kinetic theory and the choice of cells in two dimensions.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "hardball/theory/gas_statistics.hpp"
#include "hardball/theory/kinetic_theory.hpp"
#include "hardball/tuning/cell_edge.hpp"
#include "hardball/tuning/neighbor_counts.hpp"
#include "hardball/tuning/row_surplus.hpp"
#include "hardball/tuning/size_classes.hpp"

namespace hardball::theory_of_discs_test {
namespace {

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
}  // namespace hardball::theory_of_discs_test
