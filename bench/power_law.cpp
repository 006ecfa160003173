// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "bench/power_law.hpp"

#include <cmath>
#include <limits>

namespace hardball::bench {

PowerLaw fit_power_law(std::span<const double> x, std::span<const double> y) {
  const auto count = static_cast<double>(x.size());
  double mean_x = 0;
  double mean_y = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += std::log(x[i]) / count;
    mean_y += std::log(y[i]) / count;
  }
  double xx = 0;
  double xy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double dx = std::log(x[i]) - mean_x;
    xx += dx * dx;
    xy += dx * (std::log(y[i]) - mean_y);
  }
  const double exponent = xy / xx;
  double squares = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double rest = std::log(y[i]) - mean_y - exponent * (std::log(x[i]) - mean_x);
    squares += rest * rest;
  }
  const double error =
      x.size() < 3 ? std::numeric_limits<double>::quiet_NaN() : std::sqrt(squares / (count - 2) / xx);
  return {exponent, error, std::exp(mean_y - exponent * mean_x), x.size()};
}

}  // namespace hardball::bench
