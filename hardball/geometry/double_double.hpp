// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "hardball/geometry/always_inline.hpp"

namespace hardball {

/// A number held as the unevaluated sum of two doubles: about 106 bits.
/// Source: Dekker, Numer. Math. 18 (1971) 224; Ogita, Rump and Oishi, SIAM J. Sci. Comput. 26 (2005)
/// 1955.
struct DoubleDouble {
  double high = 0;
  double low = 0;
};

/// The exact sum of two doubles.
HARDBALL_ALWAYS_INLINE DoubleDouble sum(double a, double b) {
  const double high = a + b;
  const double b_part = high - a;
  return {high, (a - (high - b_part)) + (b - b_part)};
}

/// The exact product of two doubles. std::fma rounds once on every platform, in hardware or in software.
HARDBALL_ALWAYS_INLINE DoubleDouble product(double a, double b) {
  const double high = a * b;
  return {high, std::fma(a, b, -high)};
}

/// The same number with the double nearest to it as its high part. Precondition: |low| is at most |high|.
HARDBALL_ALWAYS_INLINE DoubleDouble normalized(double high, double low) {
  const double nearest = high + low;
  return {nearest, low - (nearest - high)};
}

/// a b - c d, to 2^-104 of the larger product.
HARDBALL_ALWAYS_INLINE DoubleDouble difference_of_products(double a, double b, double c, double d) {
  const DoubleDouble ab = product(a, b);
  const DoubleDouble cd = product(c, d);
  const DoubleDouble high = sum(ab.high, -cd.high);
  return normalized(high.high, high.low + (ab.low - cd.low));
}

/// a + b + c, to 2^-103 of the largest.
HARDBALL_ALWAYS_INLINE DoubleDouble sum_of_three(const DoubleDouble& a, const DoubleDouble& b,
                                                 const DoubleDouble& c) {
  const DoubleDouble ab = sum(a.high, b.high);
  const DoubleDouble abc = sum(ab.high, c.high);
  return normalized(abc.high, (ab.low + abc.low) + ((a.low + b.low) + c.low));
}

HARDBALL_ALWAYS_INLINE DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble high = sum(a.high, -b.high);
  return normalized(high.high, high.low + (a.low - b.low));
}

HARDBALL_ALWAYS_INLINE DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble high = product(a.high, b.high);
  return normalized(high.high, high.low + (a.high * b.low + a.low * b.high));
}

}  // namespace hardball
