// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "hardball/geometry/time.hpp"
#include "hardball/statistics/block_average.hpp"
#include "hardball/statistics/estimate.hpp"

namespace hardball {

/// How the mean square of a moment grows with the lag, and the rate that it reaches: by Helfand's formulas a
/// transport coefficient.
///
/// The moment comes in increments over equal times. Two of them make one of twice the lag, these again, level
/// by level; those of a level overlap by half. Of a level are kept the mean squares M of its increments and
/// of their parts at the same times, so that the slope [M(2t) - M(t)] / t has the noise of one series.
/// Source: Helfand, Phys. Rev. 119 (1960) 1; for the blocks Flyvbjerg and Petersen, J. Chem. Phys. 91 (1989)
/// 461.
class MomentLags {
 public:
  /// A slope at one lag.
  struct Plateau {
    Estimate slope = {};
    double lag = 0;           ///< [T]; zero if there is none.
    std::string reason = {};  ///< Why there is none; empty if there is one.
  };

  MomentLags() = default;
  /// Increments are over `base` [T]. Squares are summed over the components with their `weights` [1]. Of a
  /// moment that has a mean, and one component, the mean is removed.
  MomentLags(double base, std::vector<double> weights, bool has_mean = false);

  std::size_t components() const { return weights_.size(); }
  double base() const { return base_; }
  /// Adds the next increment, which ends at `time` [T]. Cost: O(components), on average twice.
  void add(std::span<const double> increment, double time);

  /// How many lags there are.
  std::size_t levels() const { return levels_.size(); }
  /// The lag from which to twice which the slope of a level is [T].
  double lag(std::size_t level) const;
  Estimate slope(std::size_t level) const;
  /// The slope at the first lag from which three agree within their errors, or the last that is known. The
  /// error consists of that of the mean, which is at least that of independent normally distributed
  /// increments, and of the change to the next lag, or from one that did not quite agree with it, as far as
  /// that is more than chance. Lags are no shorter than `wanted_lag` [T], or where the run is not 32 times as
  /// long, than `least_lag` [T]. The run is at least 32 times as long as the lag.
  Plateau plateau(double least_lag, double wanted_lag) const;

 private:
  friend class Persistence;
  static void persist(auto& archive, auto& self) {
    archive(self.base_, self.weights_, self.has_mean_, self.levels_, self.elapsed_);
  }
  bool restored() const;

  // Bins of the averages: over increments of twice the lag, the square, by how much it exceeds the mean
  // square of the two parts, and the increment itself.
  enum : std::size_t { kSquare, kExcess, kIncrement, kBins };

  struct Level {
    std::vector<double> held;  // the increment with which the next makes one of twice the lag
    std::uint64_t count = 0;   // of increments
    BlockAverage average{kBins};
    static void persist(auto& archive, auto& self) { archive(self.held, self.count, self.average); }
  };

  double square_of(std::span<const double> increment) const;
  double relative_deviation(std::size_t level) const;

  double base_ = 1;
  std::vector<double> weights_;
  bool has_mean_ = false;
  std::vector<Level> levels_;
  double elapsed_ = 0;
};

/// A moment, as of all spheres together, that changes evenly between events and jumps at them. It is exact at
/// every time, and so are its increments over equal times.
class CollectiveMoment {
 public:
  static constexpr std::size_t kComponents = 6;  // of those that have fewer the last are zero
  using Sums = std::array<double, kComponents>;

  CollectiveMoment() = default;
  /// Starts at `begin`; `lags` has as many components and no increments yet.
  CollectiveMoment(const Time& begin, MomentLags lags)
      : begin_(begin), last_(begin), lags_(std::move(lags)) {}

  /// At which the components change at present.
  Sums rates{};

  /// Advances to `now`, with these rates. Cost: O(1), and O(components) for each increment that ends.
  void advance(const Time& now) {
    for (Time end = next_end(); !(now < end); end = next_end()) {
      carry(duration(last_, end));
      last_ = end;
      lags_.add(increment_, duration(begin_, end));
      increment_ = {};
      ++ended_;
    }
    carry(duration(last_, now));
    last_ = now;
  }
  /// Adds what jumps at the time reached.
  void jump(const Sums& amounts) {
    for (std::size_t k = 0; k < kComponents; ++k) increment_[k] += amounts[k];
  }

  const MomentLags& lags() const { return lags_; }
  /// The lags of a copy that has advanced to `now`.
  MomentLags lags_at(const Time& now) const {
    CollectiveMoment later = *this;
    later.advance(now);
    return later.lags_;
  }

 private:
  friend class Persistence;
  static void persist(auto& archive, auto& self) {
    archive(self.begin_, self.last_, self.lags_, self.rates, self.increment_, self.ended_);
  }
  bool restored() const {
    const bool is_in_order = (ended_ == 0 || !(last_ < end_of(ended_))) && last_ < next_end();
    return lags_.components() == kComponents && is_in_order;
  }

  Time end_of(std::uint64_t increments) const {
    return Time(begin_.value() + static_cast<double>(increments) * lags_.base());
  }
  Time next_end() const { return end_of(ended_ + 1); }
  void carry(double elapsed) {
    for (std::size_t k = 0; k < kComponents; ++k) increment_[k] += rates[k] * elapsed;
  }

  Time begin_;
  Time last_;
  MomentLags lags_;
  Sums increment_{};
  std::uint64_t ended_ = 0;  // increments
};

}  // namespace hardball
