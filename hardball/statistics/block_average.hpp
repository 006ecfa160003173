// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hardball/statistics/estimate.hpp"

namespace hardball {

/// Means of one or several quantities over a run, with standard errors.
///
/// Values are collected in blocks of equally many successive samples. Whenever 64 blocks are full, adjacent
/// blocks are merged and blocks are twice as long from then on: memory is bounded, and the blocks grow with
/// the run. Within a block values may be collected by groups, such as of spheres.
///
/// There are two errors. The error from blocks allows for their correlation in time, and is not known if the
/// run is too short for it: see error_of_series. The error from groups is known however short the run is, but
/// assumes that groups are independent: see error_of_independent. The larger one is given, or the error from
/// blocks if at least 16 of them are independent. Source for blocks: Flyvbjerg and Petersen, J. Chem. Phys.
/// 91 (1989) 461.
class BlockAverage {
 public:
  static constexpr std::size_t kMaxBlocks = 64;
  /// Refers to the weights in place of a bin.
  static constexpr std::size_t kWeight = static_cast<std::size_t>(-1);

  /// What is known about the groups.
  enum class Groups {
    none,      ///< Nothing is known, as for collective quantities.
    separate,  ///< Groups are independent.
    /// Groups are independent at one time, but later exchange what they have, as spheres exchange energy.
    /// Then what one forgets persists in others, and the variance of a mean over many successive times is
    /// about twice that of independent groups.
    exchanging,
    /// Groups are coupled at all times, as neighbors that have bonds in common or move collectively. Then
    /// the variance of the mean is up to about twice as large, the most in a dense fluid.
    coupled,
  };

  /// `bins`: how many quantities; it may be zero. Memory: 64 numbers for each, and for each group.
  explicit BlockAverage(std::size_t bins = 1, std::size_t groups = 1);

  std::size_t bins() const { return bins_; }
  std::size_t groups() const { return groups_; }
  /// Whether this is how many bins and groups there are.
  bool has(std::size_t bins, std::size_t groups = 1) const { return bins_ == bins && groups_ == groups; }
  /// How many samples were added.
  std::uint64_t samples() const { return samples_; }
  /// How many blocks there are, the last of which may be shorter; those left out do not count.
  std::size_t blocks() const { return full_blocks_ - first_ + (samples_in_block_ > 0 ? 1 : 0); }

  /// Adds a sample: `values` with their `weight`, such as the time for which they held, up to `time`, which
  /// never decreases. Precondition: one value for each bin; the weight is not negative; there are no groups.
  /// Cost: O(bins).
  void add(std::span<const double> values, double time, double weight = 1);

  /// Adds `amount` to one bin of the sample that the next close_sample ends. It is a value times its weight,
  /// so that it may also be instantaneous, as an impulse is. Cost: O(1).
  void put(std::size_t bin, double amount, std::size_t group = 0) { open_bins(0, group)[bin] += amount; }
  /// The bins from `first` on, to add amounts to several of them.
  double* open_bins(std::size_t first, std::size_t group = 0) {
    return &sums_[(full_blocks_ * groups_ + group) * bins_ + first];
  }
  /// Ends a sample: what was added to its bins is spread over `weight`, up to `time`. Cost: O(1),
  /// occasionally O(bins).
  void close_sample(double time, double weight = 1) {
    weights_[full_blocks_] += weight;
    ends_[full_blocks_] = time;
    ++samples_;
    if (++samples_in_block_ == samples_per_block_) close_block();
  }

  /// Halves the weight of all samples so far. Cost: O(bins).
  void halve_weights();

  /// Leaves the full blocks that ended by `time` out of all means. Nothing may be added from then on.
  void leave_out_until(double time);
  /// When the full blocks end.
  std::span<const double> ends() const { return std::span(ends_).first(full_blocks_); }

  /// Sum of all amounts in a bin.
  double total(std::size_t bin) const;
  /// Sum of all amounts in one bin over that in another; NaN if that is zero. Its error is from groups, too,
  /// unless it is over the weights.
  Estimate ratio(std::size_t bin, std::size_t over = kWeight) const;
  /// Sum of all amounts over the sum of all weights; NaN if there is no weight.
  double mean(std::size_t bin = 0) const { return ratio(bin).value; }
  double error(std::size_t bin = 0) const { return ratio(bin).error; }
  /// The mean of a bin whose amounts are exchanged with a store, the changes of which are in another bin: see
  /// error_of_exchange.
  Estimate exchange(std::size_t bin, std::size_t changes) const;
  /// The ratios of `count` bins that hold counts, from `first` on: a histogram.
  ///
  /// In a bin with k counts, the true mean has the variance k + 1 if all means are equally likely a priori:
  /// so one more count is allowed for, and an empty bin has an error, too. Counts that come F at a time, as
  /// of a sphere sampled repeatedly, have F times the variance; F is estimated from all bins together.
  /// Source: Gelman and others, Bayesian Data Analysis, 3rd edition (2013), section 2.6.
  std::vector<Estimate> histogram(std::size_t first, std::size_t count, std::size_t over = kWeight) const;

  /// A function of the means of all bins, as a pressure is of several sums. If it is over groups it must not
  /// change when all bins are multiplied by a factor.
  /// Cost: O(bins) and a call of `quantity` for each block, and for each group, of every block if
  /// `exchanging`.
  Estimate estimate(const FunctionOfMeans& quantity, Groups groups = Groups::none) const;

  /// The history: `quantity` of the means over each full block that has weight; none is left out.
  std::vector<double> history(const FunctionOfMeans& quantity) const;
  /// The time at the middle of each of these blocks, if weights are times and the first began at `start`.
  std::vector<double> middles(double start) const;

 private:
  friend class Persistence;
  static void persist(auto& archive, auto& self) {
    archive(self.bins_, self.groups_, self.sums_, self.weights_, self.ends_, self.full_blocks_, self.first_,
            self.samples_, self.samples_in_block_, self.samples_per_block_);
  }
  bool restored() const;

  Estimate scatter_of_ratio(std::size_t bin, std::size_t over) const;
  double sum(std::size_t bin, std::size_t block) const;
  std::vector<double> shares_of_blocks(std::size_t bin, std::size_t over) const;
  std::vector<double> shares_of_groups(const FunctionOfMeans& quantity, std::size_t first,
                                       std::size_t end) const;
  double weight_of(std::size_t over, std::size_t block) const;
  std::size_t end() const { return first_ + blocks(); }
  void close_block();
  void merge_neighbors();

  std::size_t bins_;
  std::size_t groups_;
  std::vector<double>
      sums_;  // shape (kMaxBlocks, groups, bins); the block after the full ones is being filled
  std::vector<double> weights_;  // shape (kMaxBlocks)
  std::vector<double> ends_;     // shape (kMaxBlocks)
  std::size_t full_blocks_ = 0;  // always fewer than kMaxBlocks
  std::size_t first_ = 0;        // the first block not left out
  std::uint64_t samples_ = 0;
  std::uint64_t samples_in_block_ = 0;  // of the block being filled
  std::uint64_t samples_per_block_ = 1;
};

}  // namespace hardball
