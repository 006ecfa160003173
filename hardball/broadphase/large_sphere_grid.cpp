// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/large_sphere_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "hardball/errors/error.hpp"
#include "hardball/geometry/wait_in_ball.hpp"

namespace hardball {
namespace {

constexpr std::int32_t kMostCellsPerAxis = 1 << 28;
constexpr double kMostCellsPerSphere = 1000;

// In boxes so small that larger spheres in the grid would have candidates too far apart, it keeps those that
// touch at most two cells along each axis.
constexpr double kLargestInCell = 0.4999;

// The least skin over the edge of a cell [1].
constexpr double kLeastSkin = 0.01;

// Candidates stay closer than this fraction of a periodic box along each axis.
constexpr double kLargestShare = 0.495;

// Shells overlap a little before they touch: far more than rounding.
constexpr double kShellMargin = 1e-9;

// The least and the greatest depth of a list, over the skin.
constexpr double kLeastDepth = 1e-4;
constexpr double kGreatestDepth = 0.25;
// Lists are deeper by this fraction of the farthest distance of candidates: far more than the errors of
// compact copies.
constexpr double kDepthMargin = 0x1p-19;
// A list must last for this fraction of the time, and its skin show in coordinates, so that rounding does
// not matter.
constexpr double kFewestDigits = 0x1p-38;

double smallest_edge(const Subdivision& cells) {
  return std::min({cells.edge(0), cells.edge(1), cells.edge(2)});
}

std::int32_t round_down(double number) {
  return static_cast<std::int32_t>(std::floor(number));
}

}  // namespace

double LargeSphereGrid::cells_of_surface(double radius, std::size_t dimensions) {
  // By Steiner's formula for those that touch the sphere; those inside are missing.
  constexpr double kSphere = 4 * std::numbers::pi / 3;
  constexpr double kDepth = 2 * kSkin + 0.75;
  const double outer = radius + kSkin;
  const double inner = std::max(0.0, outer - kDepth);
  const double depth =
      std::min(outer, kDepth);  // of the largest radii, outer - inner would be rounded to zero
  if (dimensions == 2) return 1 + 4 * outer + std::numbers::pi * depth * (outer + inner);
  return 1 + 6 * outer + 3 * std::numbers::pi * outer * outer +
         kSphere * depth * (outer * outer + outer * inner + inner * inner);
}

std::optional<LargeSphereGrid::Sizes> LargeSphereGrid::sizes_for(const World& world,
                                                                 const Subdivision& cells) {
  // Where few do not fit into cells, the grid may keep all others in blocks of cells, which is the fastest.
  const std::optional<Sizes> in_blocks = sizes_for(world, cells, kLargestInCell);
  if (in_blocks && in_blocks->surfaces <= kFewSurfaces * static_cast<double>(world.size())) return in_blocks;
  if (world.largest_radius() <= kLargestInGrid * smallest_edge(cells)) return std::nullopt;
  const std::optional<Sizes> in_rows = sizes_for(world, cells, kLargestInGrid);
  return in_rows ? in_rows : in_blocks;
}

std::optional<LargeSphereGrid::Sizes> LargeSphereGrid::sizes_for(const World& world, const Subdivision& cells,
                                                                 double largest_in_edges) {
  const double edge = smallest_edge(cells);
  Sizes sizes;
  const double room_to_grow = world.room_to_grow();
  if (room_to_grow > 1) sizes.largest_in_grid = largest_in_edges * edge;
  std::size_t count = 0;
  double largest = 0;
  double second_largest = 0;
  for (const double radius : world.radii().each()) {
    if (radius <= largest_in_edges * edge) {
      sizes.largest_in_grid = std::max(sizes.largest_in_grid, radius);
      continue;
    }
    ++count;
    sizes.surfaces += cells_of_surface(radius / edge, world.box().dimensions());
    second_largest = std::max(second_largest, std::min(radius, largest));
    largest = std::max(largest, radius);
  }
  const auto spheres = static_cast<double>(world.size());
  if (count == 0 || 2 * count > world.size() || sizes.surfaces > kMostCellsPerSphere * spheres)
    return std::nullopt;
  sizes.skin = kSkin * edge;
  sizes.largest = largest;
  sizes.second_largest = second_largest;
  // A shell must be no thicker for the rounding of coordinates along an axis that is far longer than others.
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (cells.reach(axis, 0) > kLeastSkin * edge) return std::nullopt;
  }
  Vec3 extent;  // of a region of the grid; it shares one cell with that of a large sphere
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    const double touched = most_cells_touched(2 * cells.reach(axis, sizes.largest_in_grid), cells.edge(axis));
    extent[axis] = (touched + 1) * cells.edge(axis);
    if (!world.box().is_periodic(axis)) continue;
    if (!has_nearest_images(cells.period(axis), touched)) return std::nullopt;
    const double room = kLargestShare * world.box().size()[axis];
    if (count > 1) sizes.skin = std::min(sizes.skin, (room - (largest + second_largest)) / 4);
    sizes.skin = std::min(sizes.skin, (room - (largest + extent[axis])) / 2);
  }
  if (sizes.skin < kLeastSkin * edge) return std::nullopt;
  if (room_to_grow > 1) {
    const double grown = room_to_grow * largest;
    const double second_grown = room_to_grow * std::max(second_largest, sizes.largest_in_grid);
    double room = std::numeric_limits<double>::infinity();
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (!world.box().is_periodic(axis)) continue;
      const double beside = std::max(second_grown + 4 * sizes.skin, extent[axis] + 2 * sizes.skin);
      room = std::min(room, kLargestShare * world.box().size()[axis] - beside);
    }
    if (grown <= room) {
      count = 2;
      sizes.largest = grown;
      sizes.second_largest = second_grown;
    }
  }
  // From a large sphere to any point of its cells, and on to the center of one in the grid that shares them.
  const Vec3 cell{cells.edge(0), cells.edge(1), cells.edge(2)};
  sizes.farthest = sizes.largest + 2 * sizes.skin + length(cell) + length(extent);
  if (count > 1) {
    sizes.farthest = std::max(sizes.farthest, sizes.largest + sizes.second_largest + 5 * sizes.skin);
  }
  return sizes;
}

