// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Gases under gravity and between surfaces against kinetic theory.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "hardball/numbers/random.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/world/totals.hpp"
#include "hardball/world/walls.hpp"

namespace hardball::confined_gas_test {
namespace {

Vec3 thermal_velocity(Random& random, double temperature) {
  const double scale = std::sqrt(temperature);
  return scale * Vec3{random.normal(), random.normal(), random.normal()};
}

bool overlaps(const World& world, const Vec3& place, double radius) {
  for (Slot slot = 0; slot < world.size(); ++slot) {
    if (length(world.path(slot).position - place) < radius + world.base_radius(slot)) return true;
  }
  return false;
}

// Heights are distributed as exp(-m g z / kT), whatever the dilute gas started with.
TEST(BarometricFormula, HoldsInADiluteGas) {
  constexpr double kGravity = 0.1;
  constexpr double kRadius = 0.1;
  constexpr int kSpheres = 1000;
  World world(Box({Boundary::periodic, Boundary::periodic, Boundary::open}, {40, 40, 0}), {0, 0, -kGravity},
              {Surface(Plane({0, 0, 1}), {})});
  Random random(1);
  while (world.size() < kSpheres) {
    const Vec3 place{40 * random.uniform(), 40 * random.uniform(), kRadius + 20 * random.uniform()};
    if (!overlaps(world, place, kRadius)) world.add({place, thermal_velocity(random, 1), kRadius, 1});
  }
  Simulation simulation(world);
  double heights = 0;
  double energy = 0;
  constexpr int kSamples = 40;
  constexpr std::array<double, 4> kLevels{2, 5, 10, 20};
  std::array<double, 4> above{};
  for (int sample = 0; sample < kSamples; ++sample) {
    simulation.run_until(1000 + 50 * sample);
    energy += kinetic_energy(simulation.world(), simulation.now());
    for (const Vec3& place : simulation.positions()) {
      const double height = place.z - kRadius;
      heights += height;
      for (std::size_t k = 0; k < kLevels.size(); ++k) above[k] += height > kLevels[k] ? 1 : 0;
    }
  }
  constexpr double kCount = kSpheres * kSamples;
  const double temperature = energy / (1.5 * kCount);
  const double scale_height = temperature / kGravity;
  EXPECT_NEAR(temperature, 1, 0.03);
  // Samples are correlated over some mean free times: about a third of them are independent.
  const double error = 1 / std::sqrt(kCount / 3);
  EXPECT_NEAR(heights / kCount / scale_height, 1, 4 * error);
  for (std::size_t k = 0; k < kLevels.size(); ++k) {
    const double expected = std::exp(-kLevels[k] / scale_height);
    EXPECT_NEAR(above[k] / kCount, expected, 4 * error * std::sqrt(expected)) << kLevels[k];
  }
}

// Between thermal walls that are closer than a mean free path, each sphere carries 2 k T from one to the
// other: the flux is J 2 k (T_2 - T_1), with J from the density of the two streams. Source: Knudsen; Bird,
// Molecular Gas Dynamics, section 7.3.
TEST(ThermalWalls, ConductTheHeatOfFreeMolecularFlow) {
  constexpr double kCold = 1;
  constexpr double kHot = 4;
  constexpr double kRadius = 1e-3;
  constexpr double kLength = 10;
  constexpr int kSpheres = 400;
  World world(Box({Boundary::periodic, Boundary::periodic, Boundary::open}, {10, 10, 0}), {},
              {Surface(Plane({0, 0, 1}), {}, {}, {.temperature = kCold, .seed = 3}),
               Surface(Plane({0, 0, -1}), {0, 0, kLength}, {}, {.temperature = kHot, .seed = 3})});
  Random random(2);
  while (world.size() < kSpheres) {
    const Vec3 place{10 * random.uniform(), 10 * random.uniform(), 0.1 + 9.8 * random.uniform()};
    if (!overlaps(world, place, kRadius)) world.add({place, thermal_velocity(random, 2), kRadius, 1});
  }
  Simulation simulation(world);
  simulation.run_until(50);
  const WallTally cold_before = simulation.tally().wall(kFaces);
  const WallTally hot_before = simulation.tally().wall(kFaces + 1);
  constexpr double kTime = 1000;
  simulation.run_until(50 + kTime);
  const WallTally cold = simulation.tally().wall(kFaces);
  const WallTally hot = simulation.tally().wall(kFaces + 1);
  const double density = kSpheres / (100 * (kLength - 2 * kRadius));
  const double streams = std::sqrt(2 * std::numbers::pi) * (1 / std::sqrt(kCold) + 1 / std::sqrt(kHot)) / 2;
  const double flux = density / streams;
  const double heat = flux * 2 * (kHot - kCold);
  const double area = 100;
  const auto contacts = static_cast<double>(hot.contacts - hot_before.contacts);
  const double error = 4 / std::sqrt(contacts);
  EXPECT_NEAR(contacts / (area * kTime) / flux, 1, error);
  EXPECT_NEAR((hot.heat - hot_before.heat) / (area * kTime) / heat, 1, 2 * error);
  EXPECT_NEAR(-(cold.heat - cold_before.heat) / (area * kTime) / heat, 1, 2 * error);
}

// The virial theorem in a container around the origin: the force on it times its inner radius equals twice
// the kinetic energy and the collisional virial, exactly but for the change of the sum of x.v. And the
// pressure is that of the bulk, with what the second and third virial coefficients add.
void expect_pressure(const Surface& surface, const Box& box, std::size_t dimensions, double inner,
                     double volume) {
  constexpr double kRadius = 0.25;
  constexpr int kSpheres = 600;
  World world(box, {}, {surface});
  Random random(4);
  while (world.size() < kSpheres) {
    const Vec3 place = inner * Vec3{2 * random.uniform() - 1, 2 * random.uniform() - 1,
                                    dimensions == 3 ? 2 * random.uniform() - 1 : random.uniform()};
    if (distance_to_surfaces(world, place, Time(0)) < kRadius || overlaps(world, place, kRadius)) continue;
    bool is_free = true;
    for (int image = -1; dimensions == 2 && image <= 1; ++image) {
      is_free = is_free && !overlaps(world, place + Vec3{0, 0, image * box.size().z}, kRadius);
    }
    if (is_free) world.add({place, thermal_velocity(random, 1), kRadius, 1});
  }
  Simulation simulation(world);
  const auto across = [&](const Vec3& a, const Vec3& b) {
    return a.x * b.x + a.y * b.y + (dimensions == 3 ? a.z * b.z : 0);
  };
  double virial = 0;
  double kinetic = 0;  // twice that of the motion across, integrated over time
  double last = 0;
  double now = 0;
  const auto measure = [&] {
    double sum = 0;
    for (Slot slot = 0; slot < kSpheres; ++slot) {
      const Vec3& velocity = simulation.world().path(slot).velocity;
      sum += across(velocity, velocity);
    }
    return sum;
  };
  double twice_energy = measure();
  const auto positions_times_velocities = [&] {
    double sum = 0;
    for (SphereId id = 0; id < kSpheres; ++id) {
      sum += across(simulation.position(id), simulation.velocity(id));
    }
    return sum;
  };
  const double start = positions_times_velocities();
  simulation.on_contact([&](const Contact& contact) {
    now = contact.time.value();
    kinetic += twice_energy * (now - last);
    last = now;
    if (contact.is_collision()) {
      virial -= across(contact.impulse(), contact.separation);
      const Vec3 second = contact.second_mass * (contact.after.second - contact.before.second);
      twice_energy +=
          across(contact.after.first - contact.before.first, contact.after.first + contact.before.first) +
          across(second, contact.after.second + contact.before.second);
    }
  });
  constexpr double kTime = 400;
  simulation.run_until(kTime);
  kinetic += twice_energy * (kTime - last);
  const double change = positions_times_velocities() - start;
  const double impulse = simulation.tally().wall(kFaces).normal_impulse;
  EXPECT_NEAR((kinetic + virial - change) / (impulse * inner), 1, 1e-10);

  const double temperature = 2 * kinetic_energy(world, Time(0)) / (3 * kSpheres);
  const double packing = kSpheres * 4 * std::numbers::pi / 3 * kRadius * kRadius * kRadius / volume;
  const double bulk = kSpheres * temperature * (1 + 4 * packing + 10 * packing * packing);
  // Spheres at the wall are shielded from collisions on one side: of the order of the packing fraction times
  // the ratio of diameter and container.
  EXPECT_NEAR(impulse * inner / kTime / (static_cast<double>(dimensions) * bulk), 1, 0.01);
}

TEST(PressureOnASphere, IsThatOfTheBulk) {
  constexpr double kInner = 8;
  expect_pressure(Surface(HollowSphere(kInner + 0.25), {}), Box::open(), 3, kInner,
                  4 * std::numbers::pi / 3 * kInner * kInner * kInner);
}

TEST(PressureOnACylinder, IsThatOfTheBulk) {
  constexpr double kInner = 8;
  const Box box({Boundary::open, Boundary::open, Boundary::periodic}, {0, 0, kInner});
  expect_pressure(Surface(Cylinder({0, 0, 1}, kInner + 0.25), {}), box, 2, kInner,
                  std::numbers::pi * kInner * kInner * kInner);
}

}  // namespace
}  // namespace hardball::confined_gas_test
