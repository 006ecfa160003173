// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "hardball/broadphase/broad_phase.hpp"
#include "hardball/broadphase/cell_table.hpp"
#include "hardball/broadphase/sheared_block.hpp"
#include "hardball/broadphase/sheared_region.hpp"
#include "hardball/broadphase/sliding_rows.hpp"
#include "hardball/broadphase/slot_lists.hpp"
#include "hardball/broadphase/sphere_lines.hpp"
#include "hardball/broadphase/subdivision.hpp"
#include "hardball/memory/prefetch.hpp"

namespace hardball {

/// Cells in a sheared box, whose rows along y slide past each other (SlidingRows): so a sphere moves through
/// cells that move with the flow around it.
///
/// A sphere that fits into a cell is in cells of a ShearedBlock, others are in a ShearedRegion.
class ShearedCells final : public BroadPhase {
 public:
  /// The length is the wanted edge of a cell; others are taken where cells would be too many, or too large
  /// for the box.
  explicit ShearedCells(const PhaseSettings& settings)
      : BroadPhase({.kind = PhaseKind::cells, .has_more_data = true}), wanted_edge_(settings.length) {}

  /// Whether there are cells in which images are always the nearest: in a box that is large enough for the
  /// spheres.
  static bool supports(const World& world, double length) { return allowed_edge(world, length).has_value(); }
  std::unique_ptr<BroadPhase> clone() const override { return std::make_unique<ShearedCells>(*this); }
  PhaseLengths lengths() const override { return {.cell_edges = cells_.edges()}; }

  void build(const World& world, const Time& now, CompactPaths& copies) override;
  void update(const World& world, Slot slot, const Time& now, const Image& folded) override;
  bool keeps(const World& world, Slot slot, const Time& now, const CompactPaths&) const override;
  bool admits(const World& world, Slot slot) const override {
    return world.bounding_radius(slot) <= largest_built_;
  }
  void insert(const World& world, Slot slot, const Time& now, const CompactPaths&) override;
  void erase(Slot slot) override;
  void move(Slot from, Slot to) override;
  void collect_overlapping(const World& world, Slot slot, Candidates& candidates) const override {
    collect(world, slot, candidates);
  }
  void collect(const World& world, Slot slot, Candidates& candidates) const override;
  double next_crossing(const World& world, Slot slot, const Time& now, const CompactPaths&) override;
  void cross(const World& world, Slot slot, const Time& now, const CompactPaths&,
             Candidates& candidates) override;
  bool are_candidates(Slot a, Slot b) const override;
  bool uses_minimum_image() const override { return true; }
  std::size_t cached_spheres() const override { return 50000; }
  void prefetch_more(Slot slot) const override {
    if (!blocks_) prefetch(&regions_[slot]);
  }
  void prefetch_lists(Slot slot, bool) const override {
    for_each_list(slot, [this](std::uint32_t list) { prefetch(lists_.address(list)); });
  }
  void prefetch_candidates(Slot slot, bool, const CompactPaths& copies) const override {
    for_each_list(slot, [&](std::uint32_t list) {
      std::array<Slot, SlotLists::kRoom> found;
      const std::uint32_t count = lists_.copy_first(list, found.data());
      for (std::uint32_t i = 0; i < count; ++i) copies.prefetch(found[i]);
    });
  }
  const Subdivision* search_cells() const override { return &cells_; }
  // Rows have slid by any distance: all of their cells are visited.
  void visit_cells(const CellRange& range, const VisitSlots& visit) const override {
    CellRange rows = range;
    rows.low[0] = 0;
    rows.high[0] = cells_.period(0) - 1;
    cells_.for_each_folded(cells_.clipped(rows), [&](const CellIndex&, const CellIndex& cell) {
      lists_.for_each_line(table_.list(cell), [&](const SlotLists::LineOfSlots& slots, std::uint32_t count) {
        visit(std::span(slots).first(count));
      });
    });
  }
  std::uint64_t left_count() const override { return left_count_; }
  std::size_t memory_bytes() const override;
  void validate(const World& world, const Time& now, const CompactPaths&) const override;