bool LargeSphereGrid::supports(const World& world, double edge) {
  if (world.radii().is_common()) return false;
  return sizes_for(world, Subdivision(world.box(), edge, kMostCellsPerAxis)).has_value();
}

void LargeSphereGrid::build(const World& world, const Time& now, CompactPaths& copies) {
  const std::optional<Sizes> sizes =
      sizes_for(world, Subdivision(world.box(), wanted_edge_, kMostCellsPerAxis));
  HARDBALL_CHECK(sizes.has_value());
  grid_ = CellGrid(wanted_edge_, sizes->largest_in_grid, sizes->farthest);
  grid_.build(world, now, copies);
  HARDBALL_CHECK(grid_.uses_minimum_image());
  sizes_ = *sizes;
  skin_ = sizes->skin;
  margin_ = 0;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    margin_ = std::max(margin_, grid_.cells().reach(axis, 0));
  }
  large_.clear();
  are_large_.assign(world.size() / 64 + 1, 0);
  large_numbers_.assign(world.size(), 0);
  left_count_ = 0;
  for (Slot slot = 0; slot < world.size(); ++slot) {
    if (world.radius(slot) > sizes->largest_in_grid) insert_large(world, slot, now);
  }
  double squares = 0;
  for (Slot slot = 0; slot < world.size(); ++slot) {
    const Vec3 velocity = world.velocity(slot, now);
    squares += dot(velocity, velocity);
  }
  usual_speed_ = kUsualSpeed * std::sqrt(squares / static_cast<double>(world.size()));
  for (LargeSphere& large : large_) {
    collect_all(world, large, found_);
    list_near(world, large, now, copies, found_);
  }
}

void LargeSphereGrid::mark_large(Slot slot, bool is_large, std::uint32_t number) {
  if (slot >= large_numbers_.size()) {
    are_large_.resize(slot / 64 + 1);
    large_numbers_.resize(slot + 1);
  }
  const std::uint64_t bit = std::uint64_t{1} << (slot % 64);
  are_large_[slot / 64] = (are_large_[slot / 64] & ~bit) | (is_large ? bit : 0);
  large_numbers_[slot] = number;
}

