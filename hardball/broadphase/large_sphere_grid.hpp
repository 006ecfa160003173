// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "hardball/broadphase/broad_phase.hpp"
#include "hardball/broadphase/cell_grid.hpp"

namespace hardball {

/// A cell grid for spheres of very different sizes: cells suit the many small ones, and a large one belongs
/// to those cells only that its surface touches.
///
/// Spheres not much larger than a cell are kept by a CellGrid. The region of a larger one is made of the
/// cells that its surface may touch while its center is within a skin of its anchor, a past position:
/// spheres meet at their surfaces, and no other is inside it. When it reaches the edge of its skin, its
/// anchor moves to its center. Two large spheres are candidates if they share a cell and their shells
/// overlap, a shell's radius being the sphere's plus the skin, around its anchor.
///
/// Of thousands of spheres at the surface of a large one, few can reach it before it collides again. It lists
/// those that can until the list expires, at their own speeds or a usual one that is rarely exceeded, and
/// crosses then, to list others. Whoever becomes faster than that near a large sphere is added to its list.
/// Source: docs/decisions/0012-large-spheres-as-shells-of-cells.md.
class LargeSphereGrid {
 public:
  /// The largest radius that the grid keeps, in edges of a cell: up to about there, crossing from row to row
  /// costs less than changing all cells at the surface. Less in small boxes.
  static constexpr double kLargestInGrid = 1.5;
  /// The skin, in edges; less in small boxes. Measured.
  static constexpr double kSkin = 0.25;
  /// A large sphere with so many candidates lists those that can reach it soon.
  static constexpr std::size_t kFewestToList = 256;
  /// The speed assumed by lists, over the root mean square of all.
  static constexpr double kUsualSpeed = 2.5;

  /// `edge` [L] is the wanted length of a cell's edge; see Subdivision. Precondition: supports(world, edge).
  explicit LargeSphereGrid(double edge) : wanted_edge_(edge), grid_(edge) {}

  /// Where large spheres touch no more cells than this for each sphere, all that do not fit into cells are
  /// large: the others are kept in blocks, see CellGrid. Measured.
  static constexpr double kFewSurfaces = 0.5;
  /// The mean number of cells that the surface of a large sphere of this radius, in edges, touches.
  static double cells_of_surface(double radius, std::size_t dimensions);

  /// Whether there are spheres much larger than such a cell, or few that do not fit, but no more of them than
  /// of others, and candidates would be nearest images. Cost: O(n). Error: the edge is not positive and
  /// finite.
  static bool supports(const World& world, double edge);

  void build(const World& world, const Time& now, CompactPaths& copies);
  bool admits(const World& world, Slot slot) const;
  void insert(const World& world, Slot slot, const Time& now, const CompactPaths& copies);
  void erase(Slot slot);
  void move(Slot from, Slot to);
  void collect_overlapping(const World& world, Slot slot, Candidates& candidates) const;
  void refresh(const World& world, Slot slot, const Time& now, const Image& folded) {
    if (is_large(slot)) return refresh_large(slot, folded);
    grid_.refresh(world, slot, now, folded);
    if (is_fast(world, slot)) [[unlikely]]
      list_fast(world, slot);
  }
  void collect(const World& world, Slot slot, Candidates& candidates) const {
    if (!is_large(slot)) return grid_.collect(world, slot, candidates);
    collect_of_large(world, slot, candidates);
  }
  double next_crossing(const World& world, Slot slot, const Time& now, const CompactPaths& copies) {
    if (!is_large(slot)) return grid_.next_crossing(world, slot, now, copies);
    return next_crossing_of_large(world, slot, now);
  }
  void cross(const World& world, Slot slot, const Time& now, const CompactPaths& copies,
             Candidates& candidates) {
    if (is_large(slot)) return cross_large(world, slot, now, copies, candidates);
    grid_.cross(world, slot, now, copies, candidates);
    if (is_fast(world, slot)) [[unlikely]]
      list_at_large(slot, candidates);
  }
  static constexpr std::size_t kCachedSpheres = CellGrid::kCachedSpheres;
  void prefetch_region(Slot slot) const { grid_.prefetch_region(slot); }
  void prefetch_lists(Slot slot, bool crosses) const {
    if (!is_large(slot)) grid_.prefetch_lists(slot, crosses);
  }
  void prefetch_candidates(Slot slot, bool crosses, const CompactPaths& copies) const {
    if (!is_large(slot)) grid_.prefetch_candidates(slot, crosses, copies);
  }
  bool uses_minimum_image() const { return true; }
  bool are_candidates(Slot a, Slot b) const;
  auto& lines() { return grid_.lines(); }
  const auto& lines() const { return grid_.lines(); }
  std::uint64_t left_count() const { return grid_.left_count() + left_count_; }
  std::size_t memory_bytes() const;
  void validate(const World& world, const Time& now, const CompactPaths& copies) const;

