// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/statistics/qualification.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>

#include "hardball/numbers/no_number.hpp"
#include "hardball/standard/ranges.hpp"

namespace hardball {
namespace {

constexpr const char* kTooShort = "the run has too few independent parts to estimate its error";
constexpr const char* kFromTheStart = "it is over the whole run and the start still had its initial order";

// The exponent of time in a unit.
int power_of_time(const std::string& unit) {
  const std::size_t time = unit.find('T');
  if (time == std::string::npos) return 0;
  const bool has_exponent = time + 1 < unit.size() && unit[time + 1] == '^';
  return has_exponent ? std::stoi(unit.substr(time + 2)) : 1;
}

// A number with the unit of a power of time is proportional to as many inverse roots of the temperature.
double widened(double error, double value, const std::string& unit, const StartSpread& spread) {
  if (error == 0) return 0;
  const double sensitivity = std::abs(power_of_time(unit)) / 2.0 + spread.sensitivity_of_places;
  return std::hypot(error, sensitivity * spread.temperature * value);
}

// Removes the errors of all quantities, and those of columns.
void leave_all_open(Measurement& measurement, const std::string& reason) {
  leave_quantities_open(measurement, reason);
  for (Column& column : measurement.columns) {
    if (column.role == ColumnRole::error) ranges::fill(column.values, kNoNumber);
  }
}

void widen(Measurement& measurement, const StartSpread& spread) {
  for (Quantity& quantity : measurement.quantities)
    quantity.error = widened(quantity.error, quantity.value, quantity.unit, spread);
  const Column* values = nullptr;
  for (Column& column : measurement.columns) {
    if (column.role == ColumnRole::value) values = &column;
    if (column.role != ColumnRole::error || !values) continue;
    for (std::size_t row = 0; row < column.values.size(); ++row)
      column.values[row] = widened(column.values[row], values->values[row], values->unit, spread);
  }
}

}  // namespace

void leave_open(Quantity& quantity, const std::string& reason) {
  if (quantity.error == 0) return;
  quantity.error = kNoNumber;
  quantity.tolerance = kForComparison;
  if (quantity.reason.empty()) quantity.reason = reason;
}

void leave_quantities_open(Measurement& measurement, const std::string& reason) {
  for (Quantity& quantity : measurement.quantities) leave_open(quantity, reason);
}

void leave_unsettled_open(Measurement& measurement) {
  if (!measurement.is_transient_over) leave_all_open(measurement, measurement.unsettled);
}

void leave_out(Quantity& quantity, const std::string& reason) {
  quantity.value = quantity.error = kNoNumber;
  if (quantity.reason.empty()) quantity.reason = reason;
}

void require_not_negative(Quantity& quantity) {
  if (quantity.value < 0) leave_out(quantity, "the run is too short to distinguish it from zero");
}

void qualify(Measurement& measurement, const Settled& settled) {
  constexpr double kLongPart = 0.125;
  if (settled.spread.temperature > 0) widen(measurement, settled.spread);
  if (!settled.is_over) {
    measurement.is_transient_over = false;
    measurement.unsettled = settled.reason;
    leave_unsettled_open(measurement);
  } else if (measurement.transient < settled.end && settled.end > kLongPart * measurement.duration) {
    leave_all_open(measurement, kFromTheStart);
  }
  for (Quantity& quantity : measurement.quantities) {
    // The temperature sets the scale of time, and of nothing else.
    if (!settled.is_steady && power_of_time(quantity.unit) != 0) leave_open(quantity, kNotSteady);
    const bool is_open = std::isfinite(quantity.value) && std::isnan(quantity.error);
    if (is_open && quantity.reason.empty()) quantity.reason = kTooShort;
  }
}

}  // namespace hardball
