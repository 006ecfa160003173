// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/statistics/csv.hpp"

#include <cmath>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

// The sign of a NaN has no meaning.
std::string field(double number) {
  return std::isnan(number) ? "nan" : to_text(number);
}

}  // namespace

std::string columns_csv(const Measurement& measurement) {
  std::string text;
  if (measurement.columns.empty()) return text;
  for (const Column& column : measurement.columns) text += column.name + " [" + column.unit + "],";
  text.back() = '\n';
  for (std::size_t row = 0; row < measurement.columns.front().values.size(); ++row) {
    for (const Column& column : measurement.columns) text += field(column.values[row]) + ",";
    text.back() = '\n';
  }
  return text;
}

std::string quantities_csv(std::span<const Measurement> measurements) {
  std::string text = "measure,name,value,error,theory,unit,transient [T],tolerance,reason\n";
  for (const Measurement& measurement : measurements) {
    for (const Quantity& quantity : measurement.quantities) {
      text += measurement.name + "," + quantity.name + "," + field(quantity.value) + "," +
              field(quantity.error) + "," + field(quantity.theory) + "," + quantity.unit + "," +
              field(measurement.is_transient_over ? measurement.transient : measurement.duration) + "," +
              field(quantity.tolerance) + "," + quantity.reason + "\n";
    }
  }
  return text;
}

}  // namespace hardball
