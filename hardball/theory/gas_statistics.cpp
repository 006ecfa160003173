// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/theory/gas_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace hardball {
namespace {

// Twice the length of the interval that holds the middle half of all centers along an open axis: the extent
// of a uniform cloud, robust against a few distant spheres.
double stretch(const World& world, std::size_t axis, const Time& moment) {
  std::vector<double> coordinates;
  coordinates.reserve(world.size());
  for (Slot slot = 0; slot < world.size(); ++slot) {
    coordinates.push_back(world.unfolded_position(slot, moment)[axis]);
  }
  const auto quarter = static_cast<std::ptrdiff_t>(coordinates.size() / 4);
  const auto low = coordinates.begin() + quarter;
  const auto high = coordinates.end() - 1 - quarter;
  std::nth_element(coordinates.begin(), high, coordinates.end());
  std::nth_element(coordinates.begin(), low, high);
  return std::max(2 * (*high - *low), 2 * world.largest_radius());
}

}  // namespace

double GasStatistics::mean_speed_along_axis() const {
  return is_flat() ? 2 / std::numbers::pi * mean_speed : mean_speed / 2;
}

double GasStatistics::packing_fraction() const {
  if (is_flat()) return number_density() * std::numbers::pi * radius_power[2];
  return number_density() * 4 * std::numbers::pi / 3 * radius_power[3];
}

GasStatistics gas_statistics(const World& world, const Time& moment) {
  GasStatistics statistics;
  statistics.spheres = world.size();
  statistics.box = world.box();
  if (world.size() == 0) return statistics;
  statistics.radius_power = {};
  // In order of ids, so that the sums do not depend on how spheres are stored.
  world.for_each_by_id([&](Slot slot) {
    double power = 1;
    for (double& sum : statistics.radius_power) {
      sum += power;
      power *= world.radius(slot);
    }
    statistics.mean_speed += length(world.velocity(slot, moment));
  });
  const double per_sphere = 1 / static_cast<double>(world.size());
  for (double& sum : statistics.radius_power) sum *= per_sphere;
  statistics.mean_speed *= per_sphere;
  statistics.largest_radius = world.largest_radius();
  // Surfaces and gravity may keep spheres together in a part of the box.
  const bool is_confined = !world.surfaces().empty() || !world.motion().is_straight();
  for (std::size_t axis = 0; axis < statistics.box.dimensions(); ++axis) {
    statistics.extent[axis] = world.box().size()[axis];
    if (world.box().is_open(axis) || is_confined) {
      statistics.extent[axis] = std::min(statistics.extent[axis], stretch(world, axis, moment));
    }
  }
  return statistics;
}

bool are_alike(const GasStatistics& a, const GasStatistics& b) {
  const auto is_close = [](double x, double y) {
    constexpr double kSameEnough = 0.02;
    return std::fabs(x - y) <= kSameEnough * std::fabs(y);
  };
  return a.spheres == b.spheres && a.mean_speed > 0 && b.mean_speed > 0 &&
         is_close(a.mean_radius(), b.mean_radius()) && is_close(a.extent.x, b.extent.x) &&
         is_close(a.extent.y, b.extent.y) && is_close(a.extent.z, b.extent.z);
}

}  // namespace hardball
