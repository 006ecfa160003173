// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Collisions turn any velocity distribution into Maxwell's.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "hardball/simulation/simulation.hpp"
#include "support/gas.hpp"
#include "support/record.hpp"
#include "support/theory.hpp"

namespace hardball::relaxation_test {
namespace {

constexpr std::size_t kSpheres = 4000;

// <v^4> / <v^2>^2, 5/3 for Maxwell's distribution and 1 for equal speeds.
double speed_kurtosis(const World& world) {
  double squares = 0;
  double fourths = 0;
  for (const Path& path : world.paths()) {
    const double square = dot(path.velocity, path.velocity);
    squares += square;
    fourths += square * square;
  }
  return fourths * static_cast<double>(world.size()) / (squares * squares);
}

World equal_speeds() {
  const World gas = support::make_gas({.count = kSpheres, .packing_fraction = 0.1, .seed = 71});
  Random random(72);
  // Spheres in pairs of opposite velocities: no total momentum.
  World world(gas.box());
  Vec3 velocity;
  for (Slot slot = 0; slot < gas.size(); ++slot) {
    velocity = slot % 2 == 0 ? std::sqrt(3.0) * random.direction() : -velocity;
    world.add({.position = gas.path(slot).position, .velocity = velocity, .radius = gas.base_radius(slot)});
  }
  return world;
}

TEST(EqualSpeeds, RelaxToMaxwellsDistribution) {
  const World start = equal_speeds();
  EXPECT_NEAR(speed_kurtosis(start), 1, 1e-12);
  // Four collisions per sphere bring the fourth moment to its limit; 15 are more than enough.
  Simulation simulation(support::settled(start, 15));
  constexpr int kSamples = 100;
  constexpr std::uint64_t kContactsPerSample = 2 * kSpheres;  // four per sphere
  double kurtosis = 0;
  // How often a component of the velocity lies in each of sixteen ranges of equal probability.
  constexpr std::size_t kRanges = 16;
  std::array<double, kRanges> counts{};
  for (int sample = 0; sample < kSamples; ++sample) {
    simulation.run_contacts(kContactsPerSample);
    kurtosis += speed_kurtosis(simulation.world()) / kSamples;
    for (const Path& path : simulation.world().paths()) {
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        const double below = std::erfc(-path.velocity[axis] / std::sqrt(2)) / 2;
        ++counts[static_cast<std::size_t>(below * kRanges)];
      }
    }
  }
  const double expected = support::FixedEnergy::periodic(kSpheres).speed_kurtosis();
  support::record("kurtosis_ratio", kurtosis / expected);
  // A sample has a relative deviation of 1.217 / sqrt(n); samples count as independent.
  EXPECT_NEAR(kurtosis / expected, 1, 4 * 1.217 / std::sqrt(static_cast<double>(kSpheres) * kSamples));
  // Chi squared with fifteen degrees of freedom: above 45 once in 1e4. Fixed energy and momentum only reduce
  // it.
  const double mean = static_cast<double>(3 * kSpheres * kSamples) / kRanges;
  double chi_squared = 0;
  for (const double count : counts) chi_squared += (count - mean) * (count - mean) / mean;
  support::record("chi_squared", chi_squared);
  EXPECT_LT(chi_squared, 45);
}

}  // namespace
}  // namespace hardball::relaxation_test
