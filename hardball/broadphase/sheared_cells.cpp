// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/sheared_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

// With more cells per sphere, lists would take more memory than the spheres.
constexpr double kMostCellsPerSphere = 2;
constexpr double kMostCellsAlways = 4096;

// Along each axis, a sphere touches at most so many cells; its region may have two more rows.
constexpr int kMostTouched = 6;
static_assert(kMostTouched + 2 <= ShearedRegion::kMostRows);

bool are_good(const Subdivision& cells, const World& world, double radius) {
  double count = 1;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!cells.has_nearest_images(axis, radius)) return false;
    if (cells.most_touched(axis, radius) > kMostTouched) return false;
    count *= std::max(cells.shape()[axis], 1);
  }
  return count <= kMostCellsPerSphere * static_cast<double>(world.size()) + kMostCellsAlways;
}

// The radius for which cells are made.
double largest_radius(const World& world) {
  return world.room_to_grow() * world.largest_bounding_radius();
}

}  // namespace

std::optional<double> ShearedCells::allowed_edge(const World& world, double wanted) {
  const double radius = largest_radius(world);
  const auto is_good = [&](double edge) { return are_good(Subdivision(world.box(), edge), world, radius); };
  if (is_good(wanted)) return wanted;
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (world.box().is_periodic(axis)) shortest = std::min(shortest, world.box().size()[axis]);
  }
  constexpr int kFewest = 7;
  constexpr int kMost = 64;
  constexpr double kRoundedDown = 1 - 1e-9;
  for (int cells = kFewest; cells <= kMost; ++cells) {
    const double edge = shortest / cells * kRoundedDown;
    if (is_good(edge)) return edge;
  }
  return std::nullopt;
}

void ShearedCells::build(const World& world, const Time& now, CompactPaths& copies) {
  const std::optional<double> edge = allowed_edge(world, wanted_edge_);
  HARDBALL_CHECK(edge.has_value());
  cells_ = Subdivision(world.box(), *edge);
  rows_ = SlidingRows(world.box(), cells_.period(1), now);
  largest_built_ = largest_radius(world);
  table_ = CellTable(cells_.shape(), world.size());
  lists_.reset(table_.size());
  Vec3 farthest;
  double most_moved = std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double touched = cells_.most_touched(axis, largest_built_);
    farthest[axis] = (2 * touched + 1) * cells_.edge(axis);
    if (!world.box().is_periodic(axis)) continue;
    most_moved = std::min(most_moved, (cells_.period(axis) / 2.0 - (2 * touched - 1)) * cells_.edge(axis));
  }
  const double apart = std::max(length(farthest), CompactPaths::least_farthest(world.box()));
  copies.reset(world, apart, std::min(apart, most_moved), now);
  reset(lines_, world);
  regions_.assign(world.size(), {});
  left_count_ = 0;
  for (Slot slot = 0; slot < world.size(); ++slot) replace(slot, region_at(world, slot, now));
}

void ShearedCells::insert(const World& world, Slot slot, const Time& now, const CompactPaths&) {
  reset(lines_, world, slot);
  if (slot == regions_.size()) append_sparingly(regions_, {});
  regions_[slot] = {};
  replace(slot, region_at(world, slot, now));
}

void ShearedCells::erase(Slot slot) {
  replace(slot, {});
}

void ShearedCells::move(Slot from, Slot to) {
  lines_[to] = lines_[from];
  const ShearedRegion region = regions_[from];
  replace(from, {});
  regions_[to] = {};
  replace(to, region);
}

ShearedRegion::Cells ShearedCells::cells_in_row(std::int32_t row, double x, double radius,
                                                const Time& now) const {
  const auto [first, last] = cells_.range_along(0, x - rows_.displacement(row, now), radius);
  return {first, last};
}

ShearedRegion ShearedCells::region_at(const World& world, Slot slot, const Time& now) const {
  const Vec3 position = world.unfolded_position(slot, now);
  const double radius = world.bounding_radius(slot);
  const auto [lowest, highest] = cells_.range_along(1, position.y, radius);
  HARDBALL_CHECK(static_cast<std::size_t>(highest - lowest) < ShearedRegion::kMostRows);
  ShearedRegion region;
  region.lowest = lowest;
  region.count = static_cast<std::uint8_t>(highest - lowest + 1);
  std::tie(region.depths.first, region.depths.last) = cells_.range_along(2, position.z, radius);
  for (std::int32_t row = lowest; row <= highest; ++row)
    region.in_row(row) = cells_in_row(row, position.x, radius, now);
  return region;
}

