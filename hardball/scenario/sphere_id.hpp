// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>
#include <string>

#include "hardball/errors/error.hpp"
#include "hardball/events/event.hpp"

namespace hardball {

/// A number of a scenario, or of a file that it names, as the id of a sphere. Error, with `where` as its
/// place: it is not an id.
inline SphereId sphere_id(double number, const std::string& where) {
  constexpr double kLargest = std::numeric_limits<SphereId>::max() - 1;
  if (number >= 0 && number <= kLargest && number == std::floor(number)) return static_cast<SphereId>(number);
  throw Error(to_text(number) + " is not the id of a sphere", where, "give a whole number from 0 on");
}

}  // namespace hardball
