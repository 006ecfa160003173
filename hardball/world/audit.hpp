// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "hardball/errors/export.hpp"
#include "hardball/world/progress.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// Spheres may overlap by this fraction of the sum of their radii, or reach through a wall by this fraction
/// of their diameter, and still count as touching: this allows for rounding at contacts, and no more.
inline constexpr double kOverlapTolerance = 1e-9;

/// The result of a check of all spheres at one moment.
struct Audit {
  /// The deepest overlap, as a fraction of the sum of the two radii [1]; zero if no two spheres overlap.
  double max_overlap = 0;
  SphereId overlap_first = 0;
  SphereId overlap_second = 0;
  /// The farthest reach through a wall, as a fraction of the diameter [1]; zero if no sphere reaches through.
  double max_escape = 0;
  SphereId escaped = 0;
  /// Spheres whose position or velocity is not finite.
  std::size_t not_finite = 0;

  bool is_sound() const {
    return max_overlap <= kOverlapTolerance && max_escape <= kOverlapTolerance && not_finite == 0;
  }
};

/// Finds overlaps, escapes and numbers that are not finite, without the broad phases. Cost: O(n log n).
HARDBALL_EXPORT Audit audit(const World& world, const Time& moment, const Progress& progress = {});

/// Refuses an unsound start, of which this was found at `moment`. Error: names the worst pair, or the sphere.
HARDBALL_EXPORT void require_sound(const Audit& found, const Time& moment);

/// Refuses an unsound start: spheres that overlap or reach through a wall by more than kOverlapTolerance at
/// `moment`. Error: names the worst pair, or the sphere.
HARDBALL_EXPORT void require_no_overlap(const World& world, const Time& moment,
                                        const Progress& progress = {});

/// All slots of a world, for those that do not know which spheres are near.
HARDBALL_EXPORT std::vector<Slot> all_slots(const World& world);

/// Refuses a new sphere that overlaps one of these others, or reaches through a surface, by more than
/// kOverlapTolerance. Cost: O(others). Error: names the sphere in the way, of several the one with the lowest
/// id.
HARDBALL_EXPORT void require_room(const World& world, Slot added, std::span<const Slot> others,
                                  const Time& moment);

/// The collisions, at `now`, of a sphere with those of these others that it overlaps, however little, and
/// does not pass through, in order. Cost: O(others).
HARDBALL_EXPORT std::vector<Event> overlaps_of(const World& world, Slot slot, std::span<const Slot> others,
                                               const Time& now);

}  // namespace hardball
