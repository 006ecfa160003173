// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/surfaces/obstacle_tree.hpp"

#include <algorithm>
#include <cmath>

namespace hardball {
double distance_to(const Bounds& bounds, const Vec3& point) {
  Vec3 apart;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    apart[axis] = std::max({bounds.low[axis] - point[axis], point[axis] - bounds.high[axis], 0.0});
  }
  return length(apart);
}

ObstacleTree::ObstacleTree(std::vector<Obstacle> obstacles) : obstacles_(std::move(obstacles)) {
  if (obstacles_.empty()) return;
  nodes_.reserve(2 * obstacles_.size());
  nodes_.emplace_back();
  build(0, 0, static_cast<std::uint32_t>(obstacles_.size()));
}

void ObstacleTree::build(std::uint32_t node, std::uint32_t first, std::uint32_t count) {
  Bounds around = bounds_of(obstacles_[first]);
  Bounds centers{obstacles_[first].center, obstacles_[first].center};
  const auto enclose = [](Bounds& bounds, const Bounds& other, std::size_t axis) {
    bounds.low[axis] = std::min(bounds.low[axis], other.low[axis]);
    bounds.high[axis] = std::max(bounds.high[axis], other.high[axis]);
  };
  for (std::uint32_t i = first; i < first + count; ++i) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      enclose(around, bounds_of(obstacles_[i]), axis);
      enclose(centers, {obstacles_[i].center, obstacles_[i].center}, axis);
    }
  }
  if (count <= kLeaf) {
    nodes_[node] = {around, first, count};
    return;
  }
  const Vec3 extent = centers.high - centers.low;
  std::size_t longest = extent.y > extent.x ? 1 : 0;
  if (extent.z > extent[longest]) longest = 2;
  const auto begin = obstacles_.begin() + first;
  const std::uint32_t half = count / 2;
  std::nth_element(begin, begin + half, begin + count, [&](const Obstacle& a, const Obstacle& b) {
    return a.center[longest] < b.center[longest];
  });
  const auto children = static_cast<std::uint32_t>(nodes_.size());
  nodes_[node] = {around, children, 0};
  nodes_.resize(nodes_.size() + 2);
  build(children, first, half);
  build(children + 1, first + half, count - half);
}

}  // namespace hardball
