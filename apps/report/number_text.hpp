// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

/// Numbers and units as printed: with true minus signs, powers of ten and raised exponents.
namespace hardball::report {

/// A number to `digits` significant digits, without trailing zeros: "−1.25", "3.2·10⁻¹⁶"; "–" if it is NaN.
std::string number_text(double value, int digits = 6);

/// A count with thousands separators: "1,234,567".
std::string count_text(std::uint64_t count);

/// Whether a standard error is known, and larger than rounding.
bool is_known_error(double value, double error);

/// A measured value to two digits of its standard error, which is in parentheses in units of the last digit:
/// "7.752(34)" for 7.752 ± 0.034; to six digits if there is no such error.
std::string measured_text(double value, double error);

/// How far a value is from its theory: in standard errors, "+1.3 σ", or without an error in percent,
/// "+0.21%"; "–" where neither is meaningful.
std::string deviation_text(double value, double error, double theory);

/// A unit such as "L^2 T^-1" with raised exponents, "L² T⁻¹"; empty for a pure number, "1".
std::string unit_text(std::string_view unit);

/// A size in memory: "12.3 MB".
std::string bytes_text(double bytes);

/// A rate per second, to three digits, with thousands separators: "988,000".
std::string rate_text(double rate);

/// A duration: "0.42 s", "3 min 20 s".
std::string seconds_text(double seconds);

}  // namespace hardball::report
