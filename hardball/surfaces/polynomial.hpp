// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "hardball/errors/export.hpp"
#include "hardball/geometry/double_double.hpp"

namespace hardball {

/// A polynomial in time of degree four at most, its coefficients in twice the precision: how a squared
/// distance changes along a parabola, for one.
struct HARDBALL_EXPORT Polynomial {
  static constexpr std::size_t kMaxDegree = 4;

  std::array<DoubleDouble<>, kMaxDegree + 1> coefficients{};  ///< Coefficients of t^0, t^1, and so on.

  DoubleDouble<> operator()(double t) const;
  /// The highest power whose coefficient is not zero.
  std::size_t degree() const;
  Polynomial derivative() const;
};

/// The intervals of t >= 0 in which a polynomial is not positive and decreases, in order: two at most.
struct Descents {
  struct Interval {
    double begin;
    double end;  ///< Infinite if it decreases forever.
  };
  std::array<Interval, 2> intervals{};
  std::size_t count = 0;

  const Interval* begin() const { return intervals.data(); }
  const Interval* end() const { return intervals.data() + count; }
};

/// Where a gap is closed and closes. The begins are as precise as earliest_descent, which is the first.
HARDBALL_EXPORT Descents descents(const Polynomial& polynomial);

/// The earliest t >= 0 at which the polynomial is not positive and decreases; infinity if there is none.
///
/// So a gap that is closed and still closing gives zero; one that is closed but opens, the time at which it
/// turns; and a gap that is only grazed, infinity. Up to degree two accurate to a few units in the last
/// place; beyond, the least double at which the polynomial, evaluated in twice the precision, is not
/// positive. Source: Bannerman et al., Comp. Part. Mech. 1 (2014) 191, section 2.
HARDBALL_EXPORT double earliest_descent(const Polynomial& polynomial);

}  // namespace hardball
