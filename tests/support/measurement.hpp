// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "hardball/measure/measurement.hpp"

namespace hardball::support {

/// The quantity of this name; throws if there is none.
inline const Quantity& quantity(const Measurement& measurement, const std::string& name) {
  const auto found = std::find_if(measurement.quantities.begin(), measurement.quantities.end(),
                                  [&](const Quantity& quantity) { return quantity.name == name; });
  if (found == measurement.quantities.end()) throw std::out_of_range("no quantity " + name);
  return *found;
}

/// The numbers of the column of this name; throws if there is none.
inline const std::vector<double>& column(const Measurement& measurement, const std::string& name) {
  const auto found = std::find_if(measurement.columns.begin(), measurement.columns.end(),
                                  [&](const Column& column) { return column.name == name; });
  if (found == measurement.columns.end()) throw std::out_of_range("no column " + name);
  return found->values;
}

}  // namespace hardball::support
