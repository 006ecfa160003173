// SPDX-FileCopyrightText: 2026 The Hardball authors
// SPDX-License-Identifier: MIT
#include "hardball/measure/qualification.hpp"

#include <algorithm>
#include <cmath>

#include "hardball/theory/no_number.hpp"

namespace hardball {
namespace {

constexpr const char* kTooShort = "the run has too few independent parts to estimate its error";
constexpr const char* kFromTheStart = "it is over the whole run and the start still had its initial order";

// The temperature sets the scale of time, and of nothing else.
bool depends_on_temperature(const Quantity& quantity) {
  return quantity.unit.find('T') != std::string::npos;
}

}  // namespace

Quantity no_estimate(const std::string& name, const std::string& unit, double value,
                     const std::string& reason) {
  return {.name = name, .unit = unit, .value = value, .reason = reason};
}

void leave_open(Quantity& quantity, const std::string& reason) {
  if (quantity.error == 0) return;
  quantity.error = kNoNumber;
  quantity.tolerance = kForComparison;
  if (quantity.reason.empty()) quantity.reason = reason;
}

void leave_out(Quantity& quantity, const std::string& reason) {
  quantity.value = quantity.error = kNoNumber;
  if (quantity.reason.empty()) quantity.reason = reason;
}

void require_not_negative(Quantity& quantity) {
  if (quantity.value < 0) leave_out(quantity, "the run is too short to tell it from zero");
}

void qualify(Measurement& measurement, const Settled& settled) {
  constexpr double kLongPart = 0.125;
  const auto leave_all_open = [&](const std::string& reason) {
    for (Quantity& quantity : measurement.quantities) leave_open(quantity, reason);
    for (Column& column : measurement.columns) {
      if (column.role == ColumnRole::error) std::ranges::fill(column.values, kNoNumber);
    }
  };
  if (!settled.is_over) {
    leave_all_open(settled.reason);
    measurement.is_transient_over = false;
    measurement.unsettled = settled.reason;
  } else if (measurement.transient < settled.end && settled.end > kLongPart * measurement.duration) {
    leave_all_open(kFromTheStart);
  }
  for (Quantity& quantity : measurement.quantities) {
    if (!settled.is_steady && depends_on_temperature(quantity)) leave_open(quantity, kNotSteady);
    const bool is_open = std::isfinite(quantity.value) && std::isnan(quantity.error);
    if (is_open && quantity.reason.empty()) quantity.reason = kTooShort;
  }
}

}  // namespace hardball
