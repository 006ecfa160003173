// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/cell_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

constexpr double kMaxCellsPerSphere = 1000;

std::int32_t divide_down(std::int32_t a, std::int32_t b) {
  return a >= 0 ? a / b : -((b - 1 - a) / b);
}

}  // namespace

void CellGrid::build(const World& world, const Time& now, CompactPaths& copies) {
  cells_ = Subdivision(world.box(), wanted_edge_);
  refuse_tiny_cells(world);
  const double largest = std::min(world.largest_bounding_radius(), largest_radius_);
  largest_built_ = std::min(world.room_to_grow() * largest, largest_radius_);
  if (!images_are_nearest()) largest_built_ = largest;
  nearest_ = images_are_nearest();
  table_ = CellTable(cells_, world.size(), cells_.spans_of(expected_.grown(largest_built_)));
  lists_.reset(table_.size());
  blocks_ = nearest_ && fits_into_cells(largest);
  copies.reset(world, std::max(farthest_candidates(), farthest_of_guests_), now);
  // The errors of single precision grow with the spheres and with the grid of the copies; the margin is a
  // fraction of the edge.
  constexpr double kLargestInEdges = 4;
  constexpr double kMinSteps = 0x1.ap20;
  is_single_precise_ = nearest_ && world.motion().is_straight();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double steps = cells_.edge(axis) * copies.steps_per_length()[axis];
    is_single_precise_ &= largest_built_ <= kLargestInEdges * cells_.edge(axis) && steps >= kMinSteps;
    // More are those of an axis without extent, which no crossing has.
    steps_of_cell_[axis] = static_cast<std::uint64_t>(std::ldexp(std::min(steps, 0x1p31), 32));
    margin_[axis] = static_cast<float>(cells_.reach(axis, 0) / copies.length_unit());
  }
  reset(lines_, world);
  left_count_ = 0;
  for (Slot slot = 0; slot < world.size(); ++slot) {
    if (holds(world, slot)) enter(world, slot, now);
  }
}

void CellGrid::enter(const World& world, Slot slot, const Time& now) {
  const CellRange range = range_at(world, slot, now);
  stored_region(slot).take(range);
  for_each_list(range, [&](std::uint32_t list) { lists_.insert(list, slot); });
}

bool CellGrid::admits(const World& world, Slot slot) const {
  const double radius = world.bounding_radius(slot);
  if (blocks_) return fits_into_cells(radius);
  if (radius <= largest_built_) return true;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (cells_.most_touched(axis, radius) > cells_.most_touched(axis, largest_built_)) return false;
  }
  return !is_single_precise_;
}

void CellGrid::insert(const World& world, Slot slot, const Time& now, const CompactPaths&) {
  reset(lines_, world, slot);
  if (holds(world, slot)) enter(world, slot, now);
}

void CellGrid::erase(Slot slot) {
  for_each_list(stored_region(slot).range(), [&](std::uint32_t list) { lists_.erase(list, slot); });
}

void CellGrid::move(Slot from, Slot to) {
  lines_[to] = lines_[from];
  for_each_list(stored_region(to).range(), [&](std::uint32_t list) {
    lists_.erase(list, from);
    lists_.insert(list, to);
  });
}

void CellGrid::refuse_tiny_cells(const World& world) const {
  double cells = 0;
  for (Slot slot = 0; slot < world.size(); ++slot) {
    if (!holds(world, slot)) continue;
    double own = 1;
    for (std::size_t axis = 0; axis < kAxes; ++axis)
      own *= 2 * world.bounding_radius(slot) / cells_.edge(axis) + 1;
    cells += own;
  }
  if (cells <= kMaxCellsPerSphere * static_cast<double>(world.size())) return;
  throw Error(
      "with a cell edge of " + to_text(wanted_edge_) + " each sphere would lie in " +
          to_text(std::round(cells / static_cast<double>(world.size()))) + " cells",
      "cell edge",
      "give at least a fifth of the largest diameter, " + to_text(world.largest_bounding_radius() * 2 / 5));
}

bool CellGrid::images_are_nearest() const {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!cells_.has_nearest_images(axis, largest_built_)) return false;
  }
  return true;
}

// Two regions that share a cell. Unless it is a block, a region may have one cell more along an axis than its
// sphere touches.
double CellGrid::farthest_candidates() const {
  Vec3 farthest;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double most_cells = blocks_ ? 2 : cells_.most_touched(axis, largest_built_) + 1;
    farthest[axis] = (2 * most_cells - 1) * cells_.edge(axis);
  }
  return length(farthest);
}

