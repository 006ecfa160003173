// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/geometry/extent.hpp"
#include "hardball/geometry/four_extents.hpp"

namespace hardball {

/// Bodies at rest, or parts of one, in a tree of extents, each of which is around up to four others: the
/// obstacles of a world, the triangles of a mesh.
class HARDBALL_EXPORT ExtentTree {
 public:
  /// A body in the tree.
  struct Item {
    Extent extent;         ///< [L]
    std::uint32_t number;  ///< By which it is known; less than 2^31.
  };

  /// A tree of nothing.
  ExtentTree() = default;
  /// Cost: O(n log^2 n).
  explicit ExtentTree(std::span<const Item> items);

  bool is_empty() const { return nodes_.empty(); }
  /// The extent of all. Precondition: not is_empty().
  const Extent& extent() const { return extent_; }

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

  /// Calls visit(number) for all that may be no farther than `farthest`, where the distance to an extent is
  /// not more than that to whatever is within it. distance(extents) gives those to FourExtents as
  /// FourNumbers; distance(extent), that to one. The nearest of four extents comes first, and a visit may
  /// lower `farthest`. Cost: O(log n) for each that is visited.
  template <class Distance, class Visit>
  void for_each_within(const double& farthest, Distance&& distance, Visit&& visit) const {
    struct Pending {
      std::uint32_t reference;
      double distance;
    };
    if (is_empty()) return;
    std::array<Pending, kMostPending> pending;
    pending[0] = {0, -std::numeric_limits<double>::infinity()};
    std::size_t count = 1;
    while (count > 0) {
      const Pending next = pending[--count];
      if (!(next.distance <= farthest)) continue;
      if ((next.reference & kIsItem) != 0) {
        visit(next.reference & ~kIsItem);
        continue;
      }
      const Node& node = nodes_[next.reference];
      const FourNumbers distances = distances_to(extents_of(node), distance);
      const std::size_t farther = count;
      for (std::size_t i = 0; i < FourNumbers::kCount && node.references[i] != kNone; ++i) {
        if (!(distances[i] <= farthest)) continue;
        std::size_t place = count++;
        for (; place > farther && pending[place - 1].distance < distances[i]; --place)
          pending[place] = pending[place - 1];
        pending[place] = {node.references[i], distances[i]};
      }
    }
  }

  std::size_t memory_bytes() const { return nodes_.capacity() * sizeof(Node); }

 private:
  static constexpr std::uint32_t kIsItem = std::uint32_t{1} << 31;
  static constexpr std::uint32_t kNone = 0xffffffff;
  // Three more on each of a hundred levels: no child has more than 15/16 of 15/16 of 15/16 of the items.
  static constexpr std::size_t kMostPending = 304;

  // A cache line: what it takes to ask a tree is to fetch these. Ends of extents are a few bits long, rounded
  // outward: so many steps from a corner.
  struct alignas(64) Node {
    using Steps = std::array<std::uint8_t, FourNumbers::kCount>;

    std::array<float, kAxes> corner{};  // units
    std::array<float, kAxes> step{};    // units
    std::array<Steps, kAxes> low{};
    std::array<Steps, kAxes> high{};
    std::array<std::uint32_t, FourNumbers::kCount> references{kNone, kNone, kNone, kNone};
  };
  static_assert(sizeof(Node) == 64);

  FourExtents extents_of(const Node& node) const {
    FourExtents extents;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const FourNumbers corner(unit_ * static_cast<double>(node.corner[axis]));
      const FourNumbers step(unit_ * static_cast<double>(node.step[axis]));
      extents.low[axis] = corner + step * FourNumbers(node.low[axis]);
      extents.high[axis] = corner + step * FourNumbers(node.high[axis]);
    }
    return extents;
  }
  template <class Distance>
  static FourNumbers distances_to(const FourExtents& extents, Distance& distance) {
    if constexpr (std::is_invocable_v<Distance&, const FourExtents&>) {
      return distance(extents);
    } else {
      std::array<double, FourNumbers::kCount> distances;
      for (std::size_t i = 0; i < FourNumbers::kCount; ++i) distances[i] = distance(extents[i]);
      return FourNumbers(distances);
    }
  }
  struct Builder;

  double unit_ = 1;  // [L], at least the largest magnitude of a coordinate; a power of two
  Extent extent_;
  std::vector<Node> nodes_;  // the root first
};

}  // namespace hardball
