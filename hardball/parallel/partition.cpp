// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/parallel/partition.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace hardball {
namespace {

struct Extent {
  Vec3 low;
  Vec3 high;
};

Extent extent_of(const Box& box, std::span<const Vec3> centers) {
  Extent extent;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (box.is_bounded(axis)) {
      extent.low[axis] = 0;
      extent.high[axis] = box.size()[axis];
    } else if (!centers.empty()) {
      const auto [low, high] = std::ranges::minmax(centers, {}, [axis](const Vec3& x) { return x[axis]; });
      extent.low[axis] = low[axis];
      extent.high[axis] = high[axis];
    }
  }
  return extent;
}

// Divides a block that holds these centers, which are reordered, and appends its parts.
void bisect(Block block, Extent extent, std::size_t count, std::span<Vec3> centers,
            std::vector<Block>& blocks) {
  const std::size_t lower_count = count / 2;
  std::size_t axis = 0;
  for (std::size_t other = 1; other < kAxes; ++other) {
    if (extent.high[other] - extent.low[other] > extent.high[axis] - extent.low[axis]) axis = other;
  }
  if (count == 1) {
    blocks.push_back(block);
    return;
  }
  const double share = static_cast<double>(lower_count) / static_cast<double>(count);
  const auto lower = static_cast<std::size_t>(share * static_cast<double>(centers.size()));
  double place = extent.low[axis] + share * (extent.high[axis] - extent.low[axis]);
  if (!centers.empty()) {
    std::ranges::nth_element(centers, centers.begin() + static_cast<std::ptrdiff_t>(lower), {},
                             [axis](const Vec3& x) { return x[axis]; });
    place = centers[lower][axis];
  }
  // A block has an inside.
  const double least = (extent.high[axis] - extent.low[axis]) / static_cast<double>(4 * count);
  place = std::clamp(place, extent.low[axis] + least, extent.high[axis] - least);
  const auto middle =
      std::partition(centers.begin(), centers.end(), [&](const Vec3& x) { return x[axis] < place; });
  const auto inside = static_cast<std::size_t>(middle - centers.begin());
  Block rest = block.split(axis, place);
  Extent below = extent;
  below.high[axis] = place;
  extent.low[axis] = place;
  bisect(block, below, lower_count, centers.first(inside), blocks);
  bisect(rest, extent, count - lower_count, centers.subspan(inside), blocks);
}

}  // namespace

Partition Partition::grid(const Box& box, const std::array<std::size_t, kAxes>& parts,
                          std::span<const Vec3> centers) {
  const Extent extent = extent_of(box, centers);
  Partition partition;
  partition.blocks_.push_back(Block(box));
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    std::vector<Block> cut;
    for (Block rest : partition.blocks_) {
      const double width = (extent.high[axis] - extent.low[axis]) / static_cast<double>(parts[axis]);
      for (std::size_t part = 1; part < parts[axis]; ++part) {
        Block above = rest.split(axis, extent.low[axis] + static_cast<double>(part) * width);
        cut.push_back(std::exchange(rest, above));
      }
      cut.push_back(rest);
    }
    partition.blocks_ = std::move(cut);
  }
  return partition;
}

Partition Partition::bisection(const Box& box, std::size_t count, std::span<const Vec3> centers) {
  std::vector<Vec3> reordered(centers.begin(), centers.end());
  Partition partition;
  bisect(Block(box), extent_of(box, centers), count, reordered, partition.blocks_);
  return partition;
}

DomainNumber Partition::domain_at(const Vec3& point) const {
  DomainNumber nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (DomainNumber domain = 0; domain < size(); ++domain) {
    const double distance = blocks_[domain].distance(point);
    if (distance < least) {
      least = distance;
      nearest = domain;
    }
  }
  return nearest;
}

std::vector<DomainNumber> Partition::neighbors(DomainNumber domain, double distance) const {
  std::vector<DomainNumber> near;
  for (DomainNumber other = 0; other < size(); ++other) {
    if (other != domain && blocks_[domain].distance(blocks_[other]) <= distance) near.push_back(other);
  }
  return near;
}

}  // namespace hardball
