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

// By which shells are larger than they need to be, and centres cross earlier, as fractions of the farthest
// distance of neighbours: far more than the errors of places on the grid and of distances in single precision.
constexpr double kShellMargin = 0x1p-19;
constexpr double kCrossingMargin = 0x1p-23;

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
  const double farthest = world.size() > 0 ? farthest_neighbors(radius, slack_) : 1;
  const double margin = kShellMargin * farthest;
  room_ = slack_ - kCrossingMargin * farthest;
  cells_ = Subdivision(world.box(), farthest - 2 * slack_ + 2 * margin, kMostCellsPerAxis);
  copies.reset(world, farthest + 2 * margin, now);
  reach_ = static_cast<float>((2 * slack_ + margin) / copies.length_unit());
  store_.reset(cells_.shape(), world.size());
  anchors_.assign(world.size(), GridPoint{});
  neighbors_.reset(world.size());
  for (Slot slot = 0; slot < world.size(); ++slot) {
    anchors_[slot] = anchor_at(world, slot, now, copies);
    find_near(slot, copies);
    for (const Slot other : near_) {
      neighbors_.insert(slot, other);
      neighbors_.insert(other, slot);
    }
    store_.insert(anchors_[slot].cell, slot);
  }
}

void NeighborList::collect(const World&, Slot slot, Candidates& candidates) const {
  candidates.begin(slot, true);
  neighbors_.for_each_line(
      slot, [&](const SlotLists::LineOfSlots& slots, std::uint32_t count) { candidates.add(slots, count); });
  candidates.end();
}

double NeighborList::next_crossing(const World& world, Slot slot, const Time& now,
                                   const CompactPaths& copies) const {
  const Vec3 place = from_anchor(slot, copies);
  const double room = std::max(0.0, room_ * room_ - dot(place, place));
  return rounded_down(now) + wait_in_ball(place, world.path(slot).velocity, room);
}

void NeighborList::cross(const World& world, Slot slot, const Time& now, const CompactPaths& copies,
                         Candidates& candidates) {
  store_.erase(anchors_[slot].cell, slot);
  anchors_[slot] = anchor_at(world, slot, now, copies);
  find_near(slot, copies);
  store_.insert(anchors_[slot].cell, slot);
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

GridPoint NeighborList::anchor_at(const World& world, Slot slot, const Time& now,
                                  const CompactPaths& copies) const {
  return {copies.paths()[slot].place, cells_.cell_of(world.position(slot, now))};
}

// The centre, as copied, relative to its anchor.
Vec3 NeighborList::from_anchor(Slot slot, const CompactPaths& copies) const {
  const auto& anchor = anchors_[slot].place;
  return {copies.apart(anchor, slot, 0), copies.apart(anchor, slot, 1), copies.apart(anchor, slot, 2)};
}

// The spheres whose shells overlap a sphere's own, from the anchors in the cells around its own; the sphere
// itself is among them if its anchor is stored.
void NeighborList::find_near(Slot slot, const CompactPaths& copies) {
  const std::size_t count = collect_around(anchors_[slot].cell);
  if (count == 0) return near_.clear();
  // The kernel reads whole vectors.
  std::fill_n(around_.data() + count, kWidestVector, slot);
  near_.resize(count + kWidestVector);
  const NearQuery query{
      .points = anchors_.data(),
      .slots = around_.data(),
      .count = count,
      .place = anchors_[slot].place,
      .grid = copies.scale().grid,
      .reach = reach_ + copies.radius(slot) + (copies.radii() == nullptr ? copies.radius(slot) : 0),
      .radii = copies.radii(),
  };
  near_.resize(pick_near_(query, near_.data()));
}

// Collects the spheres whose anchors lie in the 27 cells around one, and returns their number.
std::size_t NeighborList::collect_around(const CellIndex& center) {
  std::array<std::array<std::int32_t, 3>, kAxes> rows;
  std::array<std::size_t, kAxes> row_count{};
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    for (std::int32_t row = center[axis] - 1; row <= center[axis] + 1; ++row) {
      if (row < cells_.first(axis) || row > cells_.last(axis)) continue;
      rows[axis][row_count[axis]++] = cells_.folded(axis, row);
    }
  }
  constexpr std::size_t kRoom = SlotLists::kRoom + kWidestVector;
  std::size_t count = 0;
  const auto add = [&](const SlotLists::LineOfSlots& slots, std::uint32_t in_line) {
    if (around_.size() < count + kRoom) [[unlikely]]
      around_.resize(2 * around_.size() + kRoom);
    std::copy(slots.begin(), slots.end(), around_.data() + count);
    count += in_line;
  };
  for (std::size_t x = 0; x < row_count[0]; ++x) {
    for (std::size_t y = 0; y < row_count[1]; ++y) {
      for (std::size_t z = 0; z < row_count[2]; ++z) {
        store_.lists().for_each_line(store_.list({rows[0][x], rows[1][y], rows[2][z]}), add);
      }
    }
  }
  return count;
}

std::size_t NeighborList::memory_bytes() const {
  return store_.memory_bytes() + anchors_.capacity() * sizeof(GridPoint) + neighbors_.memory_bytes() +
         (around_.capacity() + near_.capacity() + gained_.capacity() + lost_.capacity() + kept_.capacity()) *
             sizeof(Slot);
}

void NeighborList::validate(const World& world, const Time& now, const CompactPaths& copies) const {
  HARDBALL_CHECK(anchors_.size() == world.size());
  const auto is_listed = [this](Slot list, Slot slot) {
    int found = 0;
    neighbors_.for_each(list, [&](Slot other) { found += other == slot ? 1 : 0; });
    return found == 1;
  };
  NeighborList search = *this;
  for (Slot slot = 0; slot < world.size(); ++slot) {
    CompactPaths present = copies;
    present.copy(world, slot, now);
    HARDBALL_CHECK(length(from_anchor(slot, present)) <= slack_);
    search.find_near(slot, copies);
    std::erase(search.near_, slot);
    for (const Slot other : search.near_) HARDBALL_CHECK(is_listed(slot, other) && is_listed(other, slot));
    std::size_t listed = 0;
    neighbors_.for_each(slot, [&](Slot) { ++listed; });
    HARDBALL_CHECK(listed == search.near_.size());
  }
}

}  // namespace hardball
