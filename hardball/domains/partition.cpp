// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/domains/partition.hpp"

#include <algorithm>
#include <optional>

#include "hardball/geometry/extent.hpp"
#include "hardball/standard/ranges.hpp"

namespace hardball {
namespace {

Extent extent_of(const Box& box, std::span<const Vec3> centers) {
  Extent extent{{}, {}};
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (box.is_bounded(axis)) {
      extent.low[axis] = 0;
      extent.high[axis] = box.size()[axis];
    } else if (!centers.empty()) {
      const auto [low, high] = ranges::minmax(centers, {}, [axis](const Vec3& x) { return x[axis]; });
      extent.low[axis] = low[axis];
      extent.high[axis] = high[axis];
    }
  }
  return extent;
}

struct Place {
  std::size_t axis = 0;
  double coordinate = 0;  // [L]
};

// A part that is to become several equal blocks along each axis.
class EqualParts {
 public:
  EqualParts(const Extent& extent, const std::array<std::size_t, kAxes>& parts)
      : extent_(extent), parts_(parts) {}

  std::size_t count() const { return parts_[0] * parts_[1] * parts_[2]; }
  // Where to cut; this becomes what is below, and `above` the rest.
  Place cut(std::optional<EqualParts>& above) {
    std::size_t axis = 0;
    while (parts_[axis] == 1) ++axis;
    const std::size_t lower = parts_[axis] / 2;
    const double share = static_cast<double>(lower) / static_cast<double>(parts_[axis]);
    const double place = extent_.low[axis] + share * (extent_.high[axis] - extent_.low[axis]);
    above = *this;
    above->parts_[axis] -= lower;
    above->extent_.low[axis] = place;
    parts_[axis] = lower;
    extent_.high[axis] = place;
    return {axis, place};
  }

 private:
  Extent extent_;
  std::array<std::size_t, kAxes> parts_;
};

// A part that is to become several blocks with as many of these centers, which are reordered.
class EqualCounts {
 public:
  EqualCounts(const Extent& extent, std::size_t count, std::span<Vec3> centers)
      : extent_(extent), count_(count), centers_(centers) {}

  std::size_t count() const { return count_; }
  Place cut(std::optional<EqualCounts>& above) {
    std::size_t axis = 0;
    for (std::size_t other = 1; other < kAxes; ++other) {
      if (extent_.high[other] - extent_.low[other] > extent_.high[axis] - extent_.low[axis]) axis = other;
    }
    const std::size_t lower = count_ / 2;
    const double share = static_cast<double>(lower) / static_cast<double>(count_);
    const double width = extent_.high[axis] - extent_.low[axis];
    double place = extent_.low[axis] + share * width;
    if (!centers_.empty()) {
      const auto middle =
          centers_.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(centers_.size()));
      ranges::nth_element(centers_, middle, {}, [axis](const Vec3& x) { return x[axis]; });
      place = (*middle)[axis];
    }
    // A block has an inside.
    const double least = width / static_cast<double>(4 * count_);
    place = std::clamp(place, extent_.low[axis] + least, extent_.high[axis] - least);
    const auto rest =
        std::partition(centers_.begin(), centers_.end(), [&](const Vec3& x) { return x[axis] < place; });
    const auto inside = static_cast<std::size_t>(rest - centers_.begin());
    above = EqualCounts(extent_, count_ - lower, centers_.subspan(inside));
    above->extent_.low[axis] = place;
    extent_.high[axis] = place;
    count_ = lower;
    centers_ = centers_.first(inside);
    return {axis, place};
  }

 private:
  Extent extent_;
  std::size_t count_;
  std::span<Vec3> centers_;
};

}  // namespace

// Divides a block as its part says, and returns the cut or the block that it has become.
template <class Part>
std::int32_t Partition::divide(Block block, Part part) {
  if (part.count() == 1) {
    blocks_.push_back(block);
    return leaf(blocks_.size() - 1);
  }
  std::optional<Part> above;
  const Place place = part.cut(above);
  const std::size_t number = cuts_.size();
  cuts_.push_back({place.axis, place.coordinate, 0, 0});
  const Block rest = block.split(place.axis, place.coordinate);
  const std::int32_t below = divide(block, part);
  const std::int32_t beyond = divide(rest, *above);
  cuts_[number].below = below;
  cuts_[number].above = beyond;
  return static_cast<std::int32_t>(number);
}

Partition Partition::grid(const Box& box, const std::array<std::size_t, kAxes>& parts,
                          std::span<const Vec3> centers) {
  Partition partition;
  partition.divide(Block(box), EqualParts(extent_of(box, centers), parts));
  return partition;
}

Partition Partition::bisection(const Box& box, std::size_t count, std::span<const Vec3> centers) {
  std::vector<Vec3> reordered(centers.begin(), centers.end());
  Partition partition;
  partition.divide(Block(box), EqualCounts(extent_of(box, centers), count, reordered));
  return partition;
}

DomainNumber Partition::domain_at(const Vec3& point) const {
  std::int32_t at = cuts_.empty() ? leaf(0) : 0;
  while (at >= 0) {
    const Cut& cut = cuts_[static_cast<std::size_t>(at)];
    at = point[cut.axis] < cut.place ? cut.below : cut.above;
  }
  return static_cast<DomainNumber>(-1 - at);
}

std::vector<DomainNumber> Partition::neighbors(DomainNumber domain, double distance) const {
  std::vector<DomainNumber> near;
  for (DomainNumber other = 0; other < size(); ++other) {
    if (other == domain) continue;
    // Across a period both differ by rounding, and neighbors must be neighbors of each other.
    const double gap =
        std::min(blocks_[domain].distance(blocks_[other]), blocks_[other].distance(blocks_[domain]));
    if (gap <= distance) near.push_back(other);
  }
  return near;
}

std::size_t Partition::most_neighbors(double distance) const {
  std::size_t most = 0;
  for (DomainNumber domain = 0; domain < size(); ++domain)
    most = std::max(most, neighbors(domain, distance).size());
  return most;
}

}  // namespace hardball
