// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>

#include "hardball/geometry/double_double.hpp"
#include "hardball/geometry/vec3.hpp"

namespace hardball {

/// The separation of two centers, and the sum of their radii, while both change uniformly: in one number, or
/// one in each lane (number.hpp).
template <class Number>
struct GrowingPair {
  VectorOf<Number> separation;  ///< [L]
  VectorOf<Number> velocity;    ///< Rate of the separation [L/T].
  Number reach;                 ///< The sum of the radii [L].
  Number growth;                ///< Rate of the reach [L/T].
};

/// Half the rate at which the squared distance of two centers changes, less half that of the squared reach
/// [L^2/T]: negative where the surfaces approach each other. To 106 bits, rounded: contacts near jamming are
/// decided by its last bits. Exchanging the spheres changes no bit of it.
template <class Number>
HARDBALL_ALWAYS_INLINE Number approach(const GrowingPair<Number>& pair) {
  const VectorOf<Number>& r = pair.separation;
  const VectorOf<Number>& v = pair.velocity;
  return (sum_of_three(product(r.x, v.x), product(r.y, v.y), product(r.z, v.z)) -
          product(pair.reach, pair.growth))
      .high;
}

/// The time until the surfaces of two spheres first touch while they approach each other; infinity if they
/// never do.
///
/// Overlapping and approaching means now (zero); touching without overlap means never, and so do centers at
/// the same place, which have no direction to part in. Surfaces that recede may meet later where radii grow
/// faster than the centers part. The coefficients of the quadratic are computed to 106 bits: near jamming,
/// the gaps between spheres are the last bits of their distances.
template <class Number>
HARDBALL_ALWAYS_INLINE Number time_to_touch(const GrowingPair<Number>& pair) {
  const Number zero(0.0);
  const Number forever(std::numeric_limits<double>::infinity());
  const VectorOf<Number>& r = pair.separation;
  const VectorOf<Number>& v = pair.velocity;
  const Number& reach = pair.reach;
  const Number& growth = pair.growth;
  // The squared distance less the squared reach is excess + 2 closing t + acceleration t^2.
  const Number closing = approach(pair);
  const auto square = sum_of_three(product(r.x, r.x), product(r.y, r.y), product(r.z, r.z));
  const Number excess = (square - product(reach, reach)).high;
  const Number acceleration =
      (sum_of_three(product(v.x, v.x), product(v.y, v.y), product(v.z, v.z)) - product(growth, growth)).high;
  const auto approaches = closing < zero;
  const auto is_apart = excess > zero;
  const auto is_overtaken = acceleration < zero;
  // Kernels pad their lanes with the sphere itself.
  const auto are_two = square.high > zero;
  if (ends(!are_two || (!approaches && !is_overtaken))) return forever;
  // closing^2 - acceleration excess = |reach v - growth r|^2 - |r x v|^2, which cancels less.
  const auto along = [&](const Number& of_r, const Number& of_v) {
    const auto component = difference_of_products(reach, of_v, growth, of_r);
    return component * component;
  };
  const auto across = [](const Number& a, const Number& b, const Number& c, const Number& d) {
    const auto component = difference_of_products(a, b, c, d);
    return component * component;
  };
  const Number discriminant =
      (sum_of_three(along(r.x, v.x), along(r.y, v.y), along(r.z, v.z)) -
       sum_of_three(across(r.y, v.z, r.z, v.y), across(r.z, v.x, r.x, v.z), across(r.x, v.y, r.y, v.x)))
          .high;
  const auto touches = discriminant > zero;
  const Number root = square_root(select(touches, discriminant, zero));
  // Each root in the form that does not cancel.
  const Number sooner = select(is_apart, select(touches, excess / (root - closing), forever), zero);
  const Number last = (closing + root) / (zero - acceleration);
  const Number wait = select(approaches, sooner, select(is_overtaken, last, forever));
  // Where radii shrink, squares meet again when they would be negative.
  return select(are_two && reach + growth * wait > zero, wait, forever);
}

}  // namespace hardball
