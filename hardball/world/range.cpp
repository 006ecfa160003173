// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/world/range.hpp"

#include <cmath>

#include "hardball/errors/error.hpp"

namespace hardball {

void check_finite(double number, const std::string& name, const std::string& where) {
  if (std::isfinite(number) && std::fabs(number) <= kLargestMagnitude) return;
  throw Error(name + " is " + to_text(number), where, "give a finite number of magnitude at most 1e60");
}

void check_positive(double number, const std::string& name, const std::string& where) {
  if (number >= kSmallestMagnitude && number <= kLargestMagnitude) return;
  throw Error(name + " is " + to_text(number), where, "give a positive number between 1e-60 and 1e60");
}

}  // namespace hardball
