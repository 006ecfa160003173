// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "hardball/broadphase/broad_phase.hpp"
#include "hardball/broadphase/cell_store.hpp"
#include "hardball/broadphase/padded_lists.hpp"
#include "hardball/broadphase/subdivision.hpp"
#include "hardball/kernels/kernels.hpp"
#include "hardball/memory/prefetch.hpp"

namespace hardball {

/// A neighbour list for each sphere, for dense systems, where spheres are caged by their neighbours.
///
/// A sphere's region is a ball around its anchor, a past position of its centre. Spheres are in each other's
/// lists if the shells around their anchors overlap; a shell's radius is the sphere's plus the ball's. When a
/// sphere reaches the edge of its ball, its anchor moves to its centre, and its list and those of its
/// neighbours are updated. Anchors are found by a cell list. Source: Donev, Torquato and Stillinger, J.
/// Comput. Phys. 202 (2005) 737, section 3.
class NeighborList {
 public:
  /// `slack` [L] is the wanted radius of the ball in which a sphere's centre moves; small boxes reduce it.
  /// Precondition: suits(world). Error: the instruction set is not available.
  explicit NeighborList(double slack, InstructionSet instructions = widest_instruction_set())
      : wanted_slack_(slack), instructions_(instructions), pick_near_(kernels_of(instructions).pick_near) {}

  /// Whether neighbours can be listed: a periodic box must be so large that of a neighbour only one image is
  /// near.
  static bool suits(const World& world);

  void build(const World& world, const Time& now, CompactPaths& copies);
  void refresh(const World&, Slot, const Time&, const Image&) {}
  void collect(const World&, Slot slot, Candidates& candidates) const {
    candidates.begin(slot, true);
    candidates.refer_to(list_of(slot), anchors_[slot].count);
  }
  double next_crossing(const World& world, Slot slot, const Time& now, const CompactPaths& copies) const {
    const CompactPath& path = copies.paths()[slot];
    const auto& anchor = anchors_[slot].place;
    float outwards = 0;
    float speed_squared = 1e-30F;  // of a sphere at rest the wait is finite, but longer than any copy is good
    float room = room_squared_;
    for_each_axis([&](auto axis) {
      const auto steps =
          static_cast<std::uint32_t>(path.place[axis]) - static_cast<std::uint32_t>(anchor[axis]);
      const float place = static_cast<float>(static_cast<std::int32_t>(steps)) * copies.scale().grid[axis];
      outwards += place * path.velocity[axis];
      speed_squared += path.velocity[axis] * path.velocity[axis];
      room -= place * place;
    });
    // Of a sphere too fast to be bounded, nothing is known.
    if (!(speed_squared >= 0)) [[unlikely]]
      return next_crossing_of_any(world, slot, now, copies);
    const float root = std::sqrt(outwards * outwards + speed_squared * std::max(room, 0.0F));
    return rounded_down(now) + copies.time_unit() * static_cast<double>((root - outwards) / speed_squared);
  }
  bool has_nearest_images() const { return true; }
  void cross(const World& world, Slot slot, const Time& now, const CompactPaths& copies,
             Candidates& candidates);
  void prefetch_region(Slot slot) const {
    prefetch(neighbors_.address(slot));
    prefetch(&anchors_[slot]);
  }
  void prefetch_lists(Slot slot, bool crosses) const {
    if (!crosses || !store_.is_dense()) return;
    for_each_list_around(anchors_[slot].cell,
                         [this](std::uint32_t list) { prefetch(store_.lists().address(list)); });
  }
  void prefetch_candidates(Slot slot, bool crosses, const CompactPaths& copies) const {
    const Slot* const list = list_of(slot);
    for (std::uint32_t i = 0; i < anchors_[slot].count; ++i) copies.prefetch(list[i]);
    if (!crosses || !store_.is_dense()) return;
    for_each_list_around(anchors_[slot].cell, [this](std::uint32_t around) {
      store_.lists().for_each_first(around, [this](Slot other) { prefetch(&anchors_[other]); });
    });
  }
  std::uint64_t left_count() const { return 0; }
  std::size_t memory_bytes() const;
  void validate(const World& world, const Time& now, const CompactPaths& copies) const;

  double slack() const { return slack_; }
  InstructionSet instructions() const { return instructions_; }

 private:
  double next_crossing_of_any(const World& world, Slot slot, const Time& now,
                              const CompactPaths& copies) const;
  void move_anchor(const World& world, Slot slot, const Time& now, const CompactPaths& copies);
  void find_near(Slot slot, const CompactPaths& copies);
  std::size_t collect_around(const CellIndex& center);

  // Calls visit(list) for the anchors in each of the 27 cells around one.
  template <class Visit>
  void for_each_list_around(const CellIndex& center, Visit&& visit) const {
    std::array<std::array<std::int32_t, 3>, kAxes> rows;
    std::array<std::size_t, kAxes> row_count{};
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      for (std::int32_t row = center[axis] - 1; row <= center[axis] + 1; ++row) {
        if (row < cells_.first(axis) || row > cells_.last(axis)) continue;
        rows[axis][row_count[axis]++] = cells_.folded(axis, row);
      }
    }
    for (std::size_t x = 0; x < row_count[0]; ++x) {
      for (std::size_t y = 0; y < row_count[1]; ++y) {
        if (store_.is_dense()) {
          const std::uint32_t row = store_.list({rows[0][x], rows[1][y], 0});
          for (std::size_t z = 0; z < row_count[2]; ++z) visit(row + static_cast<std::uint32_t>(rows[2][z]));
        } else {
          for (std::size_t z = 0; z < row_count[2]; ++z) {
            visit(store_.list({rows[0][x], rows[1][y], rows[2][z]}));
          }
        }
      }
    }
  }
  void find_changes(Slot slot);
  const Slot* list_of(Slot slot) const { return neighbors_.slots(slot, anchors_[slot].count); }
  void insert(Slot list, Slot slot) { neighbors_.insert(list, anchors_[list].count, slot); }

  double wanted_slack_;
  InstructionSet instructions_;
  NearKernel pick_near_;
  double slack_ = 0;
  float reach_ = 0;         // of shells beyond the radii, in units of the compact paths
  float room_squared_ = 0;  // likewise, of room_
  double room_ = 0;         // the distance from its anchor at which a centre crosses
  Subdivision cells_;
  CellStore store_;                 // anchors
  LargeVector<GridPoint> anchors_;  // by slot
  std::uint32_t round_ = 0;         // of marks: see find_changes
  PaddedLists neighbors_;           // by slot; their lengths are in the anchors
  // Of the current sphere:
  std::vector<Slot> around_;         // those whose anchors lie in the 27 cells around its own
  std::vector<Slot> near_;           // its new neighbours
  std::vector<Slot> gained_, lost_;  // changes to its list
};

static_assert(BroadPhase<NeighborList>);

}  // namespace hardball