// A sphere that is smaller than a cell, by more than rounding errors and margins, touches at most two cells
// along each axis.
bool CellGrid::fits_into_cells(double radius) const {
  constexpr double kSurplus = 1e-4;
  const double diameter = 2 * radius * (1 + kSurplus);
  return diameter < cells_.edge(0) && diameter < cells_.edge(1) && diameter < cells_.edge(2);
}

void CellGrid::update(const World& world, Slot slot, const Time& now, const Image& folded) {
  if (blocks_) {
    refresh_block(world, slot, now, folded);
  } else {
    refresh_range(world, slot, now, folded);
  }
}

void CellGrid::refresh_range(const World& world, Slot slot, const Time& now, const Image& folded) {
  const CellRange range = range_at(world, slot, now);
  const CellRange old = stored_region(slot).range();
  if (folded.is_zero() && old.contains(range.low) && old.contains(range.high)) {
    leave(slot, old, range);
    stored_region(slot).take(range);
    return;
  }
  for_each_list(old, [&](std::uint32_t list) { lists_.erase(list, slot); });
  for_each_list(range, [&](std::uint32_t list) { lists_.insert(list, slot); });
  stored_region(slot).take(range);
}

// From the copy of the path, in single precision: for spheres of up to four edges, position, differences and
// quotient err by less than 2^-19 of an edge, half the margin.
double CellGrid::next_crossing(const World& world, Slot slot, const Time& now, const CompactPaths& copies) {
  // Slower components may have been rounded to zero.
  constexpr float kSlow = 0x1p-100F;
  CellRegion& region = stored_region(slot);
  const CompactPath& path = copies.paths()[slot];
  const float radius = copies.radius(slot);
  float least = std::numeric_limits<float>::infinity();
  Face face = 0;
  bool is_usual = is_single_precise_ & copies.is_bounded(slot);
  for_each_axis([&](auto axis) {
    const float velocity = path.velocity[axis];
    const bool up = !std::signbit(velocity);
    const std::int32_t plane = region.low[axis] + (up ? region.more[axis] + 1 : 0);
    const auto steps = static_cast<std::uint32_t>(path.position[axis]) -
                       static_cast<std::uint32_t>(face_position(axis, plane));
    const float beyond = static_cast<float>(static_cast<std::int32_t>(steps)) * copies.scale().grid[axis];
    const float ahead = (up ? -beyond : beyond) - (radius + margin_[axis]);
    const bool is_end = plane == (up ? cells_.last(axis) + 1 : cells_.first(axis));
    is_usual &= is_end | (std::fabs(velocity) >= kSlow);
    const float wait = is_end ? least : std::max(0.0F, ahead) / std::fabs(velocity);
    const bool sooner = wait < least;
    least = sooner ? wait : least;
    face ^= (face ^ face_of(axis, up)) & (0U - static_cast<Face>(sooner));
  });
  if (!is_usual) [[unlikely]]
    return next_crossing_of_any(world, slot, now);
  region.crossed_face = static_cast<std::uint8_t>(face);
  return rounded_down(now) + copies.time_unit() * static_cast<double>(least);
}

double CellGrid::next_crossing_of_any(const World& world, Slot slot, const Time& now) {
  CellRegion& region = stored_region(slot);
  const CellCrossing next =
      cells_.next_enter(world.unfolded_position(slot, now), world.velocity(slot, now),
                        world.motion().gravity(), world.bounding_radius(slot), region.range());
  region.crossed_face = static_cast<std::uint8_t>(face_of(next.axis, next.up));
  return rounded_down(now) + next.wait;
}

// Enters the row of cells ahead and releases those behind, as seen along the velocity: releasing cells ahead
// because of rounding could make two crossings repeat each other without end.
void CellGrid::cross(const World& world, Slot slot, const Time& now, const CompactPaths&,
                     Candidates& candidates) {
  if (blocks_) {
    cross_block(world, slot, now, candidates);
  } else {
    cross_range(world, slot, now, candidates);
  }
}

