// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/all_pairs.hpp"

#include <algorithm>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

// Half the length of a stretch, as a fraction of the box, and how much more is searched than lies within it.
constexpr double kStretch = 0.25;
constexpr double kMargin = 1e-6;

}  // namespace

void AllPairs::build(const World& world, const Time& now) {
  stretches_.assign(world.size(), Stretch{});
  for (Slot slot = 0; slot < world.size(); ++slot) center_stretch(world, slot, now);
}

void AllPairs::refresh(const World& world, Slot slot, const Time& now, const Image&) {
  center_stretch(world, slot, now);
}

AllPairs::Images AllPairs::images_within_reach(const World& world, Slot slot, Slot other) const {
  Images images;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!world.box().is_periodic(axis)) continue;
    const double size = world.box().size()[axis];
    const double apart = stretches_[other].middle[axis] - stretches_[slot].middle[axis];
    const double reach = 2 * kStretch * size + world.radius(slot) + world.radius(other) + kMargin * size;
    images.low[axis] = static_cast<std::int32_t>(std::ceil((-reach - apart) / size));
    images.high[axis] = static_cast<std::int32_t>(std::floor((reach - apart) / size));
  }
  return images;
}

void AllPairs::center_stretch(const World& world, Slot slot, const Time& now) {
  const Path& path = world.path(slot);
  Stretch& stretch = stretches_[slot];
  stretch.middle = position_at(path, now);
  world.box().boxes_beyond(stretch.middle);  // refuses to fly on for ever
  double soonest = std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!world.box().is_periodic(axis)) continue;
    const bool up = path.velocity[axis] > 0;
    const double reach = kStretch * world.box().size()[axis];
    const double distance = up ? (stretch.middle[axis] + reach) - path.position[axis]
                               : path.position[axis] - (stretch.middle[axis] - reach);
    soonest = std::min(soonest, time_to_plane(distance, std::fabs(path.velocity[axis])));
  }
  stretch.crossing = later(now, after(path.time, soonest));
}

void AllPairs::validate(const World& world, const Time& now) const {
  HARDBALL_CHECK(stretches_.size() == world.size());
  for (Slot slot = 0; slot < world.size(); ++slot) {
    HARDBALL_CHECK(stretches_[slot].crossing >= now);
    const Vec3 moved = position_at(world.path(slot), now) - stretches_[slot].middle;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (!world.box().is_periodic(axis)) continue;
      HARDBALL_CHECK(std::fabs(moved[axis]) <= (kStretch + kMargin / 2) * world.box().size()[axis]);
    }
  }
}

}  // namespace hardball
