// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "hardball/broadphase/broad_phase.hpp"
#include "hardball/broadphase/cell_table.hpp"
#include "hardball/broadphase/slot_lists.hpp"
#include "hardball/broadphase/sphere_lines.hpp"
#include "hardball/broadphase/subdivision.hpp"
#include "hardball/memory/prefetch.hpp"

namespace hardball {

/// The cells that a sphere touches in a sheared box, counted along its path.
///
/// Images of the box lie in layers, numbered upwards from the one in which the path began. The cells of each
/// layer slide with it, so those of two layers are displaced along x against each other; a sphere that
/// touches two layers has a range of cells in each, and never touches more.
struct ShearedRegion {
  /// The cells in one layer.
  struct Part {
    std::int32_t layer = 0;
    CellRange range;

    friend bool operator==(const Part&, const Part&) = default;
  };

  std::array<Part, 2> parts{};
  std::uint8_t count = 0;         ///< Of parts, one above the other.
  std::uint8_t crossed_part = 0;  ///< In which the next crossing is.
  std::uint8_t crossed_face = 0;

  std::int32_t lowest_row() const { return parts[0].range.low[1]; }
  std::int32_t highest_row() const { return parts[count - 1U].range.high[1]; }
  /// The part in a layer; null if there is none.
  const Part* part_in(std::int32_t layer) const {
    for (std::size_t i = 0; i < count; ++i) {
      if (parts[i].layer == layer) return &parts[i];
    }
    return nullptr;
  }
  /// Whether the cells are the same.
  friend bool operator==(const ShearedRegion& a, const ShearedRegion& b) {
    return a.count == b.count && std::equal(a.parts.begin(), a.parts.begin() + a.count, b.parts.begin());
  }
  bool contains(std::int32_t layer, const CellIndex& cell) const {
    const Part* const part = part_in(layer);
    return part != nullptr && part->range.contains(cell);
  }
};

/// Cells in a sheared box (world/shear.hpp), whose images above and below slide along x.
///
/// Each cell has two lists. One has the spheres that touch it in the layer in which their paths began, at
/// home; the other has guests, spheres that touch it in another layer, with their images. Spheres that are at
/// home in the same cell meet as in a box at rest; all others that share a cell meet across a face, and are
/// few. So the work for a sphere does not depend on the size of the box, nor on how far images have slid.
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
  void collect_overlapping(const World& world, Slot slot, Candidates& candidates) const;
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

  // The lists of the cells of a part at home are the first, those of guests follow.
  std::uint32_t first_list(const ShearedRegion::Part& part) const {
    return part.layer == 0 ? 0 : guests_from_;
  }
  // Calls visit(list) for the list of each cell that has the sphere of a region.
  template <class Visit>
  void for_each_list(const ShearedRegion& region, Visit&& visit) const {
    for (std::size_t i = 0; i < region.count; ++i) {
      const std::uint32_t first = first_list(region.parts[i]);
      cells_.for_each_folded(region.parts[i].range, [&](const CellIndex&, const CellIndex& folded) {
        visit(first + table_.list(folded));
      });
    }
  }

  Vec3 in_layer(const World& world, const Vec3& position, std::int32_t layer, const Time& now) const;
  Vec3 velocity_in_layer(const World& world, Slot slot, std::int32_t layer) const;
  std::int32_t layer_of(std::int32_t row) const;
  template <class RangeIn>
  ShearedRegion divided(std::int32_t lowest_row, std::int32_t highest_row, RangeIn&& range_in) const;
  ShearedRegion region_at(const World& world, Slot slot, const Time& now) const;
  void replace(Slot slot, const ShearedRegion& region);
  bool touches(Slot slot, const CellIndex& folded) const;
  void collect_cell(std::int32_t layer, const CellIndex& folded, Candidates& candidates) const;

  double wanted_edge_;
  double largest_built_ = 0;  // the largest radius for which the cells are good
  Subdivision cells_;
  CellTable table_;
  SlotLists lists_;
  std::uint32_t guests_from_ = 0;
  std::vector<std::uint32_t> guests_in_row_;  // how often there are guests in each row along y
  std::int32_t boxes_slid_ = 0;               // by the image above, when the cells were made
  LargeVector<ShearedRegion> regions_;
  std::uint64_t left_count_ = 0;
};

static_assert(BroadPhase<ShearedCells>);

}  // namespace hardball
