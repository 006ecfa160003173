// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/tuning/cell_edge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace hardball {
namespace {

// The length of the stretch that holds the middle half of all centres along an open axis, doubled: the extent
// of a uniform cloud, untouched by a few spheres far out.
double extent(const World& world, std::size_t axis, const Time& moment) {
  std::vector<double> places;
  places.reserve(world.size());
  for (const Path& path : world.paths()) places.push_back(position_at(path, moment)[axis]);
  const auto quarter = static_cast<std::ptrdiff_t>(places.size() / 4);
  const auto low = places.begin() + quarter;
  const auto high = places.end() - 1 - quarter;
  std::nth_element(places.begin(), high, places.end());
  std::nth_element(places.begin(), low, high);
  return std::max(2 * (*high - *low), 2 * world.largest_radius());
}

}  // namespace

double Moments::packing_fraction() const {
  return number_density() * 4 * std::numbers::pi / 3 * mean_cube_radius;
}

double Moments::contact_value() const {
  // Beyond the fluid's range the expression is held at its value there.
  const double packing = std::min(packing_fraction(), 0.5);
  const double free = 1 - packing;
  return (1 - packing / 2) / (free * free * free);
}

double Moments::mean_free_path() const {
  if (spheres < 2) return std::numeric_limits<double>::infinity();
  // The mean of (r_i + r_j)^2 over pairs.
  const double reach_squared = 2 * (mean_square_radius + mean_radius * mean_radius);
  return 1 / (std::numbers::sqrt2 * std::numbers::pi * reach_squared * number_density() * contact_value());
}

double Moments::mean_free_time() const {
  return mean_speed > 0 ? mean_free_path() / mean_speed : std::numeric_limits<double>::infinity();
}

Moments moments_of(const World& world, const Time& moment) {
  Moments moments;
  moments.spheres = world.size();
  if (world.size() == 0) return moments;
  for (Slot slot = 0; slot < world.size(); ++slot) {
    const double radius = world.radius(slot);
    moments.mean_radius += radius;
    moments.mean_square_radius += radius * radius;
    moments.mean_cube_radius += radius * radius * radius;
    moments.mean_speed += length(world.path(slot).velocity);
  }
  const double per_sphere = 1 / static_cast<double>(world.size());
  moments.mean_radius *= per_sphere;
  moments.mean_square_radius *= per_sphere;
  moments.mean_cube_radius *= per_sphere;
  moments.mean_speed *= per_sphere;
  moments.largest_radius = world.largest_radius();
  moments.volume = 1;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    moments.volume *= world.box().is_open(axis) ? extent(world, axis, moment) : world.box().size()[axis];
  }
  return moments;
}

double optimal_cell_edge(const Moments& moments, const UnitCosts& costs) {
  if (moments.spheres == 0) return 1;
  // The derivative of the cost by the edge vanishes where the cost of candidates, growing with the edge,
  // meets the cost of crossings, falling with it. Both are monotone: bisect.
  const double diameter = 2 * moments.mean_radius;
  const double density = moments.number_density();
  const double free_path = moments.mean_free_path();
  const auto crossings_outweigh = [&](double edge) {
    const double reach = edge + 2 * diameter;
    const double candidates = 2 * density * edge * edge * reach * (1 + reach / free_path) * costs.prediction;
    const double crossings =
        3 * costs.queue_operation + costs.cell_update * (1 + diameter / edge) * (1 + 3 * diameter / edge);
    return crossings > candidates;
  };
  double low = diameter / 1024;
  double high = std::max(2 * low, 16 * std::cbrt(1 / density));
  while (crossings_outweigh(high)) high *= 2;
  constexpr int kHalvings = 40;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (low + high) / 2;
    (crossings_outweigh(middle) ? low : high) = middle;
  }
  // Large spheres must not be spread over too many cells.
  return std::max(high, moments.largest_radius / 4);
}

}  // namespace hardball
