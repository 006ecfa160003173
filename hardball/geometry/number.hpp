// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "hardball/geometry/inlining.hpp"

namespace hardball {

// The formulas of vectors, times, motions and contacts are templates on the number: a double, or a vector of
// doubles, one of each pair (kernels/). All that they use besides + - * / is here, for doubles. Comparisons
// of vectors give masks, of which &&, || and ! take lane by lane; a vector has its own select, maximum,
// square_root, product_error, round_to_integer, and bits of a mask.
//
// Such templates are always inlined: they are compiled for wider instructions too, and the linker would take
// one copy for all.

HARDBALL_ALWAYS_INLINE double select(bool condition, double a, double b) {
  return condition ? a : b;
}

HARDBALL_ALWAYS_INLINE double maximum(double a, double b) {
  return a > b ? a : b;
}

HARDBALL_ALWAYS_INLINE double square_root(double a) {
  return std::sqrt(a);
}

/// a b - product, exactly, `product` being a b as it is rounded, from numbers of half the bits. Source:
/// Dekker, Numer. Math. 18 (1971) 224. Precondition: neither number exceeds 2^970, nor is the error below the
/// least normal number.
template <class Number>
HARDBALL_ALWAYS_INLINE Number product_error_by_halves(const Number& a, const Number& b,
                                                      const Number& product) {
  const Number splitter(0x1p27 + 1);
  const Number a_wide = splitter * a;
  const Number b_wide = splitter * b;
  const Number a_high = a_wide - (a_wide - a);
  const Number b_high = b_wide - (b_wide - b);
  const Number a_low = a - a_high;
  const Number b_low = b - b_high;
  return ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
}

/// a b - product, exactly, `product` being a b as it is rounded. std::fma rounds once on every platform, in
/// hardware or in software; WebAssembly has no such instruction.
HARDBALL_ALWAYS_INLINE double product_error(double a, double b, double product) {
#if defined(__wasm__)
  return product_error_by_halves(a, b, product);
#else
  return std::fma(a, b, -product);
#endif
}

/// The nearest integer, or of two the even one: adding this number rounds the fraction away. Precondition:
/// |a| < 2^51.
template <class Number>
HARDBALL_ALWAYS_INLINE Number round_to_integer(const Number& a) {
  const Number pusher(0x1.8p52);
  return (a + pusher) - pusher;
}

/// Whether a condition holds for any lane.
HARDBALL_ALWAYS_INLINE bool any(bool condition) {
  return condition;
}
template <class Mask>
HARDBALL_ALWAYS_INLINE bool any(const Mask& mask) {
  return bits(mask) != 0;
}

/// Whether a formula may end where a condition holds: that of a single number may. The lanes of a vector
/// seldom agree, so it continues, and masks choose.
HARDBALL_ALWAYS_INLINE bool ends(bool condition) {
  return condition;
}
template <class Mask>
HARDBALL_ALWAYS_INLINE bool ends(const Mask&) {
  return false;
}

}  // namespace hardball
