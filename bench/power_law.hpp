// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

namespace hardball::bench {

/// A fit y = factor * x^exponent.
struct PowerLaw {
  double exponent = 0;
  double standard_error = 0;  ///< Standard error of the exponent; NaN for fewer than three points.
  double factor = 0;
  std::size_t points = 0;
};

/// Least squares of log y over log x, with equal weights. Precondition: `x` and `y` have the same length and
/// are positive. The exponent is NaN for fewer than two different x.
PowerLaw fit_power_law(std::span<const double> x, std::span<const double> y);

}  // namespace hardball::bench
