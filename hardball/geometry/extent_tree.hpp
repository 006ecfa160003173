// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/geometry/extent.hpp"

namespace hardball {

/// Bodies at rest, or parts of one, in a tree of extents, of which each is around half of what its parent is
/// around: the obstacles of a world, the triangles of a mesh.
class HARDBALL_EXPORT ExtentTree {
 public:
  /// A body in the tree.
  struct Item {
    Extent extent;         ///< [L]
    std::uint32_t number;  ///< By which it is known.
  };

  /// A tree of nothing.
  ExtentTree() = default;
  /// Cost: O(n log^2 n).
  explicit ExtentTree(std::span<const Item> items);

  bool is_empty() const { return nodes_.empty(); }
  /// The extent of all. Precondition: not is_empty().
  Extent extent() const { return extent_of(nodes_.front()); }

  /// Calls visit(number) for all that may reach into a part of space. Cost: O(log n) for each of them.
  template <class Visit>
  void for_each_in(const Extent& part, Visit&& visit) const {
    const double farthest = 0;
    for_each_within(
        farthest,
        [&](const Extent& extent) {
          return overlap(part, extent) ? 0 : std::numeric_limits<double>::infinity();
        },
        visit);
  }

  /// Calls visit(number) for all that may be no farther than `farthest`, where distance(extent) is not more
  /// than that of whatever is within it. The nearer of two extents comes first, and a visit may lower
  /// `farthest`. Cost: O(log n) for each that is visited.
  template <class Distance, class Visit>
  void for_each_within(const double& farthest, Distance&& distance, Visit&& visit) const {
    struct Pending {
      std::uint32_t node;
      double distance;
    };
    if (is_empty()) return;
    std::array<Pending, kMaxDepth> pending;
    std::size_t count = 0;
    pending[count++] = {0, distance(extent())};
    while (count > 0) {
      const Pending next = pending[--count];
      if (!(next.distance <= farthest)) continue;
      const Node& node = nodes_[next.node];
      for (std::uint32_t i = 0; i < node.count; ++i) visit(numbers_[node.first + i]);
      if (node.count > 0) continue;
      Pending near{node.first, distance(extent_of(nodes_[node.first]))};
      Pending far{node.first + 1, distance(extent_of(nodes_[node.first + 1]))};
      if (far.distance < near.distance) std::swap(near, far);
      if (far.distance <= farthest) pending[count++] = far;
      if (near.distance <= farthest) pending[count++] = near;
    }
  }

  std::size_t memory_bytes() const {
    return nodes_.capacity() * sizeof(Node) + numbers_.capacity() * sizeof(std::uint32_t);
  }

 private:
  static constexpr std::size_t kMaxDepth = 64;  // more than twice the depth of halves of 2^31 items
  static constexpr std::uint32_t kLeaf = 2;

  // Half a cache line. Single numbers suffice for ends that are rounded outward.
  struct Node {
    std::array<float, kAxes> low;
    std::array<float, kAxes> high;
    std::uint32_t first;  // item of a leaf, or of two children the first, which the other follows
    std::uint32_t count;  // of the items of a leaf; zero elsewhere
  };

  static Extent extent_of(const Node& node) {
    return {{node.low[0], node.low[1], node.low[2]}, {node.high[0], node.high[1], node.high[2]}};
  }
  struct Builder;

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> numbers_;  // of the items, by leaf
};

}  // namespace hardball