// Gives a sphere another region, counted along the same path.
void ShearedCells::replace(Slot slot, const ShearedRegion& region) {
  const ShearedRegion old = regions_[slot];
  regions_[slot] = region;
  if (old == region) return;
  for_each_cell(old, [&](const CellIndex& cell, const CellIndex& folded) {
    if (region.contains(cell)) return;
    lists_.erase(table_.list(folded), slot);
    ++left_count_;
  });
  for_each_cell(region, [&](const CellIndex& cell, const CellIndex& folded) {
    if (!old.contains(cell)) lists_.insert(table_.list(folded), slot);
  });
}

void ShearedCells::refresh(const World& world, Slot slot, const Time& now, const Image& folded) {
  rows_.keep_near(now);
  // Cells are counted along the new path.
  if (!folded.is_zero()) replace(slot, {});
  replace(slot, region_at(world, slot, now));
}

bool ShearedCells::keeps(const World& world, Slot slot, const Time& now, const CompactPaths&) const {
  const ShearedRegion exact = region_at(world, slot, now);
  for (std::int32_t row = exact.lowest; row <= exact.highest(); ++row) {
    const CellRange range = exact.cells_in(row);
    if (!regions_[slot].contains(range.low) || !regions_[slot].contains(range.high)) return false;
  }
  return true;
}

// Whether a sphere touches a cell folded into the box.
bool ShearedCells::touches(Slot slot, const CellIndex& folded) const {
  bool is_touched = false;
  for_each_cell(regions_[slot],
                [&](const CellIndex&, const CellIndex& cell) { is_touched |= is_same(cell, folded); });
  return is_touched;
}

void ShearedCells::collect_cell(const CellIndex& folded, Candidates& candidates) const {
  lists_.for_each_line(table_.list(folded), [&](const SlotLists::LineOfSlots& slots, std::uint32_t count) {
    if (!table_.is_shared()) return candidates.add(slots, count);
    candidates.add_if(slots, count, [&](Slot other) { return touches(other, folded); });
  });
}

void ShearedCells::collect(const World&, Slot slot, Candidates& candidates) const {
  candidates.begin(slot, true);
  for_each_cell(regions_[slot],
                [&](const CellIndex&, const CellIndex& folded) { collect_cell(folded, candidates); });
  candidates.end();
}

double ShearedCells::next_crossing(const World& world, Slot slot, const Time& now, const CompactPaths&) {
  ShearedRegion& region = regions_[slot];
  const Vec3 position = world.unfolded_position(slot, now);
  const Vec3 velocity = world.path(slot).velocity;
  const double radius = world.bounding_radius(slot);
  double least = std::numeric_limits<double>::infinity();
  const auto consider = [&](std::size_t axis, double speed, double coordinate,
                            const ShearedRegion::Cells& cells, std::int32_t row) {
    const bool up = speed > 0;
    const std::int32_t plane = up ? cells.last + 1 : cells.first;
    if (speed == 0 || plane == (up ? cells_.last(axis) + 1 : cells_.first(axis))) return;
    const double beyond = cells_.beyond_face(axis, plane, coordinate);
    const double ahead = (up ? -beyond : beyond) - cells_.reach(axis, radius);
    const double wait = std::max(0.0, ahead) / std::fabs(speed);
    if (!(wait < least)) return;
    least = wait;
    region.crossed_row = static_cast<std::uint8_t>(row - region.lowest);
    region.crossed_face = static_cast<std::uint8_t>(face_of(axis, up));
  };
  for (std::int32_t row = region.lowest; row <= region.highest(); ++row) {
    consider(0, velocity.x - rows_.speed(row), position.x - rows_.displacement(row, now), region.in_row(row),
             row);
  }
  consider(1, velocity.y, position.y, {region.lowest, region.highest()}, region.lowest);
  consider(2, velocity.z, position.z, region.depths, region.lowest);
  return rounded_down(now) + least;
}

