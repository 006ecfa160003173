// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <limits>
#include <span>

namespace hardball {

/// A number with its statistical error.
struct Estimate {
  double value = std::numeric_limits<double>::quiet_NaN();
  double error = std::numeric_limits<double>::quiet_NaN();  ///< Standard error; NaN if it is not known.
};

/// A function of several means, such as a ratio or a fit.
using FunctionOfMeans = std::function<double(std::span<const double> means)>;

/// The value of `quantity` for the means over all blocks, and its standard error by leaving out one block
/// after the other.
///
/// `sums` has shape (blocks, bins), and bin k of the means is the sum over blocks of sums[block][k] over that
/// of weights[block]. The error is NaN if there are fewer than two blocks. Cost: O(blocks) calls of
/// `quantity`. Source: Miller, Biometrika 61 (1974) 1, the jackknife.
Estimate jackknife(std::span<const double> sums, std::span<const double> weights,
                   const FunctionOfMeans& quantity);

}  // namespace hardball
