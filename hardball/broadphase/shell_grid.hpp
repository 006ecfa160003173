// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "hardball/broadphase/broad_phase.hpp"
#include "hardball/broadphase/cell_grid.hpp"

namespace hardball {

/// A cell grid for spheres of very different sizes: cells suit the many small ones, and a large one belongs to
/// those cells only that its surface touches.
///
/// Spheres smaller than a cell are kept by a CellGrid. The region of a larger one, a *ball*, is made of the cells
/// that its surface may touch while its centre is within a slack of its anchor, a past position: spheres meet at
/// their surfaces, and no other is inside it. When it reaches the edge of its slack, its anchor moves to its
/// centre. Two balls are candidates if they share a cell and their shells overlap, a shell being the ball and its
/// slack around its anchor. Cost of a contact of a ball: its surface, in cells.
class ShellGrid {
 public:
  /// `edge` [L] is the wanted length of a cell's edge; see Subdivision. Precondition: suits(world, edge).
  explicit ShellGrid(double edge) : wanted_edge_(edge), grid_(edge) {}

  /// Whether there are spheres larger than such a cell, but no more than smaller ones, and candidates would be
  /// nearest images. Cost: O(n). Error: the edge is not positive and finite.
  static bool suits(const World& world, double edge);

  void build(const World& world, const Time& now, CompactPaths& copies);
  void refresh(const World& world, Slot slot, const Time& now, const Image& folded) {
    if (!is_ball(slot)) return grid_.refresh(world, slot, now, folded);
    Ball& ball = ball_of(slot);
    ball.boxes = ball.boxes + folded;
  }
  void collect(const World& world, Slot slot, Candidates& candidates) const {
    if (!is_ball(slot)) return grid_.collect(world, slot, candidates);
    collect_of_ball(world, slot, candidates);
  }
  double next_crossing(const World& world, Slot slot, const Time& now, const CompactPaths& copies) {
    if (!is_ball(slot)) return grid_.next_crossing(world, slot, now, copies);
    return next_crossing_of_ball(world, slot, now);
  }
  void cross(const World& world, Slot slot, const Time& now, const CompactPaths& copies,
             Candidates& candidates) {
    if (!is_ball(slot)) return grid_.cross(world, slot, now, copies, candidates);
    cross_ball(world, slot, now, candidates);
  }
  static constexpr std::size_t kCachedSpheres = CellGrid::kCachedSpheres;
  void prefetch_region(Slot slot) const { grid_.prefetch_region(slot); }
  void prefetch_lists(Slot slot, bool crosses) const {
    if (!is_ball(slot)) grid_.prefetch_lists(slot, crosses);
  }
  void prefetch_candidates(Slot slot, bool crosses, const CompactPaths& copies) const {
    if (!is_ball(slot)) grid_.prefetch_candidates(slot, crosses, copies);
  }
  bool has_nearest_images() const { return true; }
  std::uint64_t left_count() const { return grid_.left_count() + left_count_; }
  std::size_t memory_bytes() const;
  void validate(const World& world, const Time& now, const CompactPaths& copies) const;

  /// The length of a cell's edge along an axis [L].
  double edge(std::size_t axis) const { return grid_.edge(axis); }

 private:
  // The sizes that follow from the cells.
  struct Sizes {
    double largest_in_cell = 0;  // the largest radius that the grid keeps
    double slack = 0;
    double farthest = 0;  // distance of a ball and a candidate
  };
  struct Ball {
    Slot slot = 0;
    double radius = 0;
    Vec3 anchor;  // inside a periodic box
    Image boxes;  // from the frame of the path to that of the anchor
  };

  // Nothing if the cells do not suit the world.
  static std::optional<Sizes> sizes_for(const World& world, const Subdivision& cells);

  bool is_ball(Slot slot) const { return (are_balls_[slot / 64] >> (slot % 64) & 1) != 0; }
  Ball& ball_of(Slot slot) { return balls_[ball_numbers_[slot]]; }
  const Ball& ball_of(Slot slot) const { return balls_[ball_numbers_[slot]]; }
  void move_anchor(const World& world, Ball& ball, const Time& now) const;
  Vec3 place_of(const World& world, const Ball& ball, const Time& now) const;
  double next_crossing_of_ball(const World& world, Slot slot, const Time& now) const;
  void collect_of_ball(const World& world, Slot slot, Candidates& candidates) const;
  void cross_ball(const World& world, Slot slot, const Time& now, Candidates& candidates);
  void collect_cell(const World& world, const Ball& ball, const CellIndex& cell, Candidates& candidates) const;
  bool do_shells_meet(const World& world, const Ball& a, const Ball& b) const;
  template <class Visit>
  void for_each_cell(const Ball& ball, Visit&& visit) const;

  double wanted_edge_;
  CellGrid grid_;
  double slack_ = 0;
  double margin_ = 0;  // of the cells
  std::vector<Ball> balls_;
  std::vector<std::uint64_t> are_balls_;     // a bit for each slot
  std::vector<std::uint32_t> ball_numbers_;  // by slot, of those that are balls
  std::uint64_t left_count_ = 0;
};

static_assert(BroadPhase<ShellGrid>);

}  // namespace hardball