void LargeSphereGrid::insert_large(const World& world, Slot slot, const Time& now) {
  mark_large(slot, true, static_cast<std::uint32_t>(large_.size()));
  LargeSphere& large = large_.emplace_back();
  large.slot = slot;
  large.radius = world.radius(slot);
  move_anchor(world, large, now);
  for_each_cell(large, [&](const CellIndex& cell) { grid_.lists_to_edit().insert(grid_.list(cell), slot); });
}

bool LargeSphereGrid::admits(const World& world, Slot slot) const {
  const double radius = world.radius(slot);
  if (radius <= std::max(sizes_.largest_in_grid, sizes_.second_largest)) return true;
  return radius <= sizes_.largest && std::ranges::all_of(large_, [&](const LargeSphere& other) {
           return other.radius <= sizes_.second_largest || other.slot == slot;
         });
}

void LargeSphereGrid::insert(const World& world, Slot slot, const Time& now, const CompactPaths& copies) {
  mark_large(slot, false, 0);
  grid_.insert(world, slot, now, copies);
  if (world.radius(slot) > sizes_.largest_in_grid) insert_large(world, slot, now);
  collect(world, slot, found_);
  list_at_large(slot, found_);
}

void LargeSphereGrid::erase(Slot slot) {
  replace_in_lists(slot, std::nullopt);
  if (!is_large(slot)) return grid_.erase(slot);
  const std::uint32_t number = large_numbers_[slot];
  for_each_cell(large_[number],
                [&](const CellIndex& cell) { grid_.lists_to_edit().erase(grid_.list(cell), slot); });
  mark_large(large_.back().slot, true, number);
  large_[number] = std::move(large_.back());
  large_.pop_back();
  mark_large(slot, false, 0);
}

void LargeSphereGrid::move(Slot from, Slot to) {
  replace_in_lists(from, to);
  if (!is_large(from)) {
    mark_large(to, false, 0);
    return grid_.move(from, to);
  }
  grid_.lines()[to] = grid_.lines()[from];
  LargeSphere& large = large_of(from);
  for_each_cell(large, [&](const CellIndex& cell) {
    grid_.lists_to_edit().erase(grid_.list(cell), from);
    grid_.lists_to_edit().insert(grid_.list(cell), to);
  });
  large.slot = to;
  mark_large(to, true, large_numbers_[from]);
  mark_large(from, false, 0);
}

// Puts another slot in place of one in all lists of large spheres; without one, their own, which means none.
void LargeSphereGrid::replace_in_lists(Slot slot, std::optional<Slot> by) {
  for (LargeSphere& large : large_) {
    if (large.has_list) std::ranges::replace(large.near, slot, by.value_or(large.slot));
  }
}

// No cell tells who lies deep inside a large sphere.
void LargeSphereGrid::collect_overlapping(const World& world, Slot slot, Candidates& candidates) const {
  if (is_large(slot)) {
    candidates.begin(slot, true);
    for_each_cell(large_of(slot), 0, [&](const CellIndex& cell) {
      grid_.lists().for_each(grid_.list(cell), [&](Slot other) { candidates.add(other); });
    });
  } else {
    grid_.collect(world, slot, candidates);
  }
  for (const LargeSphere& large : large_) candidates.add(large.slot);
  candidates.end();
}

void LargeSphereGrid::move_anchor(const World& world, LargeSphere& large, const Time& now) const {
  large.anchor = world.unfolded_position(large.slot, now);
  large.boxes = -world.box().fold(large.anchor);
}

// The center, relative to the anchor.
Vec3 LargeSphereGrid::place_of(const World& world, const LargeSphere& large, const Time& now) const {
  return world.unfolded_position(large.slot, now) + world.box().shift(large.boxes) - large.anchor;
}

