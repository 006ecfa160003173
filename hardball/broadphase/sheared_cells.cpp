// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/sheared_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

// With more cells per sphere, lists would take more memory than the spheres.
constexpr double kMostCellsPerSphere = 2;
constexpr double kMostCellsAlways = 4096;

// Along each axis, a sphere touches at most so many cells.
constexpr int kMostTouched = 12;

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

bool moves_up(double velocity) {
  return velocity > 0;
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
  largest_built_ = largest_radius(world);
  table_ = CellTable(cells_.shape(), world.size());
  guests_from_ = static_cast<std::uint32_t>(table_.size());
  lists_.reset(2 * table_.size());
  guests_in_row_.assign(static_cast<std::size_t>(cells_.period(1)), 0);
  const double boxes = std::floor(world.box().images().displacement(now).high / world.box().size().x);
  HARDBALL_CHECK(std::fabs(boxes) <= Box::kMaxBoxesBeyond);
  boxes_slid_ = static_cast<std::int32_t>(boxes);
  Vec3 farthest;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    farthest[axis] = (2 * cells_.most_touched(axis, largest_built_) + 1) * cells_.edge(axis);
  }
  copies.reset(world, length(farthest), now);
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

// A point as seen from a layer: in the coordinates of its cells.
Vec3 ShearedCells::in_layer(const World& world, const Vec3& position, std::int32_t layer,
                            const Time& now) const {
  if (layer == 0) return position;
  const double slid = world.box().images().shift(-layer * boxes_slid_, layer, now);
  return {position.x - slid, position.y, position.z};
}

Vec3 ShearedCells::velocity_in_layer(const World& world, Slot slot, std::int32_t layer) const {
  Vec3 velocity = world.path(slot).velocity;
  if (layer != 0) velocity.x -= layer * world.box().images().speed();
  return velocity;
}

std::int32_t ShearedCells::layer_of(std::int32_t row) const {
  const std::int32_t rows = cells_.period(1);
  return row >= 0 ? row / rows : -((rows - 1 - row) / rows);
}

// A region with these rows; range_in(layer) gives its cells in a layer, whatever rows it has.
template <class RangeIn>
ShearedRegion ShearedCells::divided(std::int32_t lowest_row, std::int32_t highest_row,
                                    RangeIn&& range_in) const {
  ShearedRegion region;
  const std::int32_t rows = cells_.period(1);
  const std::int32_t top = layer_of(highest_row);
  HARDBALL_CHECK(top - layer_of(lowest_row) < 2);
  for (std::int32_t layer = layer_of(lowest_row); layer <= top; ++layer) {
    ShearedRegion::Part part{layer, range_in(layer)};
    part.range.low[1] = std::max(lowest_row, layer * rows);
    part.range.high[1] = std::min(highest_row, layer * rows + (rows - 1));
    region.parts[region.count++] = part;
  }
  return region;
}

ShearedRegion ShearedCells::region_at(const World& world, Slot slot, const Time& now) const {
  const Vec3 position = world.unfolded_position(slot, now);
  const double radius = world.bounding_radius(slot);
  const CellRange range = cells_.range_at(position, radius);
  return divided(range.low[1], range.high[1], [&](std::int32_t layer) {
    return layer == 0 ? range : cells_.range_at(in_layer(world, position, layer, now), radius);
  });
}

// Gives a sphere another region, counted along the same path.
void ShearedCells::replace(Slot slot, const ShearedRegion& region) {
  const ShearedRegion old = regions_[slot];
  if (old == region) {
    regions_[slot] = region;
    return;
  }
  const auto for_each_beyond = [this](const ShearedRegion& one, const ShearedRegion& other, auto&& visit) {
    for (std::size_t i = 0; i < one.count; ++i) {
      const ShearedRegion::Part& part = one.parts[i];
      const ShearedRegion::Part* const same = other.part_in(part.layer);
      if (same != nullptr && same->range == part.range) continue;
      const std::uint32_t first = first_list(part);
      cells_.for_each_folded(part.range, [&](const CellIndex& cell, const CellIndex& folded) {
        if (same != nullptr && same->range.contains(cell)) return;
        visit(first + table_.list(folded), part.layer == 0 ? 0U : 1U, folded);
      });
    }
  };
  for_each_beyond(old, region, [&](std::uint32_t list, std::uint32_t guests, const CellIndex& folded) {
    lists_.erase(list, slot);
    guests_in_row_[static_cast<std::size_t>(folded[1])] -= guests;
    ++left_count_;
  });
  for_each_beyond(region, old, [&](std::uint32_t list, std::uint32_t guests, const CellIndex& folded) {
    lists_.insert(list, slot);
    guests_in_row_[static_cast<std::size_t>(folded[1])] += guests;
  });
  regions_[slot] = region;
}

