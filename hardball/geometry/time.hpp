// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cmath>
#include <compare>
#include <cstdint>
#include <limits>

#include "hardball/errors/language.hpp"

namespace hardball {

/// A point in time [T], held as the unevaluated sum of two doubles; `high` is the double nearest to the sum.
///
/// A single double would resolve a time t only to t * 2^-53, so that contacts blur in long runs. The pair
/// resolves t * 2^-106: after 1e12 units of time it is still more precise than a single double near one. The
/// representation is unique, so times compare by their parts.
struct Time {
  static constexpr bool kIsPlain = true;  ///< To archives.

  double high = 0;
  double low = 0;

  constexpr Time() = default;
  constexpr explicit Time(double moment) : high(moment) {}
  constexpr Time(double high_part, double low_part) : high(high_part), low(low_part) {}

  /// The double nearest to this time.
  constexpr double value() const { return high; }

  friend constexpr bool operator==(const Time&, const Time&) = default;
  friend constexpr std::partial_ordering operator<=>(const Time& a, const Time& b) {
    return a.high != b.high ? a.high <=> b.high : a.low <=> b.low;
  }
  // These four follow from the order; through three-way comparison compilers generate worse code.
  friend constexpr bool operator<(const Time& a, const Time& b) {
    return a.high < b.high || (a.high == b.high && a.low < b.low);
  }
  friend constexpr bool operator>(const Time& a, const Time& b) { return b < a; }
  friend constexpr bool operator<=(const Time& a, const Time& b) {
    return a.high < b.high || (a.high == b.high && a.low <= b.low);
  }
  friend constexpr bool operator>=(const Time& a, const Time& b) { return b <= a; }
};

/// Later than any other time: that of an event that does not happen.
inline constexpr Time kNever{std::numeric_limits<double>::infinity(), 0};

inline Time later(const Time& a, const Time& b) {
  return a < b ? b : a;
}
inline Time earlier(const Time& a, const Time& b) {
  return b < a ? b : a;
}

/// The largest double below a finite number.
inline double double_before(double number) {
  if (number == 0) return -std::numeric_limits<double>::denorm_min();
  const auto bits = std::bit_cast<std::int64_t>(number);
  return std::bit_cast<double>(number > 0 ? bits - 1 : bits + 1);
}

/// The largest double not after a time.
inline double rounded_down(const Time& time) {
  if (time.high == 0) [[unlikely]]
    return time.low < 0 ? double_before(0) : time.high;
  // Branchless: the sign of the low part is unpredictable.
  const auto bits = std::bit_cast<std::int64_t>(time.high);
  const std::int64_t step = (bits >> 63) | 1;
  return std::bit_cast<double>(bits - (time.low < 0 ? step : 0));
}

/// The time from `start` to `end` [T], accurate to two units in the last place of the result, or to 2^-106 of
/// the arguments if that is more. Precondition: both are finite.
inline double duration(const Time& start, const Time& end) {
  return (end.high - start.high) + (end.low - start.low);
}

/// The time `wait` [T] after `start`; kNever if `wait` is infinite.
/// Source: Knuth, The Art of Computer Programming 2, section 4.2.2, theorem B (exact sum of two doubles).
inline Time after(const Time& start, double wait) {
  const double sum = start.high + wait;
  if (!std::isfinite(sum)) return kNever;
  const double wait_part = sum - start.high;
  const double error = (start.high - (sum - wait_part)) + (wait - wait_part);
  const double rest = error + start.low;
  const double high = sum + rest;
  return {high, rest - (high - sum)};
}

}  // namespace hardball
