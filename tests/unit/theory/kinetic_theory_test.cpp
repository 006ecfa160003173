// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/theory/kinetic_theory.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "unit/theory/some_gas.hpp"

namespace hardball::kinetic_theory_test {
namespace {

using support::some_gas;

// Carnahan and Starling's contact values at these packing fractions are (Z - 1) / (4 phi), Z as tabulated.
TEST(KineticTheory, MeanFreePathAndTimeAgreeWithTables) {
  const std::array<std::pair<double, double>, 4> kTable = {
      {{0.1, 1.52126}, {0.2, 2.40625}, {0.3, 3.97376}, {0.45, 9.38467}}};
  for (const auto& [packing_fraction, tabulated] : kTable) {
    const GasStatistics statistics = some_gas(1000, packing_fraction, 0.5);
    const double contact = (tabulated - 1) / (4 * packing_fraction);
    EXPECT_NEAR(contact_value(statistics), contact, 1e-4 * contact);
    EXPECT_NEAR(compressibility(statistics), tabulated, 1e-4 * tabulated);
    const double path = 1 / (std::numbers::sqrt2 * std::numbers::pi * statistics.number_density() * contact);
    EXPECT_NEAR(mean_free_path(statistics), path, 1e-4 * path);
    EXPECT_NEAR(mean_free_time(statistics), path / statistics.mean_speed, 1e-4 * path);
  }
  EXPECT_EQ(mean_free_path(some_gas(1, 0.1, 1)), std::numeric_limits<double>::infinity());
  GasStatistics still = some_gas(10, 0.1, 1);
  still.mean_speed = 0;
  EXPECT_EQ(mean_free_time(still), std::numeric_limits<double>::infinity());
}

// The mean over pairs of (r_i + r_j)^2 g_ij, with the published contact value of each pair.
TEST(KineticTheory, ContactValueOfAMixtureIsTheMeanOverItsPairs) {
  const std::vector<double> radii{0.3, 0.5, 0.5, 1.1};
  GasStatistics statistics = some_gas(1000, 0.3, 1);
  statistics.radius_power = {};
  for (const double radius : radii) {
    for (std::size_t k = 0; k < 6; ++k) {
      statistics.radius_power[k] +=
          std::pow(radius, static_cast<double>(k)) / static_cast<double>(radii.size());
    }
  }
  const double sixth_of_density = std::numbers::pi / 6 * statistics.number_density();
  const double xi2 = sixth_of_density * 4 * statistics.radius_power[2];
  const double xi3 = sixth_of_density * 8 * statistics.radius_power[3];
  const double free = 1 - xi3;
  double sum = 0;
  double weight = 0;
  for (const double a : radii) {
    for (const double b : radii) {
      const double h = (2 * a) * (2 * b) / (2 * a + 2 * b);
      const double g = 1 / free + 3 * xi2 / (free * free) * h + 2 * xi2 * xi2 / (free * free * free) * h * h;
      sum += (a + b) * (a + b) * g;
      weight += (a + b) * (a + b);
    }
  }
  EXPECT_NEAR(contact_value(statistics), sum / weight, 1e-12 * sum / weight);
}

TEST(KineticTheory, WallRateIsProportionalToSpeedAndInverselyToTheDistance) {
  EXPECT_EQ(wall_rate(some_gas(100, 0.1, 1)), 0) << "no walls";
  const GasStatistics points = some_gas(1000, 1e-15, 0.5, Boundary::wall);
  EXPECT_NEAR(wall_rate(points) * points.extent.x, 3.0 / 2, 1e-4)
      << "three pairs, half the mean speed along each axis";
  // Dilute: the accessible length is less by a diameter, and the density at the wall is that inside times 1 +
  // 4 phi.
  const GasStatistics dilute = some_gas(100000, 1e-3, 0.5, Boundary::wall);
  EXPECT_NEAR(wall_rate(dilute) * (dilute.extent.x - 1), 1.5 * (1 + 4e-3), 1e-4);
}

// At low density a sphere excludes others from eight times its volume, a touching pair from 8 + 8 - 2.5 times
// a sphere's; the partner is counted.
TEST(KineticTheory, ExcessAboutASphereIsTheVolumeItExcludes) {
  const double packing = 1e-5;
  const GasStatistics statistics = some_gas(1000, packing, 0.5);
  EXPECT_NEAR(excess_about_sphere(statistics), -8 * packing, 1e-7);
  EXPECT_NEAR(excess_about_pair(statistics) - 1, -13.5 * packing, 1e-7);
}

TEST(KineticTheory, ExcessOfTheDenseFluidIsOneSphereLess) {
  const GasStatistics statistics = some_gas(1000, 0.45, 0.5);
  EXPECT_NEAR(excess_about_sphere(statistics), -1, 0.03);
  EXPECT_NEAR(excess_about_pair(statistics), -1, 0.15);
}

}  // namespace
}  // namespace hardball::kinetic_theory_test
