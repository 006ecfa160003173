// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "hardball/broadphase/anchor.hpp"
#include "hardball/broadphase/broad_phase.hpp"
#include "hardball/broadphase/cell_table.hpp"
#include "hardball/broadphase/padded_lists.hpp"
#include "hardball/broadphase/point_lists.hpp"
#include "hardball/broadphase/sliding_anchors.hpp"
#include "hardball/broadphase/sphere_lines.hpp"
#include "hardball/broadphase/subdivision.hpp"
#include "hardball/geometry/inlining.hpp"
#include "hardball/geometry/wait_in_ball.hpp"
#include "hardball/kernels/kernels.hpp"
#include "hardball/memory/prefetch.hpp"

namespace hardball {

/// A neighbor list for each sphere, for dense systems, where spheres are caged by their neighbors.
///
/// A sphere's region is a ball around its anchor, a past position of its center. Spheres are in each other's
/// lists if the shells around their anchors overlap; a shell's radius is the sphere's plus the ball's. When a
/// sphere reaches the edge of its ball, its anchor moves to its center, and its list and those of its
/// neighbors are updated. Anchors are found by a cell list. In a sheared box, where anchors in adjacent rows
/// slide past each other, lists are longer by what may come near within a certain time, and a sphere's anchor
/// moves when that has passed, too. Source: Donev, Torquato and Stillinger, J. Comput. Phys. 202 (2005) 737,
/// section 3.
class NeighborList final : public BroadPhase {
 public:
  /// The length is the skin, the wanted radius of the ball in which a sphere's center moves; small boxes
  /// reduce it. In a sheared box spheres are expected everywhere. Precondition: supports(world). Error: the
  /// instruction set is not available.
  explicit NeighborList(const PhaseSettings& settings)
      : BroadPhase({.kind = PhaseKind::neighbors, .follows_paths = false, .has_more_data = true}),
        wanted_skin_(settings.length),
        expected_(settings.expected),
        kernels_(&kernels_of(settings.instructions)) {}

  /// Whether neighbors can be listed, with any skin: a periodic box must be so large that of a neighbor only
  /// one image is near.
  static bool supports(const World& world, double skin = 0);
  std::unique_ptr<BroadPhase> clone() const override { return std::make_unique<NeighborList>(*this); }
  PhaseLengths lengths() const override { return {.skin = skin_}; }

  /// The edge of the cells in which anchors are found [L]: shells that overlap are in adjacent ones.
  static double cell_edge(double largest_radius, double skin);

  /// By how much rows of cells slide past each other in a sheared box before lists expire, over the skin,
  /// where spheres have this mean peculiar speed [L/T]: the cost of lists that expire balances that of longer
  /// ones. Zero without shear.
  static double slide_of_skin(const Box& box, double largest_radius, double skin, double mean_speed);

  void build(const World& world, const Time& now, CompactPaths& copies) override;
  bool keeps(const World& world, Slot slot, const Time& now, const CompactPaths& copies) const override;
  bool admits(const World& world, Slot slot) const override {
    return world.bounding_radius(slot) <= largest_built_;
  }
  void insert(const World& world, Slot slot, const Time& now, const CompactPaths& copies) override;
  void erase(Slot slot) override;
  void move(Slot from, Slot to) override;
  void collect_overlapping(const World& world, Slot slot, Candidates& candidates) const override {
    collect(world, slot, candidates);
  }
  HARDBALL_ALWAYS_INLINE void collect(const World&, Slot slot, Candidates& candidates) const override {
    candidates.begin(slot, true);
    candidates.refer_to(neighbors_.of(slot));
  }
  HARDBALL_ALWAYS_INLINE double next_crossing(const World& world, Slot slot, const Time& now,
                                              const CompactPaths& copies) override {
    if (sliding_.are_present()) [[unlikely]]
      return next_crossing_in_sheared_box(world, slot, now, copies);
    const CompactPath& path = copies.paths()[slot];
    const float wait = wait_in_ball(copies, path.position, path.velocity, stored_region(slot).position);
    // Of a sphere too fast to be bounded, nothing is known.
    if (!(wait >= 0)) [[unlikely]]
      return leaves_ball(world, slot, now, copies);
    return rounded_down(now) + copies.time_unit() * static_cast<double>(wait);
  }
  bool are_candidates(Slot, Slot) const override { return true; }
  bool uses_minimum_image() const override { return true; }
  void cross(const World& world, Slot slot, const Time& now, const CompactPaths& copies,
             Candidates& candidates) override;
  std::size_t cached_spheres() const override { return 40000; }  // measured
  HARDBALL_ALWAYS_INLINE void prefetch_more(Slot slot) const override { prefetch(neighbors_.address(slot)); }
  void prefetch_lists(Slot slot, bool crosses) const override {
    if (!crosses) return;
    CellsAround around;
    const std::size_t count = find_cells_around(stored_region(slot), around);
    for (std::size_t i = 0; i < count; ++i) prefetch(points_.blocks() + around[i].block);
  }
  void prefetch_candidates(Slot slot, bool, const CompactPaths& copies) const override {
    for (const Slot other : neighbors_.of(slot)) copies.prefetch(other);
  }
  const Subdivision* search_cells() const override { return &cells_; }
  void visit_cells(const CellRange& range, const VisitSlots& visit) const override;
  std::uint64_t left_count() const override { return 0; }
  std::size_t memory_bytes() const override;
  void validate(const World& world, const Time& now, const CompactPaths& copies) const override;