  /// The length of a cell's edge along an axis [L].
  double edge(std::size_t axis) const { return grid_.edge(axis); }

 private:
  // The sizes that follow from the cells.
  struct Sizes {
    double largest_in_grid = 0;  // the largest radius that the grid keeps
    double largest = 0;          // the largest radius that there may be
    double second_largest = 0;   // that of all but one
    double skin = 0;
    double surfaces = 0;  // cells that the large ones touch, about
    double farthest = 0;  // distance of a large sphere and a candidate
  };
  struct LargeSphere {
    Slot slot = 0;
    double radius = 0;
    Vec3 anchor;  // inside a periodic box
    Image boxes;  // from the frame of the path to that of the anchor

    // If it lists those that can reach it before `expiry` while its center is within `near_skin` of
    // `middle`.
    bool has_list = false;
    std::vector<Slot> near;  // padded with the sphere itself
    std::size_t near_count = 0;
    Vec3 middle;  // relative to the anchor
    double near_skin = 0;
    double expiry = 0;
    double depth = 0;            // how far from its surface spheres are listed [L]
    std::uint32_t contacts = 0;  // since it listed them

    void append(Slot other);
  };

  // Nothing if the cells do not suit the world.
  static std::optional<Sizes> sizes_for(const World& world, const Subdivision& cells);
  // The same if the grid keeps radii of up to so many edges.
  static std::optional<Sizes> sizes_for(const World& world, const Subdivision& cells,
                                        double largest_in_edges);

  void mark_large(Slot slot, bool is_large, std::uint32_t number);
  void insert_large(const World& world, Slot slot, const Time& now);
  void replace_in_lists(Slot slot, std::optional<Slot> by);
  bool is_large(Slot slot) const { return (are_large_[slot / 64] >> (slot % 64) & 1) != 0; }
  LargeSphere& large_of(Slot slot) { return large_[large_numbers_[slot]]; }
  const LargeSphere& large_of(Slot slot) const { return large_[large_numbers_[slot]]; }
  void move_anchor(const World& world, LargeSphere& large, const Time& now) const;
  Vec3 place_of(const World& world, const LargeSphere& large, const Time& now) const;
  double next_crossing_of_large(const World& world, Slot slot, const Time& now) const;
  void collect_of_large(const World& world, Slot slot, Candidates& candidates) const;
  void collect_all(const World& world, const LargeSphere& large, Candidates& candidates) const;
  void cross_large(const World& world, Slot slot, const Time& now, const CompactPaths& copies,
                   Candidates& candidates);
  void refresh_large(Slot slot, const Image& folded) {
    LargeSphere& large = large_of(slot);
    large.boxes = large.boxes + folded;
    ++large.contacts;
  }
  // Whether a sphere is faster than lists assume.
  bool is_fast(const World& world, Slot slot) const {
    const Vec3& velocity = world.path(slot).velocity;
    return !(dot(velocity, velocity) <= usual_speed_ * usual_speed_);
  }
  void list_fast(const World& world, Slot slot);
  void list_at_large(Slot slot, const Candidates& candidates);
  void list_near(const World& world, LargeSphere& large, const Time& now, const CompactPaths& copies,
                 const Candidates& all) const;
  void choose_depth(LargeSphere& large, std::size_t searched) const;
  void collect_cell(const World& world, const LargeSphere& large, const CellIndex& cell,
                    Candidates& candidates) const;
  bool do_shells_meet(const World& world, const LargeSphere& a, const LargeSphere& b) const;
  // Calls visit(cell) for each cell that the surface may touch, or any part of the sphere.
  template <class Visit>
  void for_each_cell(const LargeSphere& large, Visit&& visit) const {
    for_each_cell(large, std::max(0.0, large.radius - skin_ - margin_), visit);
  }
  template <class Visit>
  void for_each_cell(const LargeSphere& large, double hollow, Visit&& visit) const;

  double wanted_edge_;
  CellGrid grid_;
  Sizes sizes_;
  double skin_ = 0;
  double margin_ = 0;  // of the cells
  double usual_speed_ = 0;
  std::vector<LargeSphere> large_;
  std::vector<std::uint64_t> are_large_;      // a bit for each slot
  std::vector<std::uint32_t> large_numbers_;  // by slot: places in large_
  std::uint64_t left_count_ = 0;
  Candidates found_;  // around the sphere in question
};

static_assert(BroadPhase<LargeSphereGrid>);

}  // namespace hardball
