// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "hardball/geometry/number.hpp"
#include "hardball/world/world.hpp"

namespace hardball {

/// Tells which spheres one may meet across a face of a sheared box, from where they are now: of the many that
/// are near, few are met, and what others cost is little.
class AcrossFilter {
 public:
  AcrossFilter(const World& world, Slot slot, const Time& now)
      : world_(world),
        now_(now),
        own_(world.motion().state_at(world.path(slot), now)),
        radius_(world.bounding_radius(slot)),
        displacement_(world.box().images().displacement_in_box(now)),
        speed_(world.box().images().speed()) {}

  /// False only if the nearest image of the other is certainly not met.
  bool operator()(Slot other) const {
    const State state = world_.motion().state_at(world_.path(other), now_);
    const Vec3& period = world_.box().period();
    const Vec3& inverse = world_.box().inverse_period();
    Vec3 r = state.position - own_.position;
    Vec3 v = state.velocity - own_.velocity;
    const double above = -round_to_integer(r.y * inverse.y);
    r.y += above * period.y;
    r.x += above * displacement_;
    r.x -= round_to_integer(r.x * inverse.x) * period.x;
    r.z -= round_to_integer(r.z * inverse.z) * period.z;
    v.x += above * speed_;
    // More than all that is rounded here, coordinates being at most so large.
    constexpr double kMargin = 1e-6;
    const double coordinates = std::fabs(state.position.x) + std::fabs(own_.position.x) + period.x +
                               std::fabs(state.position.y) + std::fabs(own_.position.y) + period.y;
    const double reach = (radius_ + world_.bounding_radius(other)) * (1 + kMargin) + 0x1p-44 * coordinates;
    const double distance_squared = dot(r, r);
    if (distance_squared <= reach * reach) return true;
    const double approach = dot(r, v);
    return approach < 0 && approach * approach >= dot(v, v) * (distance_squared - reach * reach);
  }

 private:
  const World& world_;
  Time now_;
  State own_;
  double radius_;
  double displacement_;
  double speed_;
};

}  // namespace hardball
