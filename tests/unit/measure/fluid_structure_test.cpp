// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/fluid_structure.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/gas.hpp"

namespace hardball::fluid_structure_test {
namespace {

TEST(PercusYevick, HasTheCompressibilityOfTheLongestWaves) {
  for (const double p : {0.05, 0.2, 0.45}) {
    const double expected = std::pow(1 - p, 4) / std::pow(1 + 2 * p, 2);
    EXPECT_NEAR(percus_yevick_structure_factor(p, 0) / expected, 1, 1e-3) << p;
    EXPECT_NEAR(percus_yevick_structure_factor(p, 0.1) / expected, 1, 0.02) << p;
  }
}

// To first order in the density the direct correlation function is -1 within the diameter.
TEST(PercusYevick, OfADiluteGasIsThatOfLoneObstacles) {
  constexpr double kPacking = 1e-6;
  for (const double q : {0.5, 3.0, 7.0, 15.0}) {
    const double expected = 1 - 24 * kPacking * (std::sin(q) - q * std::cos(q)) / (q * q * q);
    EXPECT_NEAR((percus_yevick_structure_factor(kPacking, q) - 1) / (expected - 1), 1, 1e-4) << q;
  }
}

TEST(PercusYevick, AgreesWithNumericalIntegration) {
  constexpr double kPacking = 0.3;
  const double constant = std::pow(1 + 2 * kPacking, 2) / std::pow(1 - kPacking, 4);
  const double linear = -std::pow(1 + kPacking / 2, 2) / std::pow(1 - kPacking, 4);
  for (const double q : {0.7, 4.0, 7.1, 19.0}) {
    constexpr int kSteps = 100000;
    double direct = 0;
    for (int step = 0; step < kSteps; ++step) {
      const double x = (step + 0.5) / kSteps;
      direct -= 24 * kPacking / kSteps * x * std::sin(q * x) / q *
                (constant + 6 * kPacking * linear * x + kPacking / 2 * constant * x * x * x);
    }
    EXPECT_NEAR(percus_yevick_structure_factor(kPacking, q), 1 / (1 - direct), 1e-7) << q;
  }
}

TEST(NearestNeighbor, OfADiluteGasIsThatOfPoints) {
  constexpr double kPacking = 1e-4;
  EXPECT_EQ(nearest_neighbor_beyond(kPacking, 1), 1);
  // The expected number of centers in the shell between the diameter and the distance.
  const double expected = std::exp(-8 * kPacking * (1000 - 1));
  EXPECT_NEAR(nearest_neighbor_beyond(kPacking, 10) / expected, 1, 1e-3);
}

// Just outside contact the density of neighbors is that of the fluid times the contact value.
TEST(NearestNeighbor, HasTheSlopeOfTheContactValueAtContact) {
  constexpr double kPacking = 0.3;
  constexpr double kStep = 1e-6;
  const double contact_value = (1 - kPacking / 2) / std::pow(1 - kPacking, 3);
  const double lost = (1 - nearest_neighbor_beyond(kPacking, 1 + kStep)) / kStep;
  EXPECT_NEAR(lost / (24 * kPacking * contact_value), 1, 1e-4);
}

TEST(FluidPackingFraction, IsKnownOfEqualSpheresInAPeriodicBox) {
  const auto packing = [](double packing_fraction, Boundary boundary) {
    const World world =
        support::make_gas({.count = 64, .packing_fraction = packing_fraction, .boundary = boundary});
    return fluid_packing_fraction({world, Time(0)});
  };
  EXPECT_NEAR(packing(0.2, Boundary::periodic), 0.2, 1e-12);
  EXPECT_TRUE(std::isnan(packing(0.2, Boundary::wall)));
  EXPECT_TRUE(std::isnan(packing(0.2, Boundary::open)));
  const World frozen =
      support::make_gas({.count = 108, .packing_fraction = 0.5, .start = support::Start::fcc});
  EXPECT_TRUE(std::isnan(fluid_packing_fraction({frozen, Time(0)})));
  World mixture(Box::periodic({9, 9, 9}));
  mixture.add({.position = {1, 1, 1}, .radius = 1});
  mixture.add({.position = {5, 5, 5}, .radius = 2});
  EXPECT_TRUE(std::isnan(fluid_packing_fraction({mixture, Time(0)})));
}

}  // namespace
}  // namespace hardball::fluid_structure_test
