// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "hardball/bounds/compact_paths.hpp"
#include "hardball/broadphase/candidates.hpp"
#include "hardball/broadphase/sphere_lines.hpp"
#include "hardball/broadphase/subdivision.hpp"
#include "hardball/geometry/extent.hpp"
#include "hardball/kernels/instruction_set.hpp"
#include "hardball/memory/function.hpp"
#include "hardball/memory/prefetch.hpp"
#include "hardball/memory/value_pointer.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// How candidates are found; see make_broad_phase.
enum class PhaseKind {
  cells,      ///< Cells: CellGrid, LargeSphereGrid or ShearedCells, whichever suits the world.
  neighbors,  ///< NeighborList
  all_pairs,  ///< AllPairs
};

/// What a broad phase is made with; each takes what it needs.
struct PhaseSettings {
  PhaseKind kind = PhaseKind::cells;
  double length = 1;  ///< The wanted edge of cells, or the skin of lists; of no use to all pairs [L].
  InstructionSet instructions = fastest_instruction_set();  ///< For kernels.
  Extent expected;  ///< Where the centers of spheres are expected; elsewhere they are found slowly.

  PhaseSettings() = default;
  PhaseSettings(PhaseKind wanted_kind, double wanted_length,
                InstructionSet available = fastest_instruction_set())
      : kind(wanted_kind), length(wanted_length), instructions(available) {}
  PhaseSettings(double wanted_length)  // NOLINT(google-explicit-constructor)
      : length(wanted_length) {}
  /// Returns these settings for spheres whose centers are expected in a part of space.
  PhaseSettings within(const Extent& extent) const {
    PhaseSettings settings = *this;
    settings.expected = extent;
    return settings;
  }
};

/// The lengths that follow from the settings and the world; zero where there are none.
struct PhaseLengths {
  Vec3 cell_edges = {};  ///< Edges of a cell [L].
  double skin = 0;       ///< Skin of neighbor lists [L].
};

/// What spares virtual calls: what a broad phase is, and what it does without.
struct PhaseTraits {
  PhaseKind kind = PhaseKind::cells;
  bool follows_paths = true;   ///< Regions change when paths do.
  bool has_more_data = false;  ///< Each sphere has data besides its line.
};

/// Knows, for every sphere, which others it may meet next.
///
/// Each sphere has a region, and its candidates are all spheres and periodic images whose regions meet its
/// own. The sphere stays in its region until its next crossing, when it reaches the region's edge and gets
/// another region. Two spheres are always candidates of each other before they touch; but a sphere may leave
/// out those that it cannot meet before its next crossing, if they have it as a candidate. A broad phase
/// reads paths and never changes them.
///
/// Which length costs least, and how much, is predicted in tuning/; see BestLength.
class BroadPhase {
 public:
  virtual ~BroadPhase() = default;
  /// An independent copy.
  virtual std::unique_ptr<BroadPhase> clone() const = 0;

