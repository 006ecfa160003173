// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/broadphase/neighbor_list.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <span>
#include <type_traits>

#include "hardball/errors/error.hpp"
#include "hardball/standard/ranges.hpp"
#include "hardball/world/images.hpp"

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
// Positions as seen from another row are rounded once more.
constexpr float kPackingErrorInRows = 4;

// With more long lists than this share, all get room for twice as many neighbors.
constexpr std::size_t kLongShare = 32;

// And between two copies of their paths spheres move no more than this one, where rows slide with them.
constexpr double kMostMoved = 0.16;

// Distances of neighbors stay below this fraction of a periodic box: then only one image of each is near,
// and there are at least three cells along each axis.
constexpr double kLargestListShare = 0.33;

// Of a sheared box, in the least lengths that compact paths allow: by how much shells are larger, and how far
// spheres may move with the flow between two copies.
constexpr double kHeightMargin = 0x1p-4;
constexpr double kHeightsMoved = 8;

// The skin is at least this fraction of the largest radius.
constexpr double kLeastListSkin = 0.02;

// The largest distance between the centers of two neighbors: shells in contact, both displaced from their
// anchors, and rows that have slid.
double farthest_neighbors(double largest_radius, double skin, double slide) {
  return 2 * largest_radius + 4 * skin + slide;
}

// Rows slide by no more than this multiple of the skin before lists expire.
constexpr double kMostSlide = 1.5;

double largest_edge(const Subdivision& cells) {
  return std::max({cells.edge(0), cells.edge(1), cells.edge(2)});
}

// Whether lists can be made for spheres of up to this radius.
bool fits(const Box& box, double largest_radius) {
  const double skin = kLeastListSkin * largest_radius;
  return farthest_neighbors(largest_radius, skin, box.is_sheared() ? kMostSlide * skin : 0) <=
         kLargestListShare * box.shortest_period();
}

}  // namespace

bool NeighborList::supports(const World& world, double) {
  return fits(world.box(), world.largest_bounding_radius());
}

double NeighborList::cell_edge(double largest_radius, double skin) {
  return 2 * (largest_radius + skin);
}

double NeighborList::slide_of_skin(const Box& box, double largest_radius, double skin, double mean_speed) {
  if (!box.is_sheared()) return 0;
  constexpr double kSlide = 1.8;
  const double speed_of_rows = std::fabs(box.shear().rate) * cell_edge(largest_radius, skin);
  const double slide = kSlide * std::sqrt(speed_of_rows / mean_speed);
  return slide < kMostSlide ? slide : kMostSlide;
}

void NeighborList::build(const World& world, const Time& now, CompactPaths& copies) {
  HARDBALL_CHECK(supports(world));
  const double grown = world.room_to_grow() * world.largest_bounding_radius();
  const double radius = largest_built_ = fits(world.box(), grown) ? grown : world.largest_bounding_radius();
  // Without spheres any distance will do.
  const double any_radius = world.size() > 0 ? radius : 1;
  double speeds = 0;
  for (Slot slot = 0; world.box().is_sheared() && slot < world.size(); ++slot)
    speeds += length(peculiar_velocity(world, slot, now));
  const double mean_speed = speeds / std::max(1.0, static_cast<double>(world.size()));
  const double per_skin = slide_of_skin(world.box(), any_radius, wanted_skin_, mean_speed);
  const double largest = (kLargestListShare * world.box().shortest_period() - 2 * radius) / (4 + per_skin);
  skin_ = std::max(kLeastListSkin * radius, std::min(wanted_skin_, largest));
  const double slide = per_skin * skin_;
  const double farthest = farthest_neighbors(any_radius, skin_, slide);
  // The heights of a sheared box fit into a ring of integers, which are coarser in a large one.
  const double height = CompactPaths::least_farthest(world.box());
  const double margin = kListMargin * std::max(farthest, kHeightMargin * height);
  room_ = skin_ - kCrossingMargin * std::max(farthest, kHeightMargin * height);
  cells_ = Subdivision(world.box(), cell_edge(any_radius, skin_) + slide / 2 + 2 * margin);
  sliding_ = SlidingAnchors(world.box(), cells_.period(1), slide, now);
  const double apart = farthest + 2 * margin;
  if (sliding_.are_present()) {
    const double scale = std::max(apart, kHeightsMoved * height);
    copies.reset(world, scale, std::min(scale, kMostMoved * world.box().shortest_period()), now);
  } else {
    copies.reset(world, apart, now);
  }
  reach_ = static_cast<float>((2 * skin_ + margin) / copies.length_unit());
  reach_of_slide_ = static_cast<float>(slide / 2 / copies.length_unit());
  room_in_units_ = static_cast<float>(room_ / copies.length_unit());
  const Extent expected = sliding_.are_present() ? Extent() : expected_.grown(largest_edge(cells_));
  table_ = CellTable(cells_, world.size(), cells_.spans_of(expected));
  points_.reset(table_.size());
  choose_packing(copies);
  reset(lines_, world);
  for (Slot slot = 0; slot < world.size(); ++slot) {
    move_anchor(world, slot, now, copies);
    store_anchor(slot);
  }
  make_lists(1, now, copies);
}