double LargeSphereGrid::next_crossing_of_large(const World& world, Slot slot, const Time& now) const {
  const LargeSphere& large = large_of(slot);
  const Vec3 place = place_of(world, large, now);
  const Vec3 velocity = world.velocity(slot, now);
  const double error = coordinate_error(world, slot, now);
  const auto wait_within = [&](const Vec3& middle, double skin) {
    const Vec3 apart = place - middle;
    const double reach = std::max(skin / 2, skin - error);
    return wait_in_ball(world.motion(), apart, velocity, reach);
  };
  const double begin = rounded_down(now);
  const double left = begin + wait_within({}, skin_);
  if (!large.has_list) return left;
  return std::max(begin, std::min({left, begin + wait_within(large.middle, large.near_skin), large.expiry}));
}

// Calls visit(cell) for each cell, folded into the box, that a large sphere may touch, but for those within
// `hollow` of its anchor, in columns along the last axis. Cells at the ends of the box or of open space reach
// on forever.
template <class Visit>
void LargeSphereGrid::for_each_cell(const LargeSphere& large, double hollow, Visit&& visit) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const Subdivision& cells = grid_.cells();
  const double outer = large.radius + skin_ + margin_;
  const auto index_at = [&](std::size_t axis, double coordinate) {
    return round_down(std::clamp<double>(coordinate / cells.edge(axis), cells.first(axis), cells.last(axis)));
  };
  const bool is_periodic[] = {cells.period(0) > 0, cells.period(1) > 0, cells.period(2) > 0};
  // The distances of the nearest and of the farthest point of a row of cells along an axis.
  struct Distances {
    double near;
    double far;
  };
  const auto distances = [&](std::size_t axis, std::int32_t index) {
    const bool has_below = is_periodic[axis] || index > cells.first(axis);
    const bool has_above = is_periodic[axis] || index < cells.last(axis);
    const double low = has_below ? cells.edge(axis) * index - large.anchor[axis] : -kInfinity;
    const double high = has_above ? cells.edge(axis) * (index + 1) - large.anchor[axis] : kInfinity;
    return Distances{std::max({low, -high, 0.0}), std::max(-low, high)};
  };
  const auto square = [](double number) { return number * number; };
  CellIndex low;
  CellIndex high;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    low[axis] = index_at(axis, large.anchor[axis] - outer);
    high[axis] = index_at(axis, large.anchor[axis] + outer);
  }
  for (std::int32_t x = low[0]; x <= high[0]; ++x) {
    const Distances in_x = distances(0, x);
    const std::int32_t folded_x = cells.folded(0, x);
    for (std::int32_t y = low[1]; y <= high[1]; ++y) {
      const Distances in_y = distances(1, y);
      const double room = outer * outer - (square(in_x.near) + square(in_y.near));
      if (room < 0) continue;
      const double height = std::sqrt(room);
      const std::int32_t folded_y = cells.folded(1, y);
      const std::int32_t begin = index_at(2, large.anchor.z - height);
      const std::int32_t end = index_at(2, large.anchor.z + height) + 1;
      // Cells in which it leaves no room for others are left out.
      std::int32_t hole_begin = end;
      std::int32_t hole_end = end;
      const double hidden = hollow * hollow - (square(in_x.far) + square(in_y.far));
      if (hidden > 0) {
        const double half = std::sqrt(hidden);
        hole_begin = std::max(begin, index_at(2, large.anchor.z - half) + 1);
        hole_end = std::min(end, index_at(2, large.anchor.z + half));
        if (hole_begin >= hole_end) hole_begin = hole_end = end;
      }
      for (std::int32_t z = begin; z < hole_begin; ++z) {
        visit(CellIndex{folded_x, folded_y, cells.folded(2, z)});
      }
      for (std::int32_t z = hole_end; z < end; ++z) {
        visit(CellIndex{folded_x, folded_y, cells.folded(2, z)});
      }
    }
  }
}

bool LargeSphereGrid::do_shells_meet(const World& world, const LargeSphere& a, const LargeSphere& b) const {
  const Vec3 apart = b.anchor - a.anchor;
  const double reach = (a.radius + b.radius + 2 * skin_) * (1 + kShellMargin);
  return length(apart + world.box().shift(world.box().nearest_image(-apart))) <= reach;
}

bool LargeSphereGrid::are_candidates(Slot a, Slot b) const {
  if (is_large(a) == is_large(b)) return is_large(a) || grid_.are_candidates(a, b);
  bool share_cell = false;
  for_each_cell(large_of(is_large(a) ? a : b),
                [&](const CellIndex& cell) { share_cell |= grid_.is_in(is_large(a) ? b : a, cell); });
  return share_cell;
}

