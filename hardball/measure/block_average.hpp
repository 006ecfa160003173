// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hardball/measure/estimate.hpp"

namespace hardball {

/// Means of one or several quantities over a run, with standard errors that allow for correlation in time.
///
/// Values are gathered in blocks of equally many samples in a row. Whenever 64 blocks are full, neighbours
/// are merged and blocks are twice as long from then on: memory is bounded, and the blocks grow with the run.
/// Once they are longer than the correlation in time they are independent, and their scatter tells the error.
/// Of a run not much longer than its correlation the error comes out too small. Source: Flyvbjerg and
/// Petersen, J. Chem. Phys. 91 (1989) 461.
class BlockAverage {
 public:
  static constexpr std::size_t kMostBlocks = 64;

  /// `bins`: how many quantities; it may be zero. Memory: 64 numbers for each.
  explicit BlockAverage(std::size_t bins = 1);

  std::size_t bins() const { return bins_; }
  /// How many samples were added.
  std::uint64_t samples() const { return samples_; }
  /// How many blocks there are, the last of which may be shorter.
  std::size_t blocks() const { return full_blocks_ + (samples_in_block_ > 0 ? 1 : 0); }

  /// Adds a sample: `values` held with `weight`, such as the time for which they did. Precondition: one value
  /// for each bin; the weight is not negative. Cost: O(bins).
  void add(std::span<const double> values, double weight = 1);
  /// The same for a single bin.
  void add(double value, double weight = 1) { add(std::span(&value, 1), weight); }

  /// Adds `amount` to one bin of the sample that the next close_sample ends. It is a value times its weight,
  /// so that it may also be what came at one moment, as an impulse does. Cost: O(1).
  void put(std::size_t bin, double amount) { *open_bins(bin) += amount; }
  /// The bins from `first` on, to add amounts to several of them.
  double* open_bins(std::size_t first) { return &sums_[full_blocks_ * bins_ + first]; }
  /// Ends a sample: what was put into its bins was spread over `weight`. Cost: O(1), now and then O(bins).
  void close_sample(double weight = 1) {
    weights_[full_blocks_] += weight;
    ++samples_;
    if (++samples_in_block_ == samples_per_block_) close_block();
  }

  /// Sum of all amounts over the sum of all weights; NaN if there is no weight.
  double mean(std::size_t bin = 0) const;
  /// Standard error of mean(bin); NaN if there are fewer than two blocks.
  double error(std::size_t bin = 0) const;

  /// Sum of all amounts in one bin over that in another, as for a mean over spheres of which not always
  /// equally many count; NaN if that is zero.
  double ratio(std::size_t bin, std::size_t over) const;
  /// Standard error of ratio(bin, over), to first order; NaN if there are fewer than two blocks.
  /// Source: Cochran, Sampling Techniques, 3rd edition (1977), section 6.3.
  double ratio_error(std::size_t bin, std::size_t over) const;

  /// A function of the means of all bins, as a pressure is of several sums, with its standard error.
  /// Cost: O(bins) and a call of `quantity` for each block.
  Estimate estimate(const FunctionOfMeans& quantity) const;

  /// The history: `quantity` of the means over one full block after the other, of those that have weight.
  std::vector<double> history(const FunctionOfMeans& quantity) const;
  /// The weight before the middle of each of these blocks: its time since the beginning, if weights are
  /// times.
  std::vector<double> middles() const;

 private:
  double sum(std::size_t bin, std::size_t block) const { return sums_[block * bins_ + bin]; }
  void close_block();
  void merge_neighbors();

  std::size_t bins_;
  std::vector<double> sums_;     // shape (kMostBlocks, bins); the block after the full ones is being filled
  std::vector<double> weights_;  // shape (kMostBlocks)
  std::size_t full_blocks_ = 0;  // always fewer than kMostBlocks
  std::uint64_t samples_ = 0;
  std::uint64_t samples_in_block_ = 0;  // of the block being filled
  std::uint64_t samples_per_block_ = 1;
};

}  // namespace hardball
