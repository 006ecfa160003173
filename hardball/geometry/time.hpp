// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <compare>
#include <limits>

namespace hardball {

/// A moment [T], held as the unevaluated sum of two doubles, `high` being the double nearest to the sum.
///
/// A single double would resolve a moment t only to t * 2^-53, so that contacts blur as a run grows long. The
/// pair resolves t * 2^-106: after 1e12 units of time a moment is still known better than a fresh double
/// knows a moment near one. The representation is unique, so moments compare by their parts.
struct Time {
  double high = 0;
  double low = 0;

  constexpr Time() = default;
  constexpr explicit Time(double moment) : high(moment) {}
  constexpr Time(double high_part, double low_part) : high(high_part), low(low_part) {}

  /// The double nearest to this moment.
  constexpr double value() const { return high; }

  friend constexpr bool operator==(const Time&, const Time&) = default;
  friend constexpr std::partial_ordering operator<=>(const Time& a, const Time& b) {
    return a.high != b.high ? a.high <=> b.high : a.low <=> b.low;
  }
  // These four follow from the order; compilers make less of them through three-way comparison.
  friend constexpr bool operator<(const Time& a, const Time& b) {
    return a.high < b.high || (a.high == b.high && a.low < b.low);
  }
  friend constexpr bool operator>(const Time& a, const Time& b) { return b < a; }
  friend constexpr bool operator<=(const Time& a, const Time& b) {
    return a.high < b.high || (a.high == b.high && a.low <= b.low);
  }
  friend constexpr bool operator>=(const Time& a, const Time& b) { return b <= a; }
};

/// Later than every moment: the time of an event that does not happen.
inline constexpr Time kNever{std::numeric_limits<double>::infinity(), 0};

inline Time later(const Time& a, const Time& b) {
  return a < b ? b : a;
}
inline Time earlier(const Time& a, const Time& b) {
  return b < a ? b : a;
}

/// The time from `start` to `end` [T], right to two units in the last place of the result, or to 2^-106 of
/// the moments if that is more. Precondition: both are finite.
inline double duration(const Time& start, const Time& end) {
  return (end.high - start.high) + (end.low - start.low);
}

/// The moment `wait` [T] after `start`, kNever when `wait` is infinite.
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
