// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "hardball/simulation/simulation.hpp"
#include "hardball/world/totals.hpp"
#include "support/gas.hpp"
#include "support/record.hpp"

namespace hardball::wall_pressure_test {
namespace {

// Relative to the middle of the box S = sum m x.v stays bounded, and the balance of its growth, 2K and the
// virial, becomes the pressure on the walls:
//   sum over axes of F (D - 2r) = 2K + virial / t,
// with an error of |S(t) - S(0)| / t. Positions in equilibrium are uniform within h = D / 2 - r of the
// middle, so that S has a variance of h^2 kT for each sphere; the initial and final S are independent, and
// four deviations are allowed.
TEST(WallPressure, ObeysTheSumRuleOfKineticEnergyAndVirial) {
  constexpr double kRadius = support::kDiameter / 2;
  constexpr std::size_t kSpheres = 500;
  const World world = support::make_gas(
      {.count = kSpheres, .packing_fraction = 0.25, .seed = 25, .boundary = Boundary::wall});
  Simulation simulation(world);
  simulation.run_contacts(400000);
  const double t = simulation.time();
  const double size = world.box().size().x;
  const Tally& tally = simulation.tally();
  double walls = 0;
  for (Face face = 0; face < 2 * kAxes; ++face)
    walls += tally.wall_impulse(face) / (2 * t) * (size - 2 * kRadius);
  const double expected = 2 * kinetic_energy(world, Time(0)) + tally.virial() / t;
  const double half = size / 2 - kRadius;
  const double bound = 4 * std::sqrt(2 * kSpheres * half * half) / t;
  EXPECT_LT(bound, 1e-3 * expected);
  support::record("sum_rule_error", walls / expected - 1);
  support::record("bound", bound / expected);
  EXPECT_NEAR(walls, expected, bound);
  const double area = size * size;
  const double pressure = tally.wall_pressure(world.box(), simulation.now());
  EXPECT_NEAR(pressure * area * (size - 2 * kRadius) * 3, walls, 1e-12 * walls);
}

// The pressure on a hard wall is kT times the density of centers that touch it, at every density of the gas.
// Source: Henderson, Blum and Lebowitz, J. Electroanal. Chem. 102 (1979) 315.
TEST(WallPressure, IsTheDensityAtContactTimesTemperature) {
  constexpr std::size_t kSpheres = 1000;
  constexpr int kSamples = 1200;
  constexpr double kBin = 0.04;
  const World start =
      support::make_gas({.count = kSpheres, .packing_fraction = 0.2, .seed = 26, .boundary = Boundary::wall});
  const World world = support::settled(start, 20);
  Simulation simulation(world);
  std::array<double, 2> counts{};
  const double size = world.box().size().x;
  for (int sample = 1; sample <= kSamples; ++sample) {
    // From one sample to the next most spheres near a wall are replaced: the layer is 0.04 deep, speeds are
    // about one.
    simulation.run_until(0.25 * sample);
    for (const Vec3& position : simulation.positions()) {
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const double gap = std::min(position[axis], size - position[axis]) - support::kDiameter / 2;
        const auto bin = static_cast<std::size_t>(std::max(gap, 0.0) / kBin);
        if (bin < counts.size()) ++counts[bin];
      }
    }
  }
  // Centers stay half a diameter away from the other walls, too.
  const double area = 6 * (size - support::kDiameter) * (size - support::kDiameter);
  const double density_at_contact = (1.5 * counts[0] - 0.5 * counts[1]) / (kSamples * area * kBin);
  const double force = simulation.tally().wall_pressure(world.box(), simulation.now()) * size * size;
  const double pressure = force / ((size - support::kDiameter) * (size - support::kDiameter));
  // Independent counts of N spheres have a relative deviation of sqrt((1.5^2 + 0.5^2) / N): 0.7% with N =
  // 5e4. Four of these, and the curvature of the profile, which takes up to 1% from the straight line through
  // two bins.
  EXPECT_GT(counts[0], 5e4);
  support::record("density_over_pressure", density_at_contact / pressure);
  support::record("counts", counts[0]);
  EXPECT_NEAR(density_at_contact / pressure, 1, 0.038);
}

}  // namespace
}  // namespace hardball::wall_pressure_test