void NeighborList::make_lists(std::uint32_t lines, const Time& now, const CompactPaths& copies) {
  neighbors_.reset(lines_.size(), lines);
  std::size_t long_ones = 0;
  for (Slot slot = 0; slot < lines_.size(); ++slot) {
    find_near(slot, now, copies);
    near_.count = static_cast<std::size_t>(std::remove(near_.begin(), near_.begin() + near_.count, slot) -
                                           near_.begin());
    neighbors_.assign(slot, near_.slots());
    long_ones += near_.count > PaddedLists::kLine ? 1U : 0U;
  }
  if (lines == 1 && long_ones > lines_.size() / kLongShare) return make_lists(2, now, copies);
  if (sliding_.are_present()) make_mutual();
}

// Seen from two rows, distances are rounded in different ways: if a sphere has another in its list, it is in
// the other's list, too.
void NeighborList::make_mutual() {
  for (Slot slot = 0; slot < lines_.size(); ++slot) {
    const std::span<const Slot> lanes = neighbors_.of(slot);
    for (const Slot other : std::vector<Slot>(lanes.begin(), lanes.end())) {
      const std::span<const Slot> its = neighbors_.of(other);
      if (other != slot && ranges::find(its, slot) == its.end()) neighbors_.insert(other, slot);
    }
  }
}

void NeighborList::insert(const World& world, Slot slot, const Time& now, const CompactPaths& copies) {
  reset(lines_, world, slot);
  neighbors_.add_owner(slot);
  move_anchor(world, slot, now, copies);
  find_near(slot, now, copies);
  store_anchor(slot);
  for (const Slot other : near_.slots()) neighbors_.insert(other, slot);
  neighbors_.assign(slot, near_.slots());
}

void NeighborList::erase(Slot slot) {
  points_.erase(table_.list(stored_region(slot).cell), slot);
  for (const Slot other : neighbors_.of(slot)) {
    if (other != slot) neighbors_.erase(other, slot);
  }
  neighbors_.assign(slot, {});
}

bool NeighborList::keeps(const World& world, Slot slot, const Time& now, const CompactPaths& copies) const {
  if (sliding_.are_present()) return false;  // where it is in its row would have to be found
  const Anchor& anchor = stored_region(slot);
  const CellIndex cell = cells_.cell_of(world.position(slot, now));
  bool is_near = copies.is_bounded(slot);
  float room = room_in_units_ * room_in_units_;
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
  points_.erase(table_.list(stored_region(from).cell), from);
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
    packing.cells_of_step = 1 / steps;
    const auto in_units = [&] { return std::ldexp(steps, -static_cast<int>(packing.shift)); };
    while (in_units() > PackedPosition::kMax - 1) ++packing.shift;
    packing.units_of_cell = static_cast<std::int32_t>(std::lround(in_units()));
    if (cells_.shape()[axis] == 0) {
      packing.below = cells_.first(axis);
      packing.above = cells_.last(axis);
    }
    packing_unit_[axis] = std::ldexp(copies.scale().grid[axis], static_cast<int>(packing.shift));
    const float units = axis == 0 && sliding_.are_present() ? kPackingErrorInRows : kPackingError;
    error += units * units * packing_unit_[axis] * packing_unit_[axis];
  }
  packing_error_ = std::sqrt(error);
}

