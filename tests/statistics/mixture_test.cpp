// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Spheres of two sizes and masses.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "hardball/simulation/simulation.hpp"
#include "hardball/world/totals.hpp"
#include "support/gas.hpp"
#include "support/record.hpp"
#include "support/theory.hpp"

namespace hardball::mixture_test {
namespace {

constexpr std::size_t kSmall = 3200;
constexpr std::size_t kLarge = 800;
constexpr double kLargeDiameter = 2;
constexpr double kLargeMass = 8;
constexpr double kPacking = 0.3;

// At first only the large spheres move: kT = 1 on average over all.
World binary_mixture(std::uint64_t seed) {
  Random random(seed);
  std::vector<double> radii(kSmall, support::kDiameter / 2);
  std::vector<double> masses(kSmall, 1);
  radii.resize(kSmall + kLarge, kLargeDiameter / 2);
  masses.resize(kSmall + kLarge, kLargeMass);
  // The number of small spheres with the volume of all.
  const double equivalent = kSmall + kLarge * kLargeDiameter * kLargeDiameter * kLargeDiameter;
  const double edge = std::cbrt(equivalent * std::numbers::pi / 6 / kPacking);
  const Box box = Box::periodic({edge, edge, edge});
  const std::vector<Vec3> centers = place_randomly(box, {{}, box.size()}, radii, random, "mixture");
  const std::vector<double> large_masses(kLarge, kLargeMass);
  const std::vector<Vec3> velocities = support::thermal_velocities(large_masses, random);
  const double share = std::sqrt(static_cast<double>(kSmall + kLarge) / kLarge);
  World world(box);
  for (std::size_t i = 0; i < radii.size(); ++i) {
    const Vec3 velocity = i < kSmall ? Vec3{} : share * velocities[i - kSmall];
    world.add({centers[i], velocity, radii[i], masses[i]});
  }
  return world;
}

TEST(BinaryMixture, SharesItsEnergyEquallyAndHasThePressureOfItsEquationOfState) {
  const World start = binary_mixture(51);
  EXPECT_NEAR(kinetic_energy(start, Time(0)) / (1.5 * (kSmall + kLarge)), 1, 1e-12);
  // Heavy and light spheres exchange their energy in a few collisions: m1 m2 / (m1 + m2)^2 is a tenth.
  const World world = support::settled(start, 40);
  Simulation simulation(world);
  constexpr int kSamples = 40;
  constexpr std::uint64_t kCollisionsPerSample = 8 * (kSmall + kLarge);
  std::array<double, 2> temperature{};
  for (int sample = 0; sample < kSamples; ++sample) {
    simulation.run_contacts(kCollisionsPerSample);
    std::array<double, 2> energy{};
    for (Slot slot = 0; slot < simulation.size(); ++slot) {
      energy[slot < kSmall ? 0 : 1] += kinetic_energy(simulation.world(), slot, simulation.now());
    }
    temperature[0] += energy[0] / (1.5 * kSmall) / kSamples;
    temperature[1] += energy[1] / (1.5 * kLarge) / kSamples;
  }
  support::record("temperature_of_small", temperature[0]);
  support::record("temperature_of_large", temperature[1]);
  // A sample of the mean energy of n spheres has a standard deviation of sqrt(2 / 3n), and samples 16
  // collisions per sphere apart are independent. That the total energy is fixed only reduces it.
  EXPECT_NEAR(temperature[0], 1, 4 * std::sqrt(2.0 / (3 * kSmall * kSamples)));
  EXPECT_NEAR(temperature[1], 1, 4 * std::sqrt(2.0 / (3 * kLarge * kSamples)));

  const double volume = world.box().volume();
  const std::array<support::Species, 2> species{
      {{kSmall / volume, support::kDiameter}, {kLarge / volume, kLargeDiameter}}};
  const double expected = support::mixture_compressibility(species) - 1;
  const double excess = simulation.tally().compressibility(simulation.now()) - 1;
  support::record("relative_error_of_excess", excess / expected - 1);
  const auto collisions = static_cast<double>(simulation.tally().collisions());
  // As for one species, with 0.5% for the equation of state.
  EXPECT_NEAR(excess / expected, 1, 4 / std::sqrt(collisions) + 0.005);
}

}  // namespace
}  // namespace hardball::mixture_test
