// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Prescribed motions with exact results.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "hardball/numbers/random.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/world/totals.hpp"
#include "support/gas.hpp"

namespace hardball::motions_physics_test {
namespace {

// A gas of spheres of diameter one between a floor and a piston, which comes down to half of the height.
struct Cylinder {
  double edge;
  Simulation simulation;

  // A piston that stops at a pressure has an interval.
  Cylinder(std::size_t count, double packing_fraction, double until, double pressure = 0, double interval = 0,
           std::size_t threads = 1)
      : edge(support::cube_edge(count, packing_fraction)),
        simulation(make(count, until, pressure, interval, threads)) {}

  Simulation make(std::size_t count, double until, double pressure, double interval,
                  std::size_t threads) const {
    // Spheres of the volume that their centers can reach.
    const Box box({Boundary::periodic, Boundary::periodic, Boundary::open}, {edge, edge, edge});
    const Surface floor(Plane({0, 0, 1}), {});
    const Surface piston(Plane({0, 0, -1}), {0, 0, edge});
    World world(box, {}, {floor, piston});
    Random random(5);
    const std::vector<double> masses(count, 1);
    const std::vector<Vec3> velocities = support::thermal_velocities(masses, random);
    std::vector<Vec3> centers;
    while (centers.size() < count) {
      const Vec3 center{edge * random.uniform(), edge * random.uniform(),
                        0.5 + (edge - 1) * random.uniform()};
      bool is_free = true;
      for (const Vec3& other : centers) {
        Vec3 apart = center - other;
        apart -= box.shift(box.nearest_image(apart));
        is_free = is_free && length(apart) > 1;
      }
      if (is_free) centers.push_back(center);
    }
    for (std::size_t k = 0; k < count; ++k)
      world.add({.position = centers[k], .velocity = velocities[k], .radius = 0.5});
    EngineOptions options;
    options.threads = threads;
    Simulation made(world, options);
    const std::vector<Keyframe> rows{{0, {}}, {until, {0, 0, -edge / 2}}};
    DrivenMotion motion("piston", PrescribedMotion::keyframes(rows), {}, {kFaces + 1});
    if (interval > 0) motion.stop_at_pressure(pressure, interval);
    made.drive(motion);
    return made;
  }
  // k T.
  double temperature() const {
    return 2 * simulation.totals().kinetic_energy.value() / (3 * static_cast<double>(simulation.size()));
  }
};

// A slow piston compresses a gas without exchange of heat. With Z = P V / N k T, d ln T = -2/3 Z d ln V: of
// an ideal gas T V^(2/3) is constant, and Z - 1 = 4 phi is the first correction.
TEST(SlowPiston, CompressesAdiabatically) {
  constexpr std::size_t kCount = 1000;
  constexpr double kPackingFraction = 0.0005;
  const double edge = support::cube_edge(kCount, kPackingFraction);
  // Force on a piston that moves with u exceeds that at rest by some 1.6 u: here by 0.3%.
  constexpr double kSpeed = 0.002;
  Cylinder cylinder(kCount, kPackingFraction, edge / 2 / kSpeed);
  const double before = cylinder.temperature();
  cylinder.simulation.run_until(edge / 2 / kSpeed);
  // The volume of the centers.
  const double compression = (edge - 1) / (edge / 2 - 1);
  const double correction = std::exp(2.0 / 3 * 4 * kPackingFraction);
  const double ratio = cylinder.temperature() / before / (std::pow(compression, 2.0 / 3) * correction);
  EXPECT_NEAR(ratio, 1, 0.005);
  EXPECT_EQ(cylinder.simulation.motions().front().next(), std::numeric_limits<double>::infinity());
  EXPECT_EQ(cylinder.simulation.world().surface(kFaces + 1).velocity(), Vec3{});
  // The piston gives all the energy.
  const double work = cylinder.simulation.work_of(cylinder.simulation.motions().front());
  EXPECT_NEAR(1.5 * kCount * (cylinder.temperature() - before), work, 1e-9 * work);
  EXPECT_GT(cylinder.simulation.counters().collision, 50 * kCount) << "the gas stays isotropic";
}

// A piston that presses until the gas presses back: against one that is looked at by hand, in every engine,
// and from a state saved on the way. At rest it feels what the equation of state says.
TEST(Piston, StopsAtAPressure) {
  constexpr std::size_t kCount = 400;
  constexpr double kPackingFraction = 0.001;
  const double edge = support::cube_edge(kCount, kPackingFraction);
  const double until = 400;
  constexpr double kInterval = 20;
  constexpr std::uint32_t kPiston = kFaces + 1;
  Cylinder by_hand(kCount, kPackingFraction, until);
  const double area = edge * edge;
  const double at_first = static_cast<double>(kCount) * by_hand.temperature() / (area * edge);
  const double wanted = 2.5 * at_first;
  double stopped = 0;
  for (double before = 0; stopped == 0;) {
    by_hand.simulation.run_until(by_hand.simulation.time() + kInterval);
    ASSERT_LT(by_hand.simulation.time(), until);
    const double impulse = by_hand.simulation.sums().tally.wall(kPiston).normal_impulse;
    if (impulse - before >= wanted * area * kInterval) stopped = by_hand.simulation.time();
    before = impulse;
  }
  EXPECT_GT(stopped, 3 * kInterval);

  for (const std::size_t threads : {1U, 2U}) {
    Cylinder cylinder(kCount, kPackingFraction, until, wanted, kInterval, threads);
    Simulation& simulation = cylinder.simulation;
    simulation.run_until(2.5 * kInterval);
    simulation = Simulation::load(simulation.save());
    simulation.set_threads(threads);
    simulation.run_until(stopped);
    EXPECT_EQ(simulation.event_log_hash(), by_hand.simulation.event_log_hash());
    simulation.run_until(stopped + 0.5 * kInterval);
    EXPECT_EQ(simulation.motions().front().stopped_at(), stopped);
    EXPECT_EQ(simulation.motions().front().next(), std::numeric_limits<double>::infinity());
    const Surface& piston = simulation.world().surface(kPiston);
    EXPECT_EQ(piston.velocity(), Vec3{});
    const double height = edge * (1 - 0.5 * stopped / until);
    EXPECT_NEAR(piston.point().z, height, 1e-12 * edge);
    // The volume of the centers; Z - 1 is 4 times the packing fraction, .002, and the walls' part of it less.
    const double before = simulation.sums().tally.wall(kPiston).normal_impulse;
    const double rest = 3000;
    simulation.run_until(simulation.time() + rest);
    const double pressure = (simulation.sums().tally.wall(kPiston).normal_impulse - before) / (area * rest);
    const double expected = static_cast<double>(kCount) * cylinder.temperature() / (area * (height - 1));
    EXPECT_NEAR(pressure / expected, 1.0 + 4 * 0.001 * edge / height, 0.02);
    EXPECT_GT(pressure, 0.8 * wanted);
  }
}

}  // namespace
}  // namespace hardball::motions_physics_test
