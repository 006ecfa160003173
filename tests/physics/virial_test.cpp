// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Sums over all contacts of a run that must agree with its initial and final states: any contact that is
// lost, counted twice, misplaced or carried out wrongly violates them.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "hardball/simulation/simulation.hpp"
#include "hardball/world/totals.hpp"
#include "support/gas.hpp"
#include "support/interacting.hpp"
#include "support/random_world.hpp"

namespace hardball::virial_test {
namespace {

// Sum of m x.v: half the rate at which the moment of inertia grows.
double inertia_rate(const World& world, const Time& moment) {
  double sum = 0;
  for (Slot slot = 0; slot < world.size(); ++slot) {
    sum += world.mass(slot) * dot(world.unfolded_position(slot, moment), world.path(slot).velocity);
  }
  return sum;
}

// Between contacts S = sum m x.v grows by sum m v^2 = 2K per time. A contact that gives the first sphere the
// impulse J and the second -J adds J.(x1 - x2), a wall that gives J adds J.x. So, whatever the masses, radii
// and response,
//   S(t) - S(0) = int 2K dt - sum over collisions of J.(x2 - x1) + sum over wall contacts of J.x.
// Exact but for rounding, a few units in the last place of each term with random signs.
struct VirialBalance {
  double left = 0;
  double right = 0;
  double scale = 0;  // the sum of the magnitudes of all terms
  std::uint64_t contacts = 0;

  double residual() const { return std::fabs(left - right) / scale; }
};

VirialBalance balance_of(const World& world, const RunLimits& limits) {
  Simulation simulation(world);
  VirialBalance balance;
  double energy = kinetic_energy(world, Time(0));
  Time last;
  const auto square = [](const Vec3& v) { return dot(v, v); };
  const auto add = [&](double term) {
    balance.right += term;
    balance.scale += std::fabs(term);
  };
  simulation.on_contact([&](const Contact& contact) {
    add(2 * energy * duration(last, contact.time));
    last = contact.time;
    energy += contact.first_mass * (square(contact.after.first) - square(contact.before.first)) / 2;
    if (contact.is_collision()) {
      energy += contact.second_mass * (square(contact.after.second) - square(contact.before.second)) / 2;
      add(-dot(contact.impulse(), contact.separation));
    } else {
      add(dot(contact.impulse(), contact.position));
    }
  });
  balance.left = -inertia_rate(world, Time(0));
  balance.scale = std::fabs(balance.left);
  simulation.run(limits);
  add(2 * energy * duration(last, simulation.now()));
  const double final_rate = inertia_rate(simulation.world(), simulation.now());
  balance.left += final_rate;
  balance.scale += std::fabs(final_rate);
  balance.contacts = simulation.counters().contacts();
  return balance;
}

// The sums have about 1e4 terms, each right to about 1e-15; the residual was observed to be below 1e-14.
constexpr double kResidual = 1e-12;

World mixed_gas(const Box& box, std::size_t spheres, std::uint64_t seed) {
  Random random(seed);
  std::vector<double> radii;
  std::vector<double> masses;
  for (std::size_t i = 0; i < spheres; ++i) {
    radii.push_back(0.2 + 0.6 * random.uniform());
    masses.push_back(std::exp2(6 * random.uniform() - 3));
  }
  const double edge = support::cube_edge(spheres, 0.15);
  const std::vector<Vec3> centers = place_randomly(box, {{}, {edge, edge, edge}}, radii, random, "mixed gas");
  const std::vector<Vec3> velocities = support::thermal_velocities(masses, random);
  World world(box);
  for (std::size_t i = 0; i < spheres; ++i) world.add({centers[i], velocities[i], radii[i], masses[i]});
  return world;
}

TEST(VirialBalance, IsKeptByMixturesBetweenWallsAndByOneThatEscapes) {
  constexpr std::size_t kSpheres = 300;
  struct Mixture {
    Boundary ends;
    std::uint64_t seed;
    double restitution;
    RunLimits limits;
    std::uint64_t least;  // number of contacts
  };
  for (const Mixture& mixture : {Mixture{Boundary::wall, 21, 1, {.contacts = 20000}, 20000},
                                 Mixture{Boundary::wall, 22, 0.8, {.contacts = 20000}, 20000},
                                 Mixture{Boundary::open, 23, 1, {.until = Time(50)}, 1001}}) {
    SCOPED_TRACE(mixture.seed);
    const double edge = support::cube_edge(kSpheres, 0.15);
    const Box box({Boundary::wall, mixture.ends, mixture.ends}, {edge, edge, edge});
    const World world = mixed_gas(box, kSpheres, mixture.seed);
    const VirialBalance balance =
        balance_of(support::interacting(world, Restitution(mixture.restitution)), mixture.limits);
    EXPECT_GE(balance.contacts, mixture.least);
    EXPECT_LT(balance.residual(), kResidual);
  }
}

TEST(VirialBalance, IsKeptByEveryRandomWorldWithoutPeriodicAxes) {
  constexpr std::uint64_t kSeeds = 1000;
  constexpr std::uint64_t kMaxContacts = 2000;
  std::uint64_t worlds = 0;
  std::uint64_t contacts = 0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const support::RandomWorld made = support::make_random_world(seed);
    const Box& box = made.world.box();
    // In a periodic box the sum depends on where each sphere is folded.
    if (box.is_periodic(0) || box.is_periodic(1) || box.is_periodic(2)) continue;
    const VirialBalance balance =
        balance_of(made.world, {.until = Time(made.until), .contacts = kMaxContacts});
    ++worlds;
    contacts += balance.contacts;
    if (balance.scale == 0) continue;
    EXPECT_LT(balance.residual(), kResidual) << made.name;
  }
  EXPECT_GT(worlds, 200U);
  EXPECT_GT(contacts, 20000U);
}

// The same sums as kept by the tally.
TEST(VirialBalance, IsWhatTheTallyAddsUp) {
  constexpr double kRadius = support::kDiameter / 2;
  const World world =
      support::make_gas({.count = 400, .packing_fraction = 0.2, .seed = 24, .boundary = Boundary::wall});
  Simulation simulation(support::interacting(world, Restitution(0.9)));
  simulation.run_contacts(20000);
  const Tally& tally = simulation.tally();
  double walls = 0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    walls += tally.wall_impulse(face_of(axis, false)) * kRadius;
    walls -= tally.wall_impulse(face_of(axis, true)) * (world.box().size()[axis] - kRadius);
  }
  const double left = inertia_rate(simulation.world(), simulation.now()) - inertia_rate(world, Time(0));
  const double energy = tally.energy_integral(simulation.now());
  EXPECT_LT(std::fabs(left - (2 * energy + tally.virial() + walls)), kResidual * 2 * energy);
}

}  // namespace
}  // namespace hardball::virial_test