void ShearedCells::refresh(const World& world, Slot slot, const Time& now, const Image& folded) {
  // Cells are counted along the new path.
  if (!folded.is_zero()) replace(slot, {});
  replace(slot, region_at(world, slot, now));
}

bool ShearedCells::keeps(const World& world, Slot slot, const Time& now, const CompactPaths&) const {
  const ShearedRegion exact = region_at(world, slot, now);
  for (std::size_t i = 0; i < exact.count; ++i) {
    const auto& [layer, range] = exact.parts[i];
    if (!regions_[slot].contains(layer, range.low) || !regions_[slot].contains(layer, range.high))
      return false;
  }
  return true;
}

// Whether a sphere touches a cell folded into the box.
bool ShearedCells::touches(Slot slot, const CellIndex& folded) const {
  const ShearedRegion& region = regions_[slot];
  const auto is_between = [&](std::size_t axis, const CellRange& range) {
    const std::int32_t above = folded[axis] - range.low[axis];
    const std::int32_t period = cells_.period(axis);
    return (period == 0 ? above : cells_.folded(axis, above)) <= range.high[axis] - range.low[axis] &&
           (period > 0 || above >= 0);
  };
  for (std::size_t i = 0; i < region.count; ++i) {
    const CellRange& range = region.parts[i].range;
    if (is_between(0, range) && is_between(1, range) && is_between(2, range)) return true;
  }
  return false;
}

// Collects the spheres in a cell for a sphere that touches it in a layer. All with guests are treated as
// meeting across a face: what bounds need to know of how far a sphere moves, cells that slide do not tell.
void ShearedCells::collect_cell(std::int32_t layer, const CellIndex& folded, Candidates& candidates) const {
  const std::uint32_t list = table_.list(folded);
  const auto is_candidate = [&](Slot other) {
    return other != candidates.self() && (!table_.is_shared() || touches(other, folded));
  };
  const auto add_across = [&](Slot other) {
    if (is_candidate(other)) candidates.add_across(other);
  };
  if (guests_in_row_[static_cast<std::size_t>(folded[1])] > 0)
    lists_.for_each(guests_from_ + list, add_across);
  if (layer != 0) return lists_.for_each(list, add_across);
  lists_.for_each_line(list, [&](const SlotLists::LineOfSlots& slots, std::uint32_t count) {
    if (!table_.is_shared()) return candidates.add(slots, count);
    candidates.add_if(slots, count, is_candidate);
  });
}

void ShearedCells::collect(const World&, Slot slot, Candidates& candidates) const {
  candidates.begin(slot, true);
  const ShearedRegion& region = regions_[slot];
  for (std::size_t i = 0; i < region.count; ++i) {
    cells_.for_each_folded(region.parts[i].range, [&](const CellIndex&, const CellIndex& folded) {
      collect_cell(region.parts[i].layer, folded, candidates);
    });
  }
  candidates.end();
}

void ShearedCells::collect_overlapping(const World& world, Slot slot, Candidates& candidates) const {
  collect(world, slot, candidates);
  for (const Slot other : candidates.across()) candidates.add(other);
  candidates.end();
}

double ShearedCells::next_crossing(const World& world, Slot slot, const Time& now, const CompactPaths&) {
  ShearedRegion& region = regions_[slot];
  const Vec3 position = world.unfolded_position(slot, now);
  const double radius = world.bounding_radius(slot);
  double least = std::numeric_limits<double>::infinity();
  for (std::uint8_t i = 0; i < region.count; ++i) {
    const ShearedRegion::Part& part = region.parts[i];
    const Vec3 seen = in_layer(world, position, part.layer, now);
    const Vec3 velocity = velocity_in_layer(world, slot, part.layer);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (i > 0 && axis > 0) continue;  // as in the first part
      const bool up = moves_up(velocity[axis]);
      const std::int32_t low = axis == 1 ? region.lowest_row() : part.range.low[axis];
      const std::int32_t high = axis == 1 ? region.highest_row() : part.range.high[axis];
      const std::int32_t plane = up ? high + 1 : low;
      if (velocity[axis] == 0 || plane == (up ? cells_.last(axis) + 1 : cells_.first(axis))) continue;
      const double beyond = cells_.beyond_face(axis, plane, seen[axis]);
      const double ahead = (up ? -beyond : beyond) - cells_.reach(axis, radius);
      const double wait = std::max(0.0, ahead) / std::fabs(velocity[axis]);
      if (!(wait < least)) continue;
      least = wait;
      region.crossed_part = i;
      region.crossed_face = static_cast<std::uint8_t>(face_of(axis, up));
    }
  }
  return rounded_down(now) + least;
}

