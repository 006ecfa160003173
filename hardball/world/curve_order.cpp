// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/world/curve_order.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace hardball {
namespace {

// Bits of a coordinate along each axis.
constexpr int kBits = 21;

// Inserts two zeros between any two bits.
std::uint64_t spread(std::uint64_t bits) {
  bits = (bits | bits << 32) & 0x1f00000000ffff;
  bits = (bits | bits << 16) & 0x1f0000ff0000ff;
  bits = (bits | bits << 8) & 0x100f00f00f00f00f;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3;
  bits = (bits | bits << 2) & 0x1249249249249249;
  return bits;
}

}  // namespace

std::vector<Slot> order_along_curve(const World& world, const Time& moment) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Vec3 low{kInfinity, kInfinity, kInfinity};
  Vec3 high = -low;
  for (Slot slot = 0; slot < world.size(); ++slot) {
    const Vec3 center = world.position(slot, moment);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      low[axis] = std::min(low[axis], center[axis]);
      high[axis] = std::max(high[axis], center[axis]);
    }
  }
  const double longest = std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  const double steps_per_length = longest > 0 ? ((1 << kBits) - 1) / longest : 0;
  std::vector<std::pair<std::uint64_t, Slot>> keyed(world.size());
  for (Slot slot = 0; slot < world.size(); ++slot) {
    const Vec3 steps = steps_per_length * (world.position(slot, moment) - low);
    keyed[slot] = {spread(static_cast<std::uint64_t>(steps.x)) << 2 |
                       spread(static_cast<std::uint64_t>(steps.y)) << 1 |
                       spread(static_cast<std::uint64_t>(steps.z)),
                   slot};
  }
  std::sort(keyed.begin(), keyed.end());
  std::vector<Slot> order;
  order.reserve(world.size());
  for (const auto& [key, slot] : keyed) order.push_back(slot);
  return order;
}

void put_in_order(World& world, const Time& moment) {
  // Fewer spheres fit in the caches in any order.
  constexpr std::size_t kSpheresToOrder = 10000;
  if (!world.has_journal() && world.size() >= kSpheresToOrder)
    world.reorder(order_along_curve(world, moment));
}

}  // namespace hardball