// Of anchors beyond the outermost cells distances are underestimated.
std::int32_t NeighborList::in_cell(const Anchor& anchor, std::size_t axis) const {
  const Packing& packing = packing_[axis];
  const std::int32_t cell = anchor.cell[axis];
  constexpr auto kMax = static_cast<std::int32_t>(PackedPosition::kMax);
  const std::int32_t inside = std::clamp(steps_in_cell(anchor, axis) >> packing.shift, 0, kMax);
  return cell == packing.below ? kMax : cell == packing.above ? 0 : inside;
}

std::int32_t NeighborList::steps_in_cell(const Anchor& anchor, std::size_t axis) const {
  const std::uint64_t corner =
      static_cast<std::uint64_t>(std::int64_t{anchor.cell[axis]}) * packing_[axis].steps_of_cell;
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(anchor.position[axis]) -
                                   static_cast<std::uint32_t>(corner >> 32));
}

double NeighborList::next_crossing_in_sheared_box(const World& world, Slot slot, const Time& now,
                                                  const CompactPaths& copies) const {
  const CompactPath& path = copies.paths()[slot];
  const Anchor& own = stored_region(slot);
  const SlidingAnchors::Row row = sliding_.row_of(own, path, now, copies);
  std::array<std::int32_t, 3> anchor = own.position;
  anchor[0] = sum_on_grid(anchor[0], row.displacement);
  std::array<float, 3> velocity = path.velocity;
  velocity[0] -= copies.in_units(row.speed);
  const float wait = wait_in_ball(copies, path.position, velocity, anchor);
  const double crossing = wait >= 0 ? rounded_down(now) + copies.time_unit() * static_cast<double>(wait)
                                    : leaves_ball(world, slot, now, copies);
  return std::min(crossing, sliding_.expiry(own, now));
}

double NeighborList::leaves_ball(const World& world, Slot slot, const Time& now,
                                 const CompactPaths& copies) const {
  const auto [position, velocity] = relative_to_anchor(world, slot, now, copies);
  const double reach = std::max(0.0, room_ - coordinate_error(world, slot, now));
  return rounded_down(now) + hardball::wait_in_ball(world.motion(), position, velocity, reach);
}

State NeighborList::relative_to_anchor(const World& world, Slot slot, const Time& now,
                                       const CompactPaths& copies) const {
  const Anchor& own = stored_region(slot);
  std::array<std::int32_t, 3> anchor = own.position;
  Vec3 velocity = world.velocity(slot, now);
  if (sliding_.are_present()) {
    const SlidingAnchors::Row row = sliding_.row_of(own, copies.paths()[slot], now, copies);
    anchor[0] = sum_on_grid(anchor[0], row.displacement);
    velocity.x -= row.speed;
  }
  return {{copies.apart(anchor, slot, 0), copies.apart(anchor, slot, 1), copies.apart(anchor, slot, 2)},
          velocity};
}

void NeighborList::cross(const World& world, Slot slot, const Time& now, const CompactPaths& copies,
                         Candidates& candidates) {
  if (sliding_.are_present()) [[unlikely]]
    sliding_.keep_near(now);
  points_.erase(table_.list(stored_region(slot).cell), slot);
  move_anchor(world, slot, now, copies);
  find_near(slot, now, copies);
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
    ranges::sort(before);
    ranges::sort(now);
    gained_.clear();
    lost_.clear();
    ranges::set_difference(now, before, std::back_inserter(gained_));
    ranges::set_difference(before, now, std::back_inserter(lost_));
  }
  for (const Slot other : gained_) prefetch(neighbors_.address(other));
  for (const Slot other : lost_) prefetch(neighbors_.address(other));
}

void NeighborList::move_anchor(const World& world, Slot slot, const Time& now, const CompactPaths& copies) {
  Anchor& anchor = stored_region(slot);
  anchor.position = copies.paths()[slot].position;
  const Vec3 position = world.position(slot, now);
  anchor.cell = cells_.cell_of(position);
  if (!sliding_.are_present()) return;
  anchor.expiry = sliding_.expiry_of_new(now);
  const double in_row = sliding_.in_row(anchor, position.x, now);
  anchor.position[0] = copies.steps_along_x(in_row);
  anchor.cell[0] = cells_.cell_along(0, in_row);
}