void CellGrid::cross_range(const World& world, Slot slot, const Time& now, Candidates& candidates) {
  CellRegion& region = stored_region(slot);
  const CellRange exact = range_at(world, slot, now);
  const Vec3 velocity = world.velocity(slot, now);
  const CellRange old = region.range();
  CellRange kept = old;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    kept.low[axis] =
        velocity[axis] > 0 ? std::clamp(exact.low[axis], old.low[axis], old.high[axis]) : old.low[axis];
    kept.high[axis] =
        velocity[axis] < 0 ? std::clamp(exact.high[axis], old.low[axis], old.high[axis]) : old.high[axis];
  }
  leave(slot, old, kept);
  const std::size_t crossed = axis_of(region.crossed_face);
  const std::int32_t row = is_upper(region.crossed_face) ? kept.high[crossed] + 1 : kept.low[crossed] - 1;
  // Where times do not resolve the motion, crossings follow one another and the sphere stays where it is: its
  // region must not grow.
  if (row > exact.high[crossed] + 2 || row < exact.low[crossed] - 2) [[unlikely]] {
    region.take(kept);
    candidates.begin(slot, nearest_);
    return candidates.end();
  }
  CellRange entered = kept;
  entered.low[crossed] = entered.high[crossed] = row;
  kept.low[crossed] = std::min(kept.low[crossed], row);
  kept.high[crossed] = std::max(kept.high[crossed], row);
  region.take(kept);
  collect_from(world, slot, entered, candidates);
  for_each_list(entered, [&](std::uint32_t list) { lists_.insert(list, slot); });
}

// As refresh, where regions are blocks: the sphere lies within its region, and keeps the cells it touches.
void CellGrid::refresh_block(const World& world, Slot slot, const Time& now, const Image& folded) {
  CellRegion& region = stored_region(slot);
  const Vec3 position = world.unfolded_position(slot, now);
  const double radius = world.bounding_radius(slot);
  std::uint32_t below = 0;  // axes along which it touches the lower half of the block
  std::uint32_t above = 0;
  for_each_axis([&](auto axis) {
    region.low[axis] -= cells_.cells_beyond(axis, folded);
    const double beyond = cells_.beyond_face(axis, region.low[axis] + 1, position[axis]);
    below |= CellBlock::axis_if(beyond < cells_.reach(axis, radius), axis);
    above |= CellBlock::axis_if(beyond > -cells_.reach(axis, radius), axis);
  });
  leave_halves(slot, region.wide_axes() & ~(below & above), above);
}

// As cross, where regions are blocks. Whatever the rounding, of two cells along the axis of the crossing it
// leaves one.
void CellGrid::cross_block(const World& world, Slot slot, const Time& now, Candidates& candidates) {
  CellRegion& region = stored_region(slot);
  const Vec3 position = world.unfolded_position(slot, now);
  const Vec3 velocities = world.velocity(slot, now);
  const double radius = world.bounding_radius(slot);
  std::uint32_t up = 0;     // axes along which it moves upwards
  std::uint32_t ahead = 0;  // axes along which it touches only the half of the block ahead
  for_each_axis([&](auto axis) {
    const double velocity = velocities[axis];
    const double beyond = cells_.beyond_face(axis, region.low[axis] + 1, position[axis]);
    up |= CellBlock::axis_if(!std::signbit(velocity), axis);
    ahead |= CellBlock::axis_if(std::copysign(1.0, velocity) * beyond > cells_.reach(axis, radius), axis);
  });
  const std::size_t axis = axis_of(region.crossed_face);
  const std::uint32_t crossed = CellBlock::kAxisBit[axis];
  leave_halves(slot, region.wide_axes() & (ahead | crossed), up);

  const std::uint32_t entered = CellBlock::cells_above(up & crossed, region.wide_axes());
  region.low[axis] -= is_upper(region.crossed_face) ? 0 : 1;
  region.more[axis] = 1;
  candidates.begin(slot, true);
  block_of(region).for_each_list(entered, [&](std::uint32_t list) {
    collect_list(list, candidates);
    lists_.insert(list, slot);
  });
  candidates.end();
}

// Releases half of a block along each of `axes`: the lower half along `up`, the upper one along the others.
void CellGrid::leave_halves(Slot slot, std::uint32_t axes, std::uint32_t up) {
  if (axes == 0) return;
  CellRegion& region = stored_region(slot);
  const std::uint32_t wide = region.wide_axes();
  const std::uint32_t kept = CellBlock::cells_above(axes & up, wide & ~axes);
  block_of(region).for_each_list(CellBlock::cells_above(0, wide) & ~kept,
                                 [&](std::uint32_t list) { lists_.erase(list, slot); });
  for_each_axis([&](auto axis) {
    region.low[axis] += static_cast<std::int32_t>(CellBlock::count(axes & up, axis));
    region.more[axis] = static_cast<std::uint16_t>(CellBlock::count(wide & ~axes, axis));
    left_count_ += CellBlock::count(axes, axis);
  });
}

