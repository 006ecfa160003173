// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "hardball/broadphase/broad_phase.hpp"
#include "hardball/broadphase/cell_store.hpp"
#include "hardball/broadphase/subdivision.hpp"

namespace hardball {

/// The paper's uniform subspaces: space is divided into cells, a sphere belongs to every cell it touches, and
/// spheres that share a cell are candidates.
///
/// Leaving needs no events of its own: cells behind a sphere are given up at its next crossing or change of
/// path. Source: Kim, Guibas and Shin (1997), section 2.
class CellGrid {
 public:
  /// `edge` [L] is the wanted length of a cell's edge; see Subdivision.
  explicit CellGrid(double edge) : wanted_edge_(edge) {}

  /// Error: an edge that is not positive, or cells so small that a sphere would lie in hundreds of them.
  void build(const World& world, const Time& now);
  void refresh(const World& world, Slot slot, const Time& now, const Image& folded);
  Time next_crossing(Slot slot) const { return residents_[slot].crossing; }
  std::uint64_t left_count() const { return left_count_; }
  std::size_t memory_bytes() const;
  void validate(const World& world, const Time& now) const;

  template <class Visit>
  void for_each_candidate(const World&, Slot slot, Visit&& visit) const {
    const CellRange& range = residents_[slot].range;
    for_each_shared_cell(slot, range, [&](const CellIndex& cell, const Occupant& other, const Image& image) {
      const CellRange& others = residents_[other.slot].range;
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        if (!is_lowest_common(axis, cell, range, others, image)) return;
      }
      visit(other.slot, image);
    });
  }

  template <class Visit>
  void cross(const World& world, Slot slot, const Time& now, Visit&& visit) {
    const Resident& resident = residents_[slot];
    const std::size_t crossed = resident.crossed_axis;
    const bool up = resident.crosses_up;
    enter_next_cells(world, slot, now);
    const CellRange& range = resident.range;
    // The spheres met are those in the row of cells entered that do not reach into the rows held before.
    CellRange entered = range;
    (up ? entered.low : entered.high)[crossed] = (up ? range.high : range.low)[crossed];
    for_each_shared_cell(
        slot, entered, [&](const CellIndex& cell, const Occupant& other, const Image& image) {
          const CellRange& others = residents_[other.slot].range;
          for (std::size_t axis = 0; axis < kAxes; ++axis) {
            const std::int32_t beyond = cells_.cells_beyond(axis, image);
            const bool here = axis == crossed ? (up ? others.low : others.high)[axis] + beyond == cell[axis]
                                              : is_lowest_common(axis, cell, range, others, image);
            if (!here) return;
          }
          visit(other.slot, image);
        });
  }

  /// The length of a cell's edge along an axis [L].
  double edge(std::size_t axis) const { return cells_.edge(axis); }
  /// Whether the cells are kept in an array or in a hash table.
  bool is_dense() const { return store_.is_dense(); }

 private:
  // A sphere's region: a range of cells.
  struct Resident {
    CellRange range;
    Time crossing = kNever;
    std::uint8_t crossed_axis = 0;
    bool crosses_up = false;
  };

  // Calls visit(cell, occupant, image of the occupant) for all others in the cells of a range.
  template <class Visit>
  void for_each_shared_cell(Slot slot, const CellRange& range, Visit&& visit) const {
    range.for_each([&](const CellIndex& cell) {
      CellIndex folded = cell;
      const Image boxes = cells_.fold(folded);
      store_.for_each(folded, [&](const Occupant& other) {
        if (other.slot != slot) visit(cell, other, boxes - other.boxes);
      });
    });
  }

  // A pair may share several cells; it is visited in the lowest one along each axis.
  bool is_lowest_common(std::size_t axis, const CellIndex& cell, const CellRange& range,
                        const CellRange& others, const Image& image) const {
    return cell[axis] == std::max(range.low[axis], others.low[axis] + cells_.cells_beyond(axis, image));
  }

  void refuse_tiny_cells(const World& world) const;
  void enter_next_cells(const World& world, Slot slot, const Time& now);
  CellRange range_at(const World& world, Slot slot, const Time& now) const;
  void set_next_crossing(const World& world, Slot slot, const Time& now);
  void insert(Slot slot, const CellIndex& cell);
  void erase(Slot slot, const CellIndex& cell);
  void move(Slot slot, const CellRange& range);

  double wanted_edge_;
  Subdivision cells_;
  CellStore store_;
  std::vector<Resident> residents_;
  std::uint64_t left_count_ = 0;
};

static_assert(BroadPhase<CellGrid>);

}  // namespace hardball
