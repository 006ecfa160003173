// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include "hardball/broadphase/broad_phase.hpp"
#include "hardball/broadphase/cell_table.hpp"
#include "hardball/broadphase/sliding_rows.hpp"
#include "hardball/broadphase/slot_lists.hpp"
#include "hardball/broadphase/sphere_lines.hpp"
#include "hardball/broadphase/subdivision.hpp"
#include "hardball/memory/prefetch.hpp"

namespace hardball {

/// The cells that a sphere touches in a sheared box, counted along its path: in each row along x, as seen
/// from there.
struct ShearedRegion {
  static constexpr std::size_t kMostRows = 8;

  /// The cells of one row.
  struct Cells {
    std::int32_t first = 0;
    std::int32_t last = 0;

    bool contains(std::int32_t cell) const { return first <= cell && cell <= last; }
    friend bool operator==(const Cells&, const Cells&) = default;
  };

  std::int32_t lowest = 0;       ///< Row along y.
  std::uint8_t count = 0;        ///< Of rows; none if there is no region.
  std::uint8_t crossed_row = 0;  ///< In which the next crossing is, counted from the lowest.
  std::uint8_t crossed_face = 0;
  Cells depths;                        ///< Along z.
  std::array<Cells, kMostRows> along;  ///< Of each row, along x.

  std::int32_t highest() const { return lowest + count - 1; }
  bool has_row(std::int32_t row) const { return lowest <= row && row <= highest(); }
  /// Precondition: has_row(row).
  Cells& in_row(std::int32_t row) { return along[static_cast<std::size_t>(row - lowest)]; }
  const Cells& in_row(std::int32_t row) const { return along[static_cast<std::size_t>(row - lowest)]; }
  /// The cells of a row in space. Precondition: likewise.
  CellRange cells_in(std::int32_t row) const {
    return {{in_row(row).first, row, depths.first}, {in_row(row).last, row, depths.last}};
  }
  bool contains(const CellIndex& cell) const {
    return has_row(cell[1]) && in_row(cell[1]).contains(cell[0]) && depths.contains(cell[2]);
  }
  /// Whether the cells are the same.
  friend bool operator==(const ShearedRegion& a, const ShearedRegion& b) {
    if (a.lowest != b.lowest || a.count != b.count || a.depths != b.depths) return false;
    for (std::size_t i = 0; i < a.count; ++i) {
      if (a.along[i] != b.along[i]) return false;
    }
    return true;
  }
};

/// Cells in a sheared box, whose rows along y slide past each other (SlidingRows): so a sphere moves through
/// cells that move with the flow around it.
class ShearedCells : public WithSphereLines<std::uint32_t> {  // its own regions do not fit into a line
 public:
  /// The length is the wanted edge of a cell; others are taken where cells would be too many, or too large
  /// for the box.
  explicit ShearedCells(const PhaseSettings& settings) : wanted_edge_(settings.length) {}

  /// Whether there are cells in which images are always the nearest: in a box that is large enough for the
  /// spheres.
  static bool supports(const World& world, double length) { return allowed_edge(world, length).has_value(); }
  PhaseLengths lengths() const { return {.cell_edges = cells_.edges()}; }

  void build(const World& world, const Time& now, CompactPaths& copies);
  void refresh(const World& world, Slot slot, const Time& now, const Image& folded);
  bool keeps(const World& world, Slot slot, const Time& now, const CompactPaths&) const;
  bool admits(const World& world, Slot slot) const { return world.bounding_radius(slot) <= largest_built_; }
  void insert(const World& world, Slot slot, const Time& now, const CompactPaths&);
  void erase(Slot slot);
  void move(Slot from, Slot to);
  void collect_overlapping(const World& world, Slot slot, Candidates& candidates) const {
    collect(world, slot, candidates);
  }
  void collect(const World& world, Slot slot, Candidates& candidates) const;
  double next_crossing(const World& world, Slot slot, const Time& now, const CompactPaths&);
  void cross(const World& world, Slot slot, const Time& now, const CompactPaths&, Candidates& candidates);
  bool are_candidates(Slot a, Slot b) const;
  bool uses_minimum_image() const { return true; }
  static constexpr std::size_t kCachedSpheres = 50000;
  void prefetch_region(Slot slot) const {
    prefetch(&lines_[slot]);
    prefetch(&regions_[slot]);
  }
  void prefetch_lists(Slot slot, bool) const {
    for_each_list(regions_[slot], [this](std::uint32_t list) { prefetch(lists_.address(list)); });
  }
  void prefetch_candidates(Slot slot, bool, const CompactPaths& copies) const {
    for_each_list(regions_[slot], [&](std::uint32_t list) {
      std::array<Slot, SlotLists::kRoom> found;
      const std::uint32_t count = lists_.copy_first(list, found.data());
      for (std::uint32_t i = 0; i < count; ++i) copies.prefetch(found[i]);
    });
  }
  std::uint64_t left_count() const { return left_count_; }
  std::size_t memory_bytes() const;
  void validate(const World& world, const Time& now, const CompactPaths&) const;

 private:
  // The edge that is used for a wanted one; nothing if there is none.
  static std::optional<double> allowed_edge(const World& world, double wanted);

  // Calls visit(cell, folded) for each cell of a region.
  template <class Visit>
  void for_each_cell(const ShearedRegion& region, Visit&& visit) const {
    for (std::int32_t row = region.lowest; row <= region.highest(); ++row)
      cells_.for_each_folded(region.cells_in(row), visit);
  }
  // Calls visit(list) for the list of each cell of a region.
  template <class Visit>
  void for_each_list(const ShearedRegion& region, Visit&& visit) const {
    for_each_cell(region, [&](const CellIndex&, const CellIndex& folded) { visit(table_.list(folded)); });
  }

  // The cells along x that a sphere touches in a row.
  ShearedRegion::Cells cells_in_row(std::int32_t row, double x, double radius, const Time& now) const;
  ShearedRegion region_at(const World& world, Slot slot, const Time& now) const;
  void replace(Slot slot, const ShearedRegion& region);
  bool touches(Slot slot, const CellIndex& folded) const;
  void collect_cell(const CellIndex& folded, Candidates& candidates) const;

  double wanted_edge_;
  double largest_built_ = 0;  // the largest radius for which the cells are good
  Subdivision cells_;
  SlidingRows rows_;
  CellTable table_;
  SlotLists lists_;
  LargeVector<ShearedRegion> regions_;
  std::uint64_t left_count_ = 0;
};

static_assert(BroadPhase<ShearedCells>);

}  // namespace hardball
