// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace hardball {

/// The operating range: lengths, speeds and masses are zero where that makes sense, or of a magnitude between
/// these. Contact times multiply four lengths and speeds; within the range nothing overflows or underflows.
inline constexpr double kSmallestMagnitude = 1e-60;
inline constexpr double kLargestMagnitude = 1e60;

/// Error, with `where` as its place: `number` is NaN, infinite or beyond kLargestMagnitude.
void check_finite(double number, const std::string& name, const std::string& where);

/// Error, with `where` as its place: `number` is not positive or outside the operating range.
void check_positive(double number, const std::string& name, const std::string& where);

}  // namespace hardball
