// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/statistics/agreement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace hardball {
namespace {

// The probability that Student's t with seven degrees of freedom is beyond +t or -t.
double beyond(double t) {
  const double angle = std::atan(t / std::sqrt(7.0));
  const double sine = std::sin(angle);
  const double cosine = std::cos(angle);
  const double square = cosine * cosine;
  return 1 - 2 / std::numbers::pi * (angle + sine * cosine * (1 + square * (2.0 / 3 + square * 8 / 15)));
}

}  // namespace

double largest_by_chance(std::size_t compared) {
  constexpr double kRuns = 0.01;
  constexpr double kTwoErrors = 2.3646;  // beyond which 5% lie: errors are scaled to be half of it
  constexpr int kHalvings = 60;
  const double each = kRuns / static_cast<double>(std::max<std::size_t>(compared, 1));
  double low = 0;
  double high = 1000;
  for (int halving = 0; halving < kHalvings; ++halving) {
    const double middle = (low + high) / 2;
    (beyond(middle) > each ? low : high) = middle;
  }
  return low / (kTwoErrors / 2);
}

double deviation(const Quantity& quantity) {
  constexpr double kRounding = 1e-12;
  const bool is_known = quantity.error > kRounding * std::fabs(quantity.value);
  const double difference = std::fabs(quantity.value - quantity.theory) - quantity.tolerance;
  if (!is_known || !std::isfinite(difference)) return std::numeric_limits<double>::quiet_NaN();
  return std::max(difference, 0.0) / quantity.error;
}

Agreement::Agreement(std::span<const Measurement> measurements) {
  const auto for_each = [&](const auto& visit) {
    for (const Measurement& measurement : measurements) {
      for (const Quantity& quantity : measurement.quantities) visit(measurement, quantity);
    }
  };
  for_each([&](const Measurement&, const Quantity& quantity) {
    if (!std::isnan(deviation(quantity))) ++compared_;
  });
  allowed_ = largest_by_chance(compared_);
  for_each([&](const Measurement& measurement, const Quantity& quantity) {
    if (is_far(quantity)) far_.push_back({quantity.name, measurement.title});
  });
}

}  // namespace hardball
