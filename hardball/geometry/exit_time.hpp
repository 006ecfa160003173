// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <type_traits>

#include "hardball/geometry/contact_time.hpp"
#include "hardball/geometry/double_double.hpp"
#include "hardball/geometry/grazing_time.hpp"
#include "hardball/geometry/vec3.hpp"

namespace hardball {

/// (reach |velocity|)^2 - |separation x velocity|^2, to 106 bits, rounded [L^4/T^2]: positive where a point
/// that passes at `separation` [L] with `velocity` [L/T] comes within `reach` [L].
template <class Number>
HARDBALL_ALWAYS_INLINE Number chord_discriminant(const VectorOf<Number>& r, const VectorOf<Number>& v,
                                                 const std::type_identity_t<Number>& reach) {
  const auto x = difference_of_products(r.y, v.z, r.z, v.y);
  const auto y = difference_of_products(r.z, v.x, r.x, v.z);
  const auto z = difference_of_products(r.x, v.y, r.y, v.x);
  const auto speed_squared = sum_of_three(product(v.x, v.x), product(v.y, v.y), product(v.z, v.z));
  return (speed_squared * product(reach, reach) - sum_of_three(x * x, y * y, z * z)).high;
}

/// |separation|^2 - reach^2, to 106 bits, rounded [L^2].
template <class Number>
HARDBALL_ALWAYS_INLINE Number squared_excess(const VectorOf<Number>& r,
                                             const std::type_identity_t<Number>& reach) {
  return (sum_of_three(product(r.x, r.x), product(r.y, r.y), product(r.z, r.z)) - product(reach, reach)).high;
}

/// separation . velocity, to 106 bits, rounded [L^2/T].
template <class Number>
HARDBALL_ALWAYS_INLINE Number approach_to_106_bits(const VectorOf<Number>& r, const VectorOf<Number>& v) {
  return sum_of_three(product(r.x, v.x), product(r.y, v.y), product(r.z, v.z)).high;
}

/// The bound for exits that corresponds to kGrazingCosineSquared (grazing_time.hpp) [1]: an error of the
/// discriminant shows in the time, by no more than sixteen times as much, and not in the distance at that
/// time.
inline constexpr double kGrazingExitCosineSquared = 1.0 / 256;

/// The time until two points that are within `reach` [L] of each other, and whose separation [L] changes with
/// `velocity` [L/T], are farther apart and recede; infinity if they are at relative rest.
///
/// Points that are farther apart, by rounding, leave now if they recede. If they approach, they leave where
/// they have passed through; if they come no nearer than `reach`, when they are nearest. Accurate to 64
/// units in the last place of `reach` over the speed, grazing passages included; the points are then apart by
/// `reach` to eight of its units. Negating both vectors changes no bit of the result, which is the same in
/// each lane of the numbers (number.hpp).
template <class Number>
HARDBALL_ALWAYS_INLINE Number time_to_exit(const VectorOf<Number>& separation,
                                           const VectorOf<Number>& velocity,
                                           const std::type_identity_t<Number>& reach) {
  const Number zero(0.0);
  const Number forever(std::numeric_limits<double>::infinity());
  const Number speed_squared = dot(velocity, velocity);
  const auto moves = speed_squared > zero;
  if (ends(!moves)) return forever;
  const VectorOf<Number> angular = cross(separation, velocity);
  const Number reach_squared = reach * reach;
  const Number closest = speed_squared * reach_squared;
  Number discriminant = closest - dot(angular, angular);
  Number approach = dot(separation, velocity);
  Number excess = dot(separation, separation) - reach_squared;
  const auto grazes = !(discriminant > Number(kGrazingExitCosineSquared) * closest);
  if (any(grazes)) {
    discriminant = select(grazes, chord_discriminant(separation, velocity, reach), discriminant);
    excess = select(grazes, squared_excess(separation, reach), excess);
    approach = select(grazes, approach_to_106_bits(separation, velocity), approach);
  }
  const auto approaches = approach < zero;
  const auto is_beyond = !(excess < zero) && !approaches;
  const auto has_chord = discriminant > zero;
  // Each root in the form that does not cancel.
  const Number root = square_root(maximum(discriminant, zero));
  const Number chord =
      select(approaches, (root - approach) / speed_squared, (zero - excess) / (approach + root));
  const Number nearest = select(approaches, (zero - approach) / speed_squared, zero);
  const Number wait = select(is_beyond, zero, select(has_chord, chord, nearest));
  return select(moves, wait, forever);
}

/// The next event of two points between two reaches [L]: they come within the inner one while they approach
/// each other, which is never if it is zero; or else they leave the outer one.
template <class Number>
struct WaitBetween {
  Number inward;   ///< [T]; infinite if they leave first.
  Number outward;  ///< [T]; of use if they do not come inwards.
};

template <class Number>
HARDBALL_ALWAYS_INLINE WaitBetween<Number> wait_between(const VectorOf<Number>& separation,
                                                        const VectorOf<Number>& velocity,
                                                        const std::type_identity_t<Number>& inner,
                                                        const std::type_identity_t<Number>& outer) {
  const Number forever(std::numeric_limits<double>::infinity());
  // What comes inwards comes before the way out.
  const Number inward = time_to_reach<Number>(separation, velocity, inner);
  if (ends(inward < forever)) return {inward, forever};
  return {inward, time_to_exit<Number>(separation, velocity, outer)};
}

/// The time of the event of two paths between two reaches, the second displaced by `shift` [L]: a function of
/// the paths alone, as contact_time (contact_time.hpp) is.
template <class Number>
HARDBALL_ALWAYS_INLINE TimeOf<Number> time_between(const PathOf<Number>& a, const PathOf<Number>& b,
                                                   const VectorOf<Number>& shift, const Number& inner,
                                                   const Number& outer) {
  const TimeOf<Number> start = later(a.time, b.time);
  const StateOf<Number> relative = relative_state_at(StraightMotion(), a, b, shift, start);
  const WaitBetween<Number> wait = wait_between(relative.position, relative.velocity, inner, outer);
  const Number forever(std::numeric_limits<double>::infinity());
  return after(start, select(wait.inward < forever, wait.inward, wait.outward));
}

}  // namespace hardball
