// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/all_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

// Half the length of the interval, as a fraction of the box, and the margin by which the search goes beyond
// it.
constexpr double kHalfInterval = 0.25;
constexpr double kMargin = 1e-6;

}  // namespace

void AllPairs::build(const World& world, const Time& now, CompactPaths& copies) {
  copies.reset(world, std::max(1.0, CompactPaths::least_farthest(world.box())), now);
  reset(lines_, world);
  middles_.assign(world.size(), {});
  slid_.assign(world.size(), 0);
  for (Slot slot = 0; slot < world.size(); ++slot) center_interval(world, slot, now);
}

void AllPairs::insert(const World& world, Slot slot, const Time& now, const CompactPaths&) {
  reset(lines_, world, slot);
  if (slot == slid_.size()) {
    append_sparingly(middles_, {});
    append_sparingly(slid_, 0.0);
  }
  center_interval(world, slot, now);
}

void AllPairs::update(const World& world, Slot slot, const Time& now, const Image&) {
  center_interval(world, slot, now);
}

AllPairs::Images AllPairs::images_within_reach(const World& world, Slot slot, Slot other) const {
  Images images;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!world.box().is_periodic(axis)) continue;
    const double size = world.box().size()[axis];
    const double apart = middles_[other][axis] - middles_[slot][axis];
    const double reach = 2 * kHalfInterval * size + world.bounding_radius(slot) +
                         world.bounding_radius(other) + kMargin * size;
    images.low[axis] = static_cast<std::int32_t>(std::ceil((-reach - apart) / size));
    images.high[axis] = static_cast<std::int32_t>(std::floor((reach - apart) / size));
  }
  return images;
}

// Finds the images along x in the layer `above`, which slides on by up to a quarter box.
void AllPairs::shift_along_x(const World& world, Slot slot, Slot other, std::int32_t above,
                             Images& images) const {
  const double size = world.box().size().x;
  const bool ahead = world.box().images().speed() > 0;
  const double slid = ahead ? std::max(slid_[slot], slid_[other]) : std::min(slid_[slot], slid_[other]);
  const double apart = (middles_[other].x - middles_[slot].x) + above * slid;
  const double reach = (2 + std::abs(above)) * kHalfInterval * size + world.bounding_radius(slot) +
                       world.bounding_radius(other) + kMargin * size;
  images.low[0] = static_cast<std::int32_t>(std::ceil((-reach - apart) / size));
  images.high[0] = static_cast<std::int32_t>(std::floor((reach - apart) / size));
}

void AllPairs::collect(const World& world, Slot slot, Candidates& candidates) const {
  candidates.begin(slot, false);
  for (Slot other = 0; other < world.size(); ++other) {
    if (other == slot) continue;
    Images images = images_within_reach(world, slot, other);
    Image image;
    for (image[1] = images.low[1]; image[1] <= images.high[1]; ++image[1]) {
      if (world.box().is_sheared()) shift_along_x(world, slot, other, image[1], images);
      for (image[0] = images.low[0]; image[0] <= images.high[0]; ++image[0]) {
        for (image[2] = images.low[2]; image[2] <= images.high[2]; ++image[2]) {
          candidates.add(other, image, world.box());
        }
      }
    }
  }
  candidates.end();
}

void AllPairs::cross(const World& world, Slot slot, const Time& now, const CompactPaths&,
                     Candidates& candidates) {
  center_interval(world, slot, now);
  collect(world, slot, candidates);
}

void AllPairs::center_interval(const World& world, Slot slot, const Time& now) {
  middles_[slot] = world.unfolded_position(slot, now);
  static_cast<void>(
      world.box().boxes_beyond(middles_[slot], now));  // throws if it has crossed too many boxes
  slid_[slot] = world.box().images().displacement(now).high;
}

double AllPairs::next_crossing(const World& world, Slot slot, const Time& now, const CompactPaths&) {
  const Vec3 moved = world.unfolded_position(slot, now) - middles_[slot];
  const Vec3 velocity = world.unfolded_velocity(slot, now);
  double soonest = std::numeric_limits<double>::infinity();
  if (const double speed = std::fabs(world.box().images().speed()); speed > 0) {
    const double slid = std::fabs(world.box().images().displacement(now).high - slid_[slot]);
    soonest = std::max(0.0, kHalfInterval * world.box().size().x - slid) / speed;
  }
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!world.box().is_periodic(axis)) continue;
    const double reach = kHalfInterval * world.box().size()[axis];
    soonest = std::min(soonest,
                       time_to_leave(std::max(0.0, reach + moved[axis]), std::max(0.0, reach - moved[axis]),
                                     velocity[axis], world.motion().gravity()[axis]));
  }
  return rounded_down(now) + soonest;
}

void AllPairs::validate(const World& world, const Time& now, const CompactPaths&) const {
  HARDBALL_CHECK(lines_.size() >= world.size());
  for (Slot slot = 0; slot < world.size(); ++slot) {
    const Vec3 moved = world.unfolded_position(slot, now) - middles_[slot];
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (!world.box().is_periodic(axis)) continue;
      HARDBALL_CHECK(std::fabs(moved[axis]) <= (kHalfInterval + kMargin / 2) * world.box().size()[axis]);
    }
  }
}

}  // namespace hardball
