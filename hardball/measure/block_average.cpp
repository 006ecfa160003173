// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/block_average.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// Sum over blocks of numerators over that of denominators.
template <class Numerator, class Denominator>
double ratio_of_sums(std::size_t blocks, const Numerator& numerator, const Denominator& denominator) {
  double above = 0;
  double below = 0;
  for (std::size_t block = 0; block < blocks; ++block) {
    above += numerator(block);
    below += denominator(block);
  }
  return below != 0 ? above / below : kNone;
}

// The standard error of that ratio. Blocks of unequal weight, such as an unfinished one, count accordingly.
template <class Numerator, class Denominator>
double error_of_ratio(std::size_t blocks, const Numerator& numerator, const Denominator& denominator) {
  if (blocks < 2) return kNone;
  const double ratio = ratio_of_sums(blocks, numerator, denominator);
  double squares = 0;
  double below = 0;
  for (std::size_t block = 0; block < blocks; ++block) {
    const double deviation = numerator(block) - ratio * denominator(block);
    squares += deviation * deviation;
    below += denominator(block);
  }
  const auto count = static_cast<double>(blocks);
  return std::sqrt(squares * count / (count - 1)) / std::fabs(below);
}

}  // namespace

BlockAverage::BlockAverage(std::size_t bins)
    : bins_(bins), sums_(kMostBlocks * bins), weights_(kMostBlocks) {}

void BlockAverage::add(std::span<const double> values, double weight) {
  HARDBALL_CHECK(values.size() == bins_);
  for (std::size_t bin = 0; bin < bins_; ++bin) put(bin, values[bin] * weight);
  close_sample(weight);
}

void BlockAverage::close_block() {
  samples_in_block_ = 0;
  if (++full_blocks_ == kMostBlocks) merge_neighbors();
}

void BlockAverage::merge_neighbors() {
  for (std::size_t block = 0; block < kMostBlocks / 2; ++block) {
    weights_[block] = weights_[2 * block] + weights_[2 * block + 1];
    for (std::size_t bin = 0; bin < bins_; ++bin) {
      sums_[block * bins_ + bin] = sum(bin, 2 * block) + sum(bin, 2 * block + 1);
    }
  }
  full_blocks_ = kMostBlocks / 2;
  samples_per_block_ *= 2;
  std::fill(weights_.begin() + kMostBlocks / 2, weights_.end(), 0);
  std::fill(sums_.begin() + static_cast<std::ptrdiff_t>(full_blocks_ * bins_), sums_.end(), 0);
}

double BlockAverage::mean(std::size_t bin) const {
  return ratio_of_sums(
      blocks(), [&](std::size_t block) { return sum(bin, block); },
      [&](std::size_t block) { return weights_[block]; });
}

double BlockAverage::error(std::size_t bin) const {
  return error_of_ratio(
      blocks(), [&](std::size_t block) { return sum(bin, block); },
      [&](std::size_t block) { return weights_[block]; });
}

double BlockAverage::ratio(std::size_t bin, std::size_t over) const {
  return ratio_of_sums(
      blocks(), [&](std::size_t block) { return sum(bin, block); },
      [&](std::size_t block) { return sum(over, block); });
}

double BlockAverage::ratio_error(std::size_t bin, std::size_t over) const {
  return error_of_ratio(
      blocks(), [&](std::size_t block) { return sum(bin, block); },
      [&](std::size_t block) { return sum(over, block); });
}

Estimate BlockAverage::estimate(const FunctionOfMeans& quantity) const {
  const std::span<const double> sums(sums_);
  const std::span<const double> weights(weights_);
  return jackknife(sums.first(blocks() * bins_), weights.first(blocks()), quantity);
}

std::vector<double> BlockAverage::history(const FunctionOfMeans& quantity) const {
  std::vector<double> values;
  std::vector<double> means(bins_);
  for (std::size_t block = 0; block < full_blocks_; ++block) {
    if (weights_[block] == 0) continue;
    for (std::size_t bin = 0; bin < bins_; ++bin) means[bin] = sum(bin, block) / weights_[block];
    values.push_back(quantity(means));
  }
  return values;
}

std::vector<double> BlockAverage::middles() const {
  std::vector<double> values;
  double before = 0;
  for (std::size_t block = 0; block < full_blocks_; ++block) {
    if (weights_[block] > 0) values.push_back(before + weights_[block] / 2);
    before += weights_[block];
  }
  return values;
}

}  // namespace hardball
