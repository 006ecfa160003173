// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/geometry/vec3.hpp"

namespace hardball {

/// An interval along each axis [L].
struct Bounds {
  Vec3 low;
  Vec3 high;
};

/// Whether two bounds have a point in common.
inline bool overlap(const Bounds& a, const Bounds& b) {
  return (a.low.x <= b.high.x) & (b.low.x <= a.high.x) & (a.low.y <= b.high.y) & (b.low.y <= a.high.y) &
         (a.low.z <= b.high.z) & (b.low.z <= a.high.z);
}

/// The distance from a point to the nearest point within bounds [L]; zero inside.
double distance_to(const Bounds& bounds, const Vec3& point);

/// Obstacles at rest in a tree of bounds, of which each is around half of the obstacles of its parent.
class ObstacleTree {
 public:
  /// A sphere at rest.
  struct Obstacle {
    Vec3 center;           ///< [L]
    double radius;         ///< [L]
    std::uint32_t number;  ///< By which it is known.
  };

  /// A tree of no obstacles.
  ObstacleTree() = default;
  /// Cost: O(n log^2 n).
  explicit ObstacleTree(std::vector<Obstacle> obstacles);

  bool is_empty() const { return nodes_.empty(); }
  /// The bounds of all obstacles. Precondition: not is_empty().
  const Bounds& bounds() const { return nodes_.front().bounds; }

  /// Calls visit(number) for each obstacle that may reach into a part of space. Cost: O(log n) for each of
  /// them.
  template <class Visit>
  void for_each_in(const Bounds& part, Visit&& visit) const {
    const double farthest = 0;
    for_each_within(
        farthest,
        [&](const Bounds& bounds) {
          return overlap(part, bounds) ? 0 : std::numeric_limits<double>::infinity();
        },
        visit);
  }

  /// Calls visit(number) for each obstacle that may be no farther than `farthest`, where distance(bounds) is
  /// not more than that of whatever is within them. The nearer of two bounds comes first, and a visit may
  /// lower `farthest`. Cost: O(log n) for each obstacle visited.
  template <class Distance, class Visit>
  void for_each_within(const double& farthest, Distance&& distance, Visit&& visit) const {
    struct Pending {
      std::uint32_t node;
      double distance;
    };
    if (is_empty()) return;
    std::array<Pending, kMaxDepth> pending;
    std::size_t count = 0;
    pending[count++] = {0, distance(bounds())};
    while (count > 0) {
      const Pending next = pending[--count];
      if (!(next.distance <= farthest)) continue;
      const Node& node = nodes_[next.node];
      for (std::uint32_t i = 0; i < node.obstacles; ++i) {
        const Obstacle& obstacle = obstacles_[node.first + i];
        if (distance(bounds_of(obstacle)) <= farthest) visit(obstacle.number);
      }
      if (node.obstacles > 0) continue;
      Pending near{node.first, distance(nodes_[node.first].bounds)};
      Pending far{node.first + 1, distance(nodes_[node.first + 1].bounds)};
      if (far.distance < near.distance) std::swap(near, far);
      pending[count++] = far;
      pending[count++] = near;
    }
  }

  std::size_t memory_bytes() const {
    return nodes_.capacity() * sizeof(Node) + obstacles_.capacity() * sizeof(Obstacle);
  }

 private:
  static constexpr std::size_t kMaxDepth = 64;  // more than twice the depth of halves of 2^31 obstacles
  static constexpr std::uint32_t kLeaf = 2;

  struct Node {
    Bounds bounds;
    std::uint32_t first;      // obstacle of a leaf, or of two children the first, which the other follows
    std::uint32_t obstacles;  // of a leaf; zero elsewhere
  };

  static Bounds bounds_of(const Obstacle& obstacle) {
    const Vec3 extent{obstacle.radius, obstacle.radius, obstacle.radius};
    return {obstacle.center - extent, obstacle.center + extent};
  }
  void build(std::uint32_t node, std::uint32_t first, std::uint32_t count);

  std::vector<Node> nodes_;
  std::vector<Obstacle> obstacles_;  // by leaf
};

}  // namespace hardball
