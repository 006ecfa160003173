// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT

// Boxes of every scale in the operating range, cubes, slabs and needles: the work of the set-up and of the
// cells depends only on the number of spheres.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "hardball/errors/error.hpp"
#include "hardball/placement/placement.hpp"
#include "hardball/simulation/simulation.hpp"
#include "hardball/theory/gas_statistics.hpp"
#include "hardball/theory/kinetic_theory.hpp"
#include "hardball/tuning/cell_counts.hpp"
#include "hardball/tuning/cell_edge.hpp"
#include "hardball/tuning/neighbor_counts.hpp"
#include "hardball/world/audit.hpp"
#include "support/history.hpp"

namespace hardball::box_scales_test {
namespace {

constexpr std::array<double, 9> kScales{1e-60, 1e-45, 1e-30, 1e-15, 1, 1e15, 1e30, 1e45, 1e60};

// Each axis and each pair of axes at every scale, the others of size ten; and cubes.
std::vector<Vec3> boxes() {
  std::vector<Vec3> sizes;
  for (const double scale : kScales) {
    for (std::uint32_t scaled = 1; scaled < 8; ++scaled) {
      Vec3 size{10, 10, 10};
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        if ((scaled >> axis & 1) != 0) size[axis] = scale;
      }
      sizes.push_back(size);
    }
  }
  return sizes;
}

std::size_t longest_axis(const Vec3& size) {
  std::size_t longest = 0;
  for (std::size_t axis = 1; axis < kAxes; ++axis) {
    if (size[axis] > size[longest]) longest = axis;
  }
  return longest;
}

double shortest(const Vec3& size) {
  return std::min({size.x, size.y, size.z});
}

// Two spheres on a line along the longest axis. One moves, by the length of that axis in a unit of time, and
// hits the other.
World two_spheres(const Box& box, const Vec3& size, double radius) {
  World world(box);
  const std::size_t along = longest_axis(size);
  Sphere sphere{0.5 * size, {}, radius, 1};
  sphere.position[along] = size[along] / 4;
  sphere.velocity[along] = size[along];
  world.add(sphere);
  sphere.position[along] = 3 * size[along] / 4;
  sphere.velocity = {};
  world.add(sphere);
  return world;
}

// Calls visit(world) for two spheres of several sizes in each of the boxes, with each kind of boundary.
template <class Visit>
void for_each_world(Visit&& visit) {
  for (const Vec3& size : boxes()) {
    const double largest = shortest(size) / 8;
    for (const double radius : {largest, std::sqrt(largest * 1e-60), 1e-60}) {
      if (radius < 1e-60 || radius > largest) continue;
      for (const Boundary boundary : {Boundary::wall, Boundary::periodic, Boundary::open}) {
        SCOPED_TRACE("size " + to_text(size.x) + " " + to_text(size.y) + " " + to_text(size.z) + ", radius " +
                     to_text(radius) + ", boundary " + to_text(static_cast<int>(boundary)));
        visit(two_spheres(Box({boundary, boundary, boundary}, size), size, radius));
      }
    }
  }
}

TEST(BoxesOfEveryScale, HaveTheSameHistoryForAllPairsWithFewCrossings) {
  for_each_world([](const World& world) {
    const auto run = [&world](EngineKind engine) { return Simulation(world, {.engine = engine}); };
    const RunLimits limits{.until = Time(5), .contacts = 10, .steps = 10000};
    Simulation all_pairs = run(EngineKind::all_pairs);
    const support::History expected = support::run_on(all_pairs, limits);
    EXPECT_GE(all_pairs.counters().collision, 1U);
    for (const EngineKind engine : {EngineKind::automatic, EngineKind::cells, EngineKind::paper}) {
      Simulation simulation = run(engine);
      EXPECT_EQ(support::difference(support::run_on(simulation, limits), expected), "");
      EXPECT_LT(simulation.counters().enter, 500U);
      EXPECT_GE(simulation.counters().enter + simulation.counters().contacts(), 1U);
    }
  });
}

TEST(BoxesOfEveryScale, AreRunByNeighborListsToo) {
  for_each_world([](const World& world) {
    Simulation simulation(world, {.engine = EngineKind::neighbors});
    // Balls are small compared with the box, so only the first steps are run.
    simulation.run({.until = Time(5), .steps = 100});
    simulation.validate();
  });
}

TEST(BoxesOfEveryScale, HaveFiniteExpectedCosts) {
  for_each_world([](const World& world) {
    const GasStatistics statistics = gas_statistics(world, Time(0));
    const double edge = optimal_cell_edge(statistics);
    const CellCounts cells = expected_counts(statistics, edge);
    const double skin = optimal_skin(statistics);
    for (const double positive : {edge, paper_cell_edge(statistics), skin, cost_rate(cells, UnitCosts{}),
                                  rebuild_cost(cells, UnitCosts{}),
                                  cost_rate(expected_neighbor_counts(statistics, skin), UnitCosts{}),
                                  mean_free_path(statistics), mean_free_time(statistics)}) {
      EXPECT_GT(positive, 0);
      EXPECT_LT(positive, std::numeric_limits<double>::infinity());
    }
  });
}

TEST(BoxesOfEveryScale, AreFilledByALattice) {
  for (const Vec3& size : boxes()) {
    for (const Boundary boundary : {Boundary::wall, Boundary::periodic, Boundary::open}) {
      const Box box({boundary, boundary, boundary}, size);
      const double radius = std::max(1e-60, shortest(size) / 1000);
      if (2 * radius > shortest(size) / 16) continue;
      const std::vector<Vec3> centers = place_on_lattice(box, {{}, size}, 100, radius, "here");
      World world(box);
      for (const Vec3& center : centers) world.add({center, {}, radius, 1});
      EXPECT_EQ(world.size(), 100U);
      require_no_overlap(world, Time(0));
    }
  }
}

}  // namespace
}  // namespace hardball::box_scales_test