// Large spheres are found in many cells, and added once.
void LargeSphereGrid::collect_cell(const World& world, const LargeSphere& large, const CellIndex& cell,
                                   Candidates& candidates) const {
  grid_.lists().for_each_line(grid_.list(cell),
                              [&](const SlotLists::LineOfSlots& slots, std::uint32_t count) {
                                const auto is_small = [&](Slot other) {
                                  const bool is_other_large = is_large(other) & (other != large.slot);
                                  if (is_other_large) [[unlikely]] {
                                    if (candidates.is_new(other)) {
                                      candidates.mark(other);
                                      return do_shells_meet(world, large, large_of(other));
                                    }
                                  }
                                  return !is_large(other);
                                };
                                candidates.add_if(slots, count, is_small);
                              });
}

void LargeSphereGrid::collect_of_large(const World& world, Slot slot, Candidates& candidates) const {
  const LargeSphere& large = large_of(slot);
  candidates.begin(slot, true);
  if (large.has_list) return candidates.refer_to({large.near.data(), large.near_count});
  collect_all(world, large, candidates);
}

void LargeSphereGrid::collect_all(const World& world, const LargeSphere& large,
                                  Candidates& candidates) const {
  candidates.begin(large.slot, true);
  candidates.start_round(large_.size());
  for_each_cell(large, [&](const CellIndex& cell) { collect_cell(world, large, cell, candidates); });
  candidates.end();
}

void LargeSphereGrid::cross_large(const World& world, Slot slot, const Time& now, const CompactPaths& copies,
                                  Candidates& candidates) {
  LargeSphere& large = large_of(slot);
  // A list reaches no farther than the skin.
  const double most = large.has_list ? (1 - 2 * kGreatestDepth) * skin_ : 0;
  const bool moves = !(length(place_of(world, large, now)) < most);
  if (moves) {
    for_each_cell(large, [&](const CellIndex& cell) { grid_.lists_to_edit().erase(grid_.list(cell), slot); });
    ++left_count_;
    move_anchor(world, large, now);
    for_each_cell(large,
                  [&](const CellIndex& cell) { grid_.lists_to_edit().insert(grid_.list(cell), slot); });
  }
  collect_all(world, large, candidates);
  if (moves) list_at_large(slot, candidates);
  list_near(world, large, now, copies, candidates);
  if (large.has_list) candidates.refer_to({large.near.data(), large.near_count});
}

void LargeSphereGrid::LargeSphere::append(Slot other) {
  near.resize(near_count + 1 + Candidates::kPadding);
  near[near_count++] = other;
  std::fill_n(near.begin() + static_cast<std::ptrdiff_t>(near_count), Candidates::kPadding, slot);
}

// Adds a sphere to the lists of the large ones among its candidates.
void LargeSphereGrid::list_at_large(Slot slot, const Candidates& candidates) {
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Slot other = candidates.slot(i);
    if (is_large(other) && other != slot && large_of(other).has_list) large_of(other).append(slot);
  }
}

void LargeSphereGrid::list_fast(const World& world, Slot slot) {
  grid_.collect(world, slot, found_);
  list_at_large(slot, found_);
}

