// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/cell_grid.hpp"

#include <cmath>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

constexpr double kMostCellsPerSphere = 1000;
constexpr std::int32_t kMostCellsPerAxis = 1 << 28;

}  // namespace

void CellGrid::build(const World& world, const Time& now) {
  cells_ = Subdivision(world.box(), wanted_edge_, kMostCellsPerAxis);
  refuse_tiny_cells(world);
  CellIndex shape{};
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (world.box().is_wall(axis)) shape[axis] = cells_.last(axis) + 1;
    if (world.box().is_periodic(axis)) shape[axis] = cells_.period(axis);
  }
  store_.reset(shape, world.size());
  residents_.assign(world.size(), Resident{});
  left_count_ = 0;
  for (Slot slot = 0; slot < world.size(); ++slot) {
    residents_[slot].range = range_at(world, slot, now);
    residents_[slot].range.for_each([&](const CellIndex& cell) { insert(slot, cell); });
    set_next_crossing(world, slot, now);
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

void CellGrid::refresh(const World& world, Slot slot, const Time& now, const Image& folded) {
  const CellRange range = range_at(world, slot, now);
  if (folded == Image{}) {
    move(slot, range);
  } else {
    residents_[slot].range.for_each([&](const CellIndex& cell) { erase(slot, cell); });
    range.for_each([&](const CellIndex& cell) { insert(slot, cell); });
    residents_[slot].range = range;
  }
  set_next_crossing(world, slot, now);
}

// Takes the row of cells ahead and gives up those that lie behind, seen along the velocity: giving up cells
// ahead, on the word of rounded arithmetic, could make two crossings chase each other.
void CellGrid::enter_next_cells(const World& world, Slot slot, const Time& now) {
  const Resident& resident = residents_[slot];
  const CellRange exact = range_at(world, slot, now);
  const Vec3& velocity = world.path(slot).velocity;
  CellRange range = resident.range;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (velocity[axis] > 0) {
      range.low[axis] = std::clamp(exact.low[axis], range.low[axis], range.high[axis]);
    } else if (velocity[axis] < 0) {
      range.high[axis] = std::clamp(exact.high[axis], range.low[axis], range.high[axis]);
    }
  }
  if (resident.crosses_up) {
    ++range.high[resident.crossed_axis];
  } else {
    --range.low[resident.crossed_axis];
  }
  move(slot, range);
  set_next_crossing(world, slot, now);
}

CellRange CellGrid::range_at(const World& world, Slot slot, const Time& now) const {
  return cells_.range_at(position_at(world.path(slot), now), world.radius(slot));
}

void CellGrid::set_next_crossing(const World& world, Slot slot, const Time& now) {
  Resident& resident = residents_[slot];
  const Path& path = world.path(slot);
  const CellCrossing next = cells_.next_enter(path, world.radius(slot), resident.range);
  resident.crossing = later(now, after(path.time, next.wait));
  resident.crossed_axis = next.axis;
  resident.crosses_up = next.up;
}

void CellGrid::insert(Slot slot, const CellIndex& cell) {
  CellIndex folded = cell;
  const Image boxes = cells_.fold(folded);
  store_.insert(folded, {slot, boxes});
}

void CellGrid::erase(Slot slot, const CellIndex& cell) {
  CellIndex folded = cell;
  const Image boxes = cells_.fold(folded);
  store_.erase(folded, {slot, boxes});
}

void CellGrid::move(Slot slot, const CellRange& range) {
  const CellRange old = residents_[slot].range;
  if (old == range) return;
  residents_[slot].range = range;
  old.for_each([&](const CellIndex& cell) {
    if (!range.contains(cell)) erase(slot, cell);
  });
  range.for_each([&](const CellIndex& cell) {
    if (!old.contains(cell)) insert(slot, cell);
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
    const CellRange& range = residents_[slot].range;
    const Vec3 position = position_at(world.path(slot), now);
    const double radius = world.radius(slot);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const double low = range.low[axis] * cells_.edge(axis);
      const double high = (range.high[axis] + 1) * cells_.edge(axis);
      HARDBALL_CHECK(range.low[axis] == cells_.first(axis) || low <= position[axis] - radius);
      HARDBALL_CHECK(range.high[axis] == cells_.last(axis) || high >= position[axis] + radius);
    }
    HARDBALL_CHECK(residents_[slot].crossing >= now);
    range.for_each([&](const CellIndex& cell) {
      CellIndex folded = cell;
      const Occupant self{slot, cells_.fold(folded)};
      int found = 0;
      store_.for_each(folded, [&](const Occupant& occupant) { found += occupant == self; });
      HARDBALL_CHECK(found == 1);
    });
  }
}

}  // namespace hardball
