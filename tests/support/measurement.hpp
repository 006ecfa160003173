// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "hardball/statistics/measurement.hpp"
#include "hardball/world/world.hpp"

namespace hardball::support {

/// The quantity of this name.
inline const Quantity& quantity(const Measurement& found, const std::string& name) {
  for (const Quantity& quantity : found.quantities) {
    if (quantity.name == name) return quantity;
  }
  throw std::out_of_range("no quantity " + name);
}

inline bool has_quantity(const Measurement& found, const std::string& name) {
  return std::any_of(found.quantities.begin(), found.quantities.end(),
                     [&](const Quantity& quantity) { return quantity.name == name; });
}

/// The column of this name.
inline const Column& column(const Measurement& found, const std::string& name) {
  for (const Column& column : found.columns) {
    if (column.name == name) return column;
  }
  throw std::out_of_range("no column " + name);
}

/// The values in the column of this name.
inline const std::vector<double>& values(const Measurement& found, const std::string& name) {
  return column(found, name).values;
}

/// The result of the measure of this name.
inline const Measurement& named(const std::vector<Measurement>& results, const std::string& name) {
  const auto found = std::ranges::find(results, name, &Measurement::name);
  if (found == results.end()) throw std::out_of_range("no measure " + name);
  return *found;
}

/// The result of a measure that samples a world once, at time zero.
template <class Measure, class... Settings>
Measurement measured(const World& world, const Settings&... settings) {
  Measure measure({world, Time(0)}, settings...);
  measure.sample({world, Time(0)});
  return result_of(measure, {world, Time(0)});
}

}  // namespace hardball::support
