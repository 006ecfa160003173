// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "hardball/broadphase/broad_phase.hpp"
#include "hardball/broadphase/cell_block.hpp"
#include "hardball/broadphase/cell_region.hpp"
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
class CellGrid : public BroadPhase {
 public:
  /// The length is the wanted edge of a cell; see Subdivision.
  explicit CellGrid(const PhaseSettings& settings)
      : BroadPhase({.kind = PhaseKind::cells}), wanted_edge_(settings.length), expected_(settings.expected) {}

  /// A grid of spheres whose radius is at most `largest_radius` [L]. Another broad phase adds the others as
  /// guests; their candidates are at most `farthest` [L] away.
  CellGrid(const PhaseSettings& settings, double largest_radius, double farthest)
      : BroadPhase({.kind = PhaseKind::cells}),
        wanted_edge_(settings.length),
        expected_(settings.expected),
        largest_radius_(largest_radius),
        farthest_of_guests_(farthest) {}

  static bool supports(const World& world, double) { return !world.box().is_sheared(); }
  std::unique_ptr<BroadPhase> clone() const override { return std::make_unique<CellGrid>(*this); }
  PhaseLengths lengths() const override { return {.cell_edges = cells_.edges()}; }

  /// Error: the edge is not positive, or so small that a sphere would lie in hundreds of cells.
  void build(const World& world, const Time& now, CompactPaths& copies) override;
  void update(const World& world, Slot slot, const Time& now, const Image& folded) override;
  bool keeps(const World& world, Slot slot, const Time& now, const CompactPaths&) const override {
    const CellRange exact = range_at(world, slot, now);
    const CellRange own = stored_region(slot).range();
    return own.contains(exact.low) && own.contains(exact.high);
  }
  bool admits(const World& world, Slot slot) const override;
  void insert(const World& world, Slot slot, const Time& now, const CompactPaths&) override;
  void erase(Slot slot) override;
  void move(Slot from, Slot to) override;
  void collect_overlapping(const World& world, Slot slot, Candidates& candidates) const override {
    collect(world, slot, candidates);
  }
  void collect(const World& world, Slot slot, Candidates& candidates) const override {
    if (!blocks_) return collect_from(world, slot, stored_region(slot).range(), candidates);
    candidates.begin(slot, true);
    block_of(stored_region(slot))
        .for_each_list(CellBlock::cells_above(0, stored_region(slot).wide_axes()),
                       [&](std::uint32_t list) { collect_list(list, candidates); });
    candidates.end();
  }
  double next_crossing(const World& world, Slot slot, const Time& now, const CompactPaths& copies) override;
  void cross(const World& world, Slot slot, const Time& now, const CompactPaths&,
             Candidates& candidates) override;
  std::size_t cached_spheres() const override { return 50000; }  // measured
  void prefetch_lists(Slot slot, bool crosses) const override {
    if (!is_prefetched(slot)) return;
    const auto prefetch_list = [this](std::uint32_t list) { prefetch(lists_.address(list)); };
    for_each_list(stored_region(slot).range(), prefetch_list);
    if (crosses) for_each_list(stored_region(slot).row_ahead(), prefetch_list);
  }
  void prefetch_candidates(Slot slot, bool crosses, const CompactPaths& copies) const override {
    if (!is_prefetched(slot)) return;
    const CellRegion& region = stored_region(slot);
    // Gathered first: in one loop the processor need not guess how long each list is.
    constexpr std::size_t kMax = 8 * SlotLists::kRoom;
    Slot found[kMax + SlotLists::kRoom];
    std::size_t count = 0;
    for_each_list(crosses ? region.row_ahead() : region.range(), [&](std::uint32_t list) {
      count = std::min(kMax, count + lists_.copy_first(list, found + count));
    });
    for (std::size_t i = 0; i < count; ++i) copies.prefetch(found[i]);
  }
  const Subdivision* search_cells() const override { return &cells_; }
  void visit_cells(const CellRange& range, const VisitSlots& visit) const override {
    cells_.for_each_folded(cells_.clipped(range), [&](const CellIndex&, const CellIndex& cell) {
      lists_.for_each_line(table_.list(cell), [&](const SlotLists::LineOfSlots& slots, std::uint32_t count) {
        visit(std::span(slots).first(count));
      });
    });
  }
  std::uint64_t left_count() const override { return left_count_; }
  std::size_t memory_bytes() const override;
  void validate(const World& world, const Time& now, const CompactPaths&) const override;