CellRange CellGrid::range_at(const World& world, Slot slot, const Time& now) const {
  return cells_.range_at(world.unfolded_position(slot, now), world.bounding_radius(slot));
}

// Collects the spheres in the cells of a range, for a sphere.
void CellGrid::collect_from(const World& world, Slot slot, const CellRange& range,
                            Candidates& candidates) const {
  candidates.begin(slot, nearest_);
  if (nearest_) {
    for_each_list(range, [&](std::uint32_t list) { collect_list(list, candidates); });
  } else {
    candidates.start_round(world.size());
    for_each_list(range, [&](std::uint32_t list) {
      lists_.for_each(list, [&](Slot other) {
        if (!candidates.is_new(other)) return;
        candidates.mark(other);
        collect_images(world, other, candidates);
      });
    });
  }
  candidates.end();
}

// All images of a sphere that share a cell with the sphere of `candidates`.
void CellGrid::collect_images(const World& world, Slot other, Candidates& candidates) const {
  const CellRange own = stored_region(candidates.self()).range();
  const CellRange range = stored_region(other).range();
  Image first;
  Image last;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const std::int32_t period = cells_.period(axis);
    if (period == 0) continue;
    // The image lies in cells range + image * period, which must meet the cells of `own`.
    first[axis] = -divide_down(range.high[axis] - own.low[axis], period);
    last[axis] = divide_down(own.high[axis] - range.low[axis], period);
  }
  Image image;
  for (image[0] = first[0]; image[0] <= last[0]; ++image[0]) {
    for (image[1] = first[1]; image[1] <= last[1]; ++image[1]) {
      for (image[2] = first[2]; image[2] <= last[2]; ++image[2]) candidates.add(other, image, world.box());
    }
  }
}

// Releases the cells of `old` that are not in `kept`, a part of it.
void CellGrid::leave(Slot slot, const CellRange& old, const CellRange& kept) {
  if (old == kept) return;
  cells_.for_each_folded(old, [&](const CellIndex& cell, const CellIndex& folded) {
    if (!kept.contains(cell)) lists_.erase(table_.list(folded), slot);
  });
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    left_count_ +=
        static_cast<std::uint64_t>((kept.low[axis] - old.low[axis]) + (old.high[axis] - kept.high[axis]));
  }
}

bool CellGrid::is_in(Slot slot, const CellIndex& cell) const {
  bool is_found = false;
  cells_.for_each_folded(stored_region(slot).range(),
                         [&](const CellIndex&, const CellIndex& own) { is_found |= is_same(own, cell); });
  return is_found;
}

bool CellGrid::are_candidates(Slot a, Slot b) const {
  bool share_cell = false;
  cells_.for_each_folded(stored_region(a).range(),
                         [&](const CellIndex&, const CellIndex& cell) { share_cell |= is_in(b, cell); });
  return share_cell;
}

std::size_t CellGrid::memory_bytes() const {
  return lists_.memory_bytes() + lines_.capacity() * sizeof(lines_[0]);
}

void CellGrid::validate(const World& world, const Time& now, const CompactPaths&) const {
  HARDBALL_CHECK(lines_.size() >= world.size());
  for (Slot slot = 0; slot < world.size(); ++slot) {
    if (!holds(world, slot)) continue;
    const CellRange range = stored_region(slot).range();
    const Vec3 position = world.unfolded_position(slot, now);
    const double radius = world.bounding_radius(slot);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      HARDBALL_CHECK(!blocks_ || range.high[axis] <= range.low[axis] + 1);
      const double low = range.low[axis] * cells_.edge(axis);
      const double high = (range.high[axis] + 1) * cells_.edge(axis);
      HARDBALL_CHECK(range.low[axis] == cells_.first(axis) || low <= position[axis] - radius);
      HARDBALL_CHECK(range.high[axis] == cells_.last(axis) || high >= position[axis] + radius);
    }
    cells_.for_each_folded(range, [&](const CellIndex&, const CellIndex& folded) {
      std::size_t expected = 0;
      cells_.for_each_folded(range, [&](const CellIndex&, const CellIndex& same) {
        expected += table_.list(same) == table_.list(folded) ? 1U : 0U;
      });
      std::size_t found = 0;
      lists_.for_each(table_.list(folded), [&](Slot occupant) { found += occupant == slot ? 1U : 0U; });
      HARDBALL_CHECK(found == expected);
    });
  }
}

}  // namespace hardball