// The spheres whose shells overlap a sphere's own, from the anchors in the cells around its own; the sphere
// itself is among them if its anchor is stored.
void NeighborList::find_near(Slot slot, const Time& now, const CompactPaths& copies) {
  if (sliding_.are_present()) [[unlikely]]
    note_step(now, copies);
  const std::size_t count = find_cells_around(stored_region(slot), near_.cells);
  // Half of the reach belongs to each sphere, so that rounding is the same from either side.
  const float half = (reach_ + reach_of_slide_ + packing_error_) / 2;
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
  if (table_.is_shared_within(1, stored_region(slot).cell)) [[unlikely]]
    leave_out_far(slot, copies);
}

// Leaves out what was found in cells elsewhere that share a list with one of those around. Of two spheres, if
// the cell of one shares its list, both go by the positions of their anchors, which are not packed.
void NeighborList::leave_out_far(Slot slot, const CompactPaths& copies) {
  Slot* const begin = near_.begin();
  Slot* end = begin + near_.count;
  const auto shares_list = [&](Slot each) { return table_.is_shared_within(0, stored_region(each).cell); };
  const bool is_own_shared = shares_list(slot);
  end = std::remove_if(begin, end, [&](Slot other) {
    return (is_own_shared || shares_list(other)) && !are_near(slot, other, copies);
  });
  std::sort(begin, end);
  near_.count = static_cast<std::size_t>(std::unique(begin, end) - begin);
}

// Whether the shells of two spheres overlap, and their cells touch: on the grid, anchors that are far apart
// may seem near.
bool NeighborList::are_near(Slot a, Slot b, const CompactPaths& copies) const {
  const Anchor& of_b = stored_region(b);
  Anchor of_a = stored_region(a);
  if (sliding_.are_present()) {
    const std::int32_t rows = of_b.cell[1] - of_a.cell[1];
    of_a = seen_from_row(of_a, std::abs(rows) <= 1 ? rows : rows > 0 ? -1 : 1);
  }
  bool do_cells_touch = true;
  float distance_squared = 0;
  for_each_axis([&](auto axis) {
    const Packing& packing = packing_[axis];
    const std::int32_t cell_of_a = of_a.cell[axis];
    const std::int32_t cell_of_b = of_b.cell[axis];
    const std::int32_t rows = std::abs(cell_of_a - cell_of_b);
    do_cells_touch &= rows <= 1 || rows == cells_.period(axis) - 1;
    if (packing.steps_of_cell == 0 || packing.is_outermost(cell_of_a) || packing.is_outermost(cell_of_b))
      return;
    const auto steps =
        static_cast<std::uint32_t>(of_a.position[axis]) - static_cast<std::uint32_t>(of_b.position[axis]);
    const float apart = static_cast<float>(static_cast<std::int32_t>(steps)) * copies.scale().grid[axis];
    distance_squared += apart * apart;
  });
  const float half = (reach_ + reach_of_slide_) / 2;
  const float reach = (half + copies.radius(a)) + (half + copies.radius(b));
  return do_cells_touch && distance_squared < reach * reach;
}

void NeighborList::note_step(const Time& now, const CompactPaths& copies) {
  const double step = sliding_.step_of_list(now);
  step_ = copies.steps_along_x(step);
  step_in_cells_ = step / cells_.edge(0);
}

Anchor NeighborList::seen_from_row(const Anchor& anchor, std::int32_t rows) const {
  if (rows == 0) return anchor;
  const double cells = steps_in_cell(anchor, 0) * packing_[0].cells_of_step - rows * step_in_cells_;
  const auto whole = static_cast<std::int32_t>(cells);
  Anchor seen = anchor;
  seen.position[0] = sum_on_grid(anchor.position[0], rows > 0 ? difference_on_grid(0, step_) : step_);
  seen.cell[0] = cells_.folded(0, anchor.cell[0] + whole - (whole > cells ? 1 : 0));
  return seen;
}

