// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/neighbor_list.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <limits>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/wait_in_ball.hpp"

namespace hardball {
namespace {

// By which shells are larger than they need to be, and centers cross earlier, as fractions of the farthest
// distance of neighbors: far more than the errors of positions on the grid and of distances in single
// precision.
constexpr double kListMargin = 0x1p-19;
constexpr double kCrossingMargin = 0x1p-21;

// How far an estimate from packed positions is off at most along an axis, in units: each position is rounded
// down, the distance of two cells is rounded, and positions just outside of their cells are moved into them.
constexpr float kPackingError = 2.5F;

// With more long lists than this share, all get room for twice as many neighbors.
constexpr std::size_t kLongShare = 32;

// Distances of neighbors stay below this fraction of a periodic box: then only one image of each is near,
// and there are at least three cells along each axis.
constexpr double kLargestListShare = 0.33;

// The skin is at least this fraction of the largest radius.
constexpr double kLeastListSkin = 0.02;

// The largest distance between the centers of two neighbors: shells in contact, and both displaced from
// their anchors.
double farthest_neighbors(double largest_radius, double skin) {
  return 2 * largest_radius + 4 * skin;
}

double smallest_period(const Box& box) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (box.is_periodic(axis)) smallest = std::min(smallest, box.size()[axis]);
  }
  return smallest;
}

// Whether lists can be made for spheres of up to this radius.
bool fits(const Box& box, double largest_radius) {
  return farthest_neighbors(largest_radius, kLeastListSkin * largest_radius) <=
         kLargestListShare * smallest_period(box);
}

}  // namespace

bool NeighborList::supports(const World& world, double) {
  return !world.box().is_sheared() && fits(world.box(), world.largest_bounding_radius());
}

double NeighborList::cell_edge(double largest_radius, double skin) {
  return farthest_neighbors(largest_radius, skin) - 2 * skin;
}

void NeighborList::build(const World& world, const Time& now, CompactPaths& copies) {
  HARDBALL_CHECK(supports(world));
  const double grown = world.room_to_grow() * world.largest_bounding_radius();
  const double radius = largest_built_ = fits(world.box(), grown) ? grown : world.largest_bounding_radius();
  const double largest = (kLargestListShare * smallest_period(world.box()) - 2 * radius) / 4;
  skin_ = std::max(kLeastListSkin * radius, std::min(wanted_skin_, largest));
  // Without spheres any distance will do.
  const double any_radius = world.size() > 0 ? radius : 1;
  const double farthest = farthest_neighbors(any_radius, skin_);
  const double margin = kListMargin * farthest;
  room_ = skin_ - kCrossingMargin * farthest;
  cells_ = Subdivision(world.box(), cell_edge(any_radius, skin_) + 2 * margin);
  copies.reset(world, farthest + 2 * margin, now);
  reach_ = static_cast<float>((2 * skin_ + margin) / copies.length_unit());
  room_squared_ = static_cast<float>(room_ * room_ / (copies.length_unit() * copies.length_unit()));
  table_ = CellTable(cells_.shape(), world.size());
  points_.reset(table_.size());
  choose_packing(copies);
  reset(lines_, world);
  for (Slot slot = 0; slot < world.size(); ++slot) {
    move_anchor(world, slot, now, copies);
    store_anchor(slot);
  }
  make_lists(1, copies);
}

void NeighborList::make_lists(std::uint32_t lines, const CompactPaths& copies) {
  neighbors_.reset(lines_.size(), lines);
  std::size_t long_ones = 0;
  for (Slot slot = 0; slot < lines_.size(); ++slot) {
    find_near(slot, copies);
    near_.count = static_cast<std::size_t>(std::remove(near_.begin(), near_.begin() + near_.count, slot) -
                                           near_.begin());
    neighbors_.assign(slot, near_.slots());
    long_ones += near_.count > PaddedLists::kLine ? 1U : 0U;
  }
  if (lines == 1 && long_ones > lines_.size() / kLongShare) make_lists(2, copies);
}

void NeighborList::insert(const World& world, Slot slot, const Time& now, const CompactPaths& copies) {
  reset(lines_, world, slot);
  neighbors_.add_owner(slot);
  move_anchor(world, slot, now, copies);
  find_near(slot, copies);
  store_anchor(slot);
  for (const Slot other : near_.slots()) neighbors_.insert(other, slot);
  neighbors_.assign(slot, near_.slots());
}

