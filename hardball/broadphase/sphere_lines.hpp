// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/events/plan.hpp"
#include "hardball/memory/huge_pages.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// What every event of a sphere reads, in one cache line: with many spheres, time is spent on lines that come
/// from memory.
template <class Region>
struct alignas(64) SphereLine {
  Plan plan;      ///< For the engine.
  Region region;  ///< For the broad phase.
  SphereId id = 0;
};

/// One for each sphere, by slot.
template <class Region>
using SphereLines = LargeVector<SphereLine<Region>>;

/// What broad phases with lines of their own have in common.
template <class Region>
class WithSphereLines {
 public:
  /// See BroadPhase.
  auto& lines() { return lines_; }
  const auto& lines() const { return lines_; }

 protected:
  SphereLines<Region> lines_;
};

/// A line without plan or region for a sphere that had none. Cost: O(1) amortized.
template <class Region>
void reset(SphereLines<Region>& lines, const World& world, Slot slot) {
  if (slot == lines.size()) append_sparingly(lines, {});
  lines[slot] = {};
  lines[slot].id = world.id(slot);
}

/// Lines without plans or regions, but with the ids. Cost: O(n).
template <class Region>
void reset(SphereLines<Region>& lines, const World& world) {
  static_assert(sizeof(SphereLine<Region>) == 64);
  lines.assign(world.size(), {});
  for (Slot slot = 0; slot < world.size(); ++slot) lines[slot].id = world.id(slot);
}

}  // namespace hardball
