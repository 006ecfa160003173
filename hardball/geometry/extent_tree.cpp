// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/geometry/extent_tree.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

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

  // Items in so many bins along an axis, by their middles.
  static constexpr std::size_t kBins = 16;
  struct Plane {
    std::size_t axis = 0;
    double low = 0;
    double bins_per_length = 0;
    std::size_t last = 0;  // the bin that is the last on the lower side

    std::size_t bin(const Place& place) const {
      const double beyond = (place.middle[axis] - low) * bins_per_length;
      return static_cast<std::size_t>(std::clamp(beyond, 0.0, static_cast<double>(kBins - 1)));
    }
  };
  struct Share {
    std::size_t count = 0;
    Extent extent;

    void take(const Share& other) {
      if (count == 0) extent = other.extent;
      if (other.count > 0) extent.enclose(other.extent);
      count += other.count;
    }
    // To ask about everything in it, by its surface.
    double cost() const {
      const Vec3 size = extent.high - extent.low;
      return static_cast<double>(count) * (size.x * size.y + size.y * size.z + size.z * size.x);
    }
  };
  // One over the part of the items that either side of a plane has at least.
  static constexpr std::ptrdiff_t kMostUneven = 16;

  // The plane across the longest axis on whose sides items cost the least, as some of them say; none if all
  // have one middle.
  std::optional<Plane> best_plane(Order begin, Order end) const {
    constexpr std::ptrdiff_t kEnough = 64;
    const std::ptrdiff_t stride = (end - begin + kEnough - 1) / kEnough;
    Extent middles{begin->middle, begin->middle};
    for (Order place = begin; end - place > stride;) {
      place += stride;
      middles.enclose({place->middle, place->middle});
    }
    const Vec3 widths = middles.high - middles.low;
    const std::size_t longer = widths.y > widths.x ? 1 : 0;
    const std::size_t axis = widths.z > widths[longer] ? 2 : longer;
    Plane plane{axis, middles.low[axis], static_cast<double>(kBins) / widths[axis]};
    if (!(plane.bins_per_length < std::numeric_limits<double>::infinity())) return std::nullopt;

    std::array<Share, kBins> bins;
    for (Order place = begin;; place += stride) {
      bins[plane.bin(*place)].take({1, items[place->item].extent});
      if (end - place <= stride) break;
    }
    std::array<double, kBins> costs_above{};
    Share above;
    for (std::size_t bin = kBins - 1; bin > 0; --bin) {
      above.take(bins[bin]);
      costs_above[bin - 1] = above.cost();
    }
    Share below;
    const std::size_t count = above.count + bins[0].count;
    std::pair least{std::numeric_limits<double>::infinity(), count};
    for (std::size_t bin = 0; bin + 1 < kBins; ++bin) {
      below.take(bins[bin]);
      const std::size_t larger = std::max(below.count, count - below.count);
      // Of planes that cost the same, as where items lie on a line, the one that halves them.
      const std::pair costs{below.cost() + costs_above[bin], larger};
      if (!(costs < least)) continue;
      least = costs;
      plane.last = bin;
    }
    return plane;
  }

  // Parts items by a plane between them, in an order that they alone decide, and returns where the upper side
  // begins.
  Order part(Order begin, Order end) const {
    const Order half = begin + (end - begin) / 2;
    const std::optional<Plane> plane = best_plane(begin, end);
    if (!plane) return half;
    const Order upper = std::stable_partition(
        begin, end, [&](const Place& place) { return plane->bin(place) <= plane->last; });
    if (kMostUneven * std::min(upper - begin, end - upper) >= end - begin) return upper;
    // Without a few that lie far away, the rest is not much less than before.
    std::stable_sort(begin, end, [&](const Place& a, const Place& b) {
      return a.middle[plane->axis] < b.middle[plane->axis];
    });
    return half;
  }

  struct Items {
    Order begin;
    Order end;

    std::ptrdiff_t size() const { return end - begin; }
  };
  // Parts items into at most four shares of at least one, and returns how many there are.
  std::size_t divide(const Items& all, std::array<Items, FourNumbers::kCount>& shares) const {
    shares[0] = all;
    std::size_t count = 1;
    for (; count < FourNumbers::kCount; ++count) {
      Items& largest = *std::max_element(shares.begin(), shares.begin() + count,
                                         [](const Items& a, const Items& b) { return a.size() < b.size(); });
      if (largest.size() == 1) break;
      const Order upper = part(largest.begin, largest.end);
      shares[count] = {upper, largest.end};
      largest.end = upper;
    }
    return count;
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
  Extent build(std::size_t place, const Items& all) {
    Node node;
    std::array<Extent, FourNumbers::kCount> extents;
    std::array<Items, FourNumbers::kCount> shares;
    const std::size_t count = divide(all, shares);
    for (std::size_t i = 0; i < count; ++i) {
      const Item& first = items[shares[i].begin->item];
      extents[i] = first.extent;
      node.references[i] = first.number | kIsItem;
      if (shares[i].size() > 1) {
        node.references[i] = static_cast<std::uint32_t>(nodes.size());
        nodes.emplace_back();
        extents[i] = build(node.references[i], shares[i]);
      }
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
  Builder{items, unit_, nodes_}.build(0, {order.begin(), order.end()});
  nodes_.shrink_to_fit();
}

}  // namespace hardball
