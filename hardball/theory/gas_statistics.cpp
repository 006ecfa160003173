// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/theory/gas_statistics.hpp"
#include "hardball/world/images.hpp"

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

void GasSums::record(const World& world, Slot slot, const Time& moment) {
  ++spheres;
  const double radius = world.radius(slot, moment);
  double power = 1;
  for (ExactSum& sum : radius_power) {
    sum += power;
    power *= radius;
  }
  speed += length(peculiar_velocity(world, slot, moment));
  largest_radius = std::max(largest_radius, world.base_radius(slot) * world.motion().largest_scale());
}

void GasSums::add(const GasSums& other) {
  spheres += other.spheres;
  for (std::size_t k = 0; k < radius_power.size(); ++k) radius_power[k].add(other.radius_power[k]);
  speed.add(other.speed);
  largest_radius = std::max(largest_radius, other.largest_radius);
}

// Surfaces and gravity may keep spheres together in a part of the box.
bool fills_box(const World& world) {
  return !world.box().is_any(Boundary::open) && world.surfaces().empty() && world.motion().is_straight();
}

GasStatistics gas_statistics(const GasSums& sums, const World& world) {
  GasStatistics statistics;
  statistics.spheres = sums.spheres;
  statistics.box = world.box();
  if (sums.spheres == 0) return statistics;
  const double per_sphere = 1 / static_cast<double>(sums.spheres);
  for (std::size_t k = 0; k < sums.radius_power.size(); ++k)
    statistics.radius_power[k] = sums.radius_power[k].value() * per_sphere;
  statistics.mean_speed = sums.speed.value() * per_sphere;
  statistics.largest_radius = sums.largest_radius;
  statistics.region_scale = world.interactions().steps().range();
  for (std::size_t axis = 0; axis < statistics.box.dimensions(); ++axis)
    statistics.extent[axis] = world.box().size()[axis];
  return statistics;
}

GasStatistics gas_statistics(const World& world, const Time& moment) {
  GasSums sums;
  for (Slot slot = 0; slot < world.size(); ++slot) sums.record(world, slot, moment);
  GasStatistics statistics = gas_statistics(sums, world);
  if (fills_box(world) || world.size() == 0) return statistics;
  const bool is_confined = !world.surfaces().empty() || !world.motion().is_straight();
  for (std::size_t axis = 0; axis < statistics.box.dimensions(); ++axis) {
    if (world.box().is_open(axis) || is_confined)
      statistics.extent[axis] = std::min(statistics.extent[axis], stretch(world, axis, moment));
  }
  return statistics;
}

std::array<double, 6> GasStatistics::region_power() const {
  std::array<double, 6> powers = radius_power;
  double scale = 1;
  for (double& power : powers) {
    power *= scale;
    scale *= region_scale;
  }
  return powers;
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
