// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include "hardball/events/plan.hpp"
#include "hardball/memory/huge_pages.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// What every event of a sphere reads, in one cache line: with many spheres, time is spent on lines that come
/// from memory.
struct alignas(64) SphereLine {
  Plan plan;  ///< For the engine.
  SphereId id = 0;
  alignas(4) std::array<std::byte, 28> region_bytes{};

  /// The region, of the type that the broad phase always uses.
  template <class Region>
  Region& region() {
    check_region<Region>();
    return *reinterpret_cast<Region*>(region_bytes.data());
  }
  template <class Region>
  const Region& region() const {
    check_region<Region>();
    return *reinterpret_cast<const Region*>(region_bytes.data());
  }

 private:
  template <class Region>
  static constexpr void check_region() {
    static_assert(sizeof(Region) <= sizeof(region_bytes) && alignof(Region) <= 4);
    static_assert(std::is_trivially_copyable_v<Region>);
  }
};
static_assert(sizeof(SphereLine) == 64);

/// One for each sphere, by slot.
using SphereLines = LargeVector<SphereLine>;

/// A line without plan or region for a sphere that had none. Cost: O(1) amortized.
inline void reset(SphereLines& lines, const World& world, Slot slot) {
  if (slot == lines.size()) append_sparingly(lines, {});
  lines[slot] = {};
  lines[slot].id = world.id(slot);
}

/// Lines without plans or regions, but with the ids. Cost: O(n).
inline void reset(SphereLines& lines, const World& world) {
  lines.assign(world.size(), {});
  for (Slot slot = 0; slot < world.size(); ++slot) lines[slot].id = world.id(slot);
}

}  // namespace hardball
