// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/transient.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "hardball/theory/no_number.hpp"

namespace hardball {
namespace {

constexpr std::size_t kSteps = 16;
constexpr double kFar = 2;  // [standard errors]

// How many blocks precede those that agree with the second half.
std::size_t transient_blocks(const std::vector<double>& history, double error_of_half) {
  const std::size_t half = history.size() / 2;
  const std::size_t step = history.size() / kSteps;
  const auto mean = [&](std::size_t begin, std::size_t end) {
    const auto at = [&](std::size_t block) { return history.begin() + static_cast<std::ptrdiff_t>(block); };
    return std::accumulate(at(begin), at(end), 0.0) / static_cast<double>(end - begin);
  };
  const double settled = mean(half, history.size());
  // Means over fewer blocks vary more.
  const double ratio = static_cast<double>(history.size() - half) / static_cast<double>(step);
  const double far = kFar * error_of_half * std::sqrt(1 + ratio);
  std::size_t left_out = 0;
  while (left_out + step <= half && std::fabs(mean(left_out, left_out + step) - settled) > far) {
    left_out += step;
  }
  return left_out;
}

}  // namespace

Transient find_transient(const BlockAverage& average, std::span<const FunctionOfMeans> quantities,
                         BlockAverage::Groups groups) {
  const std::span<const double> ends = average.ends();
  if (ends.size() < kSteps) return {};
  BlockAverage second_half = average;
  second_half.leave_out_until(ends[ends.size() / 2 - 1]);
  std::size_t left_out = 0;
  for (const FunctionOfMeans& quantity : quantities) {
    const double error = second_half.estimate(quantity, groups).error;
    const std::vector<double> history = average.history(quantity);
    if (std::isnan(error) || history.size() < ends.size()) continue;
    left_out = std::max(left_out, transient_blocks(history, error));
  }
  if (left_out == 0) return {};
  if (left_out + ends.size() / kSteps > ends.size() / 2) return {.end = {}, .is_over = false};
  return {.end = ends[left_out - 1], .is_over = true};
}

BlockAverage Transient::left_out_of(const BlockAverage& average) const {
  BlockAverage rest = average;
  if (end) rest.leave_out_until(*end);
  return rest;
}

void Transient::note_in(Measurement& measurement) const {
  measurement.transient = end.value_or(0);
  measurement.is_transient_over = is_over;
  if (is_over) return;
  for (Quantity& quantity : measurement.quantities) quantity.error = kNoNumber;
  for (Column& column : measurement.columns) {
    if (column.role == ColumnRole::error) std::fill(column.values.begin(), column.values.end(), kNoNumber);
  }
}

}  // namespace hardball