  /// Whether images that share a cell are always the nearest images.
  bool uses_minimum_image() const override { return nearest_; }
  bool are_candidates(Slot a, Slot b) const override;

  const Subdivision& cells() const { return cells_; }
  /// Whether a sphere's region contains a cell folded into the box.
  bool is_in(Slot slot, const CellIndex& cell) const;
  /// Whether cells share lists, so that a cell also has the spheres of others.
  bool shares_lists() const { return table_.is_shared(); }
  /// Calls visit(slots, count) for the spheres and guests in a cell folded into the box, as many as fit into
  /// a cache line at a time; the array is longer than count.
  template <class Visit>
  void for_each_line(const CellIndex& cell, Visit&& visit) const {
    lists_.for_each_line(table_.list(cell), visit);
  }
  /// Adds a sphere that the grid itself leaves out to a cell folded into the box, or removes it.
  void insert_guest(const CellIndex& cell, Slot slot) { lists_.insert(table_.list(cell), slot); }
  void erase_guest(const CellIndex& cell, Slot slot) { lists_.erase(table_.list(cell), slot); }

 private:
  CellRegion& stored_region(Slot slot) { return lines_[slot].region<CellRegion>(); }
  const CellRegion& stored_region(Slot slot) const { return lines_[slot].region<CellRegion>(); }
  // Large spheres in small cells touch too many.
  bool is_prefetched(Slot slot) const {
    constexpr std::uint32_t kMaxCells = 27;
    const auto& more = stored_region(slot).more;
    return (more[0] + 1U) * (more[1] + 1U) * (more[2] + 1U) <= kMaxCells;
  }
  // Calls visit(list) for each cell of a range, which is part of a block if regions are blocks.
  template <class Visit>
  HARDBALL_ALWAYS_INLINE void for_each_list(const CellRange& range, Visit&& visit) const {
    if (!blocks_) {
      return cells_.for_each_folded(
          range, [&](const CellIndex&, const CellIndex& cell) { visit(table_.list(cell)); });
    }
    std::uint32_t wide = 0;
    for_each_axis([&](auto axis) { wide |= CellBlock::axis_if(range.high[axis] > range.low[axis], axis); });
    CellBlock(table_, range.low).for_each_list(CellBlock::cells_above(0, wide), visit);
  }
  double next_crossing_of_any(const World& world, Slot slot, const Time& now);
  // The position on the grid of CompactPaths of the lower face of the cells with this index.
  std::int32_t face_position(std::size_t axis, std::int32_t index) const {
    const std::uint64_t steps = static_cast<std::uint64_t>(std::int64_t{index}) * steps_of_cell_[axis];
    return static_cast<std::int32_t>(steps >> 32);
  }
  void refuse_tiny_cells(const World& world) const;
  bool images_are_nearest() const;
  double farthest_candidates() const;
  void enter(const World& world, Slot slot, const Time& now);
  CellRange range_at(const World& world, Slot slot, const Time& now) const;
  void refresh_range(const World& world, Slot slot, const Time& now, const Image& folded);
  void cross_range(const World& world, Slot slot, const Time& now, Candidates& candidates);
  void collect_from(const World& world, Slot slot, const CellRange& range, Candidates& candidates) const;
  void collect_images(const World& world, Slot other, Candidates& candidates) const;
  bool fits_into_cells(double radius) const;
  HARDBALL_ALWAYS_INLINE CellBlock block_of(const CellRegion& region) const {
    return CellBlock(table_, region.low);
  }
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
  bool holds(const World& world, Slot slot) const { return world.bounding_radius(slot) <= largest_radius_; }

  double wanted_edge_;
  Extent expected_;
  double largest_radius_ = std::numeric_limits<double>::infinity();
  double farthest_of_guests_ = 0;
  double largest_built_ = 0;  // the largest radius in the grid when it was built
  Subdivision cells_;
  CellTable table_;
  SlotLists lists_;
  std::array<std::uint64_t, kAxes> steps_of_cell_{};  // of the grid of CompactPaths, times 2^32
  std::array<float, kAxes> margin_{};                 // of the cells, in units of the compact paths
  bool is_single_precise_ = false;
  bool nearest_ = false;
  bool blocks_ = false;  // regions are sets of cells of a block
  std::uint64_t left_count_ = 0;
};

}  // namespace hardball
