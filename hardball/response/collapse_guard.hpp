// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <unordered_map>

#include "hardball/world/world.hpp"

namespace hardball {

/// Whether a sphere on this path has not moved until `now`, to within rounding of its position.
inline bool is_idle(const Motion& motion, const Path& path, double radius, const Time& now) {
  constexpr double kHardlyMoved = 1e-15;
  const double time = duration(path.time, now);
  const double least = kHardlyMoved * radius;
  if (dot(path.velocity, path.velocity) * time * time > least * least) return false;
  return motion.is_straight() || !(0.5 * length(motion.gravity()) * time * time > least);
}

/// Detects inelastic collapse: spheres that lose energy may collide at an ever higher rate, infinitely often
/// in a finite time. A sphere that keeps being hit without moving ends the run with a message instead of a
/// hang. Source: McNamara and Young, Phys. Fluids A 4 (1992) 496.
class CollapseGuard {
 public:
  /// To be called at every contact of a sphere, with whether it has been idle since its last one. Error
  /// (RunFailure): too many idle contacts in a row.
  void note_contact(SphereId id, bool was_idle, const Time& now) {
    if (was_idle || !idle_contacts_.empty()) [[unlikely]] {
      count(id, was_idle, now);
    }
  }

  std::size_t memory_bytes() const;

 private:
  friend class Persistence;
  static void persist(auto& archive, auto& self) { archive(self.idle_contacts_); }

  void count(SphereId id, bool was_idle, const Time& now);

  // Only spheres whose last contact was idle, which are few. Keyed by id, so that counts survive edits and
  // rebuilds.
  std::unordered_map<SphereId, std::uint32_t> idle_contacts_;
};

}  // namespace hardball
