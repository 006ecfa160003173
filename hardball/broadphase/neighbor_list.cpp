// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/neighbor_list.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "hardball/broadphase/wait_in_ball.hpp"
#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

// By which shells are larger than they need to be, and centres cross earlier, as fractions of the farthest
// distance of neighbours: far more than the errors of places on the grid and of distances in single
// precision.
constexpr double kShellMargin = 0x1p-19;
constexpr double kCrossingMargin = 0x1p-21;

// Distances of neighbours stay below this fraction of a periodic box: then only one image of each is near,
// and there are at least three cells along each axis.
constexpr double kLargestShare = 0.33;

// The slack is at least this fraction of the largest radius.
constexpr double kLeastSlack = 0.02;

constexpr std::int32_t kMostCellsPerAxis = 1 << 28;

// The largest distance between the centres of two neighbours: shells in contact, and both displaced from
// their anchors.
double farthest_neighbors(double largest_radius, double slack) {
  return 2 * largest_radius + 4 * slack;
}

double smallest_period(const Box& box) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (box.is_periodic(axis)) smallest = std::min(smallest, box.size()[axis]);
  }
  return smallest;
}

}  // namespace

bool NeighborList::suits(const World& world) {
  const double radius = world.largest_radius();
  return farthest_neighbors(radius, kLeastSlack * radius) <= kLargestShare * smallest_period(world.box());
}

void NeighborList::build(const World& world, const Time& now, CompactPaths& copies) {
  HARDBALL_CHECK(suits(world));
  const double radius = world.largest_radius();
  const double largest = (kLargestShare * smallest_period(world.box()) - 2 * radius) / 4;
  slack_ = std::max(kLeastSlack * radius, std::min(wanted_slack_, largest));
  // Without spheres any distance will do.
  const double farthest = farthest_neighbors(world.size() > 0 ? radius : 1, slack_);
  const double margin = kShellMargin * farthest;
  room_ = slack_ - kCrossingMargin * farthest;
  cells_ = Subdivision(world.box(), farthest - 2 * slack_ + 2 * margin, kMostCellsPerAxis);
  copies.reset(world, farthest + 2 * margin, now);
  reach_ = static_cast<float>((2 * slack_ + margin) / copies.length_unit());
  room_squared_ = static_cast<float>(room_ * room_ / (copies.length_unit() * copies.length_unit()));
  store_.reset(cells_.shape(), world.size());
  anchors_.assign(world.size(), Anchor{});
  neighbors_.reset(world.size());
  for (Slot slot = 0; slot < world.size(); ++slot) {
    move_anchor(world, slot, now, copies);
    find_near(slot, copies);
    for (const Slot other : near_) {
      insert(slot, other);
      insert(other, slot);
    }
    store_anchor(slot);
  }
}

double NeighborList::next_crossing_of_any(const World& world, Slot slot, const Time& now,
                                          const CompactPaths& copies) const {
  const auto& anchor = anchors_[slot].place;
  const Vec3 place{copies.apart(anchor, slot, 0), copies.apart(anchor, slot, 1),
                   copies.apart(anchor, slot, 2)};
  const double reach = std::max(0.0, room_ - coordinate_error(world, slot, now));
  return rounded_down(now) + wait_in_ball(world.motion(), place, world.velocity(slot, now), reach);
}

void NeighborList::cross(const World& world, Slot slot, const Time& now, const CompactPaths& copies,
                         Candidates& candidates) {
  store_.erase(anchors_[slot].cell, slot);
  move_anchor(world, slot, now, copies);
  find_near(slot, copies);
  store_anchor(slot);
  find_changes(slot);
  candidates.begin(slot, true);
  for (const Slot gained : gained_) {
    candidates.add(gained);
    insert(gained, slot);
  }
  candidates.end();
  for (const Slot lost : lost_) neighbors_.erase(lost, anchors_[lost].count, slot);
  neighbors_.assign(slot, anchors_[slot].count, near_);
}

// Which of the spheres near a sphere are not in its list, and which in its list are no longer near: those in
// the list are marked with an even number, those near with the odd one after it.
void NeighborList::find_changes(Slot slot) {
  round_ += 2;
  if (round_ == 0) {
    // The counter has wrapped around: old marks must not pass for new ones.
    for (Anchor& anchor : anchors_) anchor.mark = 0;
    round_ = 2;
  }
  const Slot* const list = list_of(slot);
  const std::uint32_t length = anchors_[slot].count;
  for (std::uint32_t i = 0; i < length; ++i) anchors_[list[i]].mark = round_;
  // Branchless: which are known is unpredictable.
  gained_.resize(near_.size());
  Slot* gained = gained_.data();
  for (const Slot other : near_) {
    std::uint32_t& mark = anchors_[other].mark;
    *gained = other;
    gained += mark == round_ ? 0 : 1;
    mark = round_ + 1;
  }
  gained_.resize(static_cast<std::size_t>(gained - gained_.data()));
  lost_.resize(length);
  Slot* lost = lost_.data();
  for (std::uint32_t i = 0; i < length; ++i) {
    *lost = list[i];
    lost += anchors_[list[i]].mark == round_ ? 1 : 0;
  }
  lost_.resize(static_cast<std::size_t>(lost - lost_.data()));
}

