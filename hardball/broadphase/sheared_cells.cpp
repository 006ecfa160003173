// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/sheared_cells.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <tuple>
#include <type_traits>
#include <utility>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/inlining.hpp"

namespace hardball {
namespace {

// With more cells per sphere, lists would take more memory than the spheres.
constexpr double kMostCellsPerSphere = 2;
constexpr double kMostCellsAlways = 4096;

// Along each axis, a sphere touches at most this many cells; its region may have two more rows.
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

// Calls visit(direction) for each direction of a ShearedBlock, which is a constant.
template <class Visit>
HARDBALL_ALWAYS_INLINE void for_each_direction(Visit&& visit) {
  static_assert(ShearedBlock::kDirections == 4);
  visit(std::integral_constant<std::size_t, 0>());
  visit(std::integral_constant<std::size_t, 1>());
  visit(std::integral_constant<std::size_t, 2>());
  visit(std::integral_constant<std::size_t, 3>());
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
  constexpr int kFewest = 7;
  constexpr int kMost = 64;
  constexpr double kRoundedDown = 1 - 1e-9;
  for (int cells = kFewest; cells <= kMost; ++cells) {
    const double edge = world.box().shortest_period() / cells * kRoundedDown;
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
  table_ = CellTable(cells_, world.size());
  lists_.reset(table_.size());
  blocks_ = true;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    blocks_ &= cells_.most_touched(axis, largest_built_) == 2;
    room_[axis] = {std::numeric_limits<double>::infinity(), cells_.edge(axis), 0, cells_.edge(axis)};
  }
  Vec3 farthest;
  double most_moved = std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double touched = cells_.most_touched(axis, largest_built_);
    const double most_cells = blocks_ ? touched : touched + 1;
    farthest[axis] = (2 * most_cells - 1) * cells_.edge(axis);
    if (!world.box().is_periodic(axis)) continue;
    most_moved = std::min(most_moved, (cells_.period(axis) / 2.0 - (2 * touched - 1)) * cells_.edge(axis));
  }
  const double apart = std::max(length(farthest), CompactPaths::least_farthest(world.box()));
  copies.reset(world, apart, std::min(apart, most_moved), now);
  reset(lines_, world);
  regions_.assign(blocks_ ? 0 : world.size(), {});
  left_count_ = 0;
  for (Slot slot = 0; slot < world.size(); ++slot) enter(world, slot, now);
}

// Gives a region to a sphere that has none.
void ShearedCells::enter(const World& world, Slot slot, const Time& now) {
  if (blocks_) {
    stored_region(slot) = block_at(world, slot, now);
  } else {
    regions_[slot] = region_at(world, slot, now);
  }
  for_each_list(slot, [&](std::uint32_t list) { lists_.insert(list, slot); });
}

void ShearedCells::leave(Slot slot) {
  for_each_list(slot, [&](std::uint32_t list) { lists_.erase(list, slot); });
  stored_region(slot) = {};
  if (!blocks_) regions_[slot] = {};
}

void ShearedCells::insert(const World& world, Slot slot, const Time& now, const CompactPaths&) {
  reset(lines_, world, slot);
  if (!blocks_ && slot == regions_.size()) append_sparingly(regions_, {});
  enter(world, slot, now);
}

void ShearedCells::erase(Slot slot) {
  leave(slot);
}

void ShearedCells::move(Slot from, Slot to) {
  lines_[to] = lines_[from];
  if (!blocks_) regions_[to] = regions_[from];
  leave(from);
  for_each_list(to, [&](std::uint32_t list) { lists_.insert(list, to); });
}

void ShearedCells::update(const World& world, Slot slot, const Time& now, const Image& folded) {
  rows_.keep_near(now);
  if (!folded.is_zero()) {  // cells are counted along the new path
    leave(slot);
    enter(world, slot, now);
  } else if (blocks_) {
    refresh_block(world, slot, now);
  } else {
    replace(slot, region_at(world, slot, now));
  }
}

bool ShearedCells::keeps(const World& world, Slot slot, const Time& now, const CompactPaths&) const {
  bool is_inside = true;
  if (blocks_) {
    const ShearedBlock exact = block_at(world, slot, now);
    CellBlock::for_each_cell(exact.cells,
                             [&](std::uint32_t cell) { is_inside &= is_in(slot, exact.index(cell)); });
  } else {
    for_each_cell_of(region_at(world, slot, now),
                     [&](const CellIndex& cell, const CellIndex&) { is_inside &= is_in(slot, cell); });
  }
  return is_inside;
}

double ShearedCells::next_crossing(const World& world, Slot slot, const Time& now, const CompactPaths&) {
  return blocks_ ? next_crossing_of_block(world, slot, now) : next_crossing_of_region(world, slot, now);
}

// Enters the cells ahead and releases those behind, as seen along the velocity: releasing cells ahead because
// of rounding could make two crossings repeat each other without end.
void ShearedCells::cross(const World& world, Slot slot, const Time& now, const CompactPaths&,
                         Candidates& candidates) {
  rows_.keep_near(now);
  candidates.begin(slot, true);
  if (blocks_) {
    cross_block(world, slot, now, candidates);
  } else {
    cross_region(world, slot, now, candidates);
  }
  candidates.end();
}

void ShearedCells::collect(const World&, Slot slot, Candidates& candidates) const {
  candidates.begin(slot, true);
  if (blocks_ && !table_.is_shared()) {
    for_each_list(slot, [&](std::uint32_t list) { collect_list(list, candidates); });
  } else {
    for_each_cell(slot, [&](const CellIndex&, const CellIndex& folded) { collect_cell(folded, candidates); });
  }
  candidates.end();
}

// Collects the spheres that touch a cell folded into the box.
void ShearedCells::collect_cell(const CellIndex& folded, Candidates& candidates) const {
  const std::uint32_t list = table_.list(folded);
  if (!table_.is_shared()) return collect_list(list, candidates);
  lists_.for_each_line(list, [&](const SlotLists::LineOfSlots& slots, std::uint32_t count) {
    candidates.add_if(slots, count, [&](Slot other) { return touches(other, folded); });
  });
}

// Whether a sphere is in a cell counted along its path.
bool ShearedCells::is_in(Slot slot, const CellIndex& index) const {
  bool is_found = false;
  for_each_cell(slot, [&](const CellIndex& cell, const CellIndex&) { is_found |= is_same(cell, index); });
  return is_found;
}

// Whether it is in a cell folded into the box.
bool ShearedCells::touches(Slot slot, const CellIndex& folded) const {
  bool is_touched = false;
  for_each_cell(slot, [&](const CellIndex&, const CellIndex& cell) { is_touched |= is_same(cell, folded); });
  return is_touched;
}

bool ShearedCells::are_candidates(Slot a, Slot b) const {
  bool share_cell = false;
  for_each_cell(a, [&](const CellIndex&, const CellIndex& cell) { share_cell |= touches(b, cell); });
  return share_cell;
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
  for_each_cell_of(old, [&](const CellIndex& cell, const CellIndex& folded) {
    if (region.contains(cell)) return;
    lists_.erase(table_.list(folded), slot);
    ++left_count_;
  });
  for_each_cell_of(region, [&](const CellIndex& cell, const CellIndex& folded) {
    if (!old.contains(cell)) lists_.insert(table_.list(folded), slot);
  });
}

double ShearedCells::next_crossing_of_region(const World& world, Slot slot, const Time& now) {
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

void ShearedCells::cross_region(const World& world, Slot slot, const Time& now, Candidates& candidates) {
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
  for_each_cell_of(region, [&](const CellIndex& cell, const CellIndex& folded) {
    if (!old.contains(cell)) collect_cell(folded, candidates);
  });
  replace(slot, region);
}

ShearedBlock ShearedCells::block_at(const World& world, Slot slot, const Time& now) const {
  const Vec3 position = world.unfolded_position(slot, now);
  const double radius = world.bounding_radius(slot);
  const auto [lower_row, upper_row] = cells_.range_along(1, position.y, radius);
  const auto [front, back] = cells_.range_along(2, position.z, radius);
  const ShearedBlock::Halves& depth = ShearedBlock::kHalves[ShearedBlock::kDepth];
  const std::uint32_t depths = back > front ? depth.both() : depth.lower;
  ShearedBlock block;
  block.low[ShearedBlock::kAcrossRows] = lower_row;
  block.low[ShearedBlock::kDepth] = front;
  std::uint32_t cells = reach_row(block, 0, position.x, radius, now) & depths;
  if (upper_row > lower_row) cells |= reach_row(block, 1, position.x, radius, now) & depths;
  block.cells = static_cast<std::uint8_t>(cells);
  return block;
}

// Places the cells of the lower or upper row where a sphere touches them; returns those that it touches, at
// any depth.
std::uint32_t ShearedCells::reach_row(ShearedBlock& block, std::uint32_t row, double x, double radius,
                                      const Time& now) const {
  const std::int32_t number = block.low[ShearedBlock::kAcrossRows] + static_cast<std::int32_t>(row);
  const auto [first, last] = cells_in_row(number, x, radius, now);
  const ShearedBlock::Halves& along = ShearedBlock::kHalves[row];
  block.low[row] = first;
  return last > first ? along.both() : along.lower;
}

HARDBALL_ALWAYS_INLINE ShearedCells::SeenFromBlock ShearedCells::see(const World& world, Slot slot,
                                                                     const Time& now) const {
  const auto& low = stored_region(slot).low;
  const Vec3 position = world.unfolded_position(slot, now);
  const Vec3 velocity = world.path(slot).velocity;
  const std::int32_t row = low[ShearedBlock::kAcrossRows];
  const auto [of_lower, of_upper] = rows_.displacements(row, now);
  const std::array<double, ShearedBlock::kDirections> coordinates{
      position.x - of_lower, position.x - of_upper, position.y, position.z};
  SeenFromBlock seen{
      {}, {velocity.x - rows_.speed(row), velocity.x - rows_.speed(row + 1), velocity.y, velocity.z}};
  for_each_direction([&](auto direction) {
    seen.beyond[direction] =
        cells_.beyond_face(ShearedBlock::kAxis[direction], low[direction] + 1, coordinates[direction]);
  });
  return seen;
}

// Leaves all cells of the block but these.
void ShearedCells::keep(Slot slot, std::uint32_t cells) {
  ShearedBlock& block = stored_region(slot);
  const std::uint32_t left = block.cells & ~cells;
  if (left == 0) return;
  block.for_each_list(left, table_, [&](std::uint32_t list) { lists_.erase(list, slot); });
  block.cells = static_cast<std::uint8_t>(cells);
  left_count_ += static_cast<std::uint64_t>(std::popcount(left));
}

void ShearedCells::refresh_block(const World& world, Slot slot, const Time& now) {
  const SeenFromBlock seen = see(world, slot, now);
  const double radius = world.bounding_radius(slot);
  std::uint32_t cells = stored_region(slot).cells;
  for_each_direction([&](auto direction) {
    constexpr ShearedBlock::Halves kHalf = ShearedBlock::kHalves[direction];
    const double reach = cells_.reach(ShearedBlock::kAxis[direction], radius);
    const double beyond = seen.beyond[direction];
    cells = kHalf.without(kHalf.lower_if(beyond >= reach) | kHalf.upper_if(-beyond >= reach), cells);
  });
  keep(slot, cells);
}

double ShearedCells::next_crossing_of_block(const World& world, Slot slot, const Time& now) {
  ShearedBlock& block = stored_region(slot);
  const SeenFromBlock seen = see(world, slot, now);
  const double radius = world.bounding_radius(slot);
  const std::uint32_t cells = block.cells;
  std::array<double, ShearedBlock::kDirections> waits;
  std::array<std::uint32_t, ShearedBlock::kDirections> downwards;
  for_each_direction([&](auto direction) {
    constexpr std::size_t kAxis = ShearedBlock::kAxis[direction];
    constexpr ShearedBlock::Halves kHalf = ShearedBlock::kHalves[direction];
    const double speed = seen.velocity[direction];
    downwards[direction] = std::signbit(speed) ? 1 : 0;
    const std::uint32_t ahead = kHalf.half(downwards[direction]);
    // Which of the cells along this direction the sphere is in.
    const std::size_t kinds =
        std::size_t{(cells & ahead) != 0} + 2 * std::size_t{(cells & (kHalf.both() ^ ahead)) != 0};
    const double room = room_[kAxis][kinds] - std::copysign(1.0, speed) * seen.beyond[direction] -
                        cells_.reach(kAxis, radius);
    waits[direction] = std::max(0.0, room) / std::fabs(speed);  // at rest it may be no number
  });
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  if (cells_.period(2) == 0) [[unlikely]] {
    const bool up = downwards[ShearedBlock::kDepth] == 0;
    const bool is_end = block.outermost(ShearedBlock::kDepth, up) == (up ? cells_.last(2) : cells_.first(2));
    if (is_end) waits[ShearedBlock::kDepth] = kInfinite;
  }
  double least = kInfinite;
  std::uint32_t crossed = 0;
  for_each_direction([&](auto direction) {
    const bool is_sooner = waits[direction] < least;
    const std::uint32_t crossing = ShearedBlock::crossing_along(direction, downwards[direction]);
    least = std::min(least, waits[direction]);
    crossed ^= (crossed ^ crossing) & (0U - static_cast<std::uint32_t>(is_sooner));
  });
  block.crossing = static_cast<std::uint8_t>(crossed);
  return rounded_down(now) + least;
}

void ShearedCells::cross_block(const World& world, Slot slot, const Time& now, Candidates& candidates) {
  ShearedBlock& block = stored_region(slot);
  const SeenFromBlock seen = see(world, slot, now);
  const double radius = world.bounding_radius(slot);
  const std::size_t crossed = ShearedBlock::direction_of(block.crossing);
  const bool upwards = !ShearedBlock::is_downwards(block.crossing);
  std::uint32_t kept = block.cells;
  for_each_direction([&](auto direction) {
    constexpr ShearedBlock::Halves kHalf = ShearedBlock::kHalves[direction];
    const double reach = cells_.reach(ShearedBlock::kAxis[direction], radius);
    const double beyond = seen.beyond[direction];
    // Whatever the rounding, of two cells along the direction of the crossing it leaves one.
    const bool is_crossed = direction == crossed;
    const bool up = is_crossed ? upwards : !std::signbit(seen.velocity[direction]);
    const bool is_lower_behind = up & (is_crossed | (beyond >= reach));
    const bool is_upper_behind = (!up) & (is_crossed | (-beyond >= reach));
    kept = kHalf.without(kHalf.lower_if(is_lower_behind) | kHalf.upper_if(is_upper_behind), kept);
  });
  keep(slot, kept);

  std::uint32_t entered = block.make_room(crossed, upwards);
  if (crossed == ShearedBlock::kAcrossRows) {
    const double x = world.unfolded_position(slot, now).x;
    entered = reach_row(block, upwards ? 1 : 0, x, radius, now) & block.depths();
  }
  block.cells |= static_cast<std::uint8_t>(entered);
  enter_cells(slot, entered, candidates);
}

// Collects the spheres that touch some cells of the block, and enters these cells.
void ShearedCells::enter_cells(Slot slot, std::uint32_t cells, Candidates& candidates) {
  const ShearedBlock& block = stored_region(slot);
  if (table_.is_shared()) [[unlikely]] {
    CellBlock::for_each_cell(
        cells, [&](std::uint32_t cell) { collect_cell(cells_.folded(block.index(cell)), candidates); });
  }
  block.for_each_list(cells, table_, [&](std::uint32_t list) {
    if (!table_.is_shared()) collect_list(list, candidates);
    lists_.insert(list, slot);
  });
}

std::size_t ShearedCells::memory_bytes() const {
  return lists_.memory_bytes() + lines_.capacity() * sizeof(lines_[0]) +
         regions_.capacity() * sizeof(regions_[0]);
}

// The cells that a sphere is in.
ShearedRegion ShearedCells::region_of(Slot slot) const {
  if (!blocks_) return regions_[slot];
  const ShearedBlock& block = stored_region(slot);
  ShearedRegion region;
  region.lowest = block.outermost(ShearedBlock::kAcrossRows, false);
  region.count =
      static_cast<std::uint8_t>(block.outermost(ShearedBlock::kAcrossRows, true) - region.lowest + 1);
  region.depths = {block.outermost(ShearedBlock::kDepth, false), block.outermost(ShearedBlock::kDepth, true)};
  for (std::int32_t row = region.lowest; row <= region.highest(); ++row) {
    const auto direction = static_cast<std::size_t>(row - block.low[ShearedBlock::kAcrossRows]);
    region.in_row(row) = {block.outermost(direction, false), block.outermost(direction, true)};
  }
  return region;
}

void ShearedCells::validate(const World& world, const Time& now, const CompactPaths&) const {
  HARDBALL_CHECK(lines_.size() >= world.size() && (blocks_ || regions_.size() >= world.size()));
  for (Slot slot = 0; slot < world.size(); ++slot) {
    const ShearedRegion region = region_of(slot);
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
    for_each_cell_of(region, [&](const CellIndex& cell, const CellIndex& folded) {
      HARDBALL_CHECK(is_in(slot, cell));
      std::size_t expected = 0;
      for_each_list(slot, [&](std::uint32_t same) { expected += same == table_.list(folded) ? 1U : 0U; });
      std::size_t found = 0;
      lists_.for_each(table_.list(folded), [&](Slot occupant) { found += occupant == slot ? 1U : 0U; });
      HARDBALL_CHECK(found == expected);
    });
  }
}

}  // namespace hardball