void NeighborList::erase(Slot slot) {
  points_.erase(table_.list(lines_[slot].region.cell), slot);
  for (const Slot other : neighbors_.of(slot)) {
    if (other != slot) neighbors_.erase(other, slot);
  }
  neighbors_.assign(slot, {});
}

bool NeighborList::keeps(const World& world, Slot slot, const Time& now, const CompactPaths& copies) const {
  const Anchor& anchor = lines_[slot].region;
  const CellIndex cell = cells_.cell_of(world.position(slot, now));
  bool is_near = copies.is_bounded(slot);
  float room = room_squared_;
  for_each_axis([&](auto axis) {
    // On the grid alone, a place far away may seem near.
    const std::int32_t rows = std::abs(cell[axis] - anchor.cell[axis]);
    is_near &= rows <= 1 || rows == cells_.period(axis) - 1;
    const auto steps = static_cast<std::uint32_t>(copies.paths()[slot].position[axis]) -
                       static_cast<std::uint32_t>(anchor.position[axis]);
    const float apart = static_cast<float>(static_cast<std::int32_t>(steps)) * copies.scale().grid[axis];
    room -= apart * apart;
  });
  return is_near && room > 0;
}

void NeighborList::move(Slot from, Slot to) {
  points_.erase(table_.list(lines_[from].region.cell), from);
  lines_[to] = lines_[from];
  store_anchor(to);
  const std::span<const Slot> lanes = neighbors_.of(from);
  std::vector<Slot> list(lanes.begin(), lanes.end());
  std::erase(list, from);
  for (const Slot other : list) {
    neighbors_.erase(other, from);
    neighbors_.insert(other, to);
  }
  neighbors_.assign(from, {});
  neighbors_.assign(to, list);
}

void NeighborList::choose_packing(const CompactPaths& copies) {
  float error = 0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    Packing& packing = packing_[axis] = {};
    const double steps = cells_.edge(axis) * copies.steps_per_length()[axis];
    // Larger than the ring of the grid are cells of an axis without extent, and those of a box so large that
    // there cannot be more: along it nothing is known of distances, and all count as zero.
    constexpr double kHalfRing = 0x1p31;
    if (steps >= kHalfRing) {
      packing.shift = 31;
      continue;
    }
    packing.steps_of_cell = static_cast<std::uint64_t>(std::ldexp(steps, 32));
    const auto in_units = [&] { return std::ldexp(steps, -static_cast<int>(packing.shift)); };
    while (in_units() > PackedPosition::kMax - 1) ++packing.shift;
    packing.units_of_cell = static_cast<std::int32_t>(std::lround(in_units()));
    if (cells_.shape()[axis] == 0) {
      packing.below = cells_.first(axis);
      packing.above = cells_.last(axis);
    }
    packing_unit_[axis] = std::ldexp(copies.scale().grid[axis], static_cast<int>(packing.shift));
    error += kPackingError * kPackingError * packing_unit_[axis] * packing_unit_[axis];
  }
  packing_error_ = std::sqrt(error);
}

// Of anchors beyond the outermost cells distances are underestimated.
std::array<std::int32_t, 3> NeighborList::in_cell(const Anchor& anchor) const {
  std::array<std::int32_t, 3> units;
  for_each_axis([&](auto axis) {
    const Packing& packing = packing_[axis];
    const std::int32_t cell = anchor.cell[axis];
    const std::uint64_t corner = static_cast<std::uint64_t>(std::int64_t{cell}) * packing.steps_of_cell;
    const auto steps = static_cast<std::int32_t>(static_cast<std::uint32_t>(anchor.position[axis]) -
                                                 static_cast<std::uint32_t>(corner >> 32));
    constexpr auto kMax = static_cast<std::int32_t>(PackedPosition::kMax);
    const std::int32_t inside = std::clamp(steps >> packing.shift, 0, kMax);
    units[axis] = cell == packing.below ? kMax : cell == packing.above ? 0 : inside;
  });
  return units;
}

double NeighborList::next_crossing_of_any(const World& world, Slot slot, const Time& now,
                                          const CompactPaths& copies) const {
  const auto& anchor = lines_[slot].region.position;
  const Vec3 position{copies.apart(anchor, slot, 0), copies.apart(anchor, slot, 1),
                      copies.apart(anchor, slot, 2)};
  const double reach = std::max(0.0, room_ - coordinate_error(world, slot, now));
  return rounded_down(now) + wait_in_ball(world.motion(), position, world.velocity(slot, now), reach);
}

