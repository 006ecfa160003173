// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <limits>
#include <span>
#include <vector>

namespace hardball {

/// A number with its statistical error.
///
/// The error is scaled so that twice it covers 95% of runs also where it is known from little: it is the
/// standard deviation expected, times Student's factor. It is NaN if the run cannot tell.
struct Estimate {
  double value = std::numeric_limits<double>::quiet_NaN();
  double error = std::numeric_limits<double>::quiet_NaN();
};

/// A product, the errors of whose factors are independent.
Estimate operator*(const Estimate& a, const Estimate& b);

/// A function of several means, such as a ratio or a fit.
using FunctionOfMeans = std::function<double(std::span<const double> means)>;

/// A number made of parts, and by how much each part moved it.
struct Parts {
  double value = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> shares = {};  ///< They add up to about zero.
};

/// The value of `quantity` for the means over all parts, and how far each part moves it, by leaving out one
/// after the other.
///
/// `sums` has shape (parts, bins), and bin k of the means is the sum over parts of sums[part][k] over that
/// of weights[part]. Cost: O(parts) calls of `quantity`. Source: Miller, Biometrika 61 (1974) 1, the
/// jackknife.
Parts jackknife(std::span<const double> sums, std::span<const double> weights,
                const FunctionOfMeans& quantity);

/// Standard error of a number to which parts that are independent of each other, such as groups of spheres,
/// added these shares. NaN if there are fewer than four.
double error_of_independent(std::span<const double> shares);

/// How many independent parts in a row would tell as much as these [1], at most twice as many as there are:
/// their number over the sum of their autocorrelations. The smaller of two is taken: that of Geyer's initial
/// monotone sequence, which holds for slow correlations under noise, and that of an autoregressive process
/// of first order, which is the better known if the run is short.
/// Source: Geyer, Stat. Sci. 7 (1992) 473; Kendall, Biometrika 41 (1954) 403, the bias of an autocorrelation.
double independent_parts(std::span<const double> shares);

/// Standard error of a number to which parts of the run, one after the other, added these shares; NaN if
/// there are fewer than 16, in which a correlation would not be seen, or fewer than eight
/// independent_parts().
double error_of_series(std::span<const double> shares);

}  // namespace hardball
