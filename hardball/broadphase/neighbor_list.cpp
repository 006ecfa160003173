// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/neighbor_list.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

// How much farther shells reach than they need to, and how much earlier balls end: by far more than rounding.
constexpr double kMargin = 1e-9;

// Distances of neighbours stay below this fraction of a periodic box: then no two copies of one come near,
// and there are at least three cells along each axis.
constexpr double kLargestShare = 0.33;

// The slack is at least this fraction of the largest radius.
constexpr double kLeastSlack = 0.02;

constexpr std::int32_t kMostCellsPerAxis = 1 << 28;

// Two neighbours' centres are never farther apart: their shells, and twice more the way each may have gone.
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

// The squares of slower speeds lose their digits; spheres that collapse come to them.
constexpr double kSlow = 0x1p-400;

// How long a centre at `place` stays in its ball, `room` being the difference of the squared radius and its
// squared distance from the anchor.
double wait_in_ball(const Vec3& place, Vec3 velocity, double room) {
  const bool is_slow = dot(velocity, velocity) < kSlow * kSlow;
  const double time_unit = is_slow ? 0x1p600 : 1;
  if (is_slow) velocity = time_unit * velocity;
  const double speed_squared = dot(velocity, velocity);
  if (!(speed_squared > 0)) return std::numeric_limits<double>::infinity();
  const double outwards = dot(place, velocity);
  const double root = std::sqrt(outwards * outwards + speed_squared * room);
  return time_unit * (outwards > 0 ? room / (root + outwards) : (root - outwards) / speed_squared);
}

Vec3 nearest(const Box& box, Vec3 separation) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    separation[axis] -= std::round(separation[axis] * box.inverse_period()[axis]) * box.period()[axis];
  }
  return separation;
}

// Writes those of a line whose anchors are near `place` to `out`; returns how many they are. There must be
// room for all.
template <class ReachTo>
std::uint32_t pick_near(const SlotLists::LineOfSlots& slots, std::uint32_t count, const Vec3* anchors,
                        const Vec3& place, Slot self, const ReachTo& reach_to, Slot* out) {
  std::uint32_t found = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    // Without a branch: whether an anchor is near cannot be foreseen.
    const Slot other = slots[i];
    const Vec3 apart = anchors[other] - place;
    const double reach = reach_to(other);
    out[found] = other;
    found += static_cast<std::uint32_t>(dot(apart, apart) < reach * reach) &
             static_cast<std::uint32_t>(other != self);
  }
  return found;
}

}  // namespace

bool NeighborList::suits(const World& world) {
  const double radius = world.largest_radius();
  return farthest_neighbors(radius, kLeastSlack * radius) <= kLargestShare * smallest_period(world.box());
}

void NeighborList::build(const World& world, const Time& now) {
  HARDBALL_CHECK(suits(world));
  const double radius = world.largest_radius();
  const double room = (kLargestShare * smallest_period(world.box()) - 2 * radius) / 4;
  slack_ = std::max(kLeastSlack * radius, std::min(wanted_slack_, room));
  // Where there is no sphere any edge will do, but zero.
  const double least_edge = world.size() > 0 ? 2 * (radius + slack_) * (1 + 2 * kMargin) : 1;
  cells_ = Subdivision(world.box(), least_edge, kMostCellsPerAxis);
  store_.reset(cells_.shape(), world.size());
  anchors_.assign(world.size(), Vec3{});
  neighbors_.reset(world.size());
  for (Slot slot = 0; slot < world.size(); ++slot) {
    anchors_[slot] = anchor_at(world, slot, now);
    find_near(world, slot, near_);
    for (const Slot other : near_) {
      neighbors_.insert(slot, other);
      neighbors_.insert(other, slot);
    }
    store_.insert(cells_.cell_of(anchors_[slot]), slot);
  }
}

void NeighborList::collect(const World&, Slot slot, Candidates& candidates) const {
  candidates.begin(slot, true);
  neighbors_.for_each_line(
      slot, [&](const SlotLists::LineOfSlots& slots, std::uint32_t count) { candidates.add(slots, count); });
  candidates.end();
}

// When the centre comes to the edge of its ball; reckoned from now, as nothing else depends on its last bits.
Time NeighborList::next_crossing(const World& world, Slot slot, const Time& now, const Time& limit) const {
  const Vec3 place = from_anchor(world, slot, now);
  const Vec3& velocity = world.path(slot).velocity;
  const double speed_squared = dot(velocity, velocity);
  const double outwards = dot(place, velocity);
  const double reach = slack_ * (1 - kMargin);
  const double room = std::max(0.0, reach * reach - dot(place, place));
  const double longest = duration(now, limit);
  if (longest * (speed_squared * longest + 2 * outwards) < room && speed_squared > kSlow * kSlow) {
    return kNever;
  }
  return after(now, wait_in_ball(place, velocity, room));
}

void NeighborList::cross(const World& world, Slot slot, const Time& now, Candidates& candidates) {
  const CellIndex old_cell = cells_.cell_of(anchors_[slot]);
  anchors_[slot] = anchor_at(world, slot, now);
  const CellIndex cell = cells_.cell_of(anchors_[slot]);
  if (cell != old_cell) {
    store_.erase(old_cell, slot);
    store_.insert(cell, slot);
  }
  find_near(world, slot, near_);
  tell_changes(slot);
  candidates.begin(slot, true);
  for (const Slot gained : gained_) {
    candidates.add(gained);
    neighbors_.insert(gained, slot);
  }
  candidates.end();
  for (const Slot lost : lost_) neighbors_.erase(lost, slot);
  neighbors_.clear(slot);
  for (const Slot other : near_) neighbors_.insert(slot, other);
}

