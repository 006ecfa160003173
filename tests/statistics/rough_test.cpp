// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Gases of rough inelastic spheres, and cooling to far lower energies than without a cure for inelastic
// collapse.
#include <gtest/gtest.h>

#include <cmath>

#include "hardball/numbers/random.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/world/images.hpp"
#include "hardball/world/totals.hpp"
#include "support/gas.hpp"
#include "support/interacting.hpp"
#include "support/record.hpp"

namespace hardball::rough_test {
namespace {

ResponseTable all_bounce(const BounceRules& rules) {
  return ResponseTable(Bounce(rules), Bounce(rules));
}

double translational(const Simulation& simulation) {
  return kinetic_energy(simulation.world(), simulation.now());
}

double rotational(const Simulation& simulation) {
  return rotational_energy(simulation.world());
}

// Perfectly rough elastic spheres share their energy equally between translation and rotation.
TEST(RoughSpheres, ReachEquipartitionIfNoEnergyIsLost) {
  constexpr std::size_t kSpheres = 2000;
  const World world = support::make_gas({.count = kSpheres, .packing_fraction = 0.1, .seed = 71});
  Simulation simulation(support::interacting(world, all_bounce({.tangential_restitution = 1})));
  simulation.run_contacts(30 * kSpheres);
  double translation = 0;
  double rotation = 0;
  for (int i = 0; i < 40; ++i) {
    simulation.run_contacts(2 * kSpheres);
    translation += translational(simulation);
    rotation += rotational(simulation);
  }
  const double initial = energy(world, Time(0));
  EXPECT_NEAR(translational(simulation) + rotational(simulation), initial, 1e-12 * initial);
  support::record("rotational_over_translational", rotation / translation);
  // At constant energy, a mean of 40 independent values with a relative deviation of sqrt(4 / (3 N)), 2.6%,
  // has one of 0.4%; four of them.
  EXPECT_NEAR(rotation / translation, 1, 0.016);
}

Vec3 angular_momentum(const Simulation& simulation) {
  const World& world = simulation.world();
  Vec3 sum;
  world.for_each_by_id([&](Slot slot) {
    const double radius = world.base_radius(slot);
    sum += world.mass(slot) *
           cross(unwrapped_position(world, slot, simulation.now()), world.velocity(slot, simulation.now()));
    sum += (world.inertia_factor(slot) * world.mass(slot) * radius * radius) * world.spin(slot);
  });
  return sum;
}

// A cluster of spheres of all sizes, masses and moments that flies apart in open space.
TEST(RoughSpheres, KeepAngularMomentumInOpenSpace) {
  World world;
  Random random(74);
  for (int i = 0; i < 512; ++i) {
    const Vec3 site{1.0 * (i % 8), 1.0 * (i / 8 % 8), 1.0 * (i / 64)};
    const Vec3 velocity = random.normal_vector(kAxes);
    const Vec3 spin = random.normal_vector(kAxes);
    const double radius = 0.4 + 0.09 * random.uniform();
    const double mass = 0.5 + random.uniform();
    const double moment = 0.2 + 0.4 * random.uniform();
    world.add({.position = site,
               .velocity = velocity,
               .radius = radius,
               .mass = mass,
               .spin = spin,
               .inertia_factor = moment});
  }
  Simulation simulation(support::interacting(
      world, all_bounce({.restitution = ConstantRestitution{0.8}, .tangential_restitution = 0.3})));
  const Vec3 before = angular_momentum(simulation);
  const Vec3 momentum = hardball::momentum(simulation.world(), simulation.now());
  simulation.run_until(100);
  EXPECT_GT(simulation.counters().collision, 1000U);
  // Rounding of positions of up to 400 and of some 1e3 impulses.
  EXPECT_LT(length(angular_momentum(simulation) - before), 1e-9);
  EXPECT_LT(length(hardball::momentum(simulation.world(), simulation.now()) - momentum), 1e-12);
}

// The stationary ratio of the temperatures of rotation and translation, R, of spheres with the reduced moment
// q: with h = q (1 + b) / (2 (1 + q)), per collision the translational one changes in proportion to
// -A + B R, with A = (1 - e^2) / 4 + h (1 - h) and B = h^2 / q, the rotational one to B - C R, with
// C = h / q (1 - h / q). Source: Luding, Huthmann, McNamara and Zippelius, Phys. Rev. E 58 (1998) 3416.
double stationary_ratio(double e, double b, double q) {
  const double h = q * (1 + b) / (2 * (1 + q));
  const double a = (1 - e * e) / 4 + h * (1 - h);
  const double gain = h * h / q;
  const double c = h / q * (1 - h / q);
  return ((a - c) + std::sqrt((a - c) * (a - c) + 4 * gain * gain)) / (2 * gain);
}

void expect_ratio(double e, double b) {
  constexpr std::size_t kSpheres = 4000;
  const World world =
      support::settled(support::make_gas({.count = kSpheres, .packing_fraction = 0.05, .seed = 72}), 5);
  Simulation simulation(support::interacting(
      world, all_bounce({.restitution = ConstantRestitution{e}, .tangential_restitution = b})));
  // The ratio relaxes within some 10 collisions per sphere; clusters take far longer.
  simulation.run_contacts(15 * kSpheres);
  double sum = 0;
  constexpr int kSamples = 20;
  for (int i = 0; i < kSamples; ++i) {
    simulation.run_contacts(kSpheres / 2);
    sum += rotational(simulation) / translational(simulation);
  }
  const double ratio = sum / kSamples;
  support::record("stationary_ratio", ratio / stationary_ratio(e, b, kSphereInertiaFactor));
  // The theory neglects that velocities are not normally distributed, and that spins are correlated with
  // them: up to a few percent.
  EXPECT_NEAR(ratio / stationary_ratio(e, b, kSphereInertiaFactor), 1, 0.05);
}

TEST(RoughSpheres, CoolWithTheRatioOfTemperaturesOfKineticTheory) {
  expect_ratio(0.9, 0.5);
  expect_ratio(0.9, 0.9);
}

// With the TC model, and with elastic slow impacts, a gas that would collapse cools on.
TEST(ContactDuration, LetsAGasCoolByFourOrdersOfMagnitude) {
  const World world = support::make_gas({.count = 500, .packing_fraction = 0.2, .seed = 73});
  const double initial = energy(world, Time(0));
  const auto energy_after = [&](const BounceRules& rules) {
    Simulation simulation(support::interacting(world, all_bounce(rules)));
    simulation.run_until(1e4);
    return translational(simulation) / initial;
  };
  BounceRules rules{.restitution = ConstantRestitution{0.1}};
  EXPECT_THROW(energy_after(rules), RunFailure);
  rules.contact_duration = 1e-4;
  EXPECT_LT(energy_after(rules), 1e-4);
}

}  // namespace
}  // namespace hardball::rough_test
