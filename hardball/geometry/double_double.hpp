// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

/// For small functions that are also compiled for wider instructions than the rest of the program: without a copy
/// of their own, the linker cannot take that copy for all.
#if defined(__GNUC__)
#define HARDBALL_ALWAYS_INLINE [[gnu::always_inline]] inline
#else
#define HARDBALL_ALWAYS_INLINE inline
#endif

namespace hardball {

/// A number held as the unevaluated sum of two doubles: about 106 bits.
/// Source: Dekker, Numer. Math. 18 (1971) 224; Hida, Li and Bailey, 15th IEEE ARITH (2001) 155.
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

HARDBALL_ALWAYS_INLINE DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble high = sum(a.high, b.high);
  const DoubleDouble low = sum(a.low, b.low);
  const DoubleDouble middle = sum(high.high, high.low + low.high);
  return sum(middle.high, middle.low + low.low);
}

HARDBALL_ALWAYS_INLINE DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) {
  return a + DoubleDouble{-b.high, -b.low};
}

HARDBALL_ALWAYS_INLINE DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble high = product(a.high, b.high);
  return sum(high.high, high.low + (a.high * b.low + a.low * b.high));
}

}  // namespace hardball
