// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/statistics/moment_lags.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "hardball/standard/ranges.hpp"

namespace hardball {
namespace {

constexpr std::size_t kMaxLevels = 48;

}  // namespace

MomentLags::MomentLags(double base, std::vector<double> weights, bool has_mean)
    : base_(base), weights_(std::move(weights)), has_mean_(has_mean) {}

double MomentLags::square_of(std::span<const double> increment) const {
  double sum = 0;
  for (std::size_t k = 0; k < increment.size(); ++k) sum += weights_[k] * increment[k] * increment[k];
  return sum;
}

void MomentLags::add(std::span<const double> increment, double time) {
  elapsed_ += base_;
  std::vector<double> next(increment.begin(), increment.end());
  for (std::size_t number = 0; number < kMaxLevels; ++number) {
    if (number == levels_.size()) levels_.emplace_back();
    Level& level = levels_[number];
    // Increments overlap by half, but for those of the first level.
    const std::uint64_t index = level.count++;
    if (number > 0 && index % 2 == 1) return;
    if (level.held.empty()) {
      level.held = std::move(next);
      return;
    }
    const double parts = (square_of(level.held) + square_of(next)) / 2;
    std::swap(level.held, next);
    for (std::size_t k = 0; k < next.size(); ++k) next[k] += level.held[k];
    const double square = square_of(next);
    level.average.add(std::array<double, kBins>{square, square - parts, next.front()}, time);
  }
}

double MomentLags::lag(std::size_t level) const {
  return std::ldexp(base_, static_cast<int>(level));
}

Estimate MomentLags::slope(std::size_t level) const {
  const BlockAverage& average = levels_[level].average;
  if (average.samples() == 0) return {};
  const double time = lag(level);
  // The mean is that of the run, so that part of each square is missing.
  const double kept = has_mean_ ? 1 - 3 * time / elapsed_ : 1;
  return average.estimate([&](Means means) {
    constexpr double kOfMean = 0.75;
    const double of_mean = has_mean_ ? kOfMean * means[kIncrement] * means[kIncrement] : 0;
    return (means[kExcess] - of_mean) / (time * kept);
  });
}

// The relative standard deviation that a slope has where increments are independent and normally distributed.
// With two increments a and b of the lag, (a + b)^2 - (a^2 + b^2) / 2 has five times the variance of the mean
// square, and half of that variance in common with the next.
double MomentLags::relative_deviation(std::size_t level) const {
  constexpr double kVariance = 5 + 2 * 0.5;
  double sum = 0;
  double squares = 0;
  for (const double weight : weights_) {
    sum += weight;
    squares += weight * weight;
  }
  return std::sqrt(kVariance * lag(level) / elapsed_ * squares) / sum;
}

MomentLags::Plateau MomentLags::plateau(double least_lag, double wanted_lag) const {
  constexpr double kLeastLags = 16;
  constexpr double kByChance = 2;
  constexpr double kCertain = 4;
  std::vector<Estimate> slopes;
  double largest = 0;
  for (std::size_t level = 0; level < levels_.size(); ++level) {
    slopes.push_back(slope(level));
    Estimate& here = slopes.back();
    if (lag(level) >= least_lag) largest = std::fmax(largest, std::fabs(here.value));
    // At long lags there are few squares, and where they are small by chance, so is their scatter.
    here.error = std::max(here.error, largest * relative_deviation(level));
  }
  const auto is_known = [&](std::size_t level) {
    return level < slopes.size() && !std::isnan(slopes[level].error);
  };
  // The change to the next level, and the standard deviation that it has by chance: what the two have in
  // common, the longer lag has besides noise of its own.
  const auto change_after = [&](std::size_t level) -> Estimate {
    const Estimate& here = slopes[level];
    const Estimate& next = slopes[level + 1];
    return {next.value - here.value,
            std::sqrt(std::max(0.0, next.error * next.error - here.error * here.error))};
  };
  const auto beyond = [](const Estimate& change) {
    return std::sqrt(std::max(0.0, change.value * change.value - change.error * change.error));
  };
  const auto agrees_with_next = [&](std::size_t level) {
    if (!is_known(level + 1)) return true;
    const Estimate change = change_after(level);
    return std::fabs(change.value) <= kByChance * change.error;
  };
  Plateau found;
  for (std::size_t level = 1; is_known(level); ++level) {
    if (lag(level) < least_lag) continue;
    if (2 * lag(level) * kLeastLags > elapsed_) break;
    // Where the next slope is not known, it will change by no more than the last has. A change that was too
    // large to stop at an earlier lag may have been noise as well, unless it is very large.
    const Estimate last = change_after(level - 1);
    const bool is_doubtful = found.lag > 0 && std::fabs(last.value) <= kCertain * last.error;
    double beyond_chance = is_known(level + 1) ? beyond(change_after(level)) : 0;
    if (!is_known(level + 1) || is_doubtful) beyond_chance = std::max(beyond_chance, beyond(last));
    const double error = std::hypot(slopes[level].error, beyond_chance);
    found = {{slopes[level].value, error}, lag(level), {}};
    if (lag(level) >= wanted_lag && agrees_with_next(level) && agrees_with_next(level + 1)) break;
  }
  if (found.lag == 0) found.reason = "the run is too short for a lag at which correlations are over";
  return found;
}

bool MomentLags::restored() const {
  const auto is_sound = [this](const Level& level) {
    return level.average.has(kBins) && (level.held.empty() || level.held.size() == weights_.size());
  };
  return base_ > 0 && levels_.size() <= kMaxLevels && ranges::all_of(levels_, is_sound);
}

}  // namespace hardball
