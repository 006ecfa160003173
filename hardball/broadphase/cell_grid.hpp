// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "hardball/broadphase/broad_phase.hpp"
#include "hardball/broadphase/cell_block.hpp"
#include "hardball/broadphase/cell_table.hpp"
#include "hardball/broadphase/slot_lists.hpp"
#include "hardball/broadphase/sphere_lines.hpp"
#include "hardball/broadphase/subdivision.hpp"
#include "hardball/memory/prefetch.hpp"

namespace hardball {

/// The paper's uniform subspaces: space is divided into cells, a sphere belongs to every cell it touches, and
/// spheres that share a cell are candidates.
///
/// Leaving needs no events: cells behind a sphere are released at its next crossing or change of path.
/// Source: Kim, Guibas and Shin (1997), section 2.
class CellGrid {
 public:
  /// `edge` [L] is the wanted length of a cell's edge; see Subdivision.
  explicit CellGrid(double edge) : wanted_edge_(edge) {}

  /// A grid of spheres whose radius is at most `largest_radius` [L]. Another broad phase adds the others to
  /// its cells; their candidates are at most `farthest` [L] away.
  CellGrid(double edge, double largest_radius, double farthest)
      : wanted_edge_(edge), largest_radius_(largest_radius), farthest_of_others_(farthest) {}

  /// Error: the edge is not positive, or so small that a sphere would lie in hundreds of cells.
  void build(const World& world, const Time& now, CompactPaths& copies);
  void refresh(const World& world, Slot slot, const Time& now, const Image& folded);
  bool admits(const World& world, Slot slot) const;
  void insert(const World& world, Slot slot, const Time& now, const CompactPaths&);
  void erase(Slot slot);
  void move(Slot from, Slot to);
  void collect_overlapping(const World& world, Slot slot, Candidates& candidates) const {
    collect(world, slot, candidates);
  }
  void collect(const World& world, Slot slot, Candidates& candidates) const {
    if (!blocks_) return collect_from(world, slot, lines_[slot].region.range(), candidates);
    candidates.begin(slot, true);
    block_of(lines_[slot].region)
        .for_each_list(CellBlock::cells_above(0, lines_[slot].region.wide_axes()),
                       [&](std::uint32_t list) { collect_list(list, candidates); });
    candidates.end();
  }
  double next_crossing(const World& world, Slot slot, const Time& now, const CompactPaths& copies);
  void cross(const World& world, Slot slot, const Time& now, const CompactPaths&, Candidates& candidates);
  static constexpr std::size_t kCachedSpheres = 50000;  // measured
  void prefetch_region(Slot slot) const { prefetch(&lines_[slot]); }
  void prefetch_lists(Slot slot, bool crosses) const {
    if (!is_prefetched(slot)) return;
    const auto prefetch_list = [this](std::uint32_t list) { prefetch(lists_.address(list)); };
    for_each_list(lines_[slot].region.range(), prefetch_list);
    if (crosses) for_each_list(lines_[slot].region.row_ahead(), prefetch_list);
  }
  void prefetch_candidates(Slot slot, bool crosses, const CompactPaths& copies) const {
    if (!is_prefetched(slot)) return;
    const Region& region = lines_[slot].region;
    // Gathered first: in one loop the processor need not guess how long each list is.
    constexpr std::size_t kMost = 8 * SlotLists::kRoom;
    Slot found[kMost + SlotLists::kRoom];
    std::size_t count = 0;
    for_each_list(crosses ? region.row_ahead() : region.range(), [&](std::uint32_t list) {
      count = std::min(kMost, count + lists_.copy_first(list, found + count));
    });
    for (std::size_t i = 0; i < count; ++i) copies.prefetch(found[i]);
  }
  std::uint64_t left_count() const { return left_count_; }
  std::size_t memory_bytes() const;
  void validate(const World& world, const Time& now, const CompactPaths&) const;

  /// The length of a cell's edge along an axis [L].
  double edge(std::size_t axis) const { return cells_.edge(axis); }
  /// Whether images that share a cell are always the nearest images.
  bool uses_minimum_image() const { return nearest_; }
  bool are_candidates(Slot a, Slot b) const;
  auto& lines() { return lines_; }
  const auto& lines() const { return lines_; }
  /// Whether a sphere's region contains a cell folded into the box.
  bool is_in(Slot slot, const CellIndex& cell) const;

  /// The cells, and the list of the spheres in each.
  const Subdivision& cells() const { return cells_; }
  std::uint32_t list(const CellIndex& cell) const { return table_.list(cell); }
  const SlotLists& lists() const { return lists_; }
  bool shares_lists() const { return table_.is_shared(); }
  /// To add spheres that the grid itself leaves out.
  SlotLists& lists_to_edit() { return lists_; }