 private:
  ShearedBlock& stored_region(Slot slot) { return lines_[slot].region<ShearedBlock>(); }
  const ShearedBlock& stored_region(Slot slot) const { return lines_[slot].region<ShearedBlock>(); }
  // The edge that is used for a wanted one; nothing if there is none.
  static std::optional<double> allowed_edge(const World& world, double wanted);

  // Calls visit(cell, folded) for each cell that a sphere is in.
  template <class Visit>
  void for_each_cell(Slot slot, Visit&& visit) const {
    if (!blocks_) return for_each_cell_of(regions_[slot], visit);
    const ShearedBlock& block = stored_region(slot);
    CellBlock::for_each_cell(block.cells, [&](std::uint32_t cell) {
      const CellIndex index = block.index(cell);
      visit(index, cells_.folded(index));
    });
  }
  template <class Visit>
  void for_each_cell_of(const ShearedRegion& region, Visit&& visit) const {
    for (std::int32_t row = region.lowest; row <= region.highest(); ++row)
      cells_.for_each_folded(region.cells_in(row), visit);
  }
  // Calls visit(list) for the list of each cell that a sphere is in.
  template <class Visit>
  void for_each_list(Slot slot, Visit&& visit) const {
    if (blocks_) return stored_region(slot).for_each_list(stored_region(slot).cells, table_, visit);
    for_each_cell_of(regions_[slot],
                     [&](const CellIndex&, const CellIndex& folded) { visit(table_.list(folded)); });
  }

  void enter(const World& world, Slot slot, const Time& now);
  void leave(Slot slot);
  // The cells along x that a sphere touches in a row.
  ShearedRegion::Cells cells_in_row(std::int32_t row, double x, double radius, const Time& now) const;
  ShearedRegion region_at(const World& world, Slot slot, const Time& now) const;
  void replace(Slot slot, const ShearedRegion& region);
  double next_crossing_of_region(const World& world, Slot slot, const Time& now);
  void cross_region(const World& world, Slot slot, const Time& now, Candidates& candidates);

  // A sphere as seen from its block: along each direction, by how much its center is beyond the face between
  // lower and upper cells [L], and how fast it moves [L/T].
  struct SeenFromBlock {
    std::array<double, ShearedBlock::kDirections> beyond;
    std::array<double, ShearedBlock::kDirections> velocity;
  };
  SeenFromBlock see(const World& world, Slot slot, const Time& now) const;
  ShearedBlock block_at(const World& world, Slot slot, const Time& now) const;
  std::uint32_t reach_row(ShearedBlock& block, std::uint32_t row, double x, double radius,
                          const Time& now) const;
  void keep(Slot slot, std::uint32_t cells);
  void refresh_block(const World& world, Slot slot, const Time& now);
  double next_crossing_of_block(const World& world, Slot slot, const Time& now);
  void cross_block(const World& world, Slot slot, const Time& now, Candidates& candidates);
  void enter_cells(Slot slot, std::uint32_t cells, Candidates& candidates);

  ShearedRegion region_of(Slot slot) const;
  bool is_in(Slot slot, const CellIndex& index) const;
  bool touches(Slot slot, const CellIndex& folded) const;
  void collect_cell(const CellIndex& folded, Candidates& candidates) const;
  void collect_list(std::uint32_t list, Candidates& candidates) const {
    lists_.for_each_line(list, [&](const SlotLists::LineOfSlots& slots, std::uint32_t count) {
      candidates.add(slots, count);
    });
  }

  double wanted_edge_;
  double largest_built_ = 0;  // the largest radius for which the cells are good
  Subdivision cells_;
  SlidingRows rows_;
  CellTable table_;
  SlotLists lists_;
  // From the face in the middle of a block to the next that a sphere reaches, by axis, if it is in neither
  // half, that ahead, that behind, or both [L].
  std::array<std::array<double, 4>, kAxes> room_{};
  bool blocks_ = false;                 // spheres fit into cells
  LargeVector<ShearedRegion> regions_;  // otherwise, by slot
  std::uint64_t left_count_ = 0;
};

}  // namespace hardball
