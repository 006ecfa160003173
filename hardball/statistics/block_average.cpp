// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/statistics/block_average.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "hardball/errors/error.hpp"
#include "hardball/numbers/no_number.hpp"

namespace hardball {
namespace {

// With the error from blocks, or the larger one if there are too few independent blocks, or all are equal.
Estimate estimate_of(double value, std::span<const double> blocks, double of_groups) {
  constexpr double kEnough = 16;
  const double of_series = resolved({value, error_of_series(blocks)}).error;
  const bool is_enough = independent_parts(blocks) >= kEnough && !std::isnan(of_series);
  return {value, is_enough ? of_series : std::fmax(of_series, of_groups)};
}

// Whether one share differs from all others, as if due to a rare kind of sphere: then how rare it is cannot
// be estimated.
bool is_of_few(std::span<const double> shares) {
  constexpr double kMin = 1.5;
  double squares = 0;
  double fourths = 0;
  for (const double share : shares) {
    squares += share * share;
    fourths += share * share * share * share;
  }
  return squares * squares < kMin * fourths;
}

}  // namespace

BlockAverage::BlockAverage(std::size_t bins, std::size_t groups)
    : bins_(bins),
      groups_(groups),
      sums_(kMaxBlocks * groups * bins),
      weights_(kMaxBlocks),
      ends_(kMaxBlocks) {}

void BlockAverage::add(std::span<const double> values, double time, double weight) {
  HARDBALL_CHECK(values.size() == bins_ && groups_ == 1);
  for (std::size_t bin = 0; bin < bins_; ++bin) put(bin, values[bin] * weight);
  close_sample(time, weight);
}

void BlockAverage::close_block() {
  samples_in_block_ = 0;
  if (++full_blocks_ == kMaxBlocks) merge_neighbors();
}

void BlockAverage::merge_neighbors() {
  const std::size_t size = groups_ * bins_;
  for (std::size_t block = 0; block < kMaxBlocks / 2; ++block) {
    weights_[block] = weights_[2 * block] + weights_[2 * block + 1];
    ends_[block] = ends_[2 * block + 1];
    for (std::size_t k = 0; k < size; ++k) {
      sums_[block * size + k] = sums_[2 * block * size + k] + sums_[(2 * block + 1) * size + k];
    }
  }
  full_blocks_ = kMaxBlocks / 2;
  samples_per_block_ *= 2;
  std::fill(weights_.begin() + kMaxBlocks / 2, weights_.end(), 0);
  std::fill(sums_.begin() + static_cast<std::ptrdiff_t>(full_blocks_ * size), sums_.end(), 0);
}

void BlockAverage::halve_weights() {
  for (double& sum : sums_) sum /= 2;
  for (double& weight : weights_) weight /= 2;
}

void BlockAverage::leave_out_until(double time) {
  while (first_ < full_blocks_ && ends_[first_] <= time) ++first_;
}

double BlockAverage::sum(std::size_t bin, std::size_t block) const {
  double sum = 0;
  for (std::size_t group = 0; group < groups_; ++group) sum += sums_[(block * groups_ + group) * bins_ + bin];
  return sum;
}

double BlockAverage::weight_of(std::size_t over, std::size_t block) const {
  return over == kWeight ? weights_[block] : sum(over, block);
}

double BlockAverage::total(std::size_t bin) const {
  double total = 0;
  for (std::size_t block = first_; block < end(); ++block) total += weight_of(bin, block);
  return total;
}

// By how much each block moves a ratio.
std::vector<double> BlockAverage::shares_of_blocks(std::size_t bin, std::size_t over) const {
  const double below = total(over);
  const double value = total(bin) / below;
  std::vector<double> shares;
  for (std::size_t block = first_; block < end(); ++block) {
    shares.push_back((sum(bin, block) - value * weight_of(over, block)) / below);
  }
  return shares;
}

Estimate BlockAverage::exchange(std::size_t bin, std::size_t changes) const {
  if (total(kWeight) == 0) return {};
  return resolved({total(bin) / total(kWeight),
                   error_of_exchange(shares_of_blocks(bin, kWeight), shares_of_blocks(changes, kWeight))});
}

Estimate BlockAverage::ratio(std::size_t bin, std::size_t over) const {
  return resolved(scatter_of_ratio(bin, over));
}

// With an error even if that is rounding.
Estimate BlockAverage::scatter_of_ratio(std::size_t bin, std::size_t over) const {
  const double below = total(over);
  if (below == 0) return {};
  const double value = total(bin) / below;
  const std::vector<double> of_blocks = shares_of_blocks(bin, over);
  std::vector<double> of_groups;
  for (std::size_t group = 0; over != kWeight && group < groups_; ++group) {
    double share = 0;
    double counted = 0;
    for (std::size_t block = first_; block < end(); ++block) {
      const double* const sums = &sums_[(block * groups_ + group) * bins_];
      share += sums[bin] - value * sums[over];
      counted += sums[over];
    }
    // With fewer spheres than groups some groups are empty.
    if (counted > 0) of_groups.push_back(share / below);
  }
  return estimate_of(value, of_blocks, error_of_independent(of_groups));
}

std::vector<Estimate> BlockAverage::histogram(std::size_t first, std::size_t count, std::size_t over) const {
  if (total(over) == 0) return std::vector<Estimate>(count);
  std::vector<Estimate> found;
  const double one = 1 / total(over);
  double squares = 0;
  double counts = 0;
  for (std::size_t k = 0; k < count; ++k) {
    found.push_back(scatter_of_ratio(first + k, over));
    if (std::isnan(found.back().error)) continue;
    squares += found.back().error * found.back().error / (one * one);
    counts += found.back().value / one;
  }
  const double at_a_time = counts > 0 ? std::max(squares / counts, 1.0) : 1;
  for (Estimate& bin : found) bin.error = std::hypot(bin.error, at_a_time * one);
  return found;
}

// By how much each group moves the result of some blocks.
std::vector<double> BlockAverage::shares_of_groups(const FunctionOfMeans& quantity, std::size_t first,
                                                   std::size_t end) const {
  std::vector<double> sums;
  for (std::size_t group = 0; group < groups_; ++group) {
    const std::size_t begin = sums.size();
    sums.resize(begin + bins_);
    for (std::size_t block = first; block < end; ++block) {
      for (std::size_t bin = 0; bin < bins_; ++bin) {
        sums[begin + bin] += sums_[(block * groups_ + group) * bins_ + bin];
      }
    }
    const auto is_zero = [](double sum) { return sum == 0; };
    if (std::all_of(sums.begin() + static_cast<std::ptrdiff_t>(begin), sums.end(), is_zero))
      sums.resize(begin);
  }
  const std::vector<double> equal(sums.size() / bins_, 1);
  return jackknife(sums, equal, quantity).shares;
}

Estimate BlockAverage::estimate(const FunctionOfMeans& quantity, Groups groups) const {
  std::vector<double> sums;
  for (std::size_t block = first_; block < end(); ++block) {
    for (std::size_t bin = 0; bin < bins_; ++bin) sums.push_back(sum(bin, block));
  }
  const Parts of_blocks = jackknife(sums, std::span(weights_).subspan(first_, blocks()), quantity);
  if (groups == Groups::none) return resolved({of_blocks.value, error_of_series(of_blocks.shares)});
  const std::vector<double> shares = shares_of_groups(quantity, first_, end());
  double of_groups = is_of_few(shares) ? kNoNumber : error_of_independent(shares);
  if (groups == Groups::coupled) of_groups *= std::numbers::sqrt2;
  if (groups == Groups::exchanging) {
    double of_one_block = 0;
    for (std::size_t block = first_; block < end(); ++block) {
      const double error = error_of_independent(shares_of_groups(quantity, block, block + 1));
      of_one_block += error * error / static_cast<double>(blocks());
    }
    // What a group remembers from block to block makes it vary more than if blocks were independent. Of that,
    // it passes to others what it forgets during the run.
    const double square = of_groups * of_groups;
    const double remembered = std::max(square - of_one_block / static_cast<double>(blocks()), 0.0);
    const double forgotten = std::max(1 - square / of_one_block, 0.0);
    of_groups = std::sqrt(square + remembered * forgotten);
  }
  return resolved(estimate_of(of_blocks.value, of_blocks.shares, of_groups));
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

std::vector<double> BlockAverage::middles(double start) const {
  std::vector<double> values;
  double before = 0;
  for (std::size_t block = 0; block < full_blocks_; ++block) {
    if (weights_[block] > 0) values.push_back(start + (before + weights_[block] / 2));
    before += weights_[block];
  }
  return values;
}

bool BlockAverage::restored() const {
  const std::size_t bins = sums_.size() / kMaxBlocks;
  return (bins == 0 ? bins_ == 0 || groups_ == 0 : groups_ > 0 && bins / groups_ == bins_) &&
         sums_.size() == kMaxBlocks * bins_ * groups_ && weights_.size() == kMaxBlocks &&
         ends_.size() == kMaxBlocks && full_blocks_ < kMaxBlocks && first_ <= full_blocks_ &&
         samples_in_block_ < samples_per_block_;
}

}  // namespace hardball
