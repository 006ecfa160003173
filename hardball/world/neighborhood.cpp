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
  Cell cell = cell_at(level, center);
  fold(level, cell);
  std::uint32_t& head = level.head[bucket(level, cell)];
  next_.push_back(head);
  head = static_cast<std::uint32_t>(spheres_.size());
  spheres_.push_back({center, radius});
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

Image Neighborhood::fold(const Level& level, Cell& cell) {
  Image image;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const std::int64_t count = level.count[axis];
    if (count == 0) continue;
    const std::int64_t boxes = cell[axis] >= 0 ? cell[axis] / count : -((count - 1 - cell[axis]) / count);
    image[axis] = static_cast<std::int32_t>(boxes);
    cell[axis] -= boxes * count;
  }
  return image;
}

std::size_t Neighborhood::bucket(const Level& level, const Cell& cell) {
  std::uint64_t hash = 0;
  for (const std::int64_t index : cell) {
    hash = (hash ^ static_cast<std::uint64_t>(index)) * 0x9e3779b97f4a7c15;
    hash ^= hash >> 32;
  }
  return hash & (level.head.size() - 1);
}

Neighborhood::Level& Neighborhood::level_for(double radius) {
  std::size_t level = 0;
  while (level + 1 < levels_.size() && radius <= levels_[level + 1].largest_radius) ++level;
  return levels_[level];
}

}  // namespace hardball