// Each row of cells along each axis contributes to the number of a list and to the offset of its cell.
std::size_t NeighborList::find_cells_around(const Anchor& anchor, CellsAround& around) const {
  using Four = std::uint32_t __attribute__((vector_size(16)));  // modulo 2^32
  static_assert(sizeof(CellNearby) == sizeof(Four));
  struct Rows {
    std::array<Four, 3> parts;
    std::size_t count = 0;
  };
  const auto rows_around = [this](std::size_t axis, const Anchor& seen, std::int32_t first,
                                  std::int32_t last) {
    Rows rows;
    const std::int32_t own = in_cell(seen, axis);
    const bool is_run = table_.is_run(axis, seen.cell[axis] + first, seen.cell[axis] + last);
    std::uint32_t sum = is_run ? table_.part(axis, seen.cell[axis] + first) : 0;
    for (std::int32_t step = first; step <= last; ++step, sum += table_.stride(axis)) {
      if (!is_run) [[unlikely]] {
        const std::int32_t row = seen.cell[axis] + step;
        if (row < cells_.first(axis) || row > cells_.last(axis)) continue;
        sum = table_.part(axis, row);
      }
      Four part{};
      part[0] = sum;
      part[axis + 1] = static_cast<std::uint32_t>(step * packing_[axis].units_of_cell - own);
      rows.parts[rows.count++] = part;
    }
    return rows;
  };
  std::size_t count = 0;
  // Usually there are three rows along x and z, and along y a number that is a constant.
  const auto add = [&](const Rows& x, auto usual_count, const Rows& y, const Rows& z) {
    const auto add_one = [&](const Four& cell) { std::memcpy(&around[count++], &cell, sizeof cell); };
    if ((x.count == 3) & (y.count == usual_count) & (z.count == 3)) [[likely]] {
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < usual_count; ++j) {
          const Four row = x.parts[i] + y.parts[j];
          for (std::size_t k = 0; k < 3; ++k) add_one(row + z.parts[k]);
        }
      }
    } else {
      for (std::size_t i = 0; i < x.count; ++i) {
        for (std::size_t j = 0; j < y.count; ++j) {
          for (std::size_t k = 0; k < z.count; ++k) add_one(x.parts[i] + y.parts[j] + z.parts[k]);
        }
      }
    }
  };
  const Rows z = rows_around(2, anchor, -1, 1);
  if (!sliding_.are_present()) [[likely]] {
    constexpr std::integral_constant<std::size_t, 3> kAll;
    add(rows_around(0, anchor, -1, 1), kAll, rows_around(1, anchor, -1, 1), z);
  } else {
    constexpr std::integral_constant<std::size_t, 1> kOne;
    for (std::int32_t row = -1; row <= 1; ++row)
      add(rows_around(0, seen_from_row(anchor, row), -1, 1), kOne, rows_around(1, anchor, row, row), z);
  }
  if (table_.is_shared()) [[unlikely]] {
    for (std::size_t i = 0; i < count; ++i) around[i].block = table_.list_at(around[i].block);
  }
  return count;
}

// A sphere that touches a cell has its anchor there or in an adjacent one. In a sheared box rows have slid by
// any distance: all of their cells are visited.
void NeighborList::visit_cells(const CellRange& range, const VisitSlots& visit) const {
  CellRange around = range;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    around.low[axis] -= 1;
    around.high[axis] += 1;
  }
  if (sliding_.are_present()) {
    around.low[0] = 0;
    around.high[0] = cells_.period(0) - 1;
  }
  cells_.for_each_folded(cells_.clipped(around), [&](const CellIndex&, const CellIndex& cell) {
    for (std::uint32_t block = table_.list(cell); block != PointLists::kNone; block = points_.next()[block]) {
      std::array<Slot, PointBlock::kRoom> found;
      std::size_t count = 0;
      for (const Slot slot : points_.blocks()[block].slots) {
        found[count] = slot;
        count += slot != PointBlock::kNoSlot ? 1U : 0U;
      }
      visit(std::span(found).first(count));
    }
  });
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
  if (sliding_.are_present()) {
    // Of lists made earlier only what is near by now can be said.
    search.sliding_.look_at_the_present();
    search.reach_of_slide_ = 0;
    search.packing_error_ = -packing_error_;
  }
  for (Slot slot = 0; slot < world.size(); ++slot) {
    CompactPaths present = copies;
    present.copy(world, slot, now);
    const Vec3 position = relative_to_anchor(world, slot, now, present).position;
    HARDBALL_CHECK(length(position) <= skin_ + coordinate_error(world, slot, now));
    search.find_near(slot, now, copies);
    std::size_t others = 0;
    for (const Slot other : search.near_.slots()) {
      if (other == slot) continue;
      HARDBALL_CHECK(is_listed(slot, other) && is_listed(other, slot));
      ++others;
    }
    HARDBALL_CHECK(sliding_.are_present() || neighbors_.size(slot) == others);
    HARDBALL_CHECK(!sliding_.is_expired(stored_region(slot), now));
  }
}

}  // namespace hardball
