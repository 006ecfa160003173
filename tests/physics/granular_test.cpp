// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// A gas of inelastic spheres that cools while it is still homogeneous.
#include <gtest/gtest.h>

#include <cmath>

#include "hardball/simulation/simulation.hpp"
#include "hardball/world/totals.hpp"
#include "support/gas.hpp"
#include "support/interacting.hpp"
#include "support/record.hpp"
#include "support/theory.hpp"

namespace hardball::granular_test {
namespace {

// A collision at the normal speed v dissipates m (1 - e^2) v^2 / 4, and v^2 is 4 kT on average: after C
// collisions per sphere ln(T / T0) = -(1 - e^2) C / 3, at any density. The velocities deviate from Maxwell's
// distribution by a2,
//   a2 = 16 (1 - e)(1 - 2e^2) / (81 - 17e + 30e^2 (1 - e)),
// which changes the mean of v^2 by a factor of (1 + 3 a2 / 16) / (1 - a2 / 16).
// Source: van Noije and Ernst, Granul. Matter 1 (1998) 57, doi:10.1007/s100350050009.
double cooling_per_collision(double e) {
  const double a2 = 16 * (1 - e) * (1 - 2 * e * e) / (81 - 17 * e + 30 * e * e * (1 - e));
  return (1 - e * e) / 3 * (1 + 3 * a2 / 16) / (1 - a2 / 16);
}

void expect_cooling(double restitution) {
  constexpr std::size_t kSpheres = 10000;
  constexpr double kPacking = 0.05;
  constexpr double kCollisionsPerSphere = 20;  // before clusters form
  const World world =
      support::settled(support::make_gas({.count = kSpheres, .packing_fraction = kPacking, .seed = 61}), 5);
  Simulation simulation(support::interacting(world, Restitution(restitution)));
  simulation.run_contacts(static_cast<std::uint64_t>(kCollisionsPerSphere * kSpheres / 2));
  const double temperature =
      kinetic_energy(simulation.world(), simulation.now()) / kinetic_energy(world, Time(0));
  const double per_collision = -std::log(temperature) / kCollisionsPerSphere;
  support::record("cooling_ratio", per_collision / cooling_per_collision(restitution));
  // The deviation of the energy lost in N = 1e5 collisions is 1 / sqrt(N), 0.3%; growing correlations of
  // velocities, which the theory neglects, contribute up to 1% at these C and e.
  EXPECT_NEAR(per_collision / cooling_per_collision(restitution), 1, 0.02);

  // Haff's law, T = T0 / (1 + t / tau)^2 with tau = 6 / ((1 - e^2) w0) to the same order, w0 being the rate
  // at the start. Source: Haff, J. Fluid Mech. 134 (1983) 401, doi:10.1017/S0022112083003419.
  const double rate = support::collision_rate(support::fluid_compressibility(kPacking));
  const double tau = 2 / (cooling_per_collision(restitution) * rate);
  const double by_haff = 1 / std::pow(1 + simulation.time() / tau, 2);
  support::record("haff_ratio", std::log(temperature) / std::log(by_haff));
  EXPECT_NEAR(std::log(temperature) / std::log(by_haff), 1, 0.02);
}

TEST(GranularGas, CoolsByOneMinusESquaredOverThreePerCollisionAtRestitution95) {
  expect_cooling(0.95);
}

TEST(GranularGas, CoolsByOneMinusESquaredOverThreePerCollisionAtRestitution90) {
  expect_cooling(0.9);
}

// Inelastic collisions do not slow the center of mass.
TEST(GranularGas, ConservesItsMomentum) {
  const World world = support::make_gas({.count = 1000, .packing_fraction = 0.1, .seed = 62});
  Simulation simulation(support::interacting(world, Restitution(0.9)));
  for (SphereId id = 0; id < world.size(); ++id) {
    simulation.change_velocity(id, simulation.velocity(id) + Vec3{1, 2, 3});
  }
  simulation.run_contacts(10000);
  const Vec3 drift = (1.0 / 1000) * momentum(simulation.world(), simulation.now());
  // Rounding of 1e4 exchanges, each 1e-16 of a speed of four and of a random sign, over 1000 spheres.
  EXPECT_LT(length(drift - Vec3{1, 2, 3}), 1e-13);
}

}  // namespace
}  // namespace hardball::granular_test
