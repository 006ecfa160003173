// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include "hardball/geometry/motion.hpp"

namespace hardball {

/// The time until two points, separated by `separation` [L] and approaching with relative velocity `velocity`
/// [L/T], first come within `reach` [L] while approaching; infinity if they never do.
///
/// Within reach and approaching means now (zero); receding or at relative rest means never; touching `reach`
/// without falling below it means never. The result is accurate to four units in the last place of
/// |separation|/|velocity|, grazing contacts included; beyond four reaches, to 2^-50 of it. Negating both
/// vectors changes no bit of the result. Source: Bannerman et al., Comp. Part. Mech. 1 (2014) 191, section 2.
double time_to_reach(const Vec3& separation, const Vec3& velocity, double reach);

/// The time until a point at signed distance `distance` [L] from a plane, moving towards it with `speed`
/// [L/T], arrives; zero if it is already there or beyond, infinity if it does not approach (`speed` <= 0).
inline double time_to_plane(double distance, double speed) {
  if (!(speed > 0)) return std::numeric_limits<double>::infinity();
  return distance <= 0 ? 0 : distance / speed;
}

/// The separation [L] of the point on path `b`, displaced by `shift` [L], from the point on path `a`, at
/// `moment`. Exchanging the paths and negating the shift negates the result exactly.
inline Vec3 separation_at(const Motion& motion, const Path& a, const Path& b, const Vec3& shift,
                          const Time& moment) {
  return (motion.position_at(b, moment) - motion.position_at(a, moment)) + shift;
}

/// The time at which the centers on two paths, the second displaced by `shift` [L], first come within `reach`
/// [L] while approaching; kNever if they never do.
///
/// A function of the two paths alone, computed from the later of their start times: the same bits whenever it
/// is called, and in either order of the paths.
inline Time contact_time(const Motion& motion, const Path& a, const Path& b, const Vec3& shift,
                         double reach) {
  const Time start = later(a.time, b.time);
  const Vec3 separation = separation_at(motion, a, b, shift, start);
  const Vec3 velocity = motion.velocity_at(b, start) - motion.velocity_at(a, start);
  return after(start, time_to_reach(separation, velocity, reach));
}

}  // namespace hardball
