// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The conservation of energy and momentum in a million collisions.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "hardball/numbers/random.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/world/audit.hpp"
#include "hardball/world/totals.hpp"
#include "support/effort.hpp"
#include "support/gas.hpp"
#include "support/record.hpp"

namespace hardball::conservation_test {
namespace {

constexpr std::uint64_t kContacts = support::cases(1000000);

// A thin gas, one between walls, which change the momentum but must not change the energy (they reverse a
// component, without rounding), and a packed crystal, where collisions follow each other a hundred times
// faster.
//
// An elastic collision conserves energy and momentum whatever the spheres' distance; only the arithmetic
// rounds, by about 1e-16 of a sphere's share each time and with a random sign: sqrt(1e6) * 1e-16 / sqrt(1000)
// of the whole. The limits allow a hundred times that: they are to catch a drift.
TEST(MillionCollisions, ConserveEnergyAndMomentum) {
  const std::vector<std::pair<std::string, support::Gas>> gases{
      {"", {.count = 1000, .packing_fraction = 0.3, .seed = 81}},
      {"_between_walls", {.count = 1000, .packing_fraction = 0.1, .seed = 82, .boundary = Boundary::wall}},
      {"_of_crystal", {.count = 864, .packing_fraction = 0.72, .seed = 83, .start = support::Start::fcc}}};
  for (const auto& [name, gas] : gases) {
    SCOPED_TRACE("gas" + name);
    const World world = support::make_gas(gas);
    const auto spheres = static_cast<double>(world.size());
    Simulation simulation(world);
    simulation.run_contacts(kContacts);
    const double energy_error =
        kinetic_energy(simulation.world(), simulation.now()) / kinetic_energy(world, Time(0)) - 1;
    support::record("energy_error" + name, energy_error);
    EXPECT_LT(std::fabs(energy_error), 1e-12);
    const Audit found = audit(simulation.world(), simulation.now());
    EXPECT_TRUE(found.is_sound());
    // Positions in a box of twelve diameters are right to 1e-15.
    support::record("overlap_at_contact" + name, simulation.tally().max_overlap());
    EXPECT_LT(simulation.tally().max_overlap(), 1e-13);
    EXPECT_LT(found.max_overlap, 1e-13);
    if (gas.boundary == Boundary::wall) {
      EXPECT_GT(simulation.counters().wall, kContacts / 10);
      continue;
    }
    const double rms_speed = std::sqrt(2 * kinetic_energy(world, Time(0)) / spheres);
    const double momentum_error =
        length(momentum(simulation.world(), simulation.now())) / (spheres * rms_speed);
    support::record("momentum_error" + name, momentum_error);
    EXPECT_LT(momentum_error, 1e-11);
  }
}

// A rounding error that is the same at every collision adds up as the number of collisions, not as its root.
// Here the squared reach is next to one, where the spacing of doubles changes, or the ratio of two masses is
// rounded. The steps by which the energy changes must have mean zero to within their scatter; with either
// rounding alike at every collision the mean is more than ten times its standard error.
TEST(MillionCollisions, LetTheEnergyWanderAndNotDrift) {
  constexpr std::size_t kEdge = 4;
  constexpr std::size_t kSteps = 20;
  constexpr std::uint64_t kContactsPerStep = 10000;
  for (const double heavy : {1.0, 1.7}) {
    SCOPED_TRACE(heavy);
    World world(Box::periodic({2 * kEdge, 2 * kEdge, 2 * kEdge}));
    Random random(84);
    for (std::size_t i = 0; i < kEdge * kEdge * kEdge; ++i) {
      const Vec3 place{static_cast<double>(i % kEdge), static_cast<double>(i / kEdge % kEdge),
                       static_cast<double>(i / (kEdge * kEdge))};
      const Vec3 velocity{random.normal(), random.normal(), random.normal()};
      world.add({2 * place, velocity, heavy == 1 ? 0.5 : 0.45, i % 2 == 0 ? 1 : heavy});
    }
    Simulation simulation(world);
    std::vector<double> energies{kinetic_energy(simulation.world(), simulation.now())};
    for (std::size_t step = 0; step < kSteps; ++step) {
      simulation.run_contacts(kContactsPerStep);
      energies.push_back(kinetic_energy(simulation.world(), simulation.now()));
    }
    const double mean = (energies.back() - energies.front()) / kSteps;
    double squares = 0;
    for (std::size_t step = 0; step < kSteps; ++step) {
      const double deviation = energies[step + 1] - energies[step] - mean;
      squares += deviation * deviation;
    }
    const double error = std::sqrt(squares / (kSteps * (kSteps - 1)));
    support::record(heavy == 1 ? "drift_in_errors" : "drift_in_errors_of_two_masses", mean / error);
    EXPECT_LT(std::fabs(mean), 4 * error);
  }
}

}  // namespace
}  // namespace hardball::conservation_test