 private:
  // A sphere's region, a range of cells, and the face through which it will be left.
  struct Region {
    CellIndex low{};
    std::array<std::uint16_t, kAxes> more{};  // cells beyond the lowest
    std::uint8_t crossed_face = 0;

    CellRange range() const { return {low, {low[0] + more[0], low[1] + more[1], low[2] + more[2]}}; }
    // The row of cells that the sphere enters next.
    CellRange row_ahead() const {
      CellRange row = range();
      const std::size_t axis = axis_of(crossed_face);
      row.low[axis] = row.high[axis] = is_upper(crossed_face) ? row.high[axis] + 1 : row.low[axis] - 1;
      return row;
    }
    void take(const CellRange& range);
    // If regions are blocks: the axes along which this one is two cells wide.
    std::uint32_t wide_axes() const { return (more[0] * 4U + more[1] * 2U) + more[2]; }
  };

  // Large spheres in small cells touch too many.
  bool is_prefetched(Slot slot) const {
    constexpr std::uint32_t kMostCells = 27;
    const auto& more = lines_[slot].region.more;
    return (more[0] + 1U) * (more[1] + 1U) * (more[2] + 1U) <= kMostCells;
  }
  // Calls visit(list) for each cell of a range, which is part of a block if regions are blocks.
  template <class Visit>
  void for_each_list(const CellRange& range, Visit&& visit) const {
    if (!blocks_) {
      return cells_.for_each_folded(
          range, [&](const CellIndex&, const CellIndex& cell) { visit(table_.list(cell)); });
    }
    std::uint32_t wide = 0;
    for_each_axis([&](auto axis) { wide |= CellBlock::axis_if(range.high[axis] > range.low[axis], axis); });
    CellBlock(cells_, range.low, table_).for_each_list(CellBlock::cells_above(0, wide), visit);
  }
  double next_crossing_of_any(const World& world, Slot slot, const Time& now);
  // The place on the grid of CompactPaths of the lower face of the cells with this index.
  std::int32_t face_place(std::size_t axis, std::int32_t index) const {
    const std::uint64_t steps = static_cast<std::uint64_t>(std::int64_t{index}) * steps_of_cell_[axis];
    return static_cast<std::int32_t>(steps >> 32);
  }
  void refuse_tiny_cells(const World& world) const;
  // The cells that a sphere of this radius touches at most along an axis.
  double most_touched(double radius, std::size_t axis) const {
    return most_cells_touched(2 * cells_.reach(axis, radius), cells_.edge(axis));
  }
  bool images_are_nearest() const;
  double farthest_candidates() const;
  void enter(const World& world, Slot slot, const Time& now);
  CellRange range_at(const World& world, Slot slot, const Time& now) const;
  void refresh_range(const World& world, Slot slot, const Time& now, const Image& folded);
  void cross_range(const World& world, Slot slot, const Time& now, Candidates& candidates);
  void collect_from(const World& world, Slot slot, const CellRange& range, Candidates& candidates) const;
  void collect_images(const World& world, Slot other, Candidates& candidates) const;
  bool fits_into_cells(double radius) const;
  CellBlock block_of(const Region& region) const { return CellBlock(cells_, region.low, table_); }
  void collect_list(std::uint32_t list, Candidates& candidates) const {
    lists_.for_each_line(list, [&](const SlotLists::LineOfSlots& slots, std::uint32_t count) {
      candidates.add(slots, count);
    });
  }
  void refresh_block(const World& world, Slot slot, const Time& now, const Image& folded);
  void cross_block(const World& world, Slot slot, const Time& now, Candidates& candidates);
  void leave_halves(Slot slot, std::uint32_t axes, std::uint32_t up);
  void leave(Slot slot, const CellRange& old, const CellRange& kept);

  // Whether the grid has a region for the sphere.
  bool holds(const World& world, Slot slot) const { return world.radius(slot) <= largest_radius_; }
  double wanted_edge_;
  double largest_radius_ = std::numeric_limits<double>::infinity();
  double farthest_of_others_ = 0;
  double largest_built_ = 0;  // the largest radius in the grid when it was built
  Subdivision cells_;
  CellTable table_;
  SlotLists lists_;
  SphereLines<Region> lines_;
  std::array<std::uint64_t, kAxes> steps_of_cell_{};  // of the grid of CompactPaths, times 2^32
  std::array<float, kAxes> margin_{};                 // of the cells, in units of the compact paths
  bool is_single_precise_ = false;
  bool nearest_ = false;
  bool blocks_ = false;  // regions are sets of cells of a block
  std::uint64_t left_count_ = 0;
};

static_assert(BroadPhase<CellGrid>);

}  // namespace hardball