// Enters the row of cells ahead and releases those behind, as seen along the velocity: releasing cells ahead
// because of rounding could make two crossings repeat each other without end.
void ShearedCells::cross(const World& world, Slot slot, const Time& now, const CompactPaths&,
                         Candidates& candidates) {
  const ShearedRegion old = regions_[slot];
  const Vec3 position = world.unfolded_position(slot, now);
  const double radius = world.bounding_radius(slot);
  const std::size_t crossed = axis_of(old.crossed_face);
  const bool up = is_upper(old.crossed_face);
  const CellRange at_home = cells_.range_at(position, radius);
  // The indices along an axis from `low` to `high`, without those behind, and with the one ahead if it is
  // this axis that is crossed.
  const auto next = [&](std::size_t axis, double velocity, std::int32_t low, std::int32_t high,
                        const CellRange& exact, bool is_crossed) {
    std::pair<std::int32_t, std::int32_t> kept{velocity > 0 ? std::clamp(exact.low[axis], low, high) : low,
                                               velocity < 0 ? std::clamp(exact.high[axis], low, high) : high};
    if (!is_crossed) return kept;
    const std::int32_t ahead = up ? kept.second + 1 : kept.first - 1;
    // Where times do not resolve the motion, crossings follow one another and the sphere stays where it is:
    // its region must not grow.
    if (ahead > exact.high[axis] + 2 || ahead < exact.low[axis] - 2) return kept;
    (up ? kept.second : kept.first) = ahead;
    return kept;
  };
  const Vec3 velocity = world.path(slot).velocity;
  const auto [lowest, highest] =
      next(1, velocity.y, old.lowest_row(), old.highest_row(), at_home, crossed == 1);
  const CellRange& any = old.parts[0].range;
  const std::pair<std::int32_t, std::int32_t> depths =
      next(2, velocity.z, any.low[2], any.high[2], at_home, crossed == 2);
  const ShearedRegion region = divided(lowest, highest, [&](std::int32_t layer) {
    CellRange range = layer == 0 ? at_home : cells_.range_at(in_layer(world, position, layer, now), radius);
    if (const ShearedRegion::Part* const part = old.part_in(layer)) {
      const bool is_crossed = crossed == 0 && part == &old.parts[old.crossed_part];
      const auto [left, right] = next(0, velocity_in_layer(world, slot, layer).x, part->range.low[0],
                                      part->range.high[0], range, is_crossed);
      range.low[0] = left;
      range.high[0] = right;
    }
    range.low[2] = depths.first;
    range.high[2] = depths.second;
    return range;
  });
  candidates.begin(slot, true);
  for (std::size_t i = 0; i < region.count; ++i) {
    const ShearedRegion::Part& part = region.parts[i];
    cells_.for_each_folded(part.range, [&](const CellIndex& cell, const CellIndex& folded) {
      if (!old.contains(part.layer, cell)) collect_cell(part.layer, folded, candidates);
    });
  }
  candidates.end();
  replace(slot, region);
}

bool ShearedCells::are_candidates(Slot a, Slot b) const {
  bool share_cell = false;
  for_each_list(regions_[a], [&](std::uint32_t one) {
    for_each_list(regions_[b],
                  [&](std::uint32_t other) { share_cell |= one % guests_from_ == other % guests_from_; });
  });
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
    const auto check = [&](std::size_t axis, std::int32_t low, std::int32_t high, const Vec3& seen) {
      HARDBALL_CHECK(low == cells_.first(axis) || low * cells_.edge(axis) <= seen[axis] - radius);
      HARDBALL_CHECK(high == cells_.last(axis) || (high + 1) * cells_.edge(axis) >= seen[axis] + radius);
    };
    check(1, region.lowest_row(), region.highest_row(), position);
    for (std::size_t i = 0; i < region.count; ++i) {
      const ShearedRegion::Part& part = region.parts[i];
      const Vec3 seen = in_layer(world, position, part.layer, now);
      check(0, part.range.low[0], part.range.high[0], seen);
      check(2, part.range.low[2], part.range.high[2], seen);
    }
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
