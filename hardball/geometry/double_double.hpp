// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "hardball/geometry/number.hpp"

namespace hardball {

/// A number held as the unevaluated sum of two: about 106 bits. The numbers are doubles, or vectors of them
/// (kernels/).
/// Source: Dekker, Numer. Math. 18 (1971) 224; Ogita, Rump and Oishi, SIAM J. Sci. Comput. 26 (2005)
/// 1955.
template <class Number = double>
struct DoubleDouble {
  Number high;
  Number low;
};

/// The exact sum of two numbers.
template <class Number>
HARDBALL_ALWAYS_INLINE DoubleDouble<Number> sum(const Number& a, const Number& b) {
  const Number high = a + b;
  const Number b_part = high - a;
  return {high, (a - (high - b_part)) + (b - b_part)};
}

/// The exact difference of two numbers.
template <class Number>
HARDBALL_ALWAYS_INLINE DoubleDouble<Number> difference(const Number& a, const Number& b) {
  const Number high = a - b;
  const Number b_part = a - high;
  return {high, (a - (high + b_part)) - (b - b_part)};
}

/// The exact product of two numbers.
template <class Number>
HARDBALL_ALWAYS_INLINE DoubleDouble<Number> product(const Number& a, const Number& b) {
  const Number high = a * b;
  return {high, product_error(a, b, high)};
}

/// The sum of two doubles with the double nearest to it as its high part. Precondition: |low| is at most
/// |high|.
template <class Number>
HARDBALL_ALWAYS_INLINE DoubleDouble<Number> normalized(const Number& high, const Number& low) {
  const Number nearest = high + low;
  return {nearest, low - (nearest - high)};
}

/// a b - c d, to 2^-104 of the larger product.
template <class Number>
HARDBALL_ALWAYS_INLINE DoubleDouble<Number> difference_of_products(const Number& a, const Number& b,
                                                                   const Number& c, const Number& d) {
  return product(a, b) - product(c, d);
}

/// a + b + c, to 2^-103 of the largest.
template <class Number>
HARDBALL_ALWAYS_INLINE DoubleDouble<Number> sum_of_three(const DoubleDouble<Number>& a,
                                                         const DoubleDouble<Number>& b,
                                                         const DoubleDouble<Number>& c) {
  const DoubleDouble<Number> ab = sum(a.high, b.high);
  const DoubleDouble<Number> abc = sum(ab.high, c.high);
  return normalized<Number>(abc.high, (ab.low + abc.low) + ((a.low + b.low) + c.low));
}

template <class Number>
HARDBALL_ALWAYS_INLINE DoubleDouble<Number> operator-(const DoubleDouble<Number>& a,
                                                      const DoubleDouble<Number>& b) {
  const DoubleDouble<Number> high = difference(a.high, b.high);
  return normalized<Number>(high.high, high.low + (a.low - b.low));
}

template <class Number>
HARDBALL_ALWAYS_INLINE DoubleDouble<Number> operator+(const DoubleDouble<Number>& a,
                                                      const DoubleDouble<Number>& b) {
  const DoubleDouble<Number> high = sum(a.high, b.high);
  return normalized<Number>(high.high, high.low + (a.low + b.low));
}

template <class Number>
HARDBALL_ALWAYS_INLINE DoubleDouble<Number> operator-(const DoubleDouble<Number>& a) {
  return {-a.high, -a.low};
}

template <class Number>
HARDBALL_ALWAYS_INLINE DoubleDouble<Number> operator*(const DoubleDouble<Number>& a,
                                                      const DoubleDouble<Number>& b) {
  const DoubleDouble<Number> high = product(a.high, b.high);
  return normalized<Number>(high.high, high.low + (a.high * b.low + a.low * b.high));
}

/// a / b, to 2^-102.
HARDBALL_ALWAYS_INLINE DoubleDouble<double> divide(const DoubleDouble<double>& a, double b) {
  const double high = a.high / b;
  const DoubleDouble<double> taken = product(high, b);
  // The first difference is exact.
  return normalized<double>(high, (((a.high - taken.high) - taken.low) + a.low) / b);
}

}  // namespace hardball
