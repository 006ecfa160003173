// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/world/static_hash_grid.hpp"

#include <algorithm>
#include <bit>
#include <limits>

namespace hardball {

StaticHashGrid::StaticHashGrid(const Box& box, std::size_t capacity, double largest_radius,
                               const Time& moment)
    : box_(box), slid_(box.is_sheared() ? box.images().displacement_in_box(moment) : 0), capacity_(capacity) {
  // Radii of at most 2^-19 times the largest share the last level.
  constexpr int kLevels = 20;
  for (int i = 0; i < kLevels; ++i) {
    Level level;
    level.largest_radius = std::ldexp(largest_radius, -i);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      // Without an axis there is a single layer.
      level.edge[axis] = box.boundary(axis) == Boundary::flat ? std::numeric_limits<double>::infinity()
                                                              : 2 * level.largest_radius;
      if (!box.is_periodic(axis)) continue;
      level.count[axis] = std::max<std::int64_t>(
          1, static_cast<std::int64_t>(std::min(1e9, box.size()[axis] / level.edge[axis])));
      level.edge[axis] = box.size()[axis] / static_cast<double>(level.count[axis]);
    }
    levels_.push_back(std::move(level));
  }
  spheres_.reserve(capacity);
}

void StaticHashGrid::insert(const Vec3& center, double radius) {
  Level& level = levels_[level_for(radius)];
  if (level.buckets.empty()) level.buckets.resize(std::bit_ceil(std::max<std::size_t>(capacity_, 1)));
  const Cell cell = cell_at(level, center);
  const auto folded = [&](std::size_t axis) { return fold(cell[axis], level.count[axis]).index; };
  const std::uint64_t key = cell_key(column_key(folded(0), folded(1)), folded(2));
  Bucket& bucket = level.buckets[key & (level.buckets.size() - 1)];
  spheres_.push_back({center, radius, key, bucket.last});
  bucket.last = static_cast<std::uint32_t>(spheres_.size() - 1);
  bucket.tags |= tag(key);
}

StaticHashGrid::Cell StaticHashGrid::cell_at(const Level& level, const Vec3& position) {
  // Spheres beyond this many cells share the outermost ones.
  constexpr double kFarthest = 1e15;
  Cell cell;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double index = std::clamp(position[axis] / level.edge[axis], -kFarthest, kFarthest);
    // Without SSE4.1, std::floor is a function call.
    cell[axis] = static_cast<std::int64_t>(index);
    cell[axis] -= static_cast<double>(cell[axis]) > index ? 1 : 0;
  }
  return cell;
}

std::size_t StaticHashGrid::level_for(double radius) const {
  std::size_t level = 0;
  while (level + 1 < levels_.size() && radius <= levels_[level + 1].largest_radius) ++level;
  return level;
}

}  // namespace hardball
