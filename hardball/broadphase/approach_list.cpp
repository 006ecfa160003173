// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/approach_list.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/world/images.hpp"

#include <algorithm>
#include <cmath>

namespace hardball {
namespace {

// The least depth of a list, over the skin of the cells.
constexpr double kLeastDepth = 1e-4;

// Lists are deeper by this fraction of the farthest distance of candidates: far more than the errors of
// compact copies.
constexpr double kDepthMargin = 0x1p-19;

// A list must last for this fraction of the time, and its skin show in coordinates, so that rounding does not
// matter.
constexpr double kMinDigits = 0x1p-38;

}  // namespace

void ApproachList::make(const Sources& sources, Slot owner, const Vec3& position, const Time& now,
                        const Candidates& all) {
  const auto& [world, copies, large, usual_speed, skin] = sources;
  owner_ = owner;
  // Under gravity speeds change between contacts, so that it is unknown from where spheres can arrive in
  // time.
  const bool pays = world.motion().is_straight() && all.size() >= kMinToList && copies.is_bounded(owner);
  if (pays) choose_depth(skin, all.size());
  const double begin = rounded_down(now);
  // At rest, it may be hit and move.
  constexpr double kAtRest = 0.01;
  constexpr double kChange = 3;
  const double speed = length(world.path(owner).velocity);
  skin_ = depth_ * std::min(1.0, kAtRest + kChange * speed / usual_speed);
  expiry_ = begin + depth_ / usual_speed;
  exists_ = pays && usual_speed > 0 && expiry_ > begin + kMinDigits * std::fabs(begin) &&
            0x1p-12 * skin_ > coordinate_error(world, owner, now);
  if (!exists_) return;
  middle_ = position;
  contacts_ = 0;
  const double unit = copies.length_unit();
  const CompactPath& own = copies.paths()[owner];
  const auto usual = static_cast<float>(depth_ / unit);
  const float reach =
      copies.radius(owner) + static_cast<float>((skin_ + depth_ + kDepthMargin * copies.farthest()) / unit);
  const auto wait = static_cast<float>((expiry_ - begin) / copies.time_unit() * (1 + 0x1p-20));
  const auto& grid = copies.scale().grid;
  slots_.resize(all.size());
  count_ = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Slot other = all.slot(i);
    const CompactPath& path = copies.paths()[other];
    const float age = static_cast<float>(static_cast<std::int32_t>(static_cast<std::uint32_t>(own.tick) -
                                                                   static_cast<std::uint32_t>(path.tick))) *
                      copies.scale().tick;
    float distance_squared = 0;
    float speed_squared = 0;
    for_each_axis([&](auto axis) {
      const auto steps =
          static_cast<std::uint32_t>(path.position[axis]) - static_cast<std::uint32_t>(own.position[axis]);
      const float apart =
          static_cast<float>(static_cast<std::int32_t>(steps)) * grid[axis] + path.velocity[axis] * age;
      distance_squared += apart * apart;
      speed_squared += path.velocity[axis] * path.velocity[axis];
    });
    const float way = std::sqrt(speed_squared) * wait;
    const float sum = reach + copies.radius(other) + std::max(0.0F, way - usual);
    slots_[count_] = other;
    // Of a sphere too fast to be copied, nothing is known.
    count_ += !(distance_squared > sum * sum) || large.contains(other) ? 1U : 0U;
  }
  const auto end = slots_.begin() + static_cast<std::ptrdiff_t>(count_);
  std::sort(slots_.begin(), end);
  count_ = static_cast<std::size_t>(std::unique(slots_.begin(), end) - slots_.begin());
  pad();
}

// The search for a list is shared by the contacts of its time; each of these goes through the list: the depth
// at which both cost the same costs least.
void ApproachList::choose_depth(double skin, std::size_t searched) {
  constexpr double kFactor = 1.5;
  if (!exists_) {
    depth_ = skin / 64;
  } else {
    const double search = static_cast<double>(searched) / (1 + contacts_);
    depth_ *= search > static_cast<double>(count_) ? kFactor : 1 / kFactor;
  }
  depth_ = std::clamp(depth_, kLeastDepth * skin, kGreatestDepth * skin);
}

void ApproachList::add(Slot other) {
  if (!exists_) return;
  slots_.resize(count_ + 1);
  slots_[count_++] = other;
  pad();
}

void ApproachList::replace(Slot slot, Slot by) {
  ranges::replace(slots_, slot, by);
  if (owner_ == slot) owner_ = by;
}

void ApproachList::pad() {
  slots_.resize(count_);
  slots_.resize(count_ + Candidates::kPadding, owner_);
}

}  // namespace hardball