// Lists those of all candidates that can reach a large sphere before the list expires, each once.
void LargeSphereGrid::list_near(const World& world, LargeSphere& large, const Time& now,
                                const CompactPaths& copies, const Candidates& all) const {
  const Slot slot = large.slot;
  // Under gravity speeds change between contacts: nobody could say who comes from where in time.
  const bool pays = world.motion().is_straight() && all.size() >= kFewestToList && copies.is_bounded(slot);
  if (pays) choose_depth(large, all.size());
  const double begin = rounded_down(now);
  // At rest, it may be hit and move.
  constexpr double kAtRest = 0.01;
  constexpr double kChange = 3;
  const double speed = length(world.path(slot).velocity);
  large.near_skin = large.depth * std::min(1.0, kAtRest + kChange * speed / usual_speed_);
  large.expiry = begin + large.depth / usual_speed_;
  large.has_list = pays && usual_speed_ > 0 && large.expiry > begin + kFewestDigits * std::fabs(begin) &&
                   0x1p-12 * large.near_skin > coordinate_error(world, slot, now);
  if (!large.has_list) return;
  large.middle = place_of(world, large, now);
  large.contacts = 0;
  const double unit = copies.length_unit();
  const CompactPath& own = copies.paths()[large.slot];
  const auto usual = static_cast<float>(large.depth / unit);
  const float reach =
      copies.radius(large.slot) +
      static_cast<float>((large.near_skin + large.depth + kDepthMargin * copies.farthest()) / unit);
  const auto wait = static_cast<float>((large.expiry - begin) / copies.time_unit() * (1 + 0x1p-20));
  large.near.resize(all.size() + Candidates::kPadding);
  std::size_t count = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Slot other = all.slot(i);
    const CompactPath& path = copies.paths()[other];
    const float age = static_cast<float>(static_cast<std::int32_t>(static_cast<std::uint32_t>(own.tick) -
                                                                   static_cast<std::uint32_t>(path.tick))) *
                      copies.scale().tick;
    float distance_squared = 0;
    float speed_squared = 0;
    for_each_axis([&](auto axis) {
      const auto steps =
          static_cast<std::uint32_t>(path.place[axis]) - static_cast<std::uint32_t>(own.place[axis]);
      const float place = static_cast<float>(static_cast<std::int32_t>(steps)) * copies.scale().grid[axis] +
                          path.velocity[axis] * age;
      distance_squared += place * place;
      speed_squared += path.velocity[axis] * path.velocity[axis];
    });
    const float way = std::sqrt(speed_squared) * wait;
    const float sum = reach + copies.radius(other) + std::max(0.0F, way - usual);
    large.near[count] = other;
    // Of a sphere too fast to be copied, nothing is known.
    count += !(distance_squared > sum * sum) || is_large(other) ? 1U : 0U;
  }
  const auto end = large.near.begin() + static_cast<std::ptrdiff_t>(count);
  std::sort(large.near.begin(), end);
  count = static_cast<std::size_t>(std::unique(large.near.begin(), end) - large.near.begin());
  large.near_count = count;
  large.near.resize(count + Candidates::kPadding);
  std::fill_n(large.near.begin() + static_cast<std::ptrdiff_t>(count), Candidates::kPadding, large.slot);
}

// The search for a list is shared by the contacts of its time; each of these goes through the list: the depth
// at which both cost the same costs least.
void LargeSphereGrid::choose_depth(LargeSphere& large, std::size_t searched) const {
  constexpr double kFactor = 1.5;
  if (!large.has_list) {
    large.depth = skin_ / 64;
  } else {
    const double search = static_cast<double>(searched) / (1 + large.contacts);
    large.depth *= search > static_cast<double>(large.near_count) ? kFactor : 1 / kFactor;
  }
  large.depth = std::clamp(large.depth, kLeastDepth * skin_, kGreatestDepth * skin_);
}

std::size_t LargeSphereGrid::memory_bytes() const {
  return grid_.memory_bytes() + large_.capacity() * sizeof(LargeSphere) +
         are_large_.capacity() * sizeof(std::uint64_t) + large_numbers_.capacity() * sizeof(std::uint32_t);
}

void LargeSphereGrid::validate(const World& world, const Time& now, const CompactPaths& copies) const {
  HARDBALL_CHECK(large_numbers_.size() >= world.size());
  grid_.validate(world, now, copies);
  for (const LargeSphere& large : large_) {
    HARDBALL_CHECK(is_large(large.slot) && large.radius == world.radius(large.slot));
    HARDBALL_CHECK(length(place_of(world, large, now)) <= skin_ + coordinate_error(world, large.slot, now));
    for_each_cell(large, [&](const CellIndex& cell) {
      std::size_t found = 0;
      grid_.lists().for_each(grid_.list(cell),
                             [&](Slot occupant) { found += occupant == large.slot ? 1U : 0U; });
      HARDBALL_CHECK(found == 1 || (found > 1 && grid_.shares_lists()));
    });
  }
}

}  // namespace hardball
