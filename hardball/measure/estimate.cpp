// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/estimate.hpp"

#include <cmath>
#include <vector>

namespace hardball {

Estimate jackknife(std::span<const double> sums, std::span<const double> weights,
                   const FunctionOfMeans& quantity) {
  const std::size_t blocks = weights.size();
  if (blocks == 0) return {};
  const std::size_t bins = sums.size() / blocks;
  std::vector<double> total(bins);
  double weight = 0;
  for (std::size_t block = 0; block < blocks; ++block) {
    weight += weights[block];
    for (std::size_t bin = 0; bin < bins; ++bin) total[bin] += sums[block * bins + bin];
  }
  std::vector<double> means(bins);
  for (std::size_t bin = 0; bin < bins; ++bin) means[bin] = total[bin] / weight;
  Estimate estimate{.value = quantity(means)};
  if (blocks < 2) return estimate;
  std::vector<double> without;
  double mean = 0;
  for (std::size_t block = 0; block < blocks; ++block) {
    for (std::size_t bin = 0; bin < bins; ++bin) {
      means[bin] = (total[bin] - sums[block * bins + bin]) / (weight - weights[block]);
    }
    without.push_back(quantity(means));
    mean += without.back() / static_cast<double>(blocks);
  }
  double squares = 0;
  for (const double value : without) squares += (value - mean) * (value - mean);
  const auto count = static_cast<double>(blocks);
  estimate.error = std::sqrt(squares * (count - 1) / count);
  return estimate;
}

}  // namespace hardball