void NeighborList::cross(const World& world, Slot slot, const Time& now, const CompactPaths& copies,
                         Candidates& candidates) {
  points_.erase(table_.list(lines_[slot].region.cell), slot);
  move_anchor(world, slot, now, copies);
  find_near(slot, copies);
  store_anchor(slot);
  find_changes(slot);
  candidates.begin(slot, true);
  for (const Slot gained : gained_) {
    candidates.add(gained);
    neighbors_.insert(gained, slot);
  }
  candidates.end();
  for (const Slot lost : lost_) neighbors_.erase(lost, slot);
  neighbors_.assign(slot, near_.slots());
}

// Which of the spheres near a sphere are not in its list, and which in its list are no longer near.
void NeighborList::find_changes(Slot slot) {
  const std::span<const Slot> list = neighbors_.of(slot);
  const std::span<const Slot> near = near_.slots();
  gained_.resize(near.size() + kWidestVector);
  lost_.resize(list.size() + kWidestVector);
  if (list.size() <= kMaxCompared) [[likely]] {
    const Differences found = kernels_->find_differences(list.data(), list.size(), slot, near.data(),
                                                         near.size(), gained_.data(), lost_.data());
    gained_.resize(found.gained);
    lost_.resize(found.lost);
  } else {
    std::vector<Slot> before(list.begin(), list.end());
    std::erase(before, slot);
    std::vector<Slot> now(near.begin(), near.end());
    std::ranges::sort(before);
    std::ranges::sort(now);
    gained_.clear();
    lost_.clear();
    std::ranges::set_difference(now, before, std::back_inserter(gained_));
    std::ranges::set_difference(before, now, std::back_inserter(lost_));
  }
  for (const Slot other : gained_) prefetch(neighbors_.address(other));
  for (const Slot other : lost_) prefetch(neighbors_.address(other));
}

void NeighborList::move_anchor(const World& world, Slot slot, const Time& now, const CompactPaths& copies) {
  lines_[slot].region.position = copies.paths()[slot].position;
  lines_[slot].region.cell = cells_.cell_of(world.position(slot, now));
}

// The spheres whose shells overlap a sphere's own, from the anchors in the cells around its own; the sphere
// itself is among them if its anchor is stored.
void NeighborList::find_near(Slot slot, const CompactPaths& copies) {
  const std::size_t count = find_cells_around(lines_[slot].region, near_.cells);
  // Half of the reach belongs to each sphere, so that rounding is the same from either side.
  const float half = (reach_ + packing_error_) / 2;
  const float own_reach = half + copies.radius(slot);
  NearQuery query{
      .blocks = points_.blocks(),
      .next = points_.next(),
      .cells = near_.cells.data(),
      .count = count,
      .unit = packing_unit_,
      .reach = copies.radii() == nullptr ? own_reach + own_reach : own_reach,
      .radii = copies.radii(),
      .margin = half,
      .room = near_.room.size() - kWidestVector,
  };
  near_.count = kernels_->pick_near(query, near_.begin());
  if (near_.count > query.room) [[unlikely]] {
    near_.room.resize(near_.count + kWidestVector);
    query.room = near_.count;
    kernels_->pick_near(query, near_.begin());
  }
  if (table_.is_shared()) [[unlikely]]
    leave_out_far(slot, copies);
}

// Leaves out what was found in cells elsewhere that share a list with one of those around.
void NeighborList::leave_out_far(Slot slot, const CompactPaths& copies) {
  Slot* const begin = near_.begin();
  Slot* end = begin + near_.count;
  end = std::remove_if(begin, end, [&](Slot other) { return !are_near(slot, other, copies); });
  std::sort(begin, end);
  near_.count = static_cast<std::size_t>(std::unique(begin, end) - begin);
}

