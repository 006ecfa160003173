// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include "hardball/broadphase/approach_list.hpp"
#include "hardball/broadphase/broad_phase.hpp"
#include "hardball/broadphase/cell_grid.hpp"
#include "hardball/broadphase/large_sizes.hpp"
#include "hardball/broadphase/shell_cells.hpp"
#include "hardball/broadphase/slot_set.hpp"

namespace hardball {

/// A cell grid for spheres of very different sizes: cells suit the many small ones, and a large one belongs
/// to those cells only that its surface touches.
///
/// Spheres not much larger than a cell are kept by a CellGrid, whose guests are the large ones. The region of
/// a large sphere is made of the cells that its surface may touch while its center is within a skin of its
/// anchor, a past position: spheres meet at their surfaces, and no other is inside it. When it reaches the
/// edge of its skin, its anchor moves to its center. Two large spheres are candidates if they share a cell
/// and their shells overlap, a shell's radius being the sphere's plus the skin, around its anchor.
///
/// Few of thousands of spheres at the surface of a large one can reach it before it collides again. It keeps
/// these in an ApproachList and crosses when that expires, to list others.
/// Source: docs/decisions/0012-large-spheres-as-shells-of-cells.md.
class LargeSphereGrid final : public CellGrid {
 public:
  /// The speed assumed by lists, over the root mean square of all.
  static constexpr double kUsualSpeed = 2.5;

  /// The length is the wanted edge of a cell; see Subdivision. Precondition: supports(world, edge), where the
  /// world is all that is built, or has it as a part.
  explicit LargeSphereGrid(const PhaseSettings& settings) : CellGrid(settings), settings_(settings) {}

  /// Whether some spheres are too large for such cells; see LargeSizes. Cost: O(n). Error: the edge is not
  /// positive and finite.
  static bool supports(const World& world, double edge);
  std::unique_ptr<BroadPhase> clone() const override { return std::make_unique<LargeSphereGrid>(*this); }

  void build(const World& world, const Time& now, CompactPaths& copies) override;
  // Never: the lists of large spheres rely on how small ones have moved.
  bool keeps(const World&, Slot, const Time&, const CompactPaths&) const override { return false; }
  bool admits(const World& world, Slot slot) const override;
  void insert(const World& world, Slot slot, const Time& now, const CompactPaths& copies) override;
  void erase(Slot slot) override;
  void move(Slot from, Slot to) override;
  void collect_overlapping(const World& world, Slot slot, Candidates& candidates) const override;
  void update(const World& world, Slot slot, const Time& now, const Image& folded) override {
    if (is_large(slot)) return refresh_large(slot, folded);
    CellGrid::update(world, slot, now, folded);
    if (is_fast(world, slot)) [[unlikely]]
      list_fast(world, slot);
  }
  void collect(const World& world, Slot slot, Candidates& candidates) const override {
    if (!is_large(slot)) return CellGrid::collect(world, slot, candidates);
    collect_of_large(world, slot, candidates);
  }
  double next_crossing(const World& world, Slot slot, const Time& now, const CompactPaths& copies) override {
    if (!is_large(slot)) return CellGrid::next_crossing(world, slot, now, copies);
    return next_crossing_of_large(world, slot, now);
  }
  void cross(const World& world, Slot slot, const Time& now, const CompactPaths& copies,
             Candidates& candidates) override {
    if (is_large(slot)) return cross_large(world, slot, now, copies, candidates);
    CellGrid::cross(world, slot, now, copies, candidates);
    if (is_fast(world, slot)) [[unlikely]]
      list_at_large(slot, candidates);
  }
  void prefetch_lists(Slot slot, bool crosses) const override {
    if (!is_large(slot)) CellGrid::prefetch_lists(slot, crosses);
  }
  void prefetch_candidates(Slot slot, bool crosses, const CompactPaths& copies) const override {
    if (!is_large(slot)) CellGrid::prefetch_candidates(slot, crosses, copies);
  }
  bool uses_minimum_image() const override { return true; }
  bool are_candidates(Slot a, Slot b) const override;
  /// Whether `collect` gives only those candidates of a large sphere that can reach it before its list
  /// expires.
  bool has_approach_list(Slot slot) const { return is_large(slot) && large_of(slot).list.exists(); }
  void visit_hollow(const VisitSlots& visit) const override {
    for (const LargeSphere& large : large_) visit({&large.slot, 1});
  }
  std::uint64_t left_count() const override { return CellGrid::left_count() + moved_anchors_; }
  std::size_t memory_bytes() const override;
  void validate(const World& world, const Time& now, const CompactPaths& copies) const override;

