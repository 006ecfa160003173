// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/world/neighborhood.hpp"

#include <algorithm>
#include <bit>

namespace hardball {

Neighborhood::Neighborhood(const Box& box, std::size_t capacity, double largest_radius)
    : box_(box), capacity_(capacity) {
  // Radii more than 2^-19 below the largest share the last level.
  constexpr int kLevels = 20;
  for (int i = 0; i < kLevels; ++i) {
    Level level;
    level.largest_radius = std::ldexp(largest_radius, -i);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      level.edge[axis] = 2 * level.largest_radius;
      if (!box.is_periodic(axis)) continue;
      level.count[axis] = std::max<std::int64_t>(
          1, static_cast<std::int64_t>(std::min(1e9, box.size()[axis] / level.edge[axis])));
      level.edge[axis] = box.size()[axis] / static_cast<double>(level.count[axis]);
    }
    levels_.push_back(std::move(level));
  }
  spheres_.reserve(capacity);
  next_.reserve(capacity);
}

void Neighborhood::insert(const Vec3& center, double radius) {
  Level& level = level_for(radius);
  if (level.head.empty()) level.head.assign(std::bit_ceil(std::max<std::size_t>(capacity_, 1)), kNone);
  const Cell cell = cell_at(level, center);
  std::uint64_t key = 0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) key = mix(key, fold(cell[axis], level.count[axis]).index);
  std::uint32_t& head = level.head[bucket(level, key)];
  next_.push_back(head);
  head = static_cast<std::uint32_t>(spheres_.size());
  spheres_.push_back({center, radius, key});
}

Neighborhood::Cell Neighborhood::cell_at(const Level& level, const Vec3& place) const {
  // Spheres beyond this many cells share the outermost ones.
  constexpr double kFarthest = 1e15;
  Cell cell;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double index = std::floor(place[axis] / level.edge[axis]);
    cell[axis] = static_cast<std::int64_t>(std::clamp(index, -kFarthest, kFarthest));
  }
  return cell;
}

Neighborhood::Level& Neighborhood::level_for(double radius) {
  std::size_t level = 0;
  while (level + 1 < levels_.size() && radius <= levels_[level + 1].largest_radius) ++level;
  return levels_[level];
}

}  // namespace hardball
