// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/cell_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

constexpr double kMostCellsPerSphere = 1000;
constexpr std::int32_t kMostCellsPerAxis = 1 << 28;

std::int32_t divide_down(std::int32_t a, std::int32_t b) {
  return a >= 0 ? a / b : -((b - 1 - a) / b);
}

// Calls visit(slab) for the parts of a range that lie outside another, cut along each axis in turn.
template <class Visit>
void for_each_slab(CellRange range, const CellRange& outside, Visit&& visit) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (range.low[axis] < outside.low[axis]) {
      CellRange slab = range;
      slab.high[axis] = std::min(range.high[axis], outside.low[axis] - 1);
      visit(slab);
      range.low[axis] = outside.low[axis];
    }
    if (range.high[axis] > outside.high[axis]) {
      CellRange slab = range;
      slab.low[axis] = std::max(range.low[axis], outside.high[axis] + 1);
      visit(slab);
      range.high[axis] = outside.high[axis];
    }
    if (range.low[axis] > range.high[axis]) return;
  }
}

}  // namespace

void CellGrid::Resident::take(const CellRange& range) {
  low = range.low;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const std::int32_t cells = range.high[axis] - range.low[axis];
    HARDBALL_CHECK(cells >= 0 && cells <= std::numeric_limits<std::uint16_t>::max());
    more[axis] = static_cast<std::uint16_t>(cells);
  }
}

void CellGrid::build(const World& world, const Time& now) {
  cells_ = Subdivision(world.box(), wanted_edge_, kMostCellsPerAxis);
  refuse_tiny_cells(world);
  CellIndex shape{};
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (world.box().is_wall(axis)) shape[axis] = cells_.last(axis) + 1;
    if (world.box().is_periodic(axis)) shape[axis] = cells_.period(axis);
  }
  nearest_ = images_are_nearest(world);
  store_.reset(shape, world.size());
  residents_.assign(world.size(), Resident{});
  left_count_ = 0;
  for (Slot slot = 0; slot < world.size(); ++slot) {
    const CellRange range = range_at(world, slot, now);
    residents_[slot].take(range);
    cells_.for_each_folded(range, [&](const CellIndex&, const CellIndex& cell) { store_.insert(cell, slot); });
  }
}

void CellGrid::refuse_tiny_cells(const World& world) const {
  double cells = 0;
  for (Slot slot = 0; slot < world.size(); ++slot) {
    double own = 1;
    for (std::size_t axis = 0; axis < kAxes; ++axis) own *= 2 * world.radius(slot) / cells_.edge(axis) + 1;
    cells += own;
  }
  if (cells <= kMostCellsPerSphere * static_cast<double>(world.size())) return;
  throw Error("with a cell edge of " + to_text(wanted_edge_) + " each sphere would lie in " +
                  to_text(std::round(cells / static_cast<double>(world.size()))) + " cells",
              "cell edge",
              "give at least a fifth of the largest diameter, " + to_text(world.largest_radius() * 2 / 5));
}

// A sphere touches at most so many cells along an axis, its centre lies in one of them, and spheres that
// share a cell are less than twice that, less one, apart: nearer than half the box.
bool CellGrid::images_are_nearest(const World& world) const {
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!world.box().is_periodic(axis)) continue;
    const double touched = std::floor(2 * world.largest_radius() / cells_.edge(axis) * (1 + 1e-6)) + 2;
    if (cells_.period(axis) < 2 * (2 * touched - 1) + 1) return false;
  }
  return true;
}

void CellGrid::refresh(const World& world, Slot slot, const Time& now, const Image& folded) {
  const CellRange range = range_at(world, slot, now);
  if (folded == Image{}) {
    move(slot, range);
    return;
  }
  const CellRange old = residents_[slot].range();
  cells_.for_each_folded(old, [&](const CellIndex&, const CellIndex& cell) { store_.erase(cell, slot); });
  cells_.for_each_folded(range, [&](const CellIndex&, const CellIndex& cell) { store_.insert(cell, slot); });
  residents_[slot].take(range);
}

void CellGrid::collect(const World& world, Slot slot, Candidates& candidates) const {
  candidates.begin(slot, nearest_);
  collect_from(world, residents_[slot].range(), candidates);
  candidates.end();
}

Time CellGrid::next_crossing(const World& world, Slot slot, const Time& now, const Time& limit) {
  Resident& resident = residents_[slot];
  const Path& path = world.path(slot);
  const CellCrossing next = cells_.next_enter(path, world.radius(slot), resident.range(), duration(path.time, limit));
  resident.crossed_face = static_cast<std::uint8_t>(face_of(next.axis, next.up));
  return later(now, after(path.time, next.wait));
}

