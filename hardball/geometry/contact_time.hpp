// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <type_traits>

#include "hardball/errors/export.hpp"
#include "hardball/geometry/grazing_time.hpp"
#include "hardball/geometry/growing_contact.hpp"
#include "hardball/geometry/motion.hpp"
#include "hardball/geometry/sliding_images.hpp"

namespace hardball {

/// The time until two points, separated by `separation` [L] and approaching with relative velocity `velocity`
/// [L/T], first come within `reach` [L] while approaching; infinity if they never do.
///
/// Within reach and approaching means now (zero); receding or at relative rest means never; touching `reach`
/// without falling below it means never. The result is accurate to four units in the last place of
/// |separation|/|velocity|, grazing contacts included; beyond four reaches, to 2^-50 of it. Negating both
/// vectors changes no bit of the result, which is the same in each lane of the numbers (number.hpp).
/// Source: Bannerman et al., Comp. Part. Mech. 1 (2014) 191, section 2.
template <class Number>
HARDBALL_ALWAYS_INLINE Number time_to_reach(const VectorOf<Number>& separation,
                                            const VectorOf<Number>& velocity,
                                            const std::type_identity_t<Number>& reach) {
  const Number zero(0.0);
  const Number forever(std::numeric_limits<double>::infinity());
  // Distance squared minus reach squared is excess + 2 approach t + speed_squared t^2.
  const Number approach = dot(separation, velocity);
  const auto approaches = approach < zero;
  if (ends(!approaches)) return forever;
  const Number reach_squared = reach * reach;
  const Number distance_squared = dot(separation, separation);
  const Number excess = distance_squared - reach_squared;
  const auto is_apart = excess > zero;
  if (ends(!is_apart)) return zero;
  // Lagrange's identity gives approach^2 - speed_squared * excess without its cancellation between far
  // spheres.
  const Number speed_squared = dot(velocity, velocity);
  const Number closest = speed_squared * reach_squared;
  const VectorOf<Number> angular = cross(separation, velocity);
  const Number discriminant = closest - dot(angular, angular);
  const auto may_touch = Number(-kCertainMiss) * (speed_squared * distance_squared) <= discriminant;
  if (ends(!may_touch)) return forever;
  const auto meets_steeply = discriminant > Number(kGrazingCosineSquared) * closest;
  const auto grazes = approaches && is_apart && may_touch && !meets_steeply;
  const auto meets = approaches && (meets_steeply || !is_apart);
  // The smaller root, in the form that does not cancel when the spheres are close.
  const Number root = square_root(maximum(discriminant, zero));
  const Number wait = select(meets, maximum(excess, zero) / (root - approach), forever);
  if (!any(grazes)) return wait;
  return select(grazes, grazing_time_to_reach(separation, velocity, reach), wait);
}

/// The time until two centers in uniform relative motion are `reach` [L] apart, compiled once.
HARDBALL_EXPORT double time_to_reach(const Vec3& separation, const Vec3& velocity, double reach);

/// The time until a point at signed distance `distance` [L] from a plane, moving toward it with `speed`
/// [L/T], arrives; zero if it is already there or beyond, infinity if it does not approach (`speed` <= 0).
inline double time_to_plane(double distance, double speed) {
  if (!(speed > 0)) return std::numeric_limits<double>::infinity();
  return distance <= 0 ? 0 : distance / speed;
}

/// Where the point on path `b`, displaced by `shift` [L], is as seen from the point on path `a`, and how fast
/// it moves, at `moment`; `motion` is a Motion or one of its two kinds. Exchanging the paths and negating the
/// shift negates the result exactly.
template <class AnyMotion, class Number>
HARDBALL_ALWAYS_INLINE StateOf<Number> relative_state_at(const AnyMotion& motion, const PathOf<Number>& a,
                                                         const PathOf<Number>& b,
                                                         const VectorOf<Number>& shift,
                                                         const TimeOf<Number>& moment) {
  const StateOf<Number> of_a = motion.state_at(a, moment);
  const StateOf<Number> of_b = motion.state_at(b, moment);
  return {(of_b.position - of_a.position) + shift, of_b.velocity - of_a.velocity};
}

/// The relative position of `b` and `a` at `moment` [L].
inline Vec3 separation_at(const Motion& motion, const Path& a, const Path& b, const Vec3& shift,
                          const Time& moment) {
  return relative_state_at(motion, a, b, shift, moment).position;
}

/// The time at which the centers on two paths, the second displaced by `shift` [L], first come within `reach`
/// [L] while approaching; kNever if they never do.
///
/// A function of the two paths alone, computed from the later of their start times: the same bits whenever it
/// is called, in either order of the paths, and in each lane of the numbers.
template <class AnyMotion, class Number>
HARDBALL_ALWAYS_INLINE TimeOf<Number> contact_time(const AnyMotion& motion, const PathOf<Number>& a,
                                                   const PathOf<Number>& b,
                                                   const std::type_identity_t<VectorOf<Number>>& shift,
                                                   const std::type_identity_t<Number>& reach) {
  const TimeOf<Number> start = later(a.time, b.time);
  const StateOf<Number> relative = relative_state_at(motion, a, b, shift, start);
  return after(start, time_to_reach(relative.position, relative.velocity, reach));
}

/// The contact time of two spheres whose sizes change, `reach` [L] being the sum of the base radii. It is a
/// function of the two paths and of the epoch alone, computed from the latest of their start times. A contact
/// after the end of the epoch does not count.
template <class Number>
HARDBALL_ALWAYS_INLINE TimeOf<Number> contact_time(const GrowingMotion<Number>& motion,
                                                   const PathOf<Number>& a, const PathOf<Number>& b,
                                                   const std::type_identity_t<VectorOf<Number>>& shift,
                                                   const std::type_identity_t<Number>& reach) {
  const TimeOf<Number> start = later(later(a.time, b.time), motion.begin);
  const StateOf<Number> relative = relative_state_at(motion, a, b, shift, start);
  return after(start,
               time_to_touch(GrowingPair<Number>{relative.position, relative.velocity,
                                                 reach * motion.scale_at(start), reach * motion.rate}));
}

/// The contact time of two spheres in a sheared box with these periods [L]; `image`, integers, is that of `b`
/// which `a` meets.
template <class Number>
HARDBALL_ALWAYS_INLINE TimeOf<Number> contact_time_of_sliding(
    const SlidingImages& images, const VectorOf<Number>& period, const PathOf<Number>& a,
    const PathOf<Number>& b, const VectorOf<Number>& image, const std::type_identity_t<Number>& reach) {
  const TimeOf<Number> start = later(a.time, b.time);
  const VectorOf<Number> shift{images.shift(image.x, image.y, start), image.y * period.y, image.z * period.z};
  StateOf<Number> relative = relative_state_at(StraightMotion{}, a, b, shift, start);
  relative.velocity.x = relative.velocity.x + image.y * Number(images.speed());
  return after(start, time_to_reach(relative.position, relative.velocity, reach));
}

/// The contact time of two spheres whose sizes change, compiled once; `reach` [L] is the sum of the base
/// radii.
HARDBALL_EXPORT Time contact_time_of_growing(const Growth& growth, const Path& a, const Path& b,
                                             const Vec3& shift, double reach);

/// The contact time of two spheres in any motion; where sizes change, `reach` is the sum of the base radii
/// [L].
HARDBALL_ALWAYS_INLINE Time contact_time(const Motion& motion, const Path& a, const Path& b,
                                         const Vec3& shift, double reach) {
  if (motion.has_growth()) [[unlikely]]
    return contact_time_of_growing(motion.growth(), a, b, shift, reach);
  return contact_time<Motion, double>(motion, a, b, shift, reach);
}

}  // namespace hardball
