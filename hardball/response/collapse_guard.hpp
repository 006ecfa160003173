// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <unordered_map>

#include "hardball/world/world.hpp"

namespace hardball {

/// Notices inelastic collapse: spheres that lose energy may collide ever faster, infinitely often in a finite
/// time. A sphere that keeps being hit without moving any more ends the run with a message instead of a hang.
/// Source: McNamara and Young, Phys. Fluids A 4 (1992) 496.
class CollapseGuard {
 public:
  /// To be called before a contact rewrites the path of a sphere. Error (RunFailure): too many contacts in
  /// which the sphere has hardly moved since the one before.
  void note_contact(const World& world, Slot slot, const Time& now);

  std::size_t memory_bytes() const;

 private:
  // Of the few spheres whose last contact was idle. By id, so that neither an edit nor new cells make it
  // forget.
  std::unordered_map<SphereId, std::uint32_t> idle_contacts_;
};

}  // namespace hardball
