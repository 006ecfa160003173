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

// By which shells are larger and balls smaller than they need to be: far more than rounding errors.
constexpr double kMargin = 1e-9;

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

// The squares of slower speeds underflow; inelastic collapse leads to them.
constexpr double kSlow = 0x1p-400;

// How long a centre at `place`, relative to the anchor, stays in its ball; `room` is the squared radius less
// the squared distance.
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
  // Without spheres any positive edge will do.
  const double least_edge = world.size() > 0 ? 2 * (radius + slack_) * (1 + 2 * kMargin) : 1;
  margin_ = kMargin * least_edge;
  cells_ = Subdivision(world.box(), least_edge, kMostCellsPerAxis);
  store_.reset(cells_.shape(), world.size());
  anchors_.assign(world.size(), Vec3{});
  neighbors_.reset(world.size());
  for (Slot slot = 0; slot < world.size(); ++slot) {
    anchors_[slot] = anchor_at(world, slot, now);
    find_near(world, slot);
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

// When the centre reaches the edge of its ball; computed from now, as nothing else depends on its last bits.
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
  const double wait = wait_in_ball(place, velocity, room);
  return wait > longest ? kNever : after(now, wait);
}

void NeighborList::cross(const World& world, Slot slot, const Time& now, Candidates& candidates) {
  store_.erase(cells_.cell_of(anchors_[slot]), slot);
  anchors_[slot] = anchor_at(world, slot, now);
  find_near(world, slot);
  store_.insert(cells_.cell_of(anchors_[slot]), slot);
  find_changes(slot);
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

// Which of the spheres near a sphere are not in its list, and which in its list are no longer near.
void NeighborList::find_changes(Slot slot) {
  kept_.clear();
  neighbors_.for_each_line(slot,
                           [this](const SlotLists::LineOfSlots&, std::uint32_t) { kept_.push_back(0); });
  gained_.resize(near_.size());
  Slot* gained = gained_.data();
  for (const Slot other : near_) {
    // Branchless: which are known is unpredictable.
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

// The centre relative to its anchor. It is in the ball: if it seems far away, another image is meant.
Vec3 NeighborList::from_anchor(const World& world, Slot slot, const Time& now) const {
  const Vec3 place = position_at(world.path(slot), now) - anchors_[slot];
  if (dot(place, place) <= slack_ * slack_) [[likely]]
    return place;
  return nearest(world.box(), place);
}

// The spheres whose shells overlap a sphere's own, from the anchors in the cells around its own; the sphere
// itself is among them if its anchor is stored.
void NeighborList::find_near(const World& world, Slot slot) {
  const CellIndex center = cells_.cell_of(anchors_[slot]);
  std::array<std::array<std::int32_t, 3>, kAxes> rows;
  std::array<std::size_t, kAxes> row_count{};
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    for (std::int32_t row = center[axis] - 1; row <= center[axis] + 1; ++row) {
      if (row < cells_.first(axis) || row > cells_.last(axis)) continue;
      rows[axis][row_count[axis]++] = cells_.folded(axis, row);
    }
  }
  std::size_t count = 0;
  CellIndex cell;
  for (std::size_t x = 0; x < row_count[0]; ++x) {
    cell[0] = rows[0][x];
    for (std::size_t y = 0; y < row_count[1]; ++y) {
      cell[1] = rows[1][y];
      for (std::size_t z = 0; z < row_count[2]; ++z) {
        cell[2] = rows[2][z];
        store_.lists().for_each_line(store_.list(cell),
                                     [&](const SlotLists::LineOfSlots& slots, std::uint32_t in_line) {
                                       if (around_.size() < count + 2 * SlotLists::kRoom)
                                         around_.resize(2 * around_.size() + 4 * SlotLists::kRoom);
                                       std::copy(slots.begin(), slots.end(), around_.data() + count);
                                       count += in_line;
                                     });
      }
    }
  }
  if (around_.empty()) return near_.clear();
  // The kernel reads whole vectors.
  std::fill_n(around_.data() + count, kWidestVector, slot);
  near_.resize(count + kWidestVector);
  const bool is_common = world.radii().is_common();
  const double reach = world.radius(slot) + 2 * slack_ + margin_;
  const NearQuery query{
      .points = anchors_.data(),
      .slots = around_.data(),
      .count = count,
      .place = anchors_[slot],
      .period = world.box().period(),
      .inverse_period = world.box().inverse_period(),
      .reach = is_common ? reach + world.radius(slot) : reach,
      .radii = is_common ? nullptr : world.radii().each().data(),
  };
  near_.resize(pick_near_(query, near_.data()));
}

std::size_t NeighborList::memory_bytes() const {
  return store_.memory_bytes() + anchors_.capacity() * sizeof(Vec3) + neighbors_.memory_bytes() +
         (around_.capacity() + near_.capacity() + gained_.capacity() + lost_.capacity() + kept_.capacity()) *
             sizeof(Slot);
}

void NeighborList::validate(const World& world, const Time& now) const {
  HARDBALL_CHECK(anchors_.size() == world.size());
  const auto is_listed = [this](Slot list, Slot slot) {
    int found = 0;
    neighbors_.for_each(list, [&](Slot other) { found += other == slot ? 1 : 0; });
    return found == 1;
  };
  NeighborList search = *this;
  for (Slot slot = 0; slot < world.size(); ++slot) {
    const Vec3 place = from_anchor(world, slot, now);
    HARDBALL_CHECK(dot(place, place) <= slack_ * slack_);
    search.find_near(world, slot);
    std::erase(search.near_, slot);
    for (const Slot other : search.near_) HARDBALL_CHECK(is_listed(slot, other) && is_listed(other, slot));
    std::size_t listed = 0;
    neighbors_.for_each(slot, [&](Slot) { ++listed; });
    HARDBALL_CHECK(listed == search.near_.size());
  }
}

}  // namespace hardball
