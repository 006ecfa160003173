// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/tuning/size_classes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "hardball/broadphase/large_sphere_grid.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/theory/kinetic_theory.hpp"
#include "hardball/tuning/cell_edge.hpp"

namespace hardball {
namespace {

// A cell that a large sphere searches costs this many cells more: measured, docs/theory.md.
constexpr double kLargeCell = 6;

// Of velocities distributed as Maxwell's.
double mean_relative_speed(const SizeClass& a, const SizeClass& b) {
  return std::sqrt(a.mean_speed * a.mean_speed + b.mean_speed * b.mean_speed);
}

}  // namespace

std::vector<SizeClass> size_classes(const World& world, const Time& moment) {
  constexpr double kPerOctave = 4;
  std::map<int, SizeClass> classes;
  world.for_each_by_id([&](Slot slot) {
    const double radius = world.bounding_radius(slot);
    SizeClass& own = classes[static_cast<int>(std::floor(kPerOctave * std::log2(radius)))];
    own.spheres += 1;
    own.radius += radius;
    own.mean_speed += length(world.velocity(slot, moment));
  });
  std::vector<SizeClass> sorted;
  for (const auto& [number, sum] : classes) {
    sorted.push_back({sum.spheres, sum.radius / sum.spheres, sum.mean_speed / sum.spheres});
  }
  return sorted;
}

bool are_sizes_spread(const GasStatistics& statistics) {
  constexpr double kSpread = 1.5;
  return statistics.spheres > 0 && statistics.largest_radius > kSpread * statistics.mean_radius();
}

double cost_rate_by_class(const GasStatistics& statistics, const std::vector<SizeClass>& classes, double edge,
                          const UnitCosts& costs) {
  const bool is_flat = statistics.is_flat();
  const std::size_t dimensions = statistics.box.dimensions();
  const double cells = statistics.volume() / (is_flat ? edge * edge : edge * edge * edge);
  const auto fits = [&](const SizeClass& one) { return one.radius <= LargeSizes::kLargestInCell * edge; };
  double surfaces = 0;  // of those that do not fit into cells
  for (const SizeClass& one : classes) {
    if (!fits(one)) surfaces += one.spheres * LargeSizes::cells_of_surface(one.radius / edge, dimensions);
  }
  const double largest_in_grid =
      LargeSizes::largest_in_edges(surfaces, static_cast<double>(statistics.spheres)) * edge;
  const auto is_large = [&](const SizeClass& one) { return one.radius > largest_in_grid; };
  // Where regions are no blocks, crossings and searches cost more: measured, docs/theory.md.
  constexpr double kRows = 1.15;
  const bool has_blocks =
      ranges::all_of(classes, [&](const SizeClass& one) { return fits(one) || is_large(one); });
  const double in_rows = has_blocks ? 1 : kRows;
  // A sphere is still in cells that it has left.
  constexpr double kReleasedLate = 1.3;
  const auto cells_held = [&](const SizeClass& one) {
    const double rows = 1 + 2 * one.radius / edge;
    return is_large(one) ? LargeSizes::cells_of_surface(one.radius / edge, dimensions)
                         : kReleasedLate * rows * rows * (is_flat ? 1 : rows);
  };
  double occupants = 0;  // of a cell
  for (const SizeClass& one : classes) occupants += one.spheres * cells_held(one) / cells;
  const double search = costs.cell + costs.prediction * occupants;  // of a cell
  const double crowding = contact_value(statistics);
  constexpr double kDiffusion = 0.2;
  double cost = 0;
  for (const SizeClass& one : classes) {
    double collisions = 0;
    for (const SizeClass& other : classes) {
      const double reach = one.radius + other.radius;
      const double section = is_flat ? 2 * reach : std::numbers::pi * reach * reach;
      collisions +=
          other.spheres / statistics.volume() * section * mean_relative_speed(one, other) * crowding;
    }
    double each = collisions * costs.contact / 2;
    if (!is_large(one)) {
      const double rows = 1 + 2 * one.radius / edge;
      const double touched = is_flat ? rows * rows : rows * rows * rows;
      const double crossings = (is_flat ? 4 / std::numbers::pi : 1.5) * one.mean_speed / edge;
      each += in_rows * crossings * (costs.enter + touched / rows * search);
      each += in_rows * collisions * touched * search;
    } else {
      const double touched = cells_held(one);
      const double search_of_large = search + kLargeCell * costs.cell;
      const double skin = LargeSizes::kSkin * edge;
      const double path = collisions > 0 ? one.mean_speed / collisions : skin;
      const double candidates = touched * occupants;
      each += one.mean_speed / (skin * (1 + kDiffusion * skin / std::max(path, 0x1p-60 * skin))) *
              (costs.enter + touched * (2 * costs.cell + search_of_large));
      // A list costs as much as the searches for it.
      const double nearby = candidates / edge * LargeSphereGrid::kUsualSpeed * statistics.mean_speed /
                            std::max(collisions, 1e-300);
      const double listed = 2 * std::sqrt(candidates * nearby) * costs.prediction;
      each +=
          collisions * (candidates < ApproachList::kMinToList ? touched * search_of_large
                                                              : std::min(listed, touched * search_of_large));
    }
    cost += one.spheres * each;
  }
  return cost / static_cast<double>(statistics.spheres);
}

double optimal_edge_by_class(const GasStatistics& statistics, const std::vector<SizeClass>& given,
                             const UnitCosts& unit_costs) {
  const UnitCosts costs = costs_with_memory(statistics, unit_costs);
  GasStatistics moving = statistics;
  std::vector<SizeClass> classes = given;
  if (!(statistics.mean_speed > 0)) {
    moving.mean_speed = 1;
    for (SizeClass& one : classes) one.mean_speed = 1;
  }
  constexpr double kSurplus = 1.1;
  constexpr double kStep = 1.06;
  constexpr int kSteps = 120;  // up to a thousand times the smallest
  double counted = 0;
  double smallest = 0;
  for (const SizeClass& one : classes) {
    if (2 * counted <= static_cast<double>(statistics.spheres)) smallest = 2 * kSurplus * one.radius;
    counted += one.spheres;
  }
  double best = smallest;
  double least = std::numeric_limits<double>::infinity();
  double edge = smallest;
  for (int i = 0; i < kSteps; ++i, edge *= kStep) {
    const double cost = cost_rate_by_class(moving, classes, edge, costs);
    if (!(cost < least)) continue;
    least = cost;
    best = edge;
  }
  return best;
}

BestLength best_edge(const World& world, const Time& moment, const GasStatistics& statistics,
                     const UnitCosts& costs) {
  if (!are_sizes_spread(statistics)) return best_cell_edge(statistics, costs);
  const std::vector<SizeClass> classes = size_classes(world, moment);
  // In a small box, candidates must come from smaller cells to be nearest images.
  constexpr double kStep = 1.15;
  constexpr int kSteps = 20;
  double edge = optimal_edge_by_class(statistics, classes, costs);
  for (int i = 0; i < kSteps; ++i, edge /= kStep) {
    const bool has_large = edge < statistics.largest_radius / LargeSizes::kLargestInRows;
    if (!has_large || LargeSphereGrid::supports(world, edge)) {
      return {edge, cost_rate_by_class(statistics, classes, edge, costs)};
    }
  }
  return best_cell_edge(statistics, costs);
}

}  // namespace hardball
