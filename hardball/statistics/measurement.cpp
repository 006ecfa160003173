// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/statistics/measurement.hpp"

#include <cmath>
#include <utility>

#include "hardball/errors/error.hpp"

namespace hardball {
namespace {

// The sign of a NaN has no meaning.
std::string field(double number) {
  return std::isnan(number) ? "nan" : to_text(number);
}

}  // namespace

Quantity& Measurement::add(std::string quantity, std::string unit, const Estimate& estimate, double theory,
                           double tolerance) {
  return quantities.emplace_back(
      Quantity{std::move(quantity), std::move(unit), estimate.value, estimate.error, theory, tolerance});
}

void Measurement::add_argument(std::string column, std::string unit, std::vector<double> values) {
  columns.push_back({std::move(column), std::move(unit), ColumnRole::argument, std::move(values)});
}

void Measurement::add(std::string column, std::string unit, std::vector<double> values) {
  columns.push_back({std::move(column), std::move(unit), ColumnRole::value, std::move(values)});
}

void Measurement::add(const std::string& column, const std::string& unit,
                      const std::vector<Estimate>& estimates, std::optional<std::vector<double>> theory) {
  const std::size_t rows = estimates.size();
  add(column, unit, tabulated(rows, [&](std::size_t row) { return estimates[row].value; }));
  columns.push_back({column + "_error", unit, ColumnRole::error,
                     tabulated(rows, [&](std::size_t row) { return estimates[row].error; })});
  if (theory) columns.push_back({column + "_theory", unit, ColumnRole::theory, std::move(*theory)});
}

std::vector<double> bin_middles(double low, double width, std::size_t bins) {
  return tabulated(bins, [&](std::size_t bin) { return low + (static_cast<double>(bin) + 0.5) * width; });
}

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