// Whether the shells of two spheres overlap, and their cells touch: on the grid, anchors that are far apart
// may seem near.
bool NeighborList::are_near(Slot a, Slot b, const CompactPaths& copies) const {
  bool do_cells_touch = true;
  float distance_squared = 0;
  for_each_axis([&](auto axis) {
    const Packing& packing = packing_[axis];
    const std::int32_t cell_of_a = lines_[a].region.cell[axis];
    const std::int32_t cell_of_b = lines_[b].region.cell[axis];
    const std::int32_t rows = std::abs(cell_of_a - cell_of_b);
    do_cells_touch &= rows <= 1 || rows == cells_.period(axis) - 1;
    if (packing.steps_of_cell == 0 || packing.is_outermost(cell_of_a) || packing.is_outermost(cell_of_b))
      return;
    const auto steps = static_cast<std::uint32_t>(lines_[a].region.position[axis]) -
                       static_cast<std::uint32_t>(lines_[b].region.position[axis]);
    const float apart = static_cast<float>(static_cast<std::int32_t>(steps)) * copies.scale().grid[axis];
    distance_squared += apart * apart;
  });
  const float reach = (reach_ / 2 + copies.radius(a)) + (reach_ / 2 + copies.radius(b));
  return do_cells_touch && distance_squared < reach * reach;
}

// Each row of cells along each axis contributes to the number of a list and to the offset of its cell.
std::size_t NeighborList::find_cells_around(const Anchor& anchor, CellsAround& around) const {
  using Four = std::uint32_t __attribute__((vector_size(16)));  // modulo 2^32
  static_assert(sizeof(CellNearby) == sizeof(Four));
  std::array<std::array<Four, 3>, kAxes> rows;
  std::array<std::size_t, kAxes> counts{};
  const std::array<std::int32_t, 3> own = in_cell(anchor);
  for_each_axis([&](auto axis) {
    for (std::int32_t step = -1; step <= 1; ++step) {
      const std::int32_t row = anchor.cell[axis] + step;
      if (row < cells_.first(axis) || row > cells_.last(axis)) [[unlikely]]
        continue;
      Four part{};
      part[0] = table_.part(axis, cells_.folded(axis, row));
      part[axis + 1] = static_cast<std::uint32_t>(step * packing_[axis].units_of_cell - own[axis]);
      rows[axis][counts[axis]++] = part;
    }
  });
  std::size_t count = 0;
  const auto add = [&](const Four& cell) { std::memcpy(&around[count++], &cell, sizeof cell); };
  if ((counts[0] == 3) & (counts[1] == 3) & (counts[2] == 3)) [[likely]] {
    for (std::size_t x = 0; x < 3; ++x) {
      for (std::size_t y = 0; y < 3; ++y) {
        const Four row = rows[0][x] + rows[1][y];
        for (std::size_t z = 0; z < 3; ++z) add(row + rows[2][z]);
      }
    }
  } else {
    for (std::size_t x = 0; x < counts[0]; ++x) {
      for (std::size_t y = 0; y < counts[1]; ++y) {
        for (std::size_t z = 0; z < counts[2]; ++z) add(rows[0][x] + rows[1][y] + rows[2][z]);
      }
    }
  }
  if (table_.is_shared()) [[unlikely]] {
    for (std::size_t i = 0; i < count; ++i) around[i].block = table_.list_at(around[i].block);
  }
  return count;
}

std::size_t NeighborList::memory_bytes() const {
  return points_.memory_bytes() + lines_.capacity() * sizeof(lines_[0]) + neighbors_.memory_bytes() +
         (near_.room.capacity() + gained_.capacity() + lost_.capacity()) * sizeof(Slot);
}

void NeighborList::validate(const World& world, const Time& now, const CompactPaths& copies) const {
  HARDBALL_CHECK(lines_.size() >= world.size());
  const auto is_listed = [this](Slot list, Slot slot) {
    const std::span<const Slot> lanes = neighbors_.of(list);
    return std::count(lanes.begin(), lanes.end(), slot) == 1;
  };
  NeighborList search = *this;
  for (Slot slot = 0; slot < world.size(); ++slot) {
    CompactPaths present = copies;
    present.copy(world, slot, now);
    const auto& anchor = lines_[slot].region.position;
    const Vec3 position{present.apart(anchor, slot, 0), present.apart(anchor, slot, 1),
                        present.apart(anchor, slot, 2)};
    HARDBALL_CHECK(length(position) <= skin_ + coordinate_error(world, slot, now));
    search.find_near(slot, copies);
    std::size_t others = 0;
    for (const Slot other : search.near_.slots()) {
      if (other == slot) continue;
      HARDBALL_CHECK(is_listed(slot, other) && is_listed(other, slot));
      ++others;
    }
    HARDBALL_CHECK(neighbors_.size(slot) == others);
  }
}

}  // namespace hardball
