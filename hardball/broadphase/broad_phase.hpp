// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>

#include "hardball/bounds/compact_paths.hpp"
#include "hardball/broadphase/candidates.hpp"
#include "hardball/events/plan.hpp"
#include "hardball/geometry/extent.hpp"
#include "hardball/kernels/instruction_set.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// What a broad phase is made with; each takes what it needs.
struct PhaseSettings {
  double length = 1;  ///< The wanted edge of cells, or the skin of lists; of no use to all pairs [L].
  InstructionSet instructions = widest_instruction_set();  ///< For kernels.
  Extent expected;  ///< Where the centers of spheres are expected; elsewhere they are found slowly.

  PhaseSettings() = default;
  PhaseSettings(double wanted_length, InstructionSet available = widest_instruction_set())
      : length(wanted_length), instructions(available) {}
  /// The same where the centers of spheres are expected in a part of space.
  PhaseSettings within(const Extent& extent) const {
    PhaseSettings settings = *this;
    settings.expected = extent;
    return settings;
  }
};

/// The lengths that follow from the settings and the world; zero where there are none.
struct PhaseLengths {
  Vec3 cell_edges = {};  ///< Of a cell, along the axes [L].
  double skin = 0;       ///< Of neighbor lists [L].
};

/// Knows, for every sphere, which others it may meet next.
///
/// Each sphere has a region, and its candidates are all spheres and periodic images whose regions meet its
/// own. The sphere stays in its region until its next crossing, when it reaches the region's edge and gets
/// another region. Two spheres are always candidates of each other before they touch; but a sphere may leave
/// out those that it cannot meet before its next crossing, if they have it as a candidate. A broad phase
/// reads paths and never changes them.
///
/// - `Phase(settings)`, and `supports(world, length)`: whether one with this length can find the candidates
///   in such a world.
/// - `lengths()`: those in use since `build`.
/// - `build(world, now, copies)` gives every sphere a region, and resets the compact copies of paths with the
///   distance [L] that candidates are at most apart and that no sphere exceeds between two crossings.
/// - `refresh(world, slot, now, folded)` updates the region of a sphere whose path was rewritten at `now`;
///   its center has been folded back by `folded` boxes.
/// - `keeps(world, slot, now, copies)`: whether a sphere that has been put on another path at `now`, and
///   copied, may keep its region; if so, `refresh` must follow, and otherwise it needs another.
/// - `admits(world, slot)`: whether a sphere of this size can get a region without another `build`.
/// - `insert(world, slot, now, copies)` gives a region to a sphere that has none, and has been copied at
///   `now`. Precondition: admits(world, slot).
/// - `erase(slot)`: the sphere has no region any more. The world need not know it.
/// - `move(from, to)`: a sphere keeps its region, and is now in another slot, which had none.
/// - `collect_overlapping(world, slot, candidates)` collects every sphere that this one may overlap now,
///   deep inside it, too.
/// - `collect(world, slot, candidates)` collects every candidate of a sphere, some perhaps more than once,
///   and others, which may be far away.
/// - `next_crossing(world, slot, now, copies)` is a time before which the sphere stays in its region [T]; for
///   a sphere at rest, perhaps any time after its copy expires.
/// - `are_candidates(a, b)`: whether two spheres that were collected are candidates, for checks.
/// - `lines()`: a SphereLine for each slot that has been in use since `build`, with the region that the broad
///   phase keeps in it and the plan that the engine does.
/// - `uses_minimum_image()`: whether candidates mean the nearest images of spheres.
/// - `cross(world, slot, now, copies, candidates)` gives it the next region and collects the new candidates,
///   and perhaps others.
/// - `kCachedSpheres`: prefetching the regions of so many spheres costs more than it saves.
/// - `prefetch_region(slot)` and `prefetch_lists(slot, crosses)`, called a few events apart, prefetch what
///   the next event of a sphere will need; `crosses` says whether it is a crossing.
/// - `prefetch_candidates(slot, crosses, copies)`, later still, prefetches the data of most of the candidates
///   of that event.
/// - `left_count()` counts the cells, or rows of cells, that spheres have left since `build`.
/// - `validate(world, now, copies)` checks the whole structure and throws BrokenInvariant.
///
/// Which length costs least, and how much, is predicted in tuning/; see BestLength.
template <class Phase>
concept BroadPhase = requires(Phase phase, const Phase& view, const World& world, Slot slot, const Time& now,
                              const Image& image, CompactPaths& copies, const CompactPaths& copied,
                              Candidates& candidates, bool crosses, const PhaseSettings& settings) {
  Phase(settings);
  { Phase::supports(world, settings.length) } -> std::same_as<bool>;
  { view.lengths() } -> std::same_as<PhaseLengths>;
  phase.build(world, now, copies);
  phase.refresh(world, slot, now, image);
  { view.keeps(world, slot, now, copied) } -> std::same_as<bool>;
  { view.admits(world, slot) } -> std::same_as<bool>;
  phase.insert(world, slot, now, copied);
  phase.erase(slot);
  phase.move(slot, slot);
  view.collect_overlapping(world, slot, candidates);
  view.collect(world, slot, candidates);
  { phase.next_crossing(world, slot, now, copied) } -> std::same_as<double>;
  { view.are_candidates(slot, slot) } -> std::same_as<bool>;
  { (phase.lines()[slot].plan) } -> std::same_as<Plan&>;
  { (view.lines()[slot].id) } -> std::same_as<const SphereId&>;
  { view.uses_minimum_image() } -> std::same_as<bool>;
  phase.cross(world, slot, now, copied, candidates);
  { Phase::kCachedSpheres } -> std::convertible_to<std::size_t>;
  view.prefetch_region(slot);
  view.prefetch_lists(slot, crosses);
  view.prefetch_candidates(slot, crosses, copied);
  { view.left_count() } -> std::convertible_to<std::uint64_t>;
  { view.memory_bytes() } -> std::convertible_to<std::size_t>;
  view.validate(world, now, copied);
};

}  // namespace hardball
