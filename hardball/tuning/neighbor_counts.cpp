// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/tuning/neighbor_counts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "hardball/broadphase/neighbor_list.hpp"
#include "hardball/theory/kinetic_theory.hpp"

namespace hardball {

NeighborCounts expected_neighbor_counts(const GasStatistics& statistics, double skin) {
  NeighborCounts counts;
  if (statistics.spheres == 0) return counts;
  const std::array<double, 6> m = statistics.region_power();
  const double density = statistics.number_density();
  const double path = mean_free_path(statistics);
  counts.collision = statistics.events_per_collision() / mean_free_time(statistics);
  counts.wall = wall_rate(statistics);
  // Measured: docs/theory.md.
  counts.stale = counts.collision / 25;
  // A sphere flies straight out of a ball smaller than its free path and diffuses out of a larger one. The
  // factor is measured: docs/theory.md.
  const double diffusion = statistics.is_flat() ? 0.3 : 0.2;
  counts.rebuild = statistics.mean_speed / (skin * (1 + diffusion * skin / path));
  // In a sheared box lists are longer, and expire.
  const double largest_radius = statistics.region_scale * statistics.largest_radius;
  const double edge = NeighborList::cell_edge(largest_radius, skin);
  const double slide =
      NeighborList::slide_of_skin(statistics.box, largest_radius, skin, statistics.mean_speed) * skin;
  if (slide > 0) counts.rebuild += std::fabs(statistics.box.shear().rate) * edge / slide;
  const double reach = skin + slide / 4;
  counts.is_far = statistics.spheres > kVeryManySpheres;
  const double searched_edge = 3 * (edge + slide / 2);
  // The mean of (sum of two radii + 2 reach) cubed, or in two dimensions squared.
  const double sum = 2 * m[1];
  const double sum_squared = 2 * m[2] + 2 * m[1] * m[1];
  if (statistics.is_flat()) {
    const double squared = sum_squared + 4 * reach * sum + 4 * reach * reach;
    counts.neighbors = std::max(1.0, std::numbers::pi * density * squared + excess_about_sphere(statistics));
    counts.searched = density * searched_edge * searched_edge;
    counts.rows = 3;
    counts.listed = 0.6;
    return counts;
  }
  const double sum_cubed = 2 * m[3] + 6 * m[1] * m[2];
  const double cubed =
      sum_cubed + 6 * reach * sum_squared + 12 * reach * reach * sum + 8 * reach * reach * reach;
  counts.neighbors =
      std::max(1.0, 4 * std::numbers::pi / 3 * density * cubed + excess_about_sphere(statistics));
  counts.searched = density * std::pow(searched_edge, 3);
  return counts;
}

double cost_rate(const NeighborCounts& counts, const UnitCosts& costs) {
  // What an anchor searched costs, in candidates of a cell, and a rebuild whose anchors are far away: fitted,
  // as NeighborCounts::listed, so that lists are chosen where they are faster than cells, see docs/theory.md.
  constexpr double kSearch = 0.6;
  constexpr double kFarRebuild = 1.3;
  const double pass = costs.cell + counts.listed * costs.prediction * counts.neighbors;
  const double rebuild = (counts.is_far ? kFarRebuild : 1) * (costs.enter + counts.rows * costs.cell +
                                                              kSearch * costs.prediction * counts.searched);
  return costs.contact * (counts.collision / 2 + counts.wall) +
         (counts.collision + counts.wall + counts.stale) * pass + counts.rebuild * rebuild;
}

double optimal_skin(const GasStatistics& statistics, const UnitCosts& costs) {
  if (statistics.spheres == 0) return 1;
  GasStatistics moving = statistics;
  if (!(moving.mean_speed > 0)) moving.mean_speed = 1;  // the optimum does not depend on it
  constexpr double kStep = 1.05;
  constexpr int kSteps = 96;  // up to 103 times the smallest
  // Of longer lists, too many leave their cache line: measured, docs/theory.md.
  constexpr double kMaxNeighbors = 12.3;
  double best = 0;
  double least = std::numeric_limits<double>::infinity();
  double skin = 0.05 * statistics.largest_radius;
  for (int i = 0; i < kSteps; ++i, skin *= kStep) {
    const NeighborCounts counts = expected_neighbor_counts(moving, skin);
    if (best > 0 && counts.neighbors > kMaxNeighbors && statistics.region_scale == 1) break;
    const double cost = cost_rate(counts, costs);
    if (cost >= least) continue;
    least = cost;
    best = skin;
  }
  return best;
}

std::optional<double> better_skin(const GasStatistics& statistics, double skin, const ListUse& use,
                                  const UnitCosts& costs) {
  if (statistics.spheres == 0 || !(statistics.mean_speed > 0)) return std::nullopt;
  constexpr double kWorth = 0.9;
  constexpr double kShortest = 16;  // with padding
  constexpr double kStep = 1.25;
  constexpr int kSteps = 10;  // up to 9 times smaller or larger
  const NeighborCounts expected = expected_neighbor_counts(statistics, skin);
  const double crowding = use.neighbors / expected.neighbors;
  const double rebuilds = use.rebuilds * (expected.collision + expected.wall) / expected.rebuild;
  const auto cost_with = [&](double other) {
    NeighborCounts counts = expected_neighbor_counts(statistics, other);
    counts.neighbors = std::max(kShortest, crowding * counts.neighbors);
    counts.searched *= crowding;
    counts.rebuild *= rebuilds;
    return cost_rate(counts, costs);
  };
  double best = skin;
  double least = kWorth * cost_with(skin);
  for (int i = -kSteps; i <= kSteps; ++i) {
    const double other = skin * std::pow(kStep, i);
    const double cost = cost_with(other);
    if (cost >= least) continue;
    least = cost;
    best = other;
  }
  return best == skin ? std::nullopt : std::optional(best);
}

BestLength best_skin(const GasStatistics& statistics, const UnitCosts& costs) {
  const double skin = optimal_skin(statistics, costs);
  return {skin, cost_rate(expected_neighbor_counts(statistics, skin), costs)};
}

}  // namespace hardball