// Enters the row of cells ahead and releases those behind, as seen along the velocity: releasing cells ahead
// because of rounding could make two crossings repeat each other without end.
void ShearedCells::cross(const World& world, Slot slot, const Time& now, const CompactPaths&,
                         Candidates& candidates) {
  rows_.keep_near(now);
  const ShearedRegion old = regions_[slot];
  const Vec3 position = world.unfolded_position(slot, now);
  const Vec3 velocity = world.path(slot).velocity;
  const double radius = world.bounding_radius(slot);
  const std::size_t crossed = axis_of(old.crossed_face);
  const bool up = is_upper(old.crossed_face);
  // Of the cells from first to last those that are not behind, and the one ahead if it is entered.
  const auto next = [&](const ShearedRegion::Cells& cells, double speed,
                        const std::pair<std::int32_t, std::int32_t>& exact, bool is_crossed) {
    ShearedRegion::Cells kept = cells;
    if (speed > 0) kept.first = std::clamp(exact.first, cells.first, cells.last);
    if (speed < 0) kept.last = std::clamp(exact.second, cells.first, cells.last);
    if (!is_crossed) return kept;
    const std::int32_t ahead = up ? kept.last + 1 : kept.first - 1;
    // Where times do not resolve the motion, crossings follow one another and the sphere stays where it is:
    // its region must not grow.
    if (ahead > exact.second + 2 || ahead < exact.first - 2) return kept;
    (up ? kept.last : kept.first) = ahead;
    return kept;
  };
  ShearedRegion region;
  const ShearedRegion::Cells rows =
      next({old.lowest, old.highest()}, velocity.y, cells_.range_along(1, position.y, radius), crossed == 1);
  HARDBALL_CHECK(static_cast<std::size_t>(rows.last - rows.first) < ShearedRegion::kMostRows);
  region.lowest = rows.first;
  region.count = static_cast<std::uint8_t>(rows.last - rows.first + 1);
  region.depths = next(old.depths, velocity.z, cells_.range_along(2, position.z, radius), crossed == 2);
  for (std::int32_t row = rows.first; row <= rows.last; ++row) {
    const ShearedRegion::Cells exact = cells_in_row(row, position.x, radius, now);
    const bool is_crossed = crossed == 0 && row == old.lowest + old.crossed_row;
    region.in_row(row) = old.has_row(row) ? next(old.in_row(row), velocity.x - rows_.speed(row),
                                                 {exact.first, exact.last}, is_crossed)
                                          : exact;
  }
  candidates.begin(slot, true);
  for_each_cell(region, [&](const CellIndex& cell, const CellIndex& folded) {
    if (!old.contains(cell)) collect_cell(folded, candidates);
  });
  candidates.end();
  replace(slot, region);
}

bool ShearedCells::are_candidates(Slot a, Slot b) const {
  bool share_cell = false;
  for_each_cell(regions_[a],
                [&](const CellIndex&, const CellIndex& cell) { share_cell |= touches(b, cell); });
  return share_cell;
}

std::size_t ShearedCells::memory_bytes() const {
  return lists_.memory_bytes() + lines_.capacity() * sizeof(lines_[0]) +
         regions_.capacity() * sizeof(regions_[0]);
}

void ShearedCells::validate(const World& world, const Time& now, const CompactPaths&) const {
  HARDBALL_CHECK(lines_.size() >= world.size() && regions_.size() >= world.size());
  for (Slot slot = 0; slot < world.size(); ++slot) {
    const ShearedRegion& region = regions_[slot];
    const Vec3 position = world.unfolded_position(slot, now);
    const double radius = world.bounding_radius(slot);
    const auto check = [&](std::size_t axis, const ShearedRegion::Cells& cells, double seen) {
      HARDBALL_CHECK(cells.first == cells_.first(axis) || cells.first * cells_.edge(axis) <= seen - radius);
      HARDBALL_CHECK(cells.last == cells_.last(axis) ||
                     (cells.last + 1) * cells_.edge(axis) >= seen + radius);
    };
    check(1, {region.lowest, region.highest()}, position.y);
    check(2, region.depths, position.z);
    for (std::int32_t row = region.lowest; row <= region.highest(); ++row)
      check(0, region.in_row(row), position.x - rows_.displacement(row, now));
    for_each_list(region, [&](std::uint32_t list) {
      std::size_t expected = 0;
      for_each_list(region, [&](std::uint32_t same) { expected += same == list ? 1U : 0U; });
      std::size_t found = 0;
      lists_.for_each(list, [&](Slot occupant) { found += occupant == slot ? 1U : 0U; });
      HARDBALL_CHECK(found == expected);
    });
  }
}

}  // namespace hardball
