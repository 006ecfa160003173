// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>

#include "hardball/broadphase/candidates.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// Knows, for every sphere, which others it may meet next.
///
/// Each sphere has a region, and its candidates are all spheres and periodic copies whose regions meet its
/// own. The region holds the sphere until its next crossing, the moment at which the sphere reaches the
/// region's edge; crossing gives it another region. Two spheres are always candidates of each other before
/// they touch. A broad phase reads paths and never changes them.
///
/// - `build(world, now)` gives all spheres regions.
/// - `refresh(world, slot, now, folded)` gives a region to a sphere whose path has been rewritten at `now`;
///   its centre has been folded back by `folded` boxes.
/// - `collect(world, slot, candidates)` collects every candidate of a sphere, as a rule once.
/// - `next_crossing(world, slot, now, limit)` is when the sphere reaches the edge of its region, not before
///   `now`; kNever if it does not, and perhaps if it does not before `limit`.
/// - `cross(world, slot, now, candidates)` gives it the next region and collects the candidates that are new
///   (and perhaps others).
/// - `prefetch_region(slot)` and `prefetch_lists(slot, crosses)` ask for the memory that the next event of a
///   sphere will need, a few events apart; `crosses` says whether it is a crossing.
/// - `for_each_prefetched(slot, crosses, visit)` calls visit(other) for most of the candidates of that event.
/// - `left_count()` counts the cells, or rows of cells, that spheres have left since `build`.
/// - `validate(world, now)` checks the whole structure and throws BrokenInvariant.
template <class Phase>
concept BroadPhase = requires(Phase phase, const Phase& view, const World& world, Slot slot, const Time& now,
                              const Image& image, Candidates& candidates, bool crosses, void (*visit)(Slot)) {
  phase.build(world, now);
  phase.refresh(world, slot, now, image);
  view.collect(world, slot, candidates);
  { phase.next_crossing(world, slot, now, now) } -> std::convertible_to<Time>;
  phase.cross(world, slot, now, candidates);
  view.prefetch_region(slot);
  view.prefetch_lists(slot, crosses);
  view.for_each_prefetched(slot, crosses, visit);
  { view.left_count() } -> std::convertible_to<std::uint64_t>;
  { view.memory_bytes() } -> std::convertible_to<std::size_t>;
  view.validate(world, now);
};

}  // namespace hardball