  /// The lengths in use since `build`.
  virtual PhaseLengths lengths() const = 0;
  /// Gives every sphere a region, and resets the compact copies of paths with the distance [L] that
  /// candidates are at most apart and that no sphere exceeds between two crossings.
  virtual void build(const World& world, const Time& now, CompactPaths& copies) = 0;
  /// Updates the region of a sphere whose path was rewritten at `now`; its center has been folded back by
  /// `folded` boxes.
  void refresh(const World& world, Slot slot, const Time& now, const Image& folded) {
    if (traits_.follows_paths) update(world, slot, now, folded);
  }
  /// Whether a sphere that has been put on another path at `now`, and copied, may keep its region; if so,
  /// `refresh` must follow, and otherwise it needs another.
  virtual bool keeps(const World& world, Slot slot, const Time& now, const CompactPaths& copies) const = 0;
  /// Whether a sphere of this size can get a region without another `build`.
  virtual bool admits(const World& world, Slot slot) const = 0;
  /// Gives a region to a sphere that has none, and has been copied at `now`. Precondition: admits(world,
  /// slot).
  virtual void insert(const World& world, Slot slot, const Time& now, const CompactPaths& copies) = 0;
  /// Removes the region of a sphere, which the world need not know.
  virtual void erase(Slot slot) = 0;
  /// A sphere keeps its region, and is stored in another slot, which had none.
  virtual void move(Slot from, Slot to) = 0;
  /// Collects every sphere that this one may overlap, those deep inside it, too.
  virtual void collect_overlapping(const World& world, Slot slot, Candidates& candidates) const = 0;
  /// Collects every candidate of a sphere, some perhaps more than once, and others, which may be far away.
  virtual void collect(const World& world, Slot slot, Candidates& candidates) const = 0;
  /// A time before which the sphere stays in its region [T]; for a sphere at rest, perhaps any time after its
  /// copy expires.
  virtual double next_crossing(const World& world, Slot slot, const Time& now,
                               const CompactPaths& copies) = 0;
  /// Whether two spheres that were collected are candidates, for checks.
  virtual bool are_candidates(Slot a, Slot b) const = 0;
  /// Whether candidates mean the nearest images of spheres.
  virtual bool uses_minimum_image() const = 0;
  /// Gives a sphere the next region, and collects the new candidates, and perhaps others.
  virtual void cross(const World& world, Slot slot, const Time& now, const CompactPaths& copies,
                     Candidates& candidates) = 0;
  /// Up to how many spheres prefetching their regions costs more than it saves.
  virtual std::size_t cached_spheres() const = 0;
  /// Prefetches, a few events ahead, what the next event of a sphere will need: its line, and more where
  /// has_more_data().
  void prefetch_line(Slot slot) const { prefetch(&lines_[slot]); }
  bool has_more_data() const { return traits_.has_more_data; }
  virtual void prefetch_more(Slot) const {}
  /// Prefetches more of it, later; `crosses`: the event is a crossing.
  virtual void prefetch_lists(Slot slot, bool crosses) const = 0;
  /// Prefetches, later still, the data of most of the candidates of that event.
  virtual void prefetch_candidates(Slot slot, bool crosses, const CompactPaths& copies) const = 0;
  /// The cells in which visit_cells finds spheres; null if there are none.
  virtual const Subdivision* search_cells() const { return nullptr; }
  using VisitSlots = Function<void(std::span<const Slot>)>;
  /// Calls visit(slots) for spheres, some perhaps more than once: all whose surface touches one of these
  /// cells, which need not be folded into the box, and others. Precondition: search_cells() is not null; of
  /// the spheres, events have been handled up to the present.
  virtual void visit_cells(const CellRange&, const VisitSlots&) const {}
  /// Calls visit(slots) for the spheres that may touch cells with their inside alone.
  virtual void visit_hollow(const VisitSlots&) const {}
  /// How many cells, or rows of cells, spheres have left since `build`.
  virtual std::uint64_t left_count() const = 0;
  virtual std::size_t memory_bytes() const = 0;
  /// Checks the whole structure; throws BrokenInvariant.
  virtual void validate(const World& world, const Time& now, const CompactPaths& copies) const = 0;

  PhaseKind kind() const { return traits_.kind; }
  /// A line for each slot that has been in use since `build`.
  SphereLines& lines() { return lines_; }
  const SphereLines& lines() const { return lines_; }

 protected:
  explicit BroadPhase(const PhaseTraits& traits) : traits_(traits) {}
  BroadPhase(const BroadPhase&) = default;
  BroadPhase(BroadPhase&&) noexcept = default;
  BroadPhase& operator=(const BroadPhase&) = default;
  BroadPhase& operator=(BroadPhase&&) noexcept = default;

  SphereLines lines_;

 private:
  virtual void update(const World&, Slot, const Time&, const Image& /*folded*/) {}

  PhaseTraits traits_;
};

/// Makes a broad phase for a world, or a part of one; `build` must follow. Cost: O(n).
ValuePointer<BroadPhase> make_broad_phase(const PhaseSettings& settings, const World& world);

}  // namespace hardball
