// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/geometry/extent_tree.hpp"

#include <algorithm>
#include <cmath>

namespace hardball {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

float rounded_down(double number) {
  const auto nearest = static_cast<float>(number);
  return static_cast<double>(nearest) <= number ? nearest : std::nextafter(nearest, -kInfinity);
}

// A power of two that is at least the magnitude of all coordinates.
double unit_for(const Extent& extent) {
  double largest = 0;
  for (std::size_t axis = 0; axis < kAxes; ++axis)
    largest = std::max({largest, std::fabs(extent.low[axis]), std::fabs(extent.high[axis])});
  int exponent = 0;
  std::frexp(largest, &exponent);
  return std::ldexp(1.0, exponent);
}

}  // namespace

struct ExtentTree::Builder {
  // Where an item is, which is all that its place in the order depends on.
  struct Place {
    Vec3 middle;  // twice
    std::uint32_t item;
  };
  using Order = std::vector<Place>::iterator;

  std::span<const Item> items;
  double unit;
  std::vector<Node>& nodes;

  static std::size_t longest_axis(Order begin, Order end) {
    Extent middles{begin->middle, begin->middle};
    for (Order place = begin + 1; place != end; ++place) middles.enclose({place->middle, place->middle});
    const Vec3 extent = middles.high - middles.low;
    const std::size_t longer = extent.y > extent.x ? 1 : 0;
    return extent.z > extent[longer] ? 2 : longer;
  }

  // Lets the items that come first along the longest axis come first.
  static void part(Order begin, Order half, Order end) {
    const std::size_t axis = longest_axis(begin, end);
    std::nth_element(begin, half, end, [axis](const Place& a, const Place& b) {
      const double of_a = a.middle[axis];
      const double of_b = b.middle[axis];
      return of_a != of_b ? of_a < of_b : a.item < b.item;
    });
  }

  // Sets the ends of the extents along an axis, as many steps from the corner as lie outside of them.
  void set_ends(Node& node, std::span<const Extent> extents, std::size_t axis) const {
    constexpr double kMostSteps = std::numeric_limits<std::uint8_t>::max();
    double least = extents[0].low[axis];
    double greatest = extents[0].high[axis];
    for (const Extent& extent : extents) {
      least = std::min(least, extent.low[axis]);
      greatest = std::max(greatest, extent.high[axis]);
    }
    node.corner[axis] = rounded_down(least / unit);
    const double corner = unit * static_cast<double>(node.corner[axis]);
    node.step[axis] = static_cast<float>((greatest - corner) / (kMostSteps * unit));
    while (corner + unit * static_cast<double>(node.step[axis]) * kMostSteps < greatest)
      node.step[axis] = std::nextafter(node.step[axis], kInfinity);
    const double step = unit * static_cast<double>(node.step[axis]);
    for (std::size_t i = 0; i < extents.size(); ++i) {
      double low = step > 0 ? std::min(std::floor((extents[i].low[axis] - corner) / step), kMostSteps) : 0;
      while (low > 0 && corner + step * low > extents[i].low[axis]) --low;
      double high = step > 0 ? std::min(std::ceil((extents[i].high[axis] - corner) / step), kMostSteps) : 0;
      while (corner + step * high < extents[i].high[axis]) ++high;
      node.low[axis][i] = static_cast<std::uint8_t>(low);
      node.high[axis][i] = static_cast<std::uint8_t>(high);
    }
  }

  // Makes a node of at least one item, and returns the extent around all.
  Extent build(std::size_t place, Order begin, Order end) {
    // Each child but the last is full, with all nodes below it.
    std::ptrdiff_t share = 1;
    while (share * static_cast<std::ptrdiff_t>(FourNumbers::kCount) < end - begin)
      share *= static_cast<std::ptrdiff_t>(FourNumbers::kCount);
    if (end - begin > 2 * share) {
      part(begin, begin + 2 * share, end);
      part(begin, begin + share, begin + 2 * share);
      if (end - begin > 3 * share) part(begin + 2 * share, begin + 3 * share, end);
    } else if (end - begin > share) {
      part(begin, begin + share, end);
    }
    Node node;
    std::array<Extent, FourNumbers::kCount> extents;
    std::size_t count = 0;
    for (Order first = begin; first != end; ++count) {
      const Order last = first + std::min(share, end - first);
      extents[count] = items[first->item].extent;
      node.references[count] = items[first->item].number | kIsItem;
      if (last - first > 1) {
        node.references[count] = static_cast<std::uint32_t>(nodes.size());
        nodes.emplace_back();
        extents[count] = build(node.references[count], first, last);
      }
      first = last;
    }
    for (std::size_t axis = 0; axis < kAxes; ++axis) set_ends(node, std::span(extents).first(count), axis);
    nodes[place] = node;
    for (std::size_t i = 1; i < count; ++i) extents[0].enclose(extents[i]);
    return extents[0];
  }
};

ExtentTree::ExtentTree(std::span<const Item> items) {
  if (items.empty()) return;
  extent_ = items.front().extent;
  for (const Item& item : items) extent_.enclose(item.extent);
  unit_ = unit_for(extent_);
  std::vector<Builder::Place> order;
  order.reserve(items.size());
  for (const Item& item : items)
    order.push_back({item.extent.low + item.extent.high, static_cast<std::uint32_t>(order.size())});
  nodes_.reserve(items.size() / (FourNumbers::kCount - 1) + 1);
  nodes_.emplace_back();
  Builder{items, unit_, nodes_}.build(0, order.begin(), order.end());
  nodes_.shrink_to_fit();
}

}  // namespace hardball
