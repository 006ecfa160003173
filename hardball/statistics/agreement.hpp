// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "hardball/statistics/measurement.hpp"

namespace hardball {

/// How far the largest of `compared` deviations from the truth may lie by chance in one run of a hundred
/// [standard errors]. Errors are from at least eight independent parts: Student's distribution with seven
/// degrees of freedom, and as many comparisons as there are (Bonferroni). Source: Abramowitz and Stegun,
/// Handbook of Mathematical Functions, 26.7.3; Miller, Simultaneous Statistical Inference, section 1.
double largest_by_chance(std::size_t compared);

/// How far a number lies from its theory, beyond the tolerance of that [standard errors]; NaN if it cannot be
/// compared: without an error beyond rounding, without theory, or with one that is for comparison only.
double deviation(const Quantity& quantity);

/// A number that is farther from its theory than chance allows.
struct FarNumber {
  std::string quantity;  ///< Name of the quantity.
  std::string title;     ///< Title of its measurement.
};

/// Whether the numbers of a run agree with theory.
class Agreement {
 public:
  explicit Agreement(std::span<const Measurement> measurements);

  /// How many numbers have an error and a theory.
  std::size_t compared() const { return compared_; }
  /// Whether a number is farther from its theory than chance allows.
  bool is_far(const Quantity& quantity) const { return deviation(quantity) > allowed_; }
  /// The numbers that are farther from their theory than chance allows.
  const std::vector<FarNumber>& far() const { return far_; }

 private:
  std::size_t compared_ = 0;
  double allowed_ = 0;
  std::vector<FarNumber> far_;
};

}  // namespace hardball
