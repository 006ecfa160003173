// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "hardball/domains/partition.hpp"
#include "hardball/engine/window_counters.hpp"
#include "hardball/geometry/vec3.hpp"

namespace hardball {

/// The work of the domains since the layout was made, and whether another layout would pay. It is measured by
/// counts alone, so that all processes decide alike, in every run.
struct Load {
  std::vector<std::uint64_t> contacts;  ///< Contacts of own spheres, by domain.
  WindowCounters windows;

  /// How many more contacts all domains could have had while they waited for the one that has most.
  std::uint64_t waited() const;
  /// Whether domains have waited so long that dividing this many spheres evenly costs less.
  bool is_uneven(std::uint64_t spheres) const;
  /// Whether so many windows fail that deeper halos cost less.
  bool has_shallow_halos() const;
};

/// Centers from which a partition would make blocks that have as many contacts: each of these as often as
/// spheres of its domain have contacts, relative to others. Cost: O(n log(domains)).
std::vector<Vec3> centers_by_load(std::span<const Vec3> centers, const Partition& partition,
                                  const Load& load);

}  // namespace hardball
