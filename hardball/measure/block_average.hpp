// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hardball/measure/estimate.hpp"

namespace hardball {

/// Means of one or several quantities over a run, with standard errors.
///
/// Values are gathered in blocks of equally many samples in a row. Whenever 64 blocks are full, neighbours
/// are merged and blocks are twice as long from then on: memory is bounded, and the blocks grow with the run.
/// Within a block they may be gathered by groups, such as of spheres.
///
/// There are two errors. That of the blocks allows for their correlation in time, and is not known if the run
/// is too short for it: see error_of_series. That of the groups is known however short the run is, but sees
/// only what each does for itself: see error_of_independent. The larger one is given, and that of the blocks
/// where these are worth 16 independent ones.
/// Source of the blocks: Flyvbjerg and Petersen, J. Chem. Phys. 91 (1989) 461.
class BlockAverage {
 public:
  static constexpr std::size_t kMostBlocks = 64;
  /// Stands for the weights where a bin is to be named.
  static constexpr std::size_t kWeight = static_cast<std::size_t>(-1);

  /// What is known of the groups.
  enum class Groups {
    none,      ///< Nothing, as of what all spheres do together.
    separate,  ///< That they are independent.
    /// That they are independent at one moment, but in time hand on to each other what they have, as spheres
    /// do with their energy. Then what one forgets lives on in others, and the mean of many moments in a row
    /// varies about twice as much as if each were for itself.
    exchanging,
    /// That they are coupled at every moment, as neighbours that have bonds in common or drag each other
    /// along. Then the mean varies up to about twice as much, the most in a dense fluid.
    coupled,
  };

  /// `bins`: how many quantities; it may be zero. Memory: 64 numbers for each, and for each group.
  explicit BlockAverage(std::size_t bins = 1, std::size_t groups = 1);

  std::size_t bins() const { return bins_; }
  /// How many samples were added.
  std::uint64_t samples() const { return samples_; }
  /// How many blocks there are, the last of which may be shorter; of those left out, none.
  std::size_t blocks() const { return full_blocks_ - first_ + (samples_in_block_ > 0 ? 1 : 0); }

  /// Adds a sample: `values` held with `weight`, such as the time for which they did, up to `time`, which
  /// never falls. Precondition: one value for each bin; the weight is not negative; there are no groups.
  /// Cost: O(bins).
  void add(std::span<const double> values, double time, double weight = 1);

  /// Adds `amount` to one bin of the sample that the next close_sample ends. It is a value times its weight,
  /// so that it may also be what came at one moment, as an impulse does. Cost: O(1).
  void put(std::size_t bin, double amount, std::size_t group = 0) { open_bins(0, group)[bin] += amount; }
  /// The bins from `first` on, to add amounts to several of them.
  double* open_bins(std::size_t first, std::size_t group = 0) {
    return &sums_[(full_blocks_ * groups_ + group) * bins_ + first];
  }
  /// Ends a sample: what was put into its bins was spread over `weight`, up to `time`. Cost: O(1), now and
  /// then O(bins).
  void close_sample(double time, double weight = 1) {
    weights_[full_blocks_] += weight;
    ends_[full_blocks_] = time;
    ++samples_;
    if (++samples_in_block_ == samples_per_block_) close_block();
  }

  /// Leaves the full blocks that ended up to `time` out of all means. Nothing may be added from then on.
  void leave_out_until(double time);
  /// When the blocks end, those that are full.
  std::span<const double> ends() const { return std::span(ends_).first(full_blocks_); }

  /// Sum of all amounts in a bin.
  double total(std::size_t bin) const;
  /// Sum of all amounts in one bin over that in another; NaN if that is zero. Groups are told apart unless
  /// it is over the weights.
  Estimate ratio(std::size_t bin, std::size_t over = kWeight) const;
  /// Sum of all amounts over the sum of all weights; NaN if there is no weight.
  double mean(std::size_t bin = 0) const { return ratio(bin).value; }
  double error(std::size_t bin = 0) const { return ratio(bin).error; }
  /// The ratios of `count` bins that hold counts, from `first` on: a histogram.
  ///
  /// Of a bin with k counts, the true mean has the variance k + 1 if all means are equally likely before:
  /// so one more count is allowed for, and an empty bin has an error, too. Counts that come F at a time, as
  /// of a sphere that is seen again and again, vary F times as much; F is taken from all bins together.
  /// Source: Gelman and others, Bayesian Data Analysis, 3rd edition (2013), section 2.6.
  std::vector<Estimate> histogram(std::size_t first, std::size_t count, std::size_t over = kWeight) const;

  /// A function of the means of all bins, as a pressure is of several sums. If it is over groups it must not
  /// change when all bins are multiplied by a factor.
  /// Cost: O(bins) and a call of `quantity` for each block, and for each group, of every block if
  /// `exchanging`.
  Estimate estimate(const FunctionOfMeans& quantity, Groups groups = Groups::none) const;

  /// The history: `quantity` of the means over one full block after the other, of those that have weight;
  /// none is left out.
  std::vector<double> history(const FunctionOfMeans& quantity) const;
  /// The weight before the middle of each of these blocks: its time since the beginning, if weights are
  /// times.
  std::vector<double> middles() const;

 private:
  double sum(std::size_t bin, std::size_t block) const;
  std::vector<double> shares_of_groups(const FunctionOfMeans& quantity, std::size_t first,
                                       std::size_t end) const;
  double weight_of(std::size_t over, std::size_t block) const;
  std::size_t end() const { return first_ + blocks(); }
  void close_block();
  void merge_neighbors();

  std::size_t bins_;
  std::size_t groups_;
  std::vector<double>
      sums_;  // shape (kMostBlocks, groups, bins); the block after the full ones is being filled
  std::vector<double> weights_;  // shape (kMostBlocks)
  std::vector<double> ends_;     // shape (kMostBlocks)
  std::size_t full_blocks_ = 0;  // always fewer than kMostBlocks
  std::size_t first_ = 0;        // that is not left out
  std::uint64_t samples_ = 0;
  std::uint64_t samples_in_block_ = 0;  // of the block being filled
  std::uint64_t samples_per_block_ = 1;
};

}  // namespace hardball
