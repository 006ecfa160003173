// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/geometry/range.hpp"

#include <string>

#include "hardball/errors/error.hpp"

namespace hardball {

void check_finite(double number, std::string_view name, std::string_view where) {
  if (std::fabs(number) <= kLargestMagnitude) return;
  throw Error(std::string(name) + " is " + to_text(number), std::string(where),
              "give a finite number of magnitude at most 1e60");
}

void check_positive(double number, std::string_view name, std::string_view where) {
  if (number >= kSmallestMagnitude && number <= kLargestMagnitude) return;
  throw Error(std::string(name) + " is " + to_text(number), std::string(where),
              "give a positive number between 1e-60 and 1e60");
}

void refuse_moment(const Time& moment, std::string_view where) {
  const std::string low = moment.low == 0 ? "" : " with a low part of " + to_text(moment.low);
  throw Error("the time is " + to_text(moment.high) + low, std::string(where),
              "give a finite time of magnitude at most 1e120");
}

}  // namespace hardball
