// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/statistics/transient.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <vector>

#include "hardball/standard/ranges.hpp"
#include "hardball/statistics/qualification.hpp"

namespace hardball {
namespace {

constexpr const char* kStillChanging = "it still changes in the second half of the run";

constexpr std::size_t kSteps = 16;
// Parts of a run, or its halves, differ if they are more than this many standard errors apart.
constexpr double kFar = 2;
constexpr double kFarHalves = 3;

// How many blocks precede those that agree with the second half; none if there are none, and the halves
// differ.
std::optional<std::size_t> transient_blocks(const std::vector<double>& history, double error_of_half) {
  const std::size_t half = history.size() / 2;
  const std::size_t step = history.size() / kSteps;
  const auto mean = [&](std::size_t begin, std::size_t end) {
    const auto at = [&](std::size_t block) { return history.begin() + static_cast<std::ptrdiff_t>(block); };
    return std::accumulate(at(begin), at(end), 0.0) / static_cast<double>(end - begin);
  };
  const double settled = mean(half, history.size());
  const auto is_far = [&](std::size_t begin, std::size_t end, double errors = kFar) {
    // Means over fewer blocks vary more.
    const double ratio = static_cast<double>(history.size() - half) / static_cast<double>(end - begin);
    return std::fabs(mean(begin, end) - settled) > errors * error_of_half * std::sqrt(1 + ratio);
  };
  std::size_t left_out = 0;
  while (left_out + step <= half && (is_far(left_out, left_out + step) || is_far(left_out, half))) {
    left_out += step;
  }
  if (left_out + step <= half) return left_out;
  return is_far(0, half, kFarHalves) ? std::nullopt : std::optional(half);
}

// Whether the mean over all blocks is farther from that of the second half than chance allows, by the scatter
// among groups.
bool halves_differ(const BlockAverage& average, const BlockAverage& second_half,
                   const FunctionOfMeans& quantity, BlockAverage::Groups groups) {
  if (groups == BlockAverage::Groups::none) return false;
  const Estimate late = second_half.estimate(quantity, groups);
  const double half_of_difference = std::fabs(average.estimate(quantity, groups).value - late.value);
  return half_of_difference > kFarHalves * late.error / std::numbers::sqrt2;
}

}  // namespace

Transient find_transient(const BlockAverage& average, std::span<const FunctionOfMeans> quantities,
                         BlockAverage::Groups groups) {
  const std::span<const double> ends = average.ends();
  if (ends.size() < 2) return {};
  BlockAverage second_half = average;
  second_half.leave_out_until(ends[ends.size() / 2 - 1]);
  if (ends.size() < kSteps) {
    const bool differ = ranges::any_of(quantities, [&](const auto& quantity) {
      return halves_differ(average, second_half, quantity, groups);
    });
    return differ ? Transient{.end = {}, .is_over = false, .reason = kStillChanging} : Transient{};
  }
  std::size_t left_out = 0;
  for (const FunctionOfMeans& quantity : quantities) {
    const double error = second_half.estimate(quantity, groups).error;
    const std::vector<double> history = average.history(quantity);
    if (std::isnan(error) || history.size() < ends.size()) continue;
    const std::optional<std::size_t> blocks = transient_blocks(history, error);
    if (!blocks) return {.end = {}, .is_over = false, .reason = kStillChanging};
    left_out = std::max(left_out, *blocks);
  }
  if (left_out == 0) return {};
  return {.end = ends[left_out - 1], .is_over = true};
}

Transient find_transient(const BlockAverage& average, std::span<const FunctionOfMeans> quantities,
                         const Settled& settled, BlockAverage::Groups groups) {
  if (!settled.is_over) return {.end = {}, .is_over = false, .reason = settled.reason};
  const Transient found = find_transient(average, quantities, groups);
  if (settled.end == 0) return found;
  // With the block in which it ends.
  const std::span<const double> ends = average.ends();
  const auto block = ranges::lower_bound(ends, settled.end);
  return longer(found, {.end = block == ends.end() ? settled.end : *block, .is_over = true});
}

Transient longer(const Transient& a, const Transient& b) {
  if (!a.is_over || !b.is_over) return a.is_over ? b : a;
  return a.end.value_or(0) < b.end.value_or(0) ? b : a;
}

BlockAverage Transient::left_out_of(const BlockAverage& average) const {
  BlockAverage rest = average;
  if (end) rest.leave_out_until(*end);
  return rest;
}

void Transient::note_in(Measurement& measurement) const {
  measurement.transient = end.value_or(0);
  measurement.is_transient_over = is_over;
  measurement.unsettled = reason;
}

}  // namespace hardball