 private:
  Anchor& stored_region(Slot slot) { return lines_[slot].region<Anchor>(); }
  const Anchor& stored_region(Slot slot) const { return lines_[slot].region<Anchor>(); }
  // For how long a path certainly stays in the ball around an anchor, in units of the compact paths; NaN if
  // it is not bounded.
  HARDBALL_ALWAYS_INLINE float wait_in_ball(const CompactPaths& copies,
                                            const std::array<std::int32_t, 3>& center,
                                            const std::array<float, 3>& velocity,
                                            const std::array<std::int32_t, 3>& anchor) const {
    float outwards = 0;
    float speed_squared = 1e-30F;  // of a sphere at rest the wait is finite, but longer than any copy is good
    float distance_squared = 0;
    const BoundScale& scale = copies.scale();
    for_each_axis([&](auto axis) {
      const auto steps = static_cast<std::uint32_t>(center[axis]) - static_cast<std::uint32_t>(anchor[axis]);
      const float position = static_cast<float>(static_cast<std::int32_t>(steps)) * scale.grid[axis];
      outwards += position * velocity[axis];
      speed_squared += velocity[axis] * velocity[axis];
      distance_squared += position * position;
    });
    if (scale.has_gravity) [[unlikely]] {
      if (std::isnan(outwards)) return outwards;
      const float gravity =
          std::fabs(scale.gravity[0]) + std::fabs(scale.gravity[1]) + std::fabs(scale.gravity[2]);
      return falling_wait_in_ball(distance_squared, outwards, speed_squared, gravity, room_in_units_);
    }
    const float room = std::max(room_in_units_ * room_in_units_ - distance_squared, 0.0F);
    const float root = std::sqrt(outwards * outwards + speed_squared * room);
    return (root - outwards) / speed_squared;
  }
  double next_crossing_in_sheared_box(const World& world, Slot slot, const Time& now,
                                      const CompactPaths& copies) const;
  // When a center leaves its ball.
  double leaves_ball(const World& world, Slot slot, const Time& now, const CompactPaths& copies) const;
  void choose_packing(const CompactPaths& copies);
  void move_anchor(const World& world, Slot slot, const Time& now, const CompactPaths& copies);
  void make_lists(std::uint32_t lines, const Time& now, const CompactPaths& copies);
  void make_mutual();
  void find_near(Slot slot, const Time& now, const CompactPaths& copies);
  void leave_out_far(Slot slot, const CompactPaths& copies);
  bool are_near(Slot a, Slot b, const CompactPaths& copies) const;
  void find_changes(Slot slot);

  // The cells around one and itself.
  using CellsAround = std::array<CellNearby, 27>;
  // What is found near the current sphere.
  struct Nearby {
    CellsAround cells{};
    std::vector<Slot> room = std::vector<Slot>(128 + kWidestVector);
    std::size_t count = 0;

    Slot* begin() { return room.data(); }
    std::span<const Slot> slots() const { return {room.data(), count}; }
  };
  std::size_t find_cells_around(const Anchor& anchor, CellsAround& around) const;
  // Where a center is as seen from its anchor, and how fast it moves.
  State relative_to_anchor(const World& world, Slot slot, const Time& now, const CompactPaths& copies) const;
  // The anchor as seen from the row that is `rows` above its own.
  Anchor seen_from_row(const Anchor& anchor, std::int32_t rows) const;
  // Records how rows will be displaced when lists made now are half as old.
  void note_step(const Time& now, const CompactPaths& copies);
  // Where an anchor lies in its cell along an axis, on the grid of CompactPaths.
  std::int32_t steps_in_cell(const Anchor& anchor, std::size_t axis) const;
  // The same in units of packed positions.
  std::int32_t in_cell(const Anchor& anchor, std::size_t axis) const;
  void store_anchor(Slot slot) {
    const Anchor& anchor = stored_region(slot);
    points_.insert(table_.list(anchor.cell), slot,
                   PackedPosition({in_cell(anchor, 0), in_cell(anchor, 1), in_cell(anchor, 2)}));
  }

  // How positions are packed, along an axis.
  struct Packing {
    std::uint64_t steps_of_cell = 0;  // of the grid of CompactPaths, times 2^32
    double cells_of_step = 0;         // the reciprocal
    std::uint32_t shift = 0;          // a unit is 2^shift of these steps
    std::int32_t units_of_cell = 0;
    // The outermost cells of an open axis hold all spheres beyond.
    std::int32_t below = std::numeric_limits<std::int32_t>::min();
    std::int32_t above = std::numeric_limits<std::int32_t>::max();

    bool is_outermost(std::int32_t cell) const { return cell == below || cell == above; }
  };

  double wanted_skin_;
  Extent expected_;
  const Kernels* kernels_;
  double skin_ = 0;
  double largest_built_ = 0;  // the largest radius when lists were made
  float reach_ = 0;           // of shells beyond the radii, in units of the compact paths
  float reach_of_slide_ = 0;  // how far rows may slide past each other in half of the time that lists last
  float packing_error_ = 0;   // of distances, in units
  double room_ = 0;           // the distance from its anchor at which a center crosses
  float room_in_units_ = 0;
  // Of rows against those below, when the current list will be half as old:
  std::int32_t step_ = 0;     // on the grid of CompactPaths
  double step_in_cells_ = 0;  // of the edge of a cell
  Subdivision cells_;
  SlidingAnchors sliding_;
  std::array<Packing, kAxes> packing_;
  std::array<float, kAxes> packing_unit_{};  // in units of the compact paths
  CellTable table_;
  PointLists points_;      // anchors, by cell
  PaddedLists neighbors_;  // by slot
  // Of the current sphere:
  Nearby near_;                      // its new neighbors
  std::vector<Slot> gained_, lost_;  // changes to its list
};

}  // namespace hardball
