// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/geometry/extent_tree.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hardball {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr double kLargest = std::numeric_limits<float>::max();

float rounded_down(double number) {
  if (number < -kLargest) return -kInfinity;
  const auto nearest = static_cast<float>(std::min(number, kLargest));
  return static_cast<double>(nearest) <= number ? nearest : std::nextafter(nearest, -kInfinity);
}

float rounded_up(double number) {
  return -rounded_down(-number);
}

}  // namespace

struct ExtentTree::Builder {
  std::span<const Item> items;
  std::vector<std::uint32_t> order;
  std::vector<Node>& nodes;

  // Twice the middle.
  double middle(std::uint32_t item, std::size_t axis) const {
    return items[item].extent.low[axis] + items[item].extent.high[axis];
  }

  void build(std::uint32_t node, std::uint32_t first, std::uint32_t count) {
    Extent around = items[order[first]].extent;
    Vec3 least;
    Vec3 greatest;
    for (std::size_t axis = 0; axis < kAxes; ++axis)
      least[axis] = greatest[axis] = middle(order[first], axis);
    for (std::uint32_t i = first + 1; i < first + count; ++i) {
      around.enclose(items[order[i]].extent);
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        least[axis] = std::min(least[axis], middle(order[i], axis));
        greatest[axis] = std::max(greatest[axis], middle(order[i], axis));
      }
    }
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      nodes[node].low[axis] = rounded_down(around.low[axis]);
      nodes[node].high[axis] = rounded_up(around.high[axis]);
    }
    nodes[node].first = first;
    nodes[node].count = count;
    if (count <= kLeaf) return;
    const Vec3 extent = greatest - least;
    std::size_t longest = extent.y > extent.x ? 1 : 0;
    if (extent.z > extent[longest]) longest = 2;
    const auto begin = order.begin() + first;
    const std::uint32_t half = count / 2;
    std::nth_element(begin, begin + half, begin + count, [&](std::uint32_t a, std::uint32_t b) {
      const double of_a = middle(a, longest);
      const double of_b = middle(b, longest);
      return of_a != of_b ? of_a < of_b : a < b;
    });
    const auto children = static_cast<std::uint32_t>(nodes.size());
    nodes[node].first = children;
    nodes[node].count = 0;
    nodes.resize(nodes.size() + 2);
    build(children, first, half);
    build(children + 1, first + half, count - half);
  }
};

ExtentTree::ExtentTree(std::span<const Item> items) {
  if (items.empty()) return;
  Builder builder{items, std::vector<std::uint32_t>(items.size()), nodes_};
  std::iota(builder.order.begin(), builder.order.end(), 0U);
  nodes_.reserve(2 * items.size());
  nodes_.emplace_back();
  builder.build(0, 0, static_cast<std::uint32_t>(items.size()));
  nodes_.shrink_to_fit();
  numbers_.reserve(items.size());
  for (const std::uint32_t item : builder.order) numbers_.push_back(items[item].number);
}

}  // namespace hardball