 private:
  struct LargeSphere {
    Slot slot = 0;
    double radius = 0;
    Vec3 anchor;  // inside a periodic box
    Image boxes;  // from the frame of the path to that of the anchor
    ApproachList list;
  };

  void mark_large(Slot slot, bool is_large, std::uint32_t number);
  void insert_large(const World& world, Slot slot, const Time& now);
  bool is_large(Slot slot) const { return are_large_.contains(slot); }
  LargeSphere& large_of(Slot slot) { return large_[large_numbers_[slot]]; }
  const LargeSphere& large_of(Slot slot) const { return large_[large_numbers_[slot]]; }
  void move_anchor(const World& world, LargeSphere& large, const Time& now) const;
  Vec3 position_of(const World& world, const LargeSphere& large, const Time& now) const;
  double next_crossing_of_large(const World& world, Slot slot, const Time& now) const;
  void collect_of_large(const World& world, Slot slot, Candidates& candidates) const;
  void collect_all(const World& world, const LargeSphere& large, Candidates& candidates) const;
  void collect_cell(const World& world, const LargeSphere& large, const CellIndex& cell,
                    Candidates& candidates) const;
  void cross_large(const World& world, Slot slot, const Time& now, const CompactPaths& copies,
                   Candidates& candidates);
  void refresh_large(Slot slot, const Image& folded) {
    LargeSphere& large = large_of(slot);
    large.boxes = large.boxes + folded;
    large.list.note_contact();
  }
  // Whether a sphere is faster than lists assume.
  bool is_fast(const World& world, Slot slot) const {
    const Vec3& velocity = world.path(slot).velocity;
    return !(dot(velocity, velocity) <= usual_speed_ * usual_speed_);
  }
  void list_fast(const World& world, Slot slot);
  void list_at_large(Slot slot, const Candidates& candidates);
  void make_list(const World& world, LargeSphere& large, const Time& now, const CompactPaths& copies,
                 const Candidates& all) const;
  bool do_shells_meet(const World& world, const LargeSphere& a, const LargeSphere& b) const;
  // Calls visit(cell) for each cell that the surface may touch, and in which there is room for others.
  template <class Visit>
  void for_each_cell(const LargeSphere& large, Visit&& visit) const {
    const double hollow = std::max(0.0, large.radius - skin_ - margin_);
    for_each_cell_of_shell(cells(), large.anchor, hollow, large.radius + skin_ + margin_, visit);
  }
  void insert_guest(const LargeSphere& large) {
    for_each_cell(large, [&](const CellIndex& cell) { CellGrid::insert_guest(cell, large.slot); });
  }
  void erase_guest(const LargeSphere& large) {
    for_each_cell(large, [&](const CellIndex& cell) { CellGrid::erase_guest(cell, large.slot); });
  }

  PhaseSettings settings_;
  LargeSizes sizes_;
  double skin_ = 0;
  double margin_ = 0;  // of the cells
  double usual_speed_ = 0;
  std::vector<LargeSphere> large_;
  SlotSet are_large_;
  std::vector<std::uint32_t> large_numbers_;  // by slot: indices in large_
  std::uint64_t moved_anchors_ = 0;
  Candidates found_;  // around the sphere in question
};

}  // namespace hardball
