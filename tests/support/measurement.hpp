// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>

#include "hardball/measure/measurement.hpp"

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

}  // namespace hardball::support
