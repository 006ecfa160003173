// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <string_view>

#include "hardball/geometry/time.hpp"

namespace hardball {

/// The operating range: lengths, speeds and masses are zero where that makes sense, or of a magnitude between
/// these. Contact times multiply four lengths and speeds; within the range nothing overflows or underflows.
inline constexpr double kSmallestMagnitude = 1e-60;
inline constexpr double kLargestMagnitude = 1e60;

/// The largest magnitude of a moment: the largest length over the smallest speed [T].
inline constexpr double kLargestTime = kLargestMagnitude / kSmallestMagnitude;

/// Whether a number is zero, or of a magnitude in the operating range.
inline bool is_in_range(double number) {
  const double magnitude = std::fabs(number);
  return number == 0 || (magnitude >= kSmallestMagnitude && magnitude <= kLargestMagnitude);
}

/// Error, with `where` as its place: `number` is NaN, infinite or beyond kLargestMagnitude.
void check_finite(double number, std::string_view name, std::string_view where);

/// Error, with `where` as its place: `number` is not positive or outside the operating range.
void check_positive(double number, std::string_view name, std::string_view where);

/// Whether a moment is finite, not beyond kLargestTime, and its parts make a Time.
inline bool is_moment(const Time& moment) {
  // A low part that is not finite fails the second comparison.
  return std::fabs(moment.high) <= kLargestTime && moment.high + moment.low == moment.high;
}

/// Throws the Error of check_moment.
[[noreturn]] void refuse_moment(const Time& moment, std::string_view where);

/// Error, with `where` as its place: not is_moment(moment).
inline void check_moment(const Time& moment, std::string_view where) {
  if (!is_moment(moment)) refuse_moment(moment, where);
}

/// Error, with `where` as its place: `moment` is NaN or infinite. Weaker than check_moment: events of spheres
/// slowed down by inelastic collapse may lie beyond its range.
inline void check_finite(const Time& moment, std::string_view where) {
  if (!std::isfinite(moment.high)) refuse_moment(moment, where);
}

}  // namespace hardball
