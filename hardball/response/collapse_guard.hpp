// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <unordered_map>

#include "hardball/world/world.hpp"

namespace hardball {

/// Whether a sphere on this path has stood still until `now`, as far as its position can tell.
inline bool is_idle(const Path& path, double radius, const Time& now) {
  constexpr double kHardlyMoved = 1e-15;
  const double time = duration(path.time, now);
  const double least = kHardlyMoved * radius;
  return !(dot(path.velocity, path.velocity) * time * time > least * least);
}

/// Notices inelastic collapse: spheres that lose energy may collide ever faster, infinitely often in a finite
/// time. A sphere that keeps being hit without moving any more ends the run with a message instead of a hang.
/// Source: McNamara and Young, Phys. Fluids A 4 (1992) 496.
class CollapseGuard {
 public:
  /// To be called at every contact of a sphere, with whether it has been idle since the one before. Error
  /// (RunFailure): too many contacts in a row before which it was.
  void note_contact(SphereId id, bool was_idle, const Time& now) {
    if (was_idle || !idle_contacts_.empty()) [[unlikely]] {
      count(id, was_idle, now);
    }
  }

  std::size_t memory_bytes() const;

 private:
  void count(SphereId id, bool was_idle, const Time& now);

  // Of the few spheres whose last contact was idle. By id, so that neither an edit nor new cells make it
  // forget.
  std::unordered_map<SphereId, std::uint32_t> idle_contacts_;
};

}  // namespace hardball