// Takes the row of cells ahead and gives up those that lie behind, seen along the velocity: giving up cells
// ahead, on the word of rounded arithmetic, could make two crossings chase each other.
void CellGrid::cross(const World& world, Slot slot, const Time& now, Candidates& candidates) {
  const CellRange exact = range_at(world, slot, now);
  const Vec3& velocity = world.path(slot).velocity;
  CellRange range = residents_[slot].range();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (velocity[axis] > 0) {
      range.low[axis] = std::clamp(exact.low[axis], range.low[axis], range.high[axis]);
    } else if (velocity[axis] < 0) {
      range.high[axis] = std::clamp(exact.high[axis], range.low[axis], range.high[axis]);
    }
  }
  const std::size_t crossed = axis_of(residents_[slot].crossed_face);
  CellRange entered = range;
  if (is_upper(residents_[slot].crossed_face)) {
    entered.low[crossed] = entered.high[crossed] = ++range.high[crossed];
  } else {
    entered.low[crossed] = entered.high[crossed] = --range.low[crossed];
  }
  move(slot, range);
  candidates.begin(slot, nearest_);
  collect_from(world, entered, candidates);
  candidates.end();
}

CellRange CellGrid::range_at(const World& world, Slot slot, const Time& now) const {
  return cells_.range_at(position_at(world.path(slot), now), world.radius(slot));
}

// Calls for the others in the cells of a range.
void CellGrid::collect_from(const World& world, const CellRange& range, Candidates& candidates) const {
  cells_.for_each_folded(range, [&](const CellIndex&, const CellIndex& cell) {
    store_.lists().for_each_line(store_.list(cell), [&](const Slot* slots, std::uint32_t count) {
      if (nearest_) {
        candidates.add_once(slots, count);
        return;
      }
      for (std::uint32_t i = 0; i < count; ++i) {
        if (!candidates.is_new(slots[i])) continue;
        candidates.mark(slots[i]);
        collect_images(world, slots[i], candidates);
      }
    });
  });
}

// All copies of a sphere that share a cell with the sphere that asks.
void CellGrid::collect_images(const World& world, Slot other, Candidates& candidates) const {
  const CellRange own = residents_[candidates.self()].range();
  const CellRange range = residents_[other].range();
  Image first;
  Image last;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const std::int32_t period = cells_.period(axis);
    if (period == 0) continue;
    // The copy lies in cells range + image * period, which must meet the cells of `own`.
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

void CellGrid::move(Slot slot, const CellRange& range) {
  const CellRange old = residents_[slot].range();
  if (old == range) return;
  residents_[slot].take(range);
  for_each_slab(old, range, [&](const CellRange& left) {
    cells_.for_each_folded(left, [&](const CellIndex&, const CellIndex& cell) { store_.erase(cell, slot); });
  });
  for_each_slab(range, old, [&](const CellRange& entered) {
    cells_.for_each_folded(entered, [&](const CellIndex&, const CellIndex& cell) { store_.insert(cell, slot); });
  });
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    left_count_ += static_cast<std::uint64_t>(std::max(0, range.low[axis] - old.low[axis]));
    left_count_ += static_cast<std::uint64_t>(std::max(0, old.high[axis] - range.high[axis]));
  }
}

std::size_t CellGrid::memory_bytes() const {
  return store_.memory_bytes() + residents_.capacity() * sizeof(Resident);
}

void CellGrid::validate(const World& world, const Time& now) const {
  HARDBALL_CHECK(residents_.size() == world.size());
  for (Slot slot = 0; slot < world.size(); ++slot) {
    const CellRange range = residents_[slot].range();
    const Vec3 position = position_at(world.path(slot), now);
    const double radius = world.radius(slot);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const double low = range.low[axis] * cells_.edge(axis);
      const double high = (range.high[axis] + 1) * cells_.edge(axis);
      HARDBALL_CHECK(range.low[axis] == cells_.first(axis) || low <= position[axis] - radius);
      HARDBALL_CHECK(range.high[axis] == cells_.last(axis) || high >= position[axis] + radius);
    }
    cells_.for_each_folded(range, [&](const CellIndex&, const CellIndex& folded) {
      std::size_t expected = 0;
      cells_.for_each_folded(range, [&](const CellIndex&, const CellIndex& same) {
        expected += same == folded ? 1U : 0U;
      });
      std::size_t found = 0;
      store_.lists().for_each(store_.list(folded), [&](Slot occupant) { found += occupant == slot ? 1U : 0U; });
      HARDBALL_CHECK(found == expected);
    });
  }
}

}  // namespace hardball
