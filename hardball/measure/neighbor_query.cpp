// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/neighbor_query.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hardball {
namespace {

// Then few cells and few spheres are searched in vain, whatever the range.
constexpr double kSpheresInCell = 2;

// Of a cube, in two dimensions of a square.
double edge_of(const Box& box, double volume) {
  return box.is_flat() ? std::sqrt(volume) : std::cbrt(volume);
}

}  // namespace

double shortest_period(const Box& box) {
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < box.dimensions(); ++axis) {
    if (box.is_periodic(axis)) shortest = std::min(shortest, box.size()[axis]);
  }
  return shortest;
}

bool is_same_box(const Box& a, const Box& b) {
  bool is_same = a.size() == b.size();
  for (std::size_t axis = 0; axis < kAxes; ++axis) is_same &= a.boundary(axis) == b.boundary(axis);
  return is_same;
}

NeighborQuery::Effort NeighborQuery::effort(const World& world, double range) {
  constexpr double kEachSphere = 100;
  constexpr double kEachCenter = 400;
  constexpr double kEachNeighbor = 30;
  const auto spheres = static_cast<double>(world.size());
  const double of_each = spheres * world.box().sphere_volume(range) / world.box().volume();
  const double affordable = std::min(kMaxNeighbors / of_each, static_cast<double>(kMaxCenters));
  const std::size_t chosen = std::min(world.size(), static_cast<std::size_t>(std::fmax(affordable, 1.0)));
  const auto centers = static_cast<double>(chosen);
  return {.centers = chosen,
          .neighbors = centers * of_each,
          .cost = kEachSphere * spheres + centers * (kEachCenter + kEachNeighbor * of_each)};
}

NeighborQuery::NeighborQuery(const World& world, std::span<const Vec3> centers, double extent,
                             const Time& now)
    : world_(world),
      centers_(centers),
      ball_(edge_of(world.box(), kSpheresInCell * extent / static_cast<double>(centers.size())) / 2),
      neighborhood_(world.box(), centers.size(), ball_, now) {
  radii_.reserve(centers.size());
  world.for_each_by_id([&](Slot slot) { radii_.push_back(world.base_radius(slot)); });
  for (const Vec3& center : centers) neighborhood_.insert(center, ball_);
}

}  // namespace hardball
