// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// A dense cloud released in open space: it flies apart, with ever fewer collisions and finally none.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "hardball/simulation/simulation.hpp"
#include "hardball/world/pair_event.hpp"
#include "hardball/world/totals.hpp"
#include "support/gas.hpp"
#include "support/record.hpp"

namespace hardball::burst_test {
namespace {

double extent(const Simulation& simulation) {
  double largest = 0;
  for (const Vec3& position : simulation.positions()) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) largest = std::max(largest, std::fabs(position[axis]));
  }
  return largest;
}

TEST(BurstIntoOpenSpace, EndsAfterFinitelyManyContactsAndNeedsNoMoreMemoryThanItsStart) {
  constexpr std::size_t kSpheres = 2000;
  const World world = support::make_gas(
      {.count = kSpheres, .packing_fraction = 0.3, .seed = 101, .boundary = Boundary::open});
  Simulation simulation(world);
  const double start_extent = extent(simulation);
  const std::size_t start_memory = simulation.memory_bytes();
  // The fastest have a speed of about four, the slowest tenth of a half.
  std::vector<std::uint64_t> contacts;
  std::size_t largest_memory = 0;
  for (double growth = 1; growth <= 1e4; growth *= 10) {
    simulation.run_until(growth * start_extent / 2);
    contacts.push_back(simulation.counters().contacts());
    largest_memory = std::max(largest_memory, simulation.memory_bytes());
  }
  EXPECT_GT(extent(simulation), 1e4 * start_extent);
  support::record("memory_ratio", static_cast<double>(largest_memory) / static_cast<double>(start_memory));
  support::record("contacts", static_cast<double>(contacts.back()));
  // Twice, as tables grow by doubling.
  EXPECT_LE(largest_memory, 2 * start_memory);

  // Most spheres collide a few times on their way out, and none once the cloud is dilute.
  EXPECT_GT(contacts.front(), kSpheres / 2);
  EXPECT_LT(contacts.back(), 10 * kSpheres);
  EXPECT_EQ(contacts[contacts.size() - 2], contacts.back());
  // No more contacts follow: no two spheres will ever meet.
  for (Slot a = 0; a < kSpheres; ++a) {
    for (Slot b = a + 1; b < kSpheres; ++b) ASSERT_EQ(contact_time(simulation.world(), a, b, {}), kNever);
  }
  const double energy_error =
      kinetic_energy(simulation.world(), simulation.now()) / kinetic_energy(world, Time(0)) - 1;
  EXPECT_LT(std::fabs(energy_error), 1e-12);
  EXPECT_LT(length(momentum(simulation.world(), simulation.now())), 1e-11 * kSpheres);
}

}  // namespace
}  // namespace hardball::burst_test
