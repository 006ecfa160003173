// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "hardball/broadphase/broad_phase.hpp"
#include "hardball/broadphase/cell_store.hpp"
#include "hardball/broadphase/slot_lists.hpp"
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
  void collect(const World& world, Slot slot, Candidates& candidates) const;
  double next_crossing(const World& world, Slot slot, const Time& now, const CompactPaths& copies) const;
  bool has_nearest_images() const { return true; }
  void cross(const World& world, Slot slot, const Time& now, const CompactPaths& copies,
             Candidates& candidates);
  void prefetch_region(Slot slot) const {
    prefetch(neighbors_.address(slot));
    prefetch(&anchors_[slot]);
  }
  void prefetch_lists(Slot, bool) const {}
  template <class Visit>
  void for_each_prefetched(Slot slot, bool, Visit&& visit) const {
    neighbors_.for_each_first(slot, visit);
  }
  std::uint64_t left_count() const { return 0; }
  std::size_t memory_bytes() const;
  void validate(const World& world, const Time& now, const CompactPaths& copies) const;

  double slack() const { return slack_; }
  InstructionSet instructions() const { return instructions_; }

 private:
  GridPoint anchor_at(const World& world, Slot slot, const Time& now, const CompactPaths& copies) const;
  Vec3 from_anchor(Slot slot, const CompactPaths& copies) const;
  void find_near(Slot slot, const CompactPaths& copies);
  std::size_t collect_around(const CellIndex& center);
  void find_changes(Slot slot);

  double wanted_slack_;
  InstructionSet instructions_;
  NearKernel pick_near_;
  double slack_ = 0;
  float reach_ = 0;    // of shells beyond the radii, in units of the compact paths
  double room_ = 0;    // the distance from its anchor at which a centre crosses
  Subdivision cells_;
  CellStore store_;            // anchors
  LargeVector<GridPoint> anchors_;  // by slot
  SlotLists neighbors_;             // by slot
  // Of the current sphere:
  std::vector<Slot> around_;         // those whose anchors lie in the 27 cells around its own
  std::vector<Slot> near_;           // its new neighbours
  std::vector<Slot> gained_, lost_;  // changes to its list
  std::vector<std::uint32_t> kept_;  // a bit for each place of each line of its list
};

static_assert(BroadPhase<NeighborList>);

}  // namespace hardball
