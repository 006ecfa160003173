// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <compare>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "hardball/errors/language.hpp"
#include "hardball/geometry/double_double.hpp"
#include "hardball/standard/bit_cast.hpp"

namespace hardball {

/// A point in time [T], or one in each lane of the numbers (number.hpp), held as the unevaluated sum of two;
/// `high` is the number nearest to the sum.
///
/// A single double would resolve a time t only to t * 2^-53, so that contacts blur in long runs. The pair
/// resolves t * 2^-106: after 1e12 units of time it is still more precise than a single double near one. The
/// representation is unique, so times compare by their parts.
template <class Number>
struct TimeOf {
  using PlainNumber = Number;  ///< To archives.

  Number high{};
  Number low{};

  constexpr TimeOf() = default;
  constexpr explicit TimeOf(const Number& moment) : high(moment) {}
  constexpr TimeOf(const Number& high_part, const Number& low_part) : high(high_part), low(low_part) {}

  /// The number nearest to this time.
  constexpr Number value() const { return high; }

  friend constexpr bool operator==(const TimeOf&, const TimeOf&) = default;
  friend constexpr std::partial_ordering operator<=>(const TimeOf& a, const TimeOf& b) {
    return a.high != b.high ? a.high <=> b.high : a.low <=> b.low;
  }
  // These four follow from the order; through three-way comparison compilers generate worse code.
  HARDBALL_ALWAYS_INLINE friend constexpr auto operator<(const TimeOf& a, const TimeOf& b) {
    return a.high < b.high || (a.high == b.high && a.low < b.low);
  }
  friend constexpr auto operator>(const TimeOf& a, const TimeOf& b) { return b < a; }
  friend constexpr auto operator<=(const TimeOf& a, const TimeOf& b) {
    return a.high < b.high || (a.high == b.high && a.low <= b.low);
  }
  friend constexpr auto operator>=(const TimeOf& a, const TimeOf& b) { return b <= a; }
};

/// A point in time [T], a pair of doubles.
using Time = TimeOf<double>;

/// Later than any other time: that of an event that does not happen.
inline constexpr Time kNever{std::numeric_limits<double>::infinity(), 0};

/// The later of two times; the first if they are alike.
template <class Number>
HARDBALL_ALWAYS_INLINE TimeOf<Number> later(const TimeOf<Number>& a, const TimeOf<Number>& b) {
  const auto b_is_later = a < b;
  return {select(b_is_later, b.high, a.high), select(b_is_later, b.low, a.low)};
}
/// The earlier of two times.
inline Time earlier(const Time& a, const Time& b) {
  return b < a ? b : a;
}

/// The largest double below a finite number.
inline double double_before(double number) {
  if (number == 0) return -std::numeric_limits<double>::denorm_min();
  const auto bits = bit_cast<std::int64_t>(number);
  return bit_cast<double>(number > 0 ? bits - 1 : bits + 1);
}

/// The largest double not after a time.
inline double rounded_down(const Time& time) {
  if (time.high == 0) [[unlikely]]
    return time.low < 0 ? double_before(0) : time.high;
  // Branchless: the sign of the low part is unpredictable.
  const auto bits = bit_cast<std::int64_t>(time.high);
  const std::int64_t step = (bits >> 63) | 1;
  return bit_cast<double>(bits - (time.low < 0 ? step : 0));
}

/// The time from `start` to `end` [T], accurate to two units in the last place of the result, or to 2^-106 of
/// the arguments if that is more. Precondition: both are finite.
template <class Number>
HARDBALL_ALWAYS_INLINE Number duration(const TimeOf<Number>& start, const TimeOf<Number>& end) {
  return (end.high - start.high) + (end.low - start.low);
}

/// The time `wait` [T] after `start`; kNever if `wait` is infinite.
template <class Number>
HARDBALL_ALWAYS_INLINE TimeOf<Number> after(const TimeOf<Number>& start,
                                            const std::type_identity_t<Number>& wait) {
  const Number forever(kNever.high);
  const DoubleDouble<Number> end = sum(start.high, wait);
  const DoubleDouble<Number> time = normalized(end.high, end.low + start.low);
  const auto happens = time.high < forever;  // of infinity the error is NaN
  return {select(happens, time.high, forever), select(happens, time.low, Number(kNever.low))};
}

}  // namespace hardball