void NeighborList::move_anchor(const World& world, Slot slot, const Time& now, const CompactPaths& copies) {
  anchors_[slot].place = copies.paths()[slot].place;
  anchors_[slot].cell = cells_.cell_of(world.position(slot, now));
}

// The spheres whose shells overlap a sphere's own, from the anchors in the cells around its own; the sphere
// itself is among them if its anchor is stored.
void NeighborList::find_near(Slot slot, const CompactPaths& copies) {
  ListsAround lists;
  const std::size_t count = find_lists_around(anchors_[slot].cell, lists);
  around_.assign(lists.data(), lists.data() + count);
  for (std::size_t i = 0; i < around_.size(); ++i) {
    const std::uint32_t next = store_.lists().next(around_[i]);
    if (next != PointLists::kNone) [[unlikely]]
      around_.push_back(next);
  }
  near_.resize(around_.size() * PointBlock::kRoom + kWidestVector);
  // Half of the reach belongs to each sphere, so that rounding is the same from either side.
  const float own_reach = reach_ / 2 + copies.radius(slot);
  const NearQuery query{
      .blocks = store_.lists().blocks(),
      .numbers = around_.data(),
      .count = around_.size(),
      .place = anchors_[slot].place,
      .grid = copies.scale().grid,
      .reach = copies.radii() == nullptr ? own_reach + own_reach : own_reach,
      .radii = copies.radii(),
      .margin = reach_ / 2,
  };
  near_.resize(pick_near_(query, near_.data()));
}

std::size_t NeighborList::find_lists_around(const CellIndex& center, ListsAround& lists) const {
  std::array<CellIndex, kAxes> rows{};
  std::array<std::size_t, kAxes> counts{};
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    for (std::int32_t row = center[axis] - 1; row <= center[axis] + 1; ++row) {
      if (row < cells_.first(axis) || row > cells_.last(axis)) continue;
      rows[axis][counts[axis]++] = cells_.folded(axis, row);
    }
  }
  std::size_t count = 0;
  for (std::size_t x = 0; x < counts[0]; ++x) {
    for (std::size_t y = 0; y < counts[1]; ++y) {
      if (store_.is_dense()) {
        // Rows are written whole, and what is too much is overwritten.
        const std::uint32_t row = store_.list({rows[0][x], rows[1][y], 0});
        for (std::size_t z = 0; z < 3; ++z) lists[count + z] = row + static_cast<std::uint32_t>(rows[2][z]);
        count += counts[2];
        continue;
      }
      for (std::size_t z = 0; z < counts[2]; ++z) {
        lists[count] = store_.list({rows[0][x], rows[1][y], rows[2][z]});
        count += lists[count] != PointLists::kNone ? 1U : 0U;
      }
    }
  }
  return count;
}

std::size_t NeighborList::memory_bytes() const {
  return store_.memory_bytes() + anchors_.capacity() * sizeof(Anchor) + neighbors_.memory_bytes() +
         around_.capacity() * sizeof(std::uint32_t) +
         (near_.capacity() + gained_.capacity() + lost_.capacity()) * sizeof(Slot);
}

void NeighborList::validate(const World& world, const Time& now, const CompactPaths& copies) const {
  HARDBALL_CHECK(anchors_.size() == world.size());
  const auto is_listed = [this](Slot list, Slot slot) {
    const Slot* const slots = list_of(list);
    return std::count(slots, slots + anchors_[list].count, slot) == 1;
  };
  NeighborList search = *this;
  for (Slot slot = 0; slot < world.size(); ++slot) {
    CompactPaths present = copies;
    present.copy(world, slot, now);
    const auto& anchor = anchors_[slot].place;
    const Vec3 place{present.apart(anchor, slot, 0), present.apart(anchor, slot, 1),
                     present.apart(anchor, slot, 2)};
    HARDBALL_CHECK(length(place) <= slack_ + coordinate_error(world, slot, now));
    search.find_near(slot, copies);
    std::erase(search.near_, slot);
    for (const Slot other : search.near_) HARDBALL_CHECK(is_listed(slot, other) && is_listed(other, slot));
    HARDBALL_CHECK(anchors_[slot].count == search.near_.size());
  }
}

}  // namespace hardball