// Which of those near a sphere are not in its list, and which of the list are not near any more.
void NeighborList::tell_changes(Slot slot) {
  kept_.clear();
  neighbors_.for_each_line(slot,
                           [this](const SlotLists::LineOfSlots&, std::uint32_t) { kept_.push_back(0); });
  gained_.resize(near_.size());
  Slot* gained = gained_.data();
  for (const Slot other : near_) {
    // Without a branch: which are known cannot be foreseen.
    std::uint32_t known = 0;
    std::uint32_t* kept = kept_.data();
    neighbors_.for_each_line(slot, [&](const SlotLists::LineOfSlots& slots, std::uint32_t count) {
      const std::uint32_t place = SlotLists::places_of(other, slots, count);
      *kept++ |= place;
      known |= place;
    });
    *gained = other;
    gained += known == 0 ? 1 : 0;
  }
  gained_.resize(static_cast<std::size_t>(gained - gained_.data()));
  lost_.clear();
  const std::uint32_t* kept = kept_.data();
  neighbors_.for_each_line(slot, [&](const SlotLists::LineOfSlots& slots, std::uint32_t count) {
    for (std::uint32_t lost = ~*kept++ & ((1U << count) - 1); lost != 0; lost &= lost - 1) {
      lost_.push_back(slots[static_cast<std::size_t>(std::countr_zero(lost))]);
    }
  });
}

Vec3 NeighborList::anchor_at(const World& world, Slot slot, const Time& now) const {
  return world.position(slot, now);
}

// Where the centre is, seen from its anchor. It is in the ball: from far away only another copy is seen.
Vec3 NeighborList::from_anchor(const World& world, Slot slot, const Time& now) const {
  const Vec3 place = position_at(world.path(slot), now) - anchors_[slot];
  if (dot(place, place) <= slack_ * slack_) [[likely]]
    return place;
  return nearest(world.box(), place);
}

// The spheres whose shells meet a sphere's own, from the anchors in the cells around its own. Beyond the edge
// of a periodic box it is the sphere that is displaced, once for each row of cells.
void NeighborList::find_near(const World& world, Slot slot, std::vector<Slot>& near) const {
  struct Row {
    std::int32_t cell;
    double place;
  };
  std::array<std::array<Row, 3>, kAxes> rows;
  std::array<std::size_t, kAxes> row_count{};
  const Vec3& anchor = anchors_[slot];
  const CellIndex center = cells_.cell_of(anchor);
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const std::int32_t period = cells_.period(axis);
    for (std::int32_t cell = center[axis] - 1; cell <= center[axis] + 1; ++cell) {
      Row row{cell, anchor[axis]};
      if (period > 0 && cell < 0) {
        row = {cell + period, anchor[axis] + world.box().size()[axis]};
      } else if (period > 0 && cell >= period) {
        row = {cell - period, anchor[axis] - world.box().size()[axis]};
      } else if (period == 0 && (cell < cells_.first(axis) || cell > cells_.last(axis))) {
        continue;
      }
      rows[axis][row_count[axis]++] = row;
    }
  }
  const double own_reach = (world.radius(slot) + 2 * slack_) * (1 + kMargin);
  const double common_reach = own_reach + world.radius(slot) * (1 + kMargin);
  const auto reach_to_any = [common_reach](Slot) { return common_reach; };
  const auto reach_to = [&](Slot other) { return own_reach + world.radius(other) * (1 + kMargin); };
  const bool is_common = world.radii().is_common();
  const Vec3* const anchors = anchors_.data();
  std::size_t found = 0;
  CellIndex cell;
  Vec3 place;
  for (std::size_t x = 0; x < row_count[0]; ++x) {
    cell[0] = rows[0][x].cell;
    place.x = rows[0][x].place;
    for (std::size_t y = 0; y < row_count[1]; ++y) {
      cell[1] = rows[1][y].cell;
      place.y = rows[1][y].place;
      for (std::size_t z = 0; z < row_count[2]; ++z) {
        cell[2] = rows[2][z].cell;
        place.z = rows[2][z].place;
        store_.lists().for_each_line(
            store_.list(cell), [&](const SlotLists::LineOfSlots& slots, std::uint32_t count) {
              if (near.size() < found + count) near.resize(2 * (found + count));
              Slot* const out = near.data() + found;
              found += is_common ? pick_near(slots, count, anchors, place, slot, reach_to_any, out)
                                 : pick_near(slots, count, anchors, place, slot, reach_to, out);
            });
      }
    }
  }
  near.resize(found);
}

std::size_t NeighborList::memory_bytes() const {
  return store_.memory_bytes() + anchors_.capacity() * sizeof(Vec3) + neighbors_.memory_bytes() +
         (near_.capacity() + gained_.capacity() + lost_.capacity() + kept_.capacity()) * sizeof(Slot);
}

void NeighborList::validate(const World& world, const Time& now) const {
  HARDBALL_CHECK(anchors_.size() == world.size());
  const auto is_listed = [this](Slot list, Slot slot) {
    int found = 0;
    neighbors_.for_each(list, [&](Slot other) { found += other == slot ? 1 : 0; });
    return found == 1;
  };
  std::vector<Slot> near;
  for (Slot slot = 0; slot < world.size(); ++slot) {
    const Vec3 place = from_anchor(world, slot, now);
    HARDBALL_CHECK(dot(place, place) <= slack_ * slack_);
    find_near(world, slot, near);
    for (const Slot other : near) HARDBALL_CHECK(is_listed(slot, other) && is_listed(other, slot));
    std::size_t listed = 0;
    neighbors_.for_each(slot, [&](Slot) { ++listed; });
    HARDBALL_CHECK(listed == near.size());
  }
}

}  // namespace hardball
