// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/statistics/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "hardball/numbers/no_number.hpp"

namespace hardball {
namespace {

// Of a series whose error can be estimated.
constexpr std::size_t kMinParts = 16;
constexpr double kMinIndependent = 8;

// The factor for a standard deviation estimated with this many degrees of freedom, so that two of them cover
// as much as two exact ones would. Source: Abramowitz and Stegun, Handbook of Mathematical Functions, 26.7.5.
double student_factor(double freedom) {
  return 1 + (1.25 + (1.5313 + 1.4297 / freedom) / freedom) / freedom;
}

// The sum over parts of the product with the share `lag` parts later.
double autocovariance(std::span<const double> shares, std::size_t lag) {
  double sum = 0;
  for (std::size_t i = lag; i < shares.size(); ++i) sum += shares[i - lag] * shares[i];
  return sum;
}

// Standard error from the sum of squares of `parts` shares that are worth `independent` independent ones.
double error_of(double squares, double parts, double independent) {
  return std::sqrt(squares * parts / (independent - 1)) * student_factor(std::min(independent, parts) - 1);
}

}  // namespace

Estimate resolved(const Estimate& estimate) {
  constexpr double kRounding = 1e-12;
  const bool is_resolved = estimate.error > kRounding * std::fabs(estimate.value);
  return {estimate.value, is_resolved ? estimate.error : kNoNumber};
}

Estimate operator*(const Estimate& a, const Estimate& b) {
  return {a.value * b.value, std::hypot(a.error * b.value, a.value * b.error)};
}

Parts jackknife(std::span<const double> sums, std::span<const double> weights,
                const FunctionOfMeans& quantity) {
  const std::size_t parts = weights.size();
  if (parts == 0) return {};
  const std::size_t bins = sums.size() / parts;
  std::vector<double> total(bins);
  double weight = 0;
  for (std::size_t part = 0; part < parts; ++part) {
    weight += weights[part];
    for (std::size_t bin = 0; bin < bins; ++bin) total[bin] += sums[part * bins + bin];
  }
  std::vector<double> means(bins);
  for (std::size_t bin = 0; bin < bins; ++bin) means[bin] = total[bin] / weight;
  Parts found{.value = quantity(means)};
  if (parts < 2) return found;
  double mean = 0;
  for (std::size_t part = 0; part < parts; ++part) {
    for (std::size_t bin = 0; bin < bins; ++bin) {
      means[bin] = (total[bin] - sums[part * bins + bin]) / (weight - weights[part]);
    }
    found.shares.push_back(quantity(means));
    mean += found.shares.back() / static_cast<double>(parts);
  }
  const auto count = static_cast<double>(parts);
  for (double& share : found.shares) share = (mean - share) * (count - 1) / count;
  return found;
}

double error_of_independent(std::span<const double> shares) {
  constexpr std::size_t kMin = 4;
  if (shares.size() < kMin) return kNoNumber;
  const auto parts = static_cast<double>(shares.size());
  return error_of(autocovariance(shares, 0), parts, parts);
}

double independent_parts(std::span<const double> shares) {
  // Anticorrelated parts are worth more independent ones; by chance they may seem so.
  constexpr double kMax = 2;
  const auto parts = static_cast<double>(shares.size());
  const double squares = autocovariance(shares, 0);
  if (squares == 0) return parts;
  // Sums of two successive autocorrelations fall toward zero; from the first negative one there is only
  // noise.
  double least = std::numeric_limits<double>::infinity();
  double sum = -1;
  for (std::size_t lag = 0; lag + 1 < shares.size(); lag += 2) {
    least = std::min(least, (autocovariance(shares, lag) + autocovariance(shares, lag + 1)) / squares);
    if (!(least > 0)) break;
    sum += 2 * least;
  }
  const double of_sequence = parts / std::max(sum, 1 / kMax);
  const double seen = autocovariance(shares, 1) / squares;
  const double memory = std::clamp(seen + (1 + 3 * seen) / parts, (1 - kMax) / (1 + kMax), 1.0);
  return std::min(of_sequence, parts * (1 - memory) / (1 + memory));
}

double error_of_series(std::span<const double> shares) {
  if (shares.size() < kMinParts) return kNoNumber;
  const double independent = independent_parts(shares);
  if (!(independent >= kMinIndependent)) return kNoNumber;
  return error_of(autocovariance(shares, 0), static_cast<double>(shares.size()), independent);
}

double error_of_exchange(std::span<const double> shares, std::span<const double> changes) {
  constexpr double kRounding = 1e-20;
  constexpr double kMinContents = 3;
  const double of_series = error_of_series(shares);
  const std::size_t parts = shares.size();
  if (parts < kMinParts) return of_series;
  // What the store holds after each part, relative to its mean.
  std::vector<double> content(parts);
  std::partial_sum(changes.begin(), changes.end(), content.begin());
  const double mean = std::accumulate(content.begin(), content.end(), 0.0) / static_cast<double>(parts);
  for (double& held : content) held -= mean;
  const double independent = independent_parts(content);
  const double squares = autocovariance(changes, 0);
  if (squares == 0 || !(independent >= kMinContents)) return of_series;
  // How much of a change of the store is in the shares: by least squares.
  const double part_of_change =
      std::inner_product(shares.begin(), shares.end(), changes.begin(), 0.0) / squares;
  std::vector<double> others(shares.begin(), shares.end());
  for (std::size_t i = 0; i < parts; ++i) others[i] -= part_of_change * changes[i];
  const bool is_any_other = autocovariance(others, 0) > kRounding * autocovariance(shares, 0);
  const double variance_of_content = autocovariance(content, 0) / static_cast<double>(parts);
  const double of_ends = part_of_change *
                         std::sqrt(2 * variance_of_content * independent / (independent - 1)) *
                         student_factor(std::min(independent, static_cast<double>(parts)) - 1);
  return std::fmin(of_series, std::hypot(is_any_other ? error_of_series(others) : 0, of_ends));
}

}  // namespace hardball
