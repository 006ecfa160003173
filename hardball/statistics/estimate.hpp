// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "hardball/errors/language.hpp"

namespace hardball {

/// A number with its statistical error.
///
/// The error is scaled so that the true value is within two of them in 95% of runs even if it is estimated
/// from few data: it is the estimated standard deviation times Student's factor. It is NaN if the run does
/// not determine it.
struct Estimate {
  double value = std::numeric_limits<double>::quiet_NaN();
  double error = std::numeric_limits<double>::quiet_NaN();
};

/// Without the error if that is no more than rounding: where all samples are equal, their scatter says
/// nothing about other runs.
Estimate resolved(const Estimate& estimate);

/// A product of factors with independent errors.
Estimate operator*(const Estimate& a, const Estimate& b);

/// An estimate in another unit.
inline Estimate operator*(double factor, const Estimate& estimate) {
  return {factor * estimate.value, factor * estimate.error};
}
inline Estimate operator/(const Estimate& estimate, double unit) {
  return {estimate.value / unit, estimate.error / unit};
}
inline std::vector<Estimate> operator*(double factor, std::vector<Estimate> estimates) {
  for (Estimate& estimate : estimates) estimate = factor * estimate;
  return estimates;
}
inline std::vector<Estimate> operator/(std::vector<Estimate> estimates, double unit) {
  for (Estimate& estimate : estimates) estimate = estimate / unit;
  return estimates;
}

/// Several means, by their bins.
using Means = std::span<const double>;

/// A function of several means, such as a ratio or a fit.
using FunctionOfMeans = std::function<double(Means means)>;

/// One of the means.
inline FunctionOfMeans mean_of(std::size_t bin) {
  return [bin](Means means) { return means[bin]; };
}

/// One of the means over another.
inline FunctionOfMeans ratio_of(std::size_t bin, std::size_t over) {
  return [=](Means means) { return means[bin] / means[over]; };
}

/// A number computed from parts, and by how much each part moved it.
struct Parts {
  double value = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> shares = {};  ///< The shares add up to about zero.
};

/// The value of `quantity` for the means over all parts, and by how much each part moves it, found by leaving
/// out one part at a time.
///
/// `sums` has shape (parts, bins), and bin k of the means is the sum over parts of sums[part][k] over that
/// of weights[part]. Cost: O(parts) calls of `quantity`. Source: Miller, Biometrika 61 (1974) 1, the
/// jackknife.
Parts jackknife(std::span<const double> sums, std::span<const double> weights,
                const FunctionOfMeans& quantity);

/// Standard error of a number to which independent parts, such as groups of spheres, contributed these
/// shares. NaN if there are fewer than four.
double error_of_independent(std::span<const double> shares);

/// The number of independent parts that would determine the number as well as these [1], at most twice as
/// many as there are: their number over the sum of their autocorrelations. The smaller of two estimates is
/// taken: that of Geyer's initial monotone sequence, which holds for slow correlations hidden by noise, and
/// that of a first-order autoregressive process, which is more precise if the run is short. Source: Geyer,
/// Stat. Sci. 7 (1992) 473; Kendall, Biometrika 41 (1954) 403, the bias of an autocorrelation.
double independent_parts(std::span<const double> shares);

/// Standard error of a number to which successive parts of the run contributed these shares; NaN if there are
/// fewer than 16, too few to show a correlation, or fewer than eight independent_parts().
double error_of_series(std::span<const double> shares);

/// Standard error of a number whose shares are of an exchange with a store, as heat with the energy of
/// spheres; `changes` are the shares of the store's mean change. What a store takes up it gives back: of
/// that, only the difference between its end and its beginning counts, which varies as twice its content
/// does. If the run is too short for that to be known, the error is error_of_series. Source: Lavenberg and
/// Welch, Manag. Sci. 27 (1981) 322, control variables.
double error_of_exchange(std::span<const double> shares, std::span<const double> changes);

}  // namespace hardball
