// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/tuning/cell_edge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "hardball/geometry/spacing.hpp"

namespace hardball {
namespace {

// The edge of a cell containing one sphere on average [L].
double spacing_of(const GasStatistics& statistics) {
  return spacing(statistics.extent, static_cast<double>(statistics.spheres));
}

}  // namespace

double cost_rate(const CellCounts& counts, const UnitCosts& costs) {
  // Images must be found, and contact times computed exactly: measured, docs/theory.md.
  constexpr double kListedPrediction = 12;
  const double prediction =
      counts.are_images_listed ? kListedPrediction * costs.prediction : costs.prediction;
  const double passes = counts.collision + counts.wall + counts.stale;
  return costs.contact * (counts.collision / 2 + counts.wall) + costs.enter * counts.enter +
         costs.cell * (passes * counts.cells + counts.enter * counts.cells_entered) +
         prediction * counts.predictions();
}

double rebuild_cost(const CellCounts& counts, const UnitCosts& costs) {
  return costs.enter + costs.cell * counts.cells + costs.prediction * counts.candidates_at_any_time;
}

double optimal_cell_edge(const GasStatistics& statistics, const UnitCosts& unit_costs) {
  if (statistics.spheres == 0) return 1;
  const UnitCosts costs = costs_with_memory(statistics, unit_costs);
  GasStatistics moving = statistics;
  if (!(moving.mean_speed > 0)) moving.mean_speed = 1;  // the optimum does not depend on it
  constexpr double kSmallest = 1.0 / 8;
  const double smallest = std::max(kSmallest * spacing_of(statistics), statistics.largest_radius / 4);
  double best = smallest;
  double least = std::numeric_limits<double>::infinity();
  const auto scan = [&](double low, double step, int steps) {
    for (int i = 0; i <= steps; ++i, low *= step) {
      const double cost = cost_rate(expected_counts(moving, low), costs);
      if (cost < least) {
        least = cost;
        best = low;
      }
    }
  };
  // The number of cells along an axis is an integer, so that the cost has steps: scan coarsely, then finely.
  constexpr double kStep = 1.25;
  constexpr int kSteps = 24;  // up to 26 times the spacing
  scan(smallest, kStep, kSteps);
  const double coarse = best;
  scan(std::max(smallest, coarse / kStep), std::pow(kStep, 0.25), 8);
  return best;
}

BestLength best_cell_edge(const GasStatistics& statistics, const UnitCosts& costs) {
  const double edge = optimal_cell_edge(statistics, costs);
  return {edge, cost_rate(expected_counts(statistics, edge), costs)};
}

double paper_cell_edge(const GasStatistics& statistics, const UnitCosts& costs) {
  if (statistics.spheres == 0) return 1;
  const double density = statistics.number_density();
  const double radius = statistics.mean_radius();
  // 2 n0 (L + 2r)^2 {c1 pi r^2 n0 L^2 + c3 (L - r)} = c4. The left side grows from zero at or below L = r.
  // Derived in the same way, in two dimensions: n0 (L + 2r) {2 c1 r n0 L^2 + c3 (L - 2r)} = c4.
  const auto is_beyond = [&](double edge) {
    const double reach = edge + 2 * radius;
    if (statistics.is_flat()) {
      const double of_collisions = 2 * costs.prediction * radius * density * edge * edge;
      const double of_crossings = costs.prediction * (edge - 2 * radius);
      return density * reach * (of_collisions + of_crossings) > costs.enter + costs.cell;
    }
    const double collisions = costs.prediction * std::numbers::pi * radius * radius * density * edge * edge;
    const double crossings = costs.prediction * (edge - radius);
    return 2 * density * reach * reach * (collisions + crossings) > costs.enter + costs.cell;
  };
  double low = 0;
  double high = std::max(radius, spacing_of(statistics));
  while (!is_beyond(high)) high *= 2;
  constexpr int kHalvings = 50;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    (is_beyond(middle) ? high : low) = middle;
  }
  return high;
}

void CellEdgeWatch::restart(double edge) {
  edge_ = best_before_ = edge;
  regret_ = 0;
  last_statistics_ = {};
}

std::optional<double> CellEdgeWatch::update(const GasStatistics& statistics, double elapsed) {
  if (statistics.spheres == 0 || !(statistics.mean_speed > 0)) return std::nullopt;
  if (!are_alike(statistics, last_statistics_)) {
    last_statistics_ = statistics;
    best_edge_ = optimal_cell_edge(statistics, costs_);
    const CellCounts best = expected_counts(statistics, best_edge_);
    const double excess = cost_rate(expected_counts(statistics, edge_), costs_) - cost_rate(best, costs_);
    regret_per_length_ = std::max(0.0, excess) / statistics.mean_speed;
    rebuild_ = rebuild_cost(best, costs_);
  }
  regret_ += regret_per_length_ * statistics.mean_speed * elapsed;
  if (!(regret_ > rebuild_)) return std::nullopt;
  // Extrapolates: halfway to the next rebuild the best edge will have moved by half as much again, on a
  // logarithmic scale.
  constexpr double kFarthestAhead = 2;
  const double ahead = std::clamp(std::sqrt(best_edge_ / best_before_), 1 / kFarthestAhead, kFarthestAhead);
  const double best = best_edge_;
  restart(best * ahead);
  best_before_ = best;
  return edge_;
}

}  // namespace hardball
