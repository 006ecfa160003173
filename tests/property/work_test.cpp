// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// The work per contact, counted, not timed: the same for a thousand spheres and for a million, wherever they
// are.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/simulation/simulation.hpp"
#include "support/effort.hpp"
#include "support/gas.hpp"
#include "support/record.hpp"

namespace hardball::work_test {
namespace {

constexpr double kPacking = 0.1;
constexpr double kDensity = 6 * kPacking / std::numbers::pi;

struct Work {
  double predictions = 0;
  double queue_operations = 0;
  double crossings = 0;
  double stale = 0;
  double contacts = 0;
  double bytes = 0;  ///< Per sphere.

  void add_run(World world, double cell_edge, std::uint64_t count) {
    const auto spheres = static_cast<double>(world.size());
    Simulation simulation(std::move(world), {.cell_edge = cell_edge});
    const Counters before = simulation.counters();
    simulation.run_contacts(count);
    const Counters after = simulation.counters();
    predictions += static_cast<double>(after.predictions - before.predictions);
    queue_operations += static_cast<double>(after.queue_operations - before.queue_operations);
    crossings += static_cast<double>(after.enter - before.enter);
    stale += static_cast<double>(after.stale - before.stale);
    contacts += static_cast<double>(count);
    bytes = static_cast<double>(simulation.memory_bytes()) / spheres;
  }
};

// Gases that start from the same crystal, so that all melt in the same way; a cell is a cube of the crystal,
// four spheres, 2.8 diameters wide. Small gases run many times, for the same number of contacts.
TEST(WorkPerContact, AndMemoryPerSphereDoNotGrowWithTheNumberOfSpheres) {
  const double cell_edge = support::cube_edge(4, kPacking) * (1 - 1e-9);
  std::vector<std::size_t> cubes_per_axis{12, 18, 30, 63};  // 6,912 to 1,000,188 spheres
  if (support::kIsSlowBuild) cubes_per_axis = {12, 14};
  std::vector<Work> all;
  for (const std::size_t cubes : cubes_per_axis) {
    const std::size_t count = 4 * cubes * cubes * cubes;
    Work work;
    for (std::uint64_t seed = 0; work.contacts < 50000; ++seed) {
      const support::Gas gas{
          .count = count, .packing_fraction = kPacking, .seed = 201 + seed, .start = support::Start::fcc};
      work.add_run(support::make_gas(gas), cell_edge, count / 2);
    }
    const std::string n = to_text(count);
    support::record("predictions_" + n, work.predictions / work.contacts);
    support::record("queue_operations_" + n, work.queue_operations / work.contacts);
    support::record("bytes_" + n, work.bytes);
    all.push_back(work);
  }
  for (const Work& work : all) {
    // The counts are the same up to fluctuations over 5e4 contacts, below 1%.
    EXPECT_NEAR(work.predictions / work.contacts, all[0].predictions / all[0].contacts,
                0.03 * all[0].predictions / all[0].contacts);
    EXPECT_NEAR(work.queue_operations / work.contacts, all[0].queue_operations / all[0].contacts,
                0.03 * all[0].queue_operations / all[0].contacts);
    EXPECT_NEAR(work.crossings / work.contacts, all[0].crossings / all[0].contacts,
                0.03 * all[0].crossings / all[0].contacts);
    EXPECT_NEAR(work.bytes / all[0].bytes, 1, 0.2);
  }
}

// A sphere of diameter one touches (1 + 1 / L)^3 cells, L being the edge, and finds in each, besides itself,
// n0 (L + 1)^3 others; there are (1 + 1 / L)^2 cells in a row that it enters. Cells are released only at the
// next crossing or change of path, which adds about a quarter.
TEST(WorkPerContact, IsAtMostAThirdAboveTheory) {
  constexpr std::size_t kSpheres = 4000;
  const double edge = support::cube_edge(kSpheres, kPacking) / 11;  // 2.5 diameters
  const World world =
      support::settled(support::make_gas({.count = kSpheres, .packing_fraction = kPacking, .seed = 202}), 4);
  Work work;
  work.add_run(world, edge * (1 - 1e-9), 20000);
  const double in_cell = kDensity * std::pow(edge + 1, 3);
  const double all = std::pow(1 + 1 / edge, 3) * (1 + in_cell);
  const double entered = std::pow(1 + 1 / edge, 2) * in_cell;
  const double theory = (2 * work.contacts + work.stale) * all + work.crossings * entered;
  support::record("predictions_over_theory", work.predictions / theory);
  EXPECT_LT(work.predictions / theory, 4.0 / 3);
  EXPECT_GT(work.predictions / theory, 0.95);
}

// The same spheres, their distances stretched by `stretch`.
World stretched(const World& world, Boundary boundary, double stretch) {
  const Vec3 size = stretch * world.box().size();
  World other(Box({boundary, boundary, boundary}, size));
  for (Slot slot = 0; slot < world.size(); ++slot) {
    other.add({.position = stretch * world.path(slot).position,
               .velocity = world.path(slot).velocity,
               .radius = world.base_radius(slot)});
  }
  return other;
}

double bytes_after_a_run(const World& world, const EngineOptions& options) {
  Simulation simulation(world, options);
  simulation.run({.contacts = world.size(), .steps = 40 * world.size()});
  return static_cast<double>(simulation.memory_bytes()) / static_cast<double>(world.size());
}

TEST(Memory, DoesNotDependOnTheSizeOfTheBox) {
  constexpr std::size_t kSpheres = 4000;
  const World world = support::make_gas({.count = kSpheres, .packing_fraction = kPacking, .seed = 203});
  const double dense = bytes_after_a_run(world, {});
  support::record("dense", dense);
  for (const double stretch : {1e2, 1e4, 1e6}) {  // up to 1e18 times the volume
    for (const Boundary boundary : {Boundary::periodic, Boundary::open}) {
      const double sparse = bytes_after_a_run(stretched(world, boundary, stretch), {});
      support::record((boundary == Boundary::open ? "open_" : "periodic_") + to_text(stretch), sparse);
      // Cells that outnumber the spheres share lists.
      EXPECT_LT(sparse, 2 * dense);
    }
  }
}

// Cells of a fixed size, 1e9 times as many as spheres: each sphere occupies a few, and no others take memory.
TEST(Memory, DoesNotDependOnTheNumberOfEmptyCells) {
  constexpr std::size_t kSpheres = 4000;
  const double edge = support::cube_edge(kSpheres, kPacking) / 11 * (1 - 1e-9);
  const World world = support::make_gas({.count = kSpheres, .packing_fraction = kPacking, .seed = 204});
  const double sparse = bytes_after_a_run(stretched(world, Boundary::periodic, 10), {.cell_edge = edge});
  support::record("dense", bytes_after_a_run(world, {.cell_edge = edge}));
  support::record("sparse", sparse);
  // A sphere touches (1 + 1 / 2.5)^3 = 2.7 cells on average and holds some that it has left; each costs two
  // cache lines and its share of a table that is a quarter to a half full.
  EXPECT_LT(sparse, 2500);
  for (const double stretch : {1e2, 1e4}) {
    const double bytes =
        bytes_after_a_run(stretched(world, Boundary::periodic, stretch), {.cell_edge = edge});
    EXPECT_NEAR(bytes / sparse, 1, 0.2);
  }
  const double open = bytes_after_a_run(stretched(world, Boundary::open, 1e4), {.cell_edge = edge});
  EXPECT_NEAR(open / sparse, 1, 0.2);
}

}  // namespace
}  // namespace hardball::work_test
